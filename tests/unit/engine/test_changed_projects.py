"""Edits of the project while its world runs: nodes keep their places as far as those still exist."""

from contextlib import suppress
from dataclasses import replace
from typing import Any

import pytest

from app.core.automaton import START, Basic, Nested, RaiseFlag
from app.core.edits import (
    add_state,
    add_type,
    bind_state,
    delete_automaton,
    delete_type,
    disable_examples,
    remove_state,
    rename_arm,
    rename_automaton,
    rename_parameter,
    rename_state,
    set_content,
    set_hierarchy,
    set_parameters,
    take_back_pick,
)
from app.core.errors import EditError
from app.core.project import LevelTable
from app.engine.commands import Pick, Reset, UndoPick, UseProject
from app.engine.commands import Test as LearnAndTest
from app.engine.snapshots import Edit, Interrupted, Mode, Picked, Refused, edited
from tests.corridor import project, to
from tests.driver import Driver
from tests.samples import AGENT, GROUP, SQUAD


def teaching() -> Driver:
    return Driver().teach("agent-1", "Shuttle").pick("up").advance(2)


# ------------------------------------------------------------------------------------------ places that are kept


def test_a_renamed_behavior_goes_on() -> None:
    driver = Driver().advance(2).edit(rename_automaton, AGENT, "Stroll", "Walkabout")
    assert (driver.view().behavior, driver.view().path) == ("Walkabout", (("Stroll", "up"),))
    assert driver.interruptions == []
    assert driver.run().advance().view().behavior == "Walkabout"  # the arm knows the new name too


def test_a_behavior_that_is_renamed_while_it_is_taught_goes_on() -> None:
    driver = teaching().edit(rename_automaton, AGENT, "Shuttle", "Bus").advance()
    assert (driver.mode, driver.state(), driver.view().behavior) == (Mode.TEACHING, "up", "Bus")
    driver.pick("down").advance().test()
    assert driver.view().behavior == "Bus"


def test_a_state_renamed_under_a_node_goes_on() -> None:
    driver = teaching().edit(rename_state, AGENT, "Shuttle", "up", "Onward")
    assert (driver.state(), driver.interruptions) == ("up", [])


def test_edits_of_examples_disturb_nobody() -> None:
    driver = teaching().pick("jump").advance().edit(disable_examples, AGENT, "Shuttle", ["1", "2"])
    assert driver.advance().state() == "jump"
    assert driver.place() == 7.0
    assert driver.interruptions == []


def test_a_waiting_pick_is_carried_out_after_an_edit() -> None:
    driver = teaching().pick("down").edit(rename_state, AGENT, "Shuttle", "down", "Back").advance()
    assert driver.state() == "down"


def test_a_state_added_by_the_caller_can_be_picked() -> None:
    driver = teaching().edit(add_state, AGENT, "Shuttle", Basic("Leave")).pick("leave").advance()
    assert driver.taught[-1] == "up>leave"


# ---------------------------------------------------------------------------------------------- places that are gone


def test_a_node_whose_state_was_removed_is_in_start_and_the_session_says_so() -> None:
    driver = teaching().edit(remove_state, AGENT, "Shuttle", "up")
    assert (driver.state(), driver.mode) == (START, Mode.TEACHING)
    assert driver.interruptions == [
        "the state is gone, or holds something else, that these nodes were in: agent-1"
    ]
    assert driver.pick("down").advance().taught[-2:] == ["start>down", "down>down+"]


def test_a_node_whose_state_holds_something_else_is_in_start() -> None:
    driver = teaching().edit(set_content, AGENT, "Shuttle", "up", Basic("Down"))
    assert driver.state() == START
    assert "agent-1" in driver.interruptions[0]


def test_a_waiting_pick_of_a_state_that_was_removed_is_not_carried_out() -> None:
    driver = teaching().pick("down").edit(remove_state, AGENT, "Shuttle", "down").advance()
    assert (driver.state(), driver.snapshot.failure) == ("up", "")
    assert driver.interruptions == [
        "what was picked for Agent 1 is not done: the state 'down' is gone from 'Shuttle'"
    ]
    assert driver.undo().taught == ["start>up", "up>up+"]


def test_a_waiting_pick_whose_target_gets_open_is_not_carried_out() -> None:
    held, _ = add_state(project(), AGENT, "Shuttle", Basic("Toward", to("lamp")))
    driver = Driver(held).teach("agent-1", "Shuttle").pick("up").advance().pick("toward")
    driver.edit(bind_state, AGENT, "Shuttle", "toward", "target", None).advance()
    assert (driver.state(), driver.snapshot.failure) == ("up", "")
    assert driver.interruptions[0].startswith("what was picked for Agent 1 is not done: 'target' of state ")


def test_nodes_whose_behavior_was_deleted_begin_with_what_replaces_it_in_the_arm() -> None:
    driver = Driver().advance(2).edit(delete_automaton, AGENT, "Stroll", "Signal")
    assert driver.view().behavior == "Signal"
    assert driver.interruptions == [
        "what these nodes did is gone, so they begin with Signal: agent-1, agent-2"
    ]


def test_undoing_a_deletion_lets_nodes_go_on_where_they_were() -> None:
    driver = Driver().advance(2)
    whole, path = driver.project, driver.view().path
    driver.edit(delete_automaton, AGENT, "Stroll", "Signal").advance(3)
    told = driver.interruptions
    driver.edit(lambda _: whole)
    assert (driver.view().behavior, driver.view().path) == ("Stroll", path)
    assert driver.interruptions == told  # nobody has lost anything
    place = driver.place()
    assert driver.advance().place() > place
    driver.edit(delete_automaton, AGENT, "Stroll", "Signal")  # as redo does
    assert driver.view().behavior == "Signal"


def test_ticks_in_which_a_behavior_was_gone_do_not_count_for_those_that_go_on() -> None:
    driver = Driver().advance(4)
    whole = driver.project
    entered = driver.session._world.engine.machine.actors["agent-1"].run.entered  # type: ignore[union-attr]  # it runs something
    driver.edit(delete_automaton, AGENT, "Stroll", "Signal").advance(3).edit(lambda _: whole)
    run = driver.session._world.engine.machine.actors["agent-1"].run
    assert run is not None
    assert run.entered == entered + 3


def test_nodes_that_were_told_something_else_meanwhile_go_on_with_that() -> None:
    driver = Driver().advance(2)
    whole = driver.project
    driver.edit(delete_automaton, AGENT, "Stroll", "Signal").run().edit(lambda _: whole)
    assert driver.view().behavior == "Signal"


def test_where_nothing_replaces_a_behavior_nodes_idle_until_it_is_back() -> None:
    driver = Driver().advance(2)
    whole = driver.project
    bare = replace(
        whole,
        libraries={**whole.libraries, AGENT: replace(whole.library(AGENT), automata={})},
        arms=tuple(replace(arm, top="") for arm in whole.arms),
    )
    driver.edit(lambda _: bare)
    assert driver.view().behavior == ""
    assert driver.interruptions == [
        "what these nodes did is gone, so they idle until it is back: agent-1, agent-2"
    ]
    assert driver.advance(3).place() == 2.0
    driver.edit(lambda _: whole)
    assert driver.view().behavior == "Stroll"
    assert driver.advance().place() == 3.0


def test_the_arm_runs_again_once_what_was_taught_has_been_deleted() -> None:
    driver = teaching().edit(delete_automaton, AGENT, "Shuttle")
    assert [driver.view(f"agent-{k}").behavior for k in (1, 2)] == ["Stroll", "Stroll"]


def test_deleting_the_behavior_that_is_taught_ends_the_lesson_and_pauses() -> None:
    driver = teaching()
    driver.session.send(Pick("agent-1", "down"))
    driver.listen()
    driver.edit(delete_automaton, AGENT, "Shuttle")
    assert (driver.mode, driver.session.playing) == (Mode.RUNNING, False)
    assert driver.interruptions[-1] == "the lesson is over: Shuttle was deleted; undo brings it back"
    assert "nothing is being taught" in driver.refused(UndoPick())


def test_deleting_the_behavior_that_is_learned_gives_the_answer_up() -> None:
    driver = teaching()
    driver.session.send(LearnAndTest())
    driver.edit(delete_automaton, AGENT, "Shuttle")
    assert driver.mode is Mode.RUNNING
    driver.session.settle()
    assert driver.listen().mode is Mode.RUNNING


@pytest.mark.parametrize(
    ("edit", "why"),
    [
        ((rename_parameter, AGENT, "Seek", "target", "goal"), "while teaching, 'goal' is open"),
        ((set_parameters, AGENT, "Seek", ("target", "home")), "while teaching, 'home' is open"),
    ],
)
def test_a_parameter_that_gets_open_ends_the_lesson(edit: tuple[Any, ...], why: str) -> None:
    driver = Driver().teach("agent-1", "Seek", target="lamp").pick("Up").advance().edit(*edit)
    assert driver.interruptions[-1].startswith(f"the lesson is over: {why}")
    assert driver.mode is Mode.RUNNING


def test_a_nested_behavior_that_is_deleted_takes_only_the_state_away_that_held_it() -> None:
    driver = Driver().teach("agent-1", "Shuttle").pick("signal").advance(2)
    driver.edit(delete_automaton, AGENT, "Signal", "Stroll")
    assert (driver.state(), driver.mode) == (START, Mode.TEACHING)
    assert driver.session.project.library(GROUP).get("Lead").state("signal").content == Basic("Stroll")


def test_a_controller_whose_direction_was_renamed_directs_anew() -> None:
    made, _ = add_state(project(), GROUP, "Lead", Basic("Stroll"))
    driver = Driver(made, "groups").teach("group-1", "Lead").pick("stroll").advance()
    driver.edit(rename_automaton, AGENT, "Stroll", "Walkabout")
    assert (driver.state(), driver.mode) == (START, Mode.TEACHING)
    assert [driver.view(f"agent-{k}").behavior for k in (1, 2)] == ["Walkabout", "Walkabout"]
    assert driver.pick("stroll").advance().view("agent-1").basic == "Up"


def test_an_open_binding_is_no_problem_until_it_is_needed_and_then_stops_the_world() -> None:
    made, _ = add_state(project(), AGENT, "Shuttle", Nested("Seek", {}), "go")
    driver = Driver(made).teach("agent-1", "Shuttle").pick("up").advance()
    driver.edit(bind_state, AGENT, "Shuttle", "go", "target", None).advance()
    assert driver.snapshot.failure == ""


# -------------------------------------------------------------------------------------------- types, arms, forests


def test_a_project_in_which_the_nodes_have_no_type_any_more_stops_the_world() -> None:
    driver = Driver().advance()
    lost = replace(project(), types=project().types[1:])
    driver.session.send(UseProject(lost))
    (event,) = driver.session.events()
    assert isinstance(event, Refused)
    assert event.message.startswith("the world cannot go on with the changed project: there is no node type")
    assert driver.session.project is lost
    assert driver.session.snapshot().failure
    driver.session.send(UseProject(project()))
    driver.session.send(Reset())
    assert driver.session.advance(2).world["x"][0] == 2.0


def test_a_new_type_disturbs_nobody() -> None:
    driver = teaching().edit(add_type, "swarm", (SQUAD,)).edit(delete_type, "swarm").advance()
    assert (driver.state(), driver.place(), driver.interruptions) == ("up", 3.0, [])


def test_a_world_keeps_its_forest_until_it_is_reset() -> None:
    driver = Driver().edit(set_hierarchy, "alone", LevelTable((3,), (AGENT,))).advance(2)
    assert set(driver.snapshot.nodes) == {"agent-1", "agent-2"}
    driver.reset().advance()
    assert set(driver.snapshot.nodes) == {"agent-1", "agent-2", "agent-3"}


def test_reset_is_refused_where_a_taught_node_is_gone_from_the_arm() -> None:
    driver = Driver().teach("agent-2", "Shuttle").pick("up").advance()
    driver.edit(set_hierarchy, "alone", LevelTable((1,), (AGENT,)))
    assert "there is no node 'agent-2' in this world" in driver.refused(Reset())
    assert driver.advance().state() == "up"
    assert set(driver.run().reset().snapshot.nodes) == {"agent-1"}


def test_a_renamed_arm_goes_on_under_its_new_name() -> None:
    driver = teaching().edit(rename_arm, "alone", "solo").pick("down").reset()
    assert driver.snapshot.arm == "solo"
    assert driver.project.moments[driver.examples[-1].snapshot].arm == "solo"


def test_reset_is_refused_where_the_arm_is_gone() -> None:
    driver = Driver().edit(lambda made: replace(made, arms=made.arms[1:])).advance(2)
    assert driver.refused(Reset()) == "there is no arm 'alone'; there are: 'groups', 'squads'"
    assert driver.run().advance().view().basic == "Up"


# -------------------------------------------------------------------------------- edits that cross on their way


class Slow(Driver):
    """A caller that hears late: its edits and the session's cross on their way."""

    applied = 0

    def listen(self) -> "Driver":
        return self

    def hear(self) -> None:
        for event in self.session.events():
            if isinstance(event, Edit):
                self.applied += 1
                with suppress(EditError):
                    self.project = edited(self.project, event)
        assert self.project == self.session.project

    def cross(self, change: Any, *args: Any) -> None:
        """An edit of a project that lacks what the session has reported last."""
        made = change(self.project, *args)
        self.project = made[0] if isinstance(made, tuple) else made
        self.session.send(UseProject(self.project, self.applied))


def test_a_pick_that_crosses_an_edit_of_the_caller_is_not_lost() -> None:
    driver = Slow()
    driver.teach("agent-1", "Shuttle").pick("up")
    driver.cross(rename_state, AGENT, "Shuttle", "down", "Back")
    driver.hear()
    assert driver.taught == ["start>up", "up>up+"]
    assert driver.project.library(AGENT).get("Shuttle").state("down").name == "Back"
    driver.advance().pick("down")
    driver.hear()
    assert [(e.id, e.pick) for e in driver.examples] == [("1", 1), ("2", 1), ("3", 2), ("4", 2)]


def test_a_pick_of_a_state_that_the_caller_removes_meanwhile_is_given_up_by_both() -> None:
    driver = Slow()
    driver.teach("agent-1", "Shuttle").pick("up")
    driver.cross(remove_state, AGENT, "Shuttle", "up")
    assert driver.session.advance(2).nodes["agent-1"].path == (("Shuttle", START),)
    events = driver.session.events()
    assert isinstance(events[0], Picked)
    assert [event.message.partition(":")[0] for event in events if isinstance(event, Interrupted)] == [
        "what was picked for Agent 1 is not done",
        "what was just taught could not be kept",
    ]
    driver.session._events = events  # not heard yet
    driver.hear()
    assert driver.taught == []


def test_what_was_learned_is_not_put_into_a_project_that_has_other_examples_by_then() -> None:
    driver = Slow()
    driver.teach("agent-1", "Shuttle").pick("up").advance()
    driver.hear()
    driver.session.send(LearnAndTest())
    driver.session.settle()
    driver.cross(disable_examples, AGENT, "Shuttle", ["1"])
    driver.hear()
    assert driver.project.library(AGENT).get("Shuttle").learned == {}


def test_a_caller_that_undoes_a_pick_in_its_own_way_is_followed() -> None:
    driver = Driver().teach("agent-1", "Shuttle").pick("up").advance(2)
    recorded = driver.session._lesson.acts[0].recorded  # type: ignore[union-attr]  # there is a lesson
    driver.edit(take_back_pick, recorded)
    assert (driver.taught, driver.state()) == ([], "up")
    assert driver.pick("down").taught == ["up>down", "down>down+"]


def test_edits_that_the_caller_has_are_not_kept() -> None:
    driver = Slow()
    driver.teach("agent-1", "Shuttle").pick("up").advance().pick("down")
    driver.hear()
    driver.cross(rename_state, AGENT, "Shuttle", "down", "Back")
    assert driver.refused(UseProject(driver.project, 1)).endswith("allowed: 2 to 2, as many as were made")


# ---------------------------------------------------------------------------------------------------- in general


def test_a_flag_state_that_is_raised_under_another_name_is_in_start_all_the_same() -> None:
    driver = Driver().teach("agent-1", "Shuttle").pick("over").advance()
    driver.edit(set_content, AGENT, "Shuttle", "over", RaiseFlag("gone"))
    assert (driver.state(), driver.interruptions) == (START, [])


def test_the_revision_grows_with_every_change() -> None:
    driver = Driver()
    revisions = [driver.snapshot.revision]
    driver.teach("agent-1", "Shuttle").pick("up")
    revisions.append(driver.snapshot.revision)
    driver.edit(rename_state, AGENT, "Shuttle", "up", "Onward")
    revisions.append(driver.snapshot.revision)
    driver.undo()
    revisions.append(driver.snapshot.revision)
    assert revisions == sorted(set(revisions))
