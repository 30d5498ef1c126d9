"""Training mode, sentence by sentence (paper, section 3.1)."""

from dataclasses import replace
from typing import Any

import pytest

from app.core.automaton import START, Basic, RaiseFlag, Start
from app.core.edits import add_feature
from app.core.features import FlagUp, Parameter, TicksInState
from app.core.vocabulary import DONE
from app.engine.commands import Others, Pick
from app.engine.snapshots import Demonstrated, Mode, Picked, TakenBack
from tests.corridor import features, project, to
from tests.driver import Driver
from tests.samples import automaton, nested, state


def lesson(**fields: Any) -> Driver:
    """An agent that is taught to shuttle."""
    return Driver().teach("agent-1", "Shuttle", **fields)


# ------------------------------------------------------------------------------- what the nodes do meanwhile


def test_a_node_in_training_is_in_start_and_idles_until_the_first_pick() -> None:
    driver = lesson().advance(5)
    assert (driver.state(), driver.place(), driver.mode) == (START, 0.0, Mode.TEACHING)
    assert driver.view().taught


def test_the_node_does_exactly_what_the_user_picks_and_nothing_else() -> None:
    driver = lesson().pick("up")
    assert driver.does(4) == ["Up"] * 4
    driver.pick("down")
    assert driver.does(3) == ["Down"] * 3
    assert driver.place() == 1.0


def test_the_node_does_not_follow_what_it_has_learned_while_it_is_taught() -> None:
    driver = lesson().pick("up").advance(2).pick("down").advance(2).test()
    driver.teach("agent-1", "Shuttle")
    assert driver.does(3) == [""] * 3


def test_a_pick_takes_effect_in_the_next_tick() -> None:
    driver = lesson().pick("up")
    assert (driver.state(), driver.place()) == (START, 0.0)
    driver.advance()
    assert (driver.state(), driver.place()) == ("up", 1.0)


def test_a_picked_automaton_runs_by_itself() -> None:
    driver = lesson().pick("signal").advance(2)
    assert driver.state() == "signal/up"
    driver.advance(2)
    assert driver.state() == "signal/start"
    assert driver.view().taught


def test_nodes_not_being_taught_idle() -> None:
    driver = Driver().advance(3).teach("agent-1", "Shuttle").pick("up").advance(4)
    assert (driver.place(1), driver.place(2)) == (7.0, 13.0)


def test_by_a_switch_nodes_not_being_taught_run_their_current_behavior() -> None:
    driver = Driver().advance(3).teach("agent-1", "Shuttle", others=Others.RUN).pick("down").advance(4)
    assert (driver.place(1), driver.place(2)) == (0.0, 17.0)


@pytest.mark.parametrize("others", list(Others))
def test_the_ancestors_of_a_taught_node_do_not_tick(others: Others) -> None:
    driver = Driver(arm="squads").teach("agent-1", "Shuttle", others=others).pick("up").advance(5)
    assert [driver.state(node) for node in ("squad-1", "group-1")] == [START, ""]
    assert driver.state() == "up"


# ----------------------------------------------------------------------------------------- what a pick records


def test_each_pick_records_a_transition_and_its_continuation() -> None:
    driver = lesson().pick("up").advance(3).pick("down")
    assert driver.taught == ["start>up", "up>up+", "up>down", "down>down+"]


def test_an_example_holds_the_features_as_they_were_at_the_pick() -> None:
    driver = lesson().pick("up").advance(3).pick("down")
    went = driver.examples[2]
    assert went.values == {"place": 3.0, "done": 0.0, "ticks": 3.0}
    assert (went.tick, went.node) == (3, "agent-1")


@pytest.mark.parametrize("once", ["jump", "ring", "over"])
def test_no_continuation_is_recorded_of_a_behavior_that_runs_once(once: str) -> None:
    assert lesson().pick(once).taught == [f"start>{once}"]


def test_a_continuation_sees_what_the_state_will_see_on_entry() -> None:
    driver = lesson().pick("signal").advance(4)
    assert driver.pick("up").examples[2].values == {"place": 3.0, "done": 1.0, "ticks": 4.0}
    continuation = driver.examples[3]
    assert (continuation.source, continuation.label, continuation.continuation) == ("up", "up", True)
    assert continuation.values == {"place": 3.0, "done": 0.0, "ticks": 0.0}


def test_picking_the_current_behavior_again_records_one_stay_that_is_no_continuation() -> None:
    driver = lesson().pick("up").advance(2).pick("up").advance(2)
    assert driver.taught == ["start>up", "up>up+", "up>up"]
    assert (driver.state(), driver.place()) == ("up", 4.0)


def test_picking_the_current_automaton_again_lets_it_go_on() -> None:
    driver = lesson().pick("signal").advance(2).pick("signal").advance()
    assert (driver.state(), driver.place()) == ("signal/up", 3.0)


def test_picking_the_current_one_shot_again_runs_it_again_and_records_nothing() -> None:
    driver = lesson().pick("jump").advance(3)
    assert driver.place() == 5.0
    driver.pick("jump").advance(3)
    assert (driver.place(), driver.taught) == (10.0, ["start>jump"])


def test_after_a_flag_state_the_current_state_is_start() -> None:
    driver = lesson().pick("over").advance()
    assert (driver.state(), driver.view().flags) == (START, frozenset({DONE}))
    assert driver.pick("up").taught == ["start>over", "start>up", "up>up+"]


def test_after_a_behavior_that_raises_a_flag_the_current_state_is_start() -> None:
    driver = lesson().pick("ring").advance()
    assert driver.state() == START
    assert driver.pick("ring").advance().taught == ["start>ring", "start>ring"]


@pytest.mark.parametrize("choice", [START, Start()])
def test_no_example_is_recorded_to_start(choice: str | Start) -> None:
    driver = lesson().pick("up").advance(2).pick(choice).advance(2)
    assert (driver.taught, driver.state(), driver.place()) == (["start>up", "up>up+"], START, 2.0)


def test_no_example_is_recorded_of_staying_in_start() -> None:
    assert lesson().pick(START).advance().taught == []


# --------------------------------------------------------------------------- behaviors that the automaton lacks


def test_picking_a_behavior_that_the_automaton_lacks_adds_a_state() -> None:
    driver = Driver().teach("agent-1", "Seek", target="lamp").pick("Up").advance(2)
    assert [s.content for s in driver.automaton.states] == [Start(), Basic("Up")]
    assert (driver.taught, driver.place()) == (["start>up", "up>up+"], 2.0)


def test_the_same_behavior_bound_in_another_way_is_another_state() -> None:
    driver = Driver().teach("agent-1", "Seek", target="lamp")
    driver.pick(Basic("Toward", to("lamp"))).advance()
    driver.pick(Basic("Toward", {"target": Parameter("target")})).advance()
    driver.pick(Basic("Toward", to("lamp")))
    assert driver.taught[-2:] == ["toward-2>toward", "toward>toward+"]


def test_the_state_that_a_pick_added_goes_with_the_pick() -> None:
    driver = Driver().teach("agent-1", "Seek", target="lamp").flag("bored").undo()
    assert (driver.automaton.states[1:], driver.taught) == ((), [])


def test_the_state_that_a_pick_added_stays_as_long_as_another_pick_uses_it() -> None:
    driver = Driver().teach(("agent-1", "agent-2"), "Seek", target="lamp")
    driver.pick("Up", "agent-1").advance().pick("Up", "agent-2").advance().pick("Down", "agent-1").advance()
    driver.undo()
    assert [s.id for s in driver.automaton.states] == [START, "up"]
    driver.undo()
    assert [s.id for s in driver.automaton.states] == [START, "up"]


def test_a_parameter_means_its_target_while_it_is_taught() -> None:
    driver = Driver().teach("agent-2", "Seek", target="lamp")
    driver.pick(Basic("Toward", {"target": Parameter("target")})).advance(50)
    assert driver.place(2) == 50.0
    assert driver.examples[0].values == {"distance": 40.0}


# ------------------------------------------------------------------------------------- a second pick before the tick


def test_a_second_pick_before_the_tick_replaces_the_first() -> None:
    driver = lesson().pick("up").pick("down")
    assert driver.taught == ["start>down", "down>down+"]
    assert driver.does(2) == ["Down", "Down"]


def test_a_replaced_pick_is_reported_as_taken_back() -> None:
    driver = lesson().pick("up")
    driver.session.send(Pick("agent-1", "down"))
    assert [type(event) for event in driver.session.events()] == [TakenBack, Picked, Demonstrated]


def test_a_replaced_pick_takes_the_state_along_that_it_added() -> None:
    driver = Driver().teach("agent-1", "Seek", target="lamp").pick("Up").pick("Down").advance()
    assert [s.id for s in driver.automaton.states] == [START, "down"]


def test_the_state_that_a_replaced_pick_added_can_be_picked_again_by_its_id() -> None:
    driver = Driver().teach("agent-1", "Seek", target="lamp").pick("Up").pick("up").advance(2)
    assert (driver.taught, driver.place()) == (["start>up", "up>up+"], 2.0)


def test_a_second_pick_after_the_tick_is_one_more() -> None:
    driver = lesson().pick("up").advance().pick("down")
    assert driver.taught == ["start>up", "up>up+", "up>down", "down>down+"]


def test_picks_for_other_nodes_do_not_replace_each_other() -> None:
    driver = Driver().teach(("agent-1", "agent-2"), "Shuttle").pick("up", "agent-1").pick("down", "agent-2")
    driver.advance(3)
    assert (driver.place(1), driver.place(2)) == (3.0, 7.0)
    assert driver.taught == ["start>up", "up>up+", "start>down", "down>down+"]


# ---------------------------------------------------------------------------------------- several agents in turn


def test_several_agents_are_taught_in_turn() -> None:
    driver = Driver().teach(("agent-1", "agent-2"), "Shuttle").pick("up", "agent-2").advance(2)
    driver.pick("down", "agent-2").pick("up", "agent-1").advance(2)
    assert [(e.node, e.tick, e.source, e.label) for e in driver.examples if not e.continuation] == [
        ("agent-2", 0, START, "up"),
        ("agent-2", 2, "up", "down"),
        ("agent-1", 2, START, "up"),
    ]


def test_teaching_another_agent_begins_another_lesson() -> None:
    driver = lesson().pick("up").advance(2).teach("agent-2", "Shuttle").advance(2)
    assert [driver.view(node).taught for node in ("agent-1", "agent-2")] == [False, True]
    assert (driver.place(1), driver.acts) == (2.0, [])


# ------------------------------------------------------------------------------------------- what examples keep


def test_each_example_refers_to_the_moment_it_was_recorded_in_which_is_stored_once() -> None:
    driver = lesson().pick("up").advance(3).pick("down")
    snapshots = [e.snapshot for e in driver.examples]
    assert snapshots[0] == snapshots[1] != snapshots[2] == snapshots[3]
    assert set(driver.project.moments) == set(snapshots)
    moment = driver.project.moments[snapshots[2]]
    assert (moment.scenario, moment.arm, moment.world["x"][0]) == ("corridor", "alone", 3.0)


def test_examples_of_one_pick_share_its_number_and_count_up() -> None:
    driver = lesson().pick("up").advance().pick("jump").advance().pick("down")
    assert [(e.id, e.pick) for e in driver.examples] == [("1", 1), ("2", 1), ("3", 2), ("4", 3), ("5", 3)]


def test_examples_are_filed_under_the_demonstration() -> None:
    driver = lesson(demonstration="shuttle-1").pick("up")
    assert {e.demonstration for e in driver.examples} == {"shuttle-1"}


def test_a_feature_added_during_the_lesson_is_recorded_from_then_on() -> None:
    driver = lesson().pick("up").advance()
    driver.edit(add_feature, "agent", "Shuttle", FlagUp("failed")).advance().pick("down")
    assert [len(e.values) for e in driver.examples] == [3, 3, 4, 4]


# ------------------------------------------------------------------------------- flags of what is run meanwhile


def test_a_flag_of_the_sub_behavior_stays_up_until_the_next_pick_is_carried_out() -> None:
    driver = lesson().pick("signal").advance(6).pick("up").advance().pick("down")
    assert [e.values["done"] for e in driver.examples if not e.continuation] == [0.0, 1.0, 0.0]


def test_a_sub_behavior_with_parameters_of_the_automaton_sees_their_targets() -> None:
    inner = automaton(
        "Inner",
        state("go", "Toward", {"target": Parameter("goal")}),
        parameters=("goal",),
        features=features(ticks=TicksInState()),
    )
    outer = automaton("Outer", nested("inner", "Inner", {"goal": Parameter("place")}), parameters=("place",))
    made = project(replace(inner, rules=()), outer)
    driver = Driver(made).teach("agent-1", "Outer", place="lamp").pick("inner").advance(2)
    assert driver.state() == "inner/start"


def test_raising_a_flag_by_name_adds_a_flag_state() -> None:
    driver = Driver().teach("agent-1", "Seek", target="lamp").flag("bored").advance()
    assert driver.automaton.states[1].content == RaiseFlag("bored")
    assert (driver.taught, driver.view().flags) == (["start>bored"], frozenset({"bored"}))
