"""Controllers are taught in the same way as agents: what is picked for them, their subsidiaries do (paper, section 3.2)."""

from app.core.automaton import START
from app.core.edits import add_feature
from app.core.features import FlagUp, Operation, Over, Sense, Source, Statistic
from app.core.vocabulary import DONE, FINISHED
from tests.corridor import features, lead, project
from tests.driver import Driver
from tests.samples import GROUP, automaton, nested, state


def group_lesson(*more: Source) -> Driver:
    made = project()
    for source in more:
        made, _ = add_feature(made, GROUP, "Lead", source)
    return Driver(made, "groups").teach("group-1", "Lead")


def test_the_subsidiaries_of_a_taught_controller_do_what_is_picked_for_it() -> None:
    driver = group_lesson().pick("down").advance()
    assert [driver.view(agent).basic for agent in ("agent-1", "agent-2")] == ["Down", "Down"]
    driver.pick("signal").advance()
    assert [driver.view(agent).behavior for agent in ("agent-1", "agent-2")] == ["Signal", "Signal"]


def test_the_subsidiaries_of_other_controllers_idle_meanwhile() -> None:
    driver = group_lesson().pick("up").advance(5)
    assert [driver.place(k) for k in (1, 2, 3, 4)] == [5.0, 15.0, 20.0, 30.0]


def test_each_pick_for_a_controller_records_a_transition_and_its_continuation() -> None:
    driver = group_lesson().pick("up").advance(3).pick("down")
    assert driver.taught == ["start>up", "up>up+", "up>down", "down>down+"]


def test_picking_a_behavior_of_the_subsidiaries_that_the_controller_lacks_adds_a_state() -> None:
    driver = group_lesson().pick("Stroll").advance(2)
    assert driver.taught == ["start>stroll", "stroll>stroll+"]
    assert driver.view("agent-2").behavior == "Stroll"


def test_a_behavior_that_runs_once_is_directed_once_and_records_no_continuation() -> None:
    driver = group_lesson().pick("Jump").advance(4)
    assert (driver.taught, driver.place(1)) == (["start>jump"], 5.0)


def test_picking_the_current_one_shot_again_directs_again_and_records_nothing() -> None:
    driver = group_lesson().pick("Jump").advance(2).pick("jump").advance(2)
    assert (driver.taught, driver.place(1)) == (["start>jump"], 10.0)


def test_a_controllers_examples_hold_its_statistics() -> None:
    driver = group_lesson(
        Statistic(Operation.MEAN, Sense("Place")),
        Statistic(Operation.COUNT, FlagUp(DONE), Over.SUBSIDIARIES),
        Sense("SomeoneAtEnd"),
    )
    driver.pick("signal").advance(4).pick("up")
    assert list(driver.examples[0].values.values()) == [5.0, 0.0, 0.0]
    assert list(driver.examples[2].values.values()) == [8.0, 2.0, 0.0]


def test_a_continuation_sees_the_flags_of_those_who_are_directed_anew_lowered() -> None:
    driver = group_lesson(Statistic(Operation.ANY, FlagUp(DONE)), Statistic(Operation.ALL, FlagUp(FINISHED)))
    driver.pick("Leave").advance(2).pick("up")
    (_, went, stays) = driver.examples
    assert list(went.values.values()) == [1.0, 1.0]
    assert list(stays.values.values()) == [0.0, 0.0]


def test_what_a_continuation_sees_is_what_the_controller_sees_in_the_next_tick() -> None:
    done = Statistic(Operation.COUNT, FlagUp(DONE))
    finished = Statistic(Operation.COUNT, FlagUp(FINISHED))
    inner = automaton("Inner", state("up", "Up"))
    outer = automaton(
        "Outer",
        state("leave", "Leave"),
        nested("inner", "Inner"),
        features=features(done=done, finished=finished),
    )
    made = project()
    group = {a.id: a for a in (lead(), inner, outer)}
    libraries = {**made.libraries, GROUP: type(made.library(GROUP))(group)}
    driver = Driver(project(libraries=libraries), "groups").teach("group-1", "Outer")
    driver.pick("leave").advance(2).pick("inner")  # directs nobody, but ends what was directed
    assert driver.examples[-2].values == {"done": 2.0, "finished": 2.0}
    stays = driver.examples[-1].values
    driver.advance().pick("leave")
    assert stays == driver.examples[-1].values == {"done": 0.0, "finished": 2.0}


def test_a_controller_of_controllers_is_taught_through_all_levels() -> None:
    driver = Driver(arm="squads").teach("squad-1", "Command").pick("Up").advance(3)
    assert [driver.view(f"group-{k}").basic for k in (1, 2)] == ["Up", "Up"]
    assert [driver.place(k) for k in (1, 2, 3, 4)] == [3.0, 13.0, 23.0, 33.0]


def test_a_group_below_a_squad_is_taught_while_the_squad_does_not_tick() -> None:
    driver = Driver(arm="squads").teach("group-2", "Lead").pick("down").advance(4)
    assert [driver.state(node) for node in ("squad-1", "group-2")] == [START, "down"]
    assert [driver.place(k) for k in (1, 2, 3, 4)] == [0.0, 10.0, 16.0, 26.0]


def test_in_a_test_all_controllers_of_the_type_run_what_was_learned() -> None:
    driver = group_lesson(Sense("SomeoneAtEnd")).pick("up").advance(3).test().advance(4)
    assert [driver.place(k) for k in (1, 2, 3, 4)] == [7.0, 17.0, 24.0, 34.0]


def test_a_correction_returns_only_the_picked_controller_to_training() -> None:
    driver = group_lesson(Sense("SomeoneAtEnd")).pick("up").advance(3).test().advance(2)
    driver.pick("down", "group-2").advance(2)
    assert [driver.view(f"group-{k}").taught for k in (1, 2)] == [False, True]
    assert [driver.view(f"agent-{k}").basic for k in (1, 2, 3, 4)] == ["Up", "Up", "Down", "Down"]


def test_a_controller_should_not_have_left_its_state() -> None:
    driver = group_lesson(Statistic(Operation.ANY, FlagUp(DONE)))
    driver.pick("signal").advance(4).pick("down").advance().test().advance(8)
    assert driver.state("group-1") == "down"
    driver.should_not_have_left("group-1").advance()
    assert driver.taught[-1] == "signal>signal"
    assert list(driver.examples[-1].values.values()) == [1.0]
    assert driver.view("agent-1").behavior == "Signal"
    assert driver.view("agent-3").basic == "Down"
