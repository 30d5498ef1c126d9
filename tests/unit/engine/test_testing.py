"""Testing mode, corrections in the middle of a test, and mending what already happened (paper, section 3.1)."""

from dataclasses import replace

import pytest

from app.core.automaton import START, Automaton, Refit, Settings
from app.core.edits import bind_state, disable_examples, enable_examples, remove_state
from app.core.features import FlagUp
from app.engine.commands import MoveEntities, Others, Pick, Play, ShouldNotHaveLeft
from app.engine.commands import Test as LearnAndTest
from app.engine.snapshots import Mode, Relearned
from tests.corridor import PLACE, project, to
from tests.driver import Driver
from tests.samples import automaton, flag, state


def pacer(**fields: object) -> Automaton:
    """Looks at its place alone."""
    return automaton("Pacer", state("up", "Up"), state("down", "Down"), features=(PLACE,), **fields)


def in_a_test(arm: str = "alone", others: Others = Others.IDLE, **fields: object) -> Driver:
    """All agents test this: up to place 4, then down to place 1, then up again.

    What holds at places 2 and 3 depends on the state; the cuts lie next to the transitions.
    """
    driver = Driver(project(pacer(**fields)), arm)
    driver.teach("agent-1", "Pacer", others).pick("up").advance(4).pick("down").advance(3).pick(
        "up"
    ).advance()
    return driver.test()


# --------------------------------------------------------------------------------------- learn, then all run it


def test_a_test_learns_what_was_taught() -> None:
    driver = in_a_test()
    assert set(driver.automaton.learned) == {START, "up", "down"}
    assert driver.mode is Mode.TESTING


def test_in_a_test_all_nodes_of_the_type_run_what_was_learned_from_start() -> None:
    driver = in_a_test()
    assert [driver.state(node) for node in ("agent-1", "agent-2")] == [START, START]
    driver.advance()
    assert [driver.view(node).behavior for node in ("agent-1", "agent-2")] == ["Pacer", "Pacer"]
    assert [driver.state(node) for node in ("agent-1", "agent-2")] == ["up", "up"]
    assert not any(view.taught for view in driver.snapshot.nodes.values())


def test_a_tested_node_follows_what_it_has_learned() -> None:
    driver = in_a_test()  # agent 1 stands at place 2
    assert driver.does(6) == ["Up", "Up", "Down", "Down", "Down", "Up"]


def test_a_parameter_means_its_target_for_all_tested_nodes() -> None:
    driver = Driver().teach("agent-1", "Seek", target="lamp").pick("Up").advance(3).test().advance(3)
    assert [driver.place(1), driver.place(2)] == [6.0, 13.0]


def test_in_a_test_ancestors_of_the_tested_do_not_tick() -> None:
    driver = in_a_test("squads").advance(5)
    assert [driver.state(node) for node in ("squad-1", "group-1")] == [START, ""]


@pytest.mark.parametrize(("others", "steps"), [(Others.IDLE, 0.0), (Others.RUN, 6.0)])
def test_in_a_test_nodes_of_other_types_idle_or_by_the_switch_run(others: Others, steps: float) -> None:
    driver = Driver(arm="groups").advance(2)  # both groups direct their agents to stroll
    driver.teach("group-1", "Lead", Others.IDLE).pick("up").advance().test()
    driver.teach("group-2", "Lead", others).pick("down")
    before = driver.place(1)
    driver.advance(6)
    assert driver.place(1) - before == steps


def test_time_stands_still_while_it_learns() -> None:
    driver = in_a_test()
    driver.session.send(Play())
    driver.session.send(LearnAndTest())
    assert (driver.mode, driver.session.playing) == (Mode.LEARNING, False)
    driver.session.settle()
    assert (driver.mode, driver.session.playing) == (Mode.TESTING, True)


def test_what_was_learned_is_reported() -> None:
    driver = Driver(project(pacer())).teach("agent-1", "Pacer").pick("up").advance()
    driver.session.send(LearnAndTest())
    driver.session.settle()
    (event,) = driver.session.events()
    assert isinstance(event, Relearned)
    assert set(event.learned.automata) == {("agent", "Pacer")}


def test_a_test_without_examples_says_so_and_leaves_the_session_teaching() -> None:
    driver = Driver().teach("agent-1", "Shuttle").advance(2)
    assert "no examples to learn from" in driver.refused(LearnAndTest())
    assert driver.mode is Mode.TEACHING
    assert driver.pick("up").advance(2).place() == 2.0


def test_a_pick_that_waits_when_the_test_begins_is_learned_from_but_not_carried_out() -> None:
    driver = Driver(project(pacer())).teach("agent-1", "Pacer").pick("up").test()
    assert driver.acts == ["up"]
    assert driver.does(2) == ["Up", "Up"]


def test_a_disabled_example_is_not_learned_from_until_it_is_enabled_again() -> None:
    driver = in_a_test().edit(disable_examples, "agent", "Pacer", ["3", "4"]).test().reset()
    assert driver.does(6) == ["Up"] * 6
    driver.edit(enable_examples, "agent", "Pacer", ["3", "4"]).test().reset()
    assert driver.does(6) == ["Up"] * 4 + ["Down"] * 2


# ------------------------------------------------------------------------------------ correcting during a test


def test_a_pick_during_a_test_returns_the_picked_node_and_only_it_to_training_at_that_instant() -> None:
    driver = in_a_test().advance()
    driver.pick("down", "agent-2")
    assert [driver.view(node).taught for node in ("agent-1", "agent-2")] == [False, True]
    assert driver.mode is Mode.TESTING
    assert driver.does(4, "agent-1") == ["Up", "Down", "Down", "Down"]
    assert driver.state("agent-2") == "down"


def test_a_pick_during_a_test_records_the_correction() -> None:
    driver = in_a_test().advance()
    before = len(driver.taught)
    driver.pick("down", "agent-2")
    assert driver.taught[before:] == ["up>down", "down>down+"]
    assert driver.examples[before].values == {"place": 11.0}


def test_picking_the_current_behavior_during_a_test_records_that_it_is_right() -> None:
    driver = in_a_test().advance()
    assert driver.pick("up").taught[-1] == "up>up"
    assert driver.advance(9).state() == "up"


def test_a_correction_can_be_picked_for_any_node_of_the_type() -> None:
    driver = in_a_test("groups").advance()
    for node in ("agent-1", "agent-4"):
        assert driver.pick("down", node).view().taught


def test_a_corrected_node_stays_in_training_until_the_next_test() -> None:
    driver = in_a_test().advance().pick("up").advance(20)
    assert driver.view().taught
    driver.test().advance()
    assert not driver.view().taught


def test_a_correction_is_learned_from_in_the_next_test() -> None:
    driver = in_a_test().reset().advance(3)
    assert (driver.state(), driver.place()) == ("up", 3.0)
    driver.pick("down").advance().test().reset()
    assert driver.does(5) == ["Up"] * 3 + ["Down"] * 2


# ------------------------------------------------------------------------------------- should not have left


def test_should_not_have_left_records_a_stay_with_the_values_of_that_transition() -> None:
    driver = in_a_test().advance(4)  # it left up at place 4, and is at place 2 now
    assert driver.place() == 2.0
    driver.should_not_have_left()
    mended = driver.examples[-1]
    assert (mended.source, mended.label, mended.continuation) == ("up", "up", False)
    assert mended.values == {"place": 4.0}


def test_should_not_have_left_refers_to_the_tick_and_moment_of_that_transition() -> None:
    driver = in_a_test().advance(2)
    tick = driver.snapshot.tick
    mended = driver.advance(3).should_not_have_left().examples[-1]
    assert mended.tick == tick
    moment = driver.project.moments[mended.snapshot]
    assert (moment.world["x"][0], moment.machine["nodes"]["agent-1"]["run"]["state"]) == (4.0, "up")  # type: ignore[index]  # as it was written


def test_should_not_have_left_takes_the_node_back_there_and_only_it_into_training() -> None:
    driver = in_a_test().advance(4)
    assert driver.state() == "down"
    driver.should_not_have_left().advance()
    assert [driver.view(node).taught for node in ("agent-1", "agent-2")] == [True, False]
    assert driver.state() == "up"
    assert driver.does(5) == ["Up"] * 5


def test_should_not_have_left_is_about_the_last_state_that_the_node_left() -> None:
    driver = in_a_test().advance(6)  # up, down, up again
    assert driver.state() == "up"
    assert driver.should_not_have_left().taught[-1] == "down>down"


def test_should_not_have_left_is_not_about_leaving_start_since_no_example_leads_there() -> None:
    driver = Driver(project(automaton("Bell", state("up", "Up"), flag("over"), features=(PLACE,))))
    driver.teach("agent-1", "Bell").pick("up").advance(3).pick("over").advance().test()
    assert driver.advance().state() == "up"
    assert "has left no state by itself" in driver.refused(ShouldNotHaveLeft("agent-1"))
    assert [driver.advance().state(), driver.advance().state()] == [START, "up"]  # it has raised the flag
    assert driver.should_not_have_left().taught[-1] == "up>up"


def test_should_not_have_left_is_mended_once() -> None:
    driver = in_a_test().advance(4).should_not_have_left().advance()
    assert "has left no state by itself" in driver.refused(ShouldNotHaveLeft("agent-1"))


def test_saying_it_twice_before_the_tick_changes_nothing() -> None:
    driver = in_a_test().advance(4).should_not_have_left()
    assert "has left no state by itself" in driver.refused(ShouldNotHaveLeft("agent-1"))
    assert driver.advance().state() == "up"


def test_a_pick_before_the_tick_replaces_should_not_have_left_which_can_be_said_again() -> None:
    driver = in_a_test().advance(4)
    before = driver.taught
    driver.should_not_have_left().pick("up")
    assert driver.taught == [*before, "down>up", "up>up+"]
    assert driver.should_not_have_left().taught == [*before, "up>up"]


def test_should_not_have_left_is_refused_where_no_node_left_a_state_by_itself() -> None:
    driver = Driver().teach("agent-1", "Shuttle").pick("up").advance().pick("down").advance()
    assert "has left no state by itself" in driver.refused(ShouldNotHaveLeft("agent-1"))


def test_should_not_have_left_is_refused_for_a_state_that_is_gone() -> None:
    driver = in_a_test().advance(4)
    driver.edit(remove_state, "agent", "Pacer", "up")
    assert "'up', which is gone" in driver.refused(ShouldNotHaveLeft("agent-1"))


def test_should_not_have_left_is_refused_for_a_state_whose_target_is_open_now() -> None:
    seeker = automaton("Seeker", state("go", "Toward", to("lamp")), state("up", "Up"), features=(PLACE,))
    driver = Driver(project(seeker)).teach("agent-1", "Seeker").pick("go").advance(4).pick("up").advance()
    driver.test().reset().advance(7)
    driver.edit(bind_state, "agent", "Seeker", "go", "target", None)
    assert "'target' of state 'go' of 'Seeker' is open" in driver.refused(ShouldNotHaveLeft("agent-1"))


def test_a_mended_transition_is_learned() -> None:
    driver = in_a_test().advance(4).should_not_have_left().test()
    up = driver.automaton.learned["up"]
    assert up.decide(lambda _: 4.0).probabilities == (0.5, 0.5)  # type: ignore[union-attr]  # of trees


def test_what_was_left_in_an_earlier_test_is_not_mended_in_the_next() -> None:
    driver = in_a_test().advance(4).test()
    assert "has left no state by itself" in driver.refused(ShouldNotHaveLeft("agent-1"))


# -------------------------------------------------------------------------------- models without a table form


def test_a_model_that_is_fitted_again_does_not_change_before_the_next_test() -> None:
    driver = in_a_test(settings=Settings(classifier="knn", options={"neighbors": 1})).reset()
    assert driver.automaton.learned["up"] == Refit("knn")
    driver.send(MoveEntities({1: (0.0, 0.0)})).advance(2).pick("down", "agent-2")  # where agent 1 is, too
    assert driver.advance().view("agent-1").basic == "Up"
    driver.test().reset()
    assert driver.does(3, "agent-1") == ["Up", "Up", "Down"]


def test_flags_are_tested_like_any_feature() -> None:
    lesson = automaton(
        "Twice",
        *project().library("agent").get("Shuttle").states[5:6],
        state("down", "Down"),
        features=(replace(PLACE, id="done", source=FlagUp("done")),),
    )
    driver = Driver(project(lesson)).teach("agent-1", "Twice")
    driver.pick("signal").advance(6).pick("down").advance(2).test()
    assert driver.does(6, "agent-2") == ["Up", "Up", "Up", "", "Down", "Down"]


def test_a_session_with_a_lesson_does_not_wait_for_answers_that_nobody_asked_for() -> None:
    driver = in_a_test()
    driver.session.send(Pick("agent-1", "up"))
    driver.session.settle()
    assert driver.mode is Mode.TESTING
