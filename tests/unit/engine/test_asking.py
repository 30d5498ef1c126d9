"""While testing, the session stops and asks before a node does what it is not sure of."""

from dataclasses import replace
from math import inf, nan

import pytest

from app.core.automaton import Settings
from app.core.edits import delete_automaton, disable_examples, remove_state
from app.core.project import Project
from app.engine.commands import (
    AskMe,
    Command,
    LetGo,
    MoveEntities,
    Others,
    Pause,
    Pick,
    Play,
    RedoMove,
    Reset,
    RunArm,
    Step,
    Teach,
    UndoMove,
    UndoPick,
    UseArm,
    UseProject,
)
from app.engine.commands import Test as LearnAndTest
from app.engine.snapshots import Asked, Mode, Moved
from tests.corridor import AT_END, PLACE, project
from tests.driver import UNCOMPILED, Driver
from tests.samples import AGENT, GROUP, automaton, state

WAVER = (AGENT, "Waver")
ALL = ("agent-1", "agent-2")


def wavering() -> Project:
    """Looks at nothing that tells its two examples of what comes after up apart."""
    waver = automaton("Waver", state("up", "Up"), state("down", "Down"), features=(AT_END,))
    pacer = automaton("Pacer", state("up", "Up"), state("down", "Down"), features=(PLACE,))
    return project(waver, pacer)


def in_doubt(*nodes: str, below: float | None = 0.9, beyond: float | None = None, seed: int = 1) -> Driver:
    """A test of Waver: from up, one of two examples stays and the other goes down."""
    driver = Driver(wavering(), seed=seed).teach("agent-1", "Waver")
    driver.pick("up").advance(2).pick("down").advance(2).test()
    return driver.send(AskMe(nodes or ("agent-1",), below, beyond))


def asked(driver: Driver) -> Asked:
    found = driver.snapshot.asked
    assert found is not None
    return found


# ------------------------------------------------------------------------------------------ being asked


def test_time_stops_before_a_node_does_what_it_is_not_sure_of() -> None:
    driver = in_doubt().advance(10)
    question = asked(driver)
    assert driver.told == [question]
    assert (question.node, question.type, question.automaton, question.state) == ("agent-1", *WAVER, "up")
    assert (question.outcome, question.confidence) == ((("up", 0.5), ("down", 0.5)), 0.5)
    assert question.values == {"end": 0.0}
    assert driver.snapshot.tick == 5  # four of the lesson, and one into up
    assert driver.advance(3).snapshot.tick == 5


def test_the_question_says_why_in_words() -> None:
    assert asked(in_doubt().advance(2)).reason == "Agent 1 is not sure what comes after up: up 50%, down 50%"


def test_while_asked_the_speed_is_zero_and_nothing_plays() -> None:
    driver = in_doubt()
    driver.send(Play(4.0)).advance(2)
    assert (driver.snapshot.speed, driver.session.playing) == (0.0, False)


def test_playing_and_stepping_are_refused_until_there_is_an_answer() -> None:
    driver = in_doubt().advance(2)
    for command in (Play(), Step()):
        assert driver.refused(command).endswith("let it decide by itself; then time goes on")


def test_only_the_nodes_wished_for_are_asked_about() -> None:
    driver = in_doubt("agent-2").advance(2)
    assert asked(driver).node == "agent-2"
    assert in_doubt("nobody", "group-1").advance(2).told == []


@pytest.mark.parametrize("below", [None, 0.5])
def test_a_node_that_is_sure_enough_is_not_asked_about(below: float | None) -> None:
    assert in_doubt(below=below, beyond=None if below else 2.0).advance(5).told == []


def test_without_a_wish_nobody_is_asked() -> None:
    driver = Driver(wavering()).teach("agent-1", "Waver").pick("up").advance(2).pick("down").advance().test()
    assert driver.advance(5).told == []


@pytest.mark.parametrize("mode", ["running", "teaching"])
def test_nobody_is_asked_outside_of_a_test(mode: str) -> None:
    driver = in_doubt()
    driver.run() if mode == "running" else driver.teach("agent-1", "Waver")
    assert driver.advance(5).told == []


# --------------------------------------------------------------------------------------- beyond the examples


def far(beyond: float = 0.3) -> Driver:
    """A test of Pacer, whose examples are at places 0 to 8; agent 2 has just gone up to 11."""
    driver = Driver(wavering()).teach("agent-1", "Pacer").pick("up").advance(8).pick("down").advance()
    driver.pick("up").advance().test().advance()
    return driver.send(AskMe(("agent-2",), None, beyond))


def test_a_situation_far_from_all_examples_is_asked_about_with_its_distance() -> None:
    driver = far().advance(20)
    question = asked(driver)
    assert (question.node, question.state, question.values) == ("agent-2", "up", {"place": 11.0})
    nearest, scale = 8.0, 8.0
    assert question.distance == (11.0 - nearest) / scale
    assert question.reason == "Agent 2 was never shown anything like this in up: Place is 11 steps"


def test_a_situation_like_an_example_is_not() -> None:
    assert far(beyond=0.4).advance(20).told == []


def test_a_state_without_any_example_is_infinitely_far() -> None:
    driver = Driver(wavering()).teach("agent-1", "Pacer").pick("up").advance(2).test()
    ids = [example.id for example in driver.examples if example.source == "up"]
    driver.edit(disable_examples, AGENT, "Pacer", ids).send(AskMe(("agent-1",), None, 3.0)).advance(3)
    assert (asked(driver).distance, asked(driver).state) == (inf, "up")
    assert asked(driver).reason == "Agent 1 was never shown what comes after up"


# ------------------------------------------------------------------------------------------- answering


def test_a_pick_answers_is_recorded_and_hands_the_node_back_after_its_tick() -> None:
    driver = in_doubt().send(Play(2.0)).advance(2)
    before = len(driver.examples)
    driver.pick("down")
    assert driver.snapshot.asked is None
    assert (driver.snapshot.speed, driver.session.playing) == (2.0, True)
    assert [e.label for e in driver.examples[before:]] == ["down", "down"]
    assert driver.view().taught
    driver.advance()
    assert (driver.state(), driver.view().taught) == ("down", False)
    assert driver.mode is Mode.TESTING


def test_the_rest_of_a_step_passes_after_the_answer() -> None:
    driver = in_doubt().send(Step(4)).advance(4)
    assert (driver.session.due, driver.snapshot.tick) == (0, 5)
    driver.pick("down")
    assert driver.session.due == 3


def test_a_pause_meanwhile_stays_a_pause() -> None:
    driver = in_doubt().send(Play(2.0)).advance(2).send(Pause()).pick("down")
    assert driver.snapshot.speed == 0.0


def test_should_not_have_left_answers_too() -> None:
    driver = far(0.1).advance().send(LetGo()).advance(2)
    assert asked(driver).state == "down"
    driver.should_not_have_left("agent-2")
    assert (driver.snapshot.asked, driver.taught[-1]) == (None, "up>up")
    assert driver.advance().state("agent-2") == "up"


def test_a_pick_for_another_node_leaves_the_question_open() -> None:
    driver = in_doubt().advance(2).pick("down", "agent-2")
    assert asked(driver).node == "agent-1"


def test_a_refused_pick_leaves_the_question_open() -> None:
    driver = in_doubt().advance(2)
    driver.refused(Pick("agent-1", "nowhere"))
    assert asked(driver).node == "agent-1"


def test_let_go_records_nothing_and_the_same_is_not_asked_again() -> None:
    driver = in_doubt().send(Play()).advance(2)
    before = driver.examples
    driver.send(LetGo())
    assert (driver.snapshot.asked, driver.session.speed) == (None, 1.0)
    driver.advance(20)
    assert [question.state for question in driver.told if isinstance(question, Asked)] == ["up"]
    assert driver.examples == before


def test_let_go_is_for_one_node_and_one_state() -> None:
    driver = in_doubt(*ALL).advance(2).send(LetGo()).advance()
    assert asked(driver).node == "agent-2"


def test_a_new_test_asks_again() -> None:
    driver = in_doubt().advance(2).send(LetGo()).advance(2).test().advance(2)
    assert len(driver.told) == 2


def test_a_reset_goes_on_with_the_same_test_so_it_does_not_ask_again() -> None:
    assert len(in_doubt().advance(2).send(LetGo()).reset().advance(5).told) == 1


def test_nothing_is_let_go_where_nothing_is_asked() -> None:
    assert in_doubt().refused(LetGo()) == "nothing is asked now, so there is nothing to let go"


# ------------------------------------------------------------------------------- while the question is open


@pytest.mark.parametrize(
    "command",
    [
        Reset(),
        RunArm(),
        UseArm("groups", UNCOMPILED),
        Teach(AGENT, "Waver", ("agent-2",)),
        LearnAndTest(),
        AskMe(),
        AskMe(("agent-1",), None, None),
        AskMe(("agent-1",), 0.2, None),
    ],
    ids=repr,
)
def test_what_ends_the_question_lets_time_go_on_as_before(command: Command) -> None:
    driver = in_doubt().send(Play(3.0)).advance(2)
    driver.send(command)
    assert (driver.snapshot.asked, driver.session.speed) == (None, 3.0)


def test_moving_what_it_sees_changes_the_question() -> None:
    driver = far().advance(20)
    first = asked(driver)
    driver.send(MoveEntities({1: (30.0, 0.0)}))
    assert asked(driver).values == {"place": 30.0}
    assert driver.told[-1] == asked(driver) != first


def test_moving_what_it_sees_back_among_the_examples_closes_the_question_and_time_waits() -> None:
    driver = far().send(Play()).advance(20).send(MoveEntities({1: (6.0, 0.0)}))
    assert (driver.snapshot.asked, driver.session.speed) == (None, 0.0)
    (move,) = [event for event in driver.told if isinstance(event, Moved)]
    driver.send(UndoMove(move.number))
    assert driver.snapshot.asked is None  # time has been told to wait: it asks when it goes on
    assert isinstance(driver.advance().told[-1], Asked)
    driver.send(RedoMove(move.number))
    assert driver.snapshot.asked is None
    assert driver.reset().session.speed == 0.0


def test_taking_back_the_pick_before_asks_about_what_is_then() -> None:
    driver = in_doubt().advance(2).pick("down").advance()
    driver.send(AskMe(("agent-1",), 1.0, None)).advance(3)
    driver.send(UndoPick())
    question = driver.snapshot.asked
    assert question is None or question.state == driver.state()


def test_a_state_or_behavior_that_is_deleted_under_a_question_closes_it() -> None:
    driver = in_doubt().advance(2).edit(remove_state, *WAVER, "up")
    assert driver.snapshot.asked is None
    driver = in_doubt().advance(2).edit(delete_automaton, *WAVER)
    assert (driver.snapshot.asked, driver.mode) == (None, Mode.RUNNING)


def test_the_same_project_again_leaves_the_question_as_it_is() -> None:
    driver = in_doubt().advance(2)
    first = asked(driver)
    driver.send(UseProject(driver.project))
    assert (asked(driver), len(driver.told)) == (first, 1)


# ------------------------------------------------------------------------------------------- no difference


@pytest.mark.parametrize("others", list(Others))
def test_looking_ahead_changes_nothing(others: Others) -> None:
    looked, plain = in_doubt(*ALL, below=0.1, beyond=9.0, seed=5), in_doubt(*ALL, below=None, seed=5)
    for driver in (looked, plain):
        driver.advance(60)
    assert looked.look() == plain.look()


def test_letting_all_go_changes_nothing() -> None:
    asking, plain = in_doubt(*ALL, seed=5), in_doubt(*ALL, below=None, seed=5)
    while asking.snapshot.tick < plain.snapshot.tick + 60:
        if asking.snapshot.asked is not None:
            asking.send(LetGo())
        asking.advance()
    plain.advance(60)
    assert asking.look() == plain.look()


def test_groups_are_asked_about_as_agents_are() -> None:
    driver = (
        Driver(arm="squads").teach("group-1", "Lead").pick("up").advance(2).pick("down").advance(2).test()
    )
    driver.send(AskMe(("group-2",), 0.9, None)).advance(3)
    assert (asked(driver).node, asked(driver).type, asked(driver).reason) == (
        "group-2",
        GROUP,
        "Group 2 is not sure what comes after up: up 50%, down 50%",
    )


def test_a_model_that_is_no_tree_is_asked_about_as_well() -> None:
    made = wavering()
    waver = made.library(AGENT).get("Waver")
    knn = replace(waver, settings=Settings("knn", options={"neighbors": 2.0}))
    library = replace(made.library(AGENT), automata={**made.library(AGENT).automata, "Waver": knn})
    driver = Driver(replace(made, libraries={**made.libraries, AGENT: library})).teach("agent-1", "Waver")
    driver.pick("up").advance(2).pick("down").advance(2).test().send(AskMe(ALL, 0.9, None)).advance(3)
    assert asked(driver).confidence == 0.5


@pytest.mark.parametrize(
    ("wish", "message"),
    [
        (AskMe(ALL, 0.0, None), "asking below a probability of 0.0; allowed: above 0, up to 1"),
        (AskMe(ALL, 1.5, None), "asking below a probability of 1.5; allowed: above 0, up to 1"),
        (AskMe(ALL, nan, None), "asking below a probability of nan; allowed: above 0, up to 1"),
        (AskMe(ALL, None, -1.0), "asking beyond a distance of -1.0; allowed: 0 or more"),
        (AskMe(ALL, None, nan), "asking beyond a distance of nan; allowed: 0 or more"),
    ],
    ids=repr,
)
def test_a_bound_that_makes_no_sense_is_refused(wish: AskMe, message: str) -> None:
    assert in_doubt().refused(wish) == message
