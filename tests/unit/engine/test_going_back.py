"""Going to any tick of a run: the world is as it was, or will be, exactly."""

from dataclasses import replace

import pytest

from app.core.automaton import Basic
from app.core.edits import add_state, delete_automaton, rename_arm
from app.engine import keyframes
from app.engine.commands import (
    Command,
    GoTo,
    MoveEntities,
    Pause,
    Play,
    Reset,
    RunArm,
    Step,
    Teach,
    UndoMove,
    UseArm,
)
from app.engine.keyframes import Timeline
from app.engine.session import Session
from app.engine.snapshots import Mode, Snapshot
from tests.driver import UNCOMPILED, Driver
from tests.samples import AGENT


@pytest.fixture(autouse=True)
def _near_keyframes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(keyframes, "SPACING", 20)
    monkeypatch.setattr(keyframes, "MOST", 6)


def at(driver: Driver, tick: int) -> Snapshot:
    """Go there, in slices as the thread does; what is seen on arrival."""
    driver.send(GoTo(tick))
    while driver.snapshot.going_to is not None:
        driver.advance(7)
    return driver.look()


def straight(ticks: int, arm: str = "squads", hand: dict[int, MoveEntities] | None = None) -> list[Snapshot]:
    """What is seen before each tick of a run that is never gone back in."""
    driver = Driver(arm=arm, seed=3)
    looks = []
    for tick in range(ticks):
        if hand and tick in hand:
            driver.send(hand[tick])
        looks.append(driver.look())
        driver.advance()
    return looks


@pytest.mark.parametrize("arm", ["alone", "groups", "squads"])
def test_a_run_is_gone_back_and_forth_in_exactly(arm: str) -> None:
    looks = straight(150, arm)
    driver = Driver(arm=arm, seed=3)
    for tick in (149, 0, 70, 71, 20, 19, 148, 149, 3, 140):
        assert at(driver, tick) == looks[tick]


def test_from_where_it_went_to_a_run_goes_on_as_it_did() -> None:
    looks = straight(100)
    driver = Driver(arm="squads", seed=3).advance(90)
    at(driver, 33)
    for tick in range(33, 100):
        assert driver.look() == looks[tick]
        driver.advance()


def test_going_to_a_tick_pauses_there() -> None:
    driver = Driver().send(Play(8.0)).advance(50)
    seen = at(driver, 12)
    assert (seen.tick, seen.speed, seen.going_to, seen.mode) == (12, 0.0, None, Mode.RUNNING)
    assert not driver.session.playing


def test_on_its_way_it_shows_how_far_it_is_and_where_it_goes() -> None:
    driver = Driver().send(GoTo(50)).advance(7)
    assert (driver.snapshot.tick, driver.snapshot.going_to) == (7, 50)
    assert driver.session.playing
    driver.advance(1_000)
    assert (driver.snapshot.tick, driver.snapshot.going_to) == (50, None)


def test_going_to_where_it_is_arrives_at_once() -> None:
    driver = Driver().advance(10).send(GoTo(10))
    assert (driver.snapshot.tick, driver.snapshot.going_to) == (10, None)


@pytest.mark.parametrize(
    ("command", "speed", "due"),
    [
        (Play(2.0), 2.0, 0),
        (Pause(), 0.0, 0),
        (Step(3), 0.0, 3),
        (Reset(), 0.0, 0),
        (UseArm("groups", UNCOMPILED), 0.0, 0),
        (Teach(AGENT, "Shuttle", ("agent-1",)), 0.0, 0),
        (RunArm(), 0.0, 0),
        (MoveEntities({0: (3.0, 0.0)}), 0.0, 0),
    ],
    ids=repr,
)
def test_another_wish_ends_the_journey_where_it_is(command: Command, speed: float, due: int) -> None:
    driver = Driver().send(GoTo(500)).advance(30).send(command)
    assert (driver.snapshot.going_to, driver.session.speed, driver.session.due) == (None, speed, due)


def test_another_journey_takes_the_place_of_the_first() -> None:
    driver = Driver().send(GoTo(500)).advance(30).send(GoTo(40))
    assert driver.advance(500).snapshot.tick == 40


def test_what_was_moved_is_moved_again_when_its_tick_comes() -> None:
    hand = {30: MoveEntities({0: (77.0, 0.0)}), 41: MoveEntities({1: (3.0, 0.0)})}
    looks = straight(100, hand=hand)
    driver = Driver(arm="squads", seed=3)
    for tick in range(90):
        if tick in hand:
            driver.send(hand[tick])
        driver.advance()
    for tick in (10, 30, 31, 41, 45, 60, 29, 99):
        assert at(driver, tick) == looks[tick]


def test_a_move_in_the_past_makes_another_future() -> None:
    driver = Driver(arm="alone", seed=3).advance(90)
    at(driver, 30)
    driver.send(MoveEntities({0: (77.0, 0.0)})).advance(30)
    after = driver.look()
    assert after == straight(61, "alone", {30: MoveEntities({0: (77.0, 0.0)})})[60]
    at(driver, 5)
    assert at(driver, 60) == after


def test_several_that_were_moved_at_once_are_moved_again_when_their_tick_comes_or_taken_back_all() -> None:
    hand = {30: MoveEntities({0: (77.0, 0.0), 1: (3.0, 0.0)})}
    looks = straight(60, hand=hand)
    driver = Driver(arm="squads", seed=3).advance(30).send(hand[30]).advance(20)
    assert at(driver, 10) == looks[10]
    assert at(driver, 50) == looks[50]
    at(driver, 10)
    driver.send(UndoMove(1))
    assert at(driver, 50) == straight(60)[50]


def test_a_move_taken_back_before_a_tick_never_was() -> None:
    looks = straight(60)
    driver = Driver(arm="squads", seed=3).advance(30).send(MoveEntities({0: (77.0, 0.0)})).send(UndoMove(1))
    driver.advance(20)
    assert at(driver, 10) == looks[10]
    assert at(driver, 50) == looks[50]


def test_a_move_that_is_still_to_come_after_going_back_is_taken_out_of_the_future() -> None:
    looks = straight(60)
    driver = Driver(arm="squads", seed=3).advance(30).send(MoveEntities({0: (77.0, 0.0)})).advance(20)
    at(driver, 10)
    driver.send(UndoMove(1))
    assert at(driver, 10) == looks[10]
    assert at(driver, 50) == looks[50]


# ------------------------------------------------------------------------------------------- what is refused


def test_a_lesson_cannot_be_gone_back_in() -> None:
    driver = Driver().advance(10).teach("agent-1", "Shuttle")
    assert driver.refused(GoTo(5)).startswith("a lesson cannot be gone back in")
    driver.pick("up").advance().test()
    assert driver.refused(GoTo(5)).startswith("a lesson cannot be gone back in")


def test_before_tick_zero_there_is_nothing() -> None:
    assert Driver().refused(GoTo(-1)) == "there is no tick -1; the first is 0"


def test_after_a_lesson_the_run_is_gone_back_in_to_where_the_arm_was_run() -> None:
    driver = Driver().advance(10).teach("agent-1", "Shuttle").pick("up").advance(5).run().advance(30)
    assert driver.refused(GoTo(14)).startswith("this run can be gone back in to tick 15, not to 14")
    assert at(driver, 15).tick == 15
    driver.reset()
    assert at(driver, 14).tick == 14


def test_after_an_edit_of_behaviors_it_is_gone_back_in_to_there() -> None:
    driver = Driver().advance(10).edit(add_state, AGENT, "Stroll", Basic("Jump")).advance(30)
    assert driver.refused(GoTo(9)).startswith("this run can be gone back in to tick 10")
    assert at(driver, 10).tick == 10


def test_a_snapshot_tells_how_far_the_run_can_be_gone_back_in() -> None:
    driver = Driver().advance(10)
    assert driver.snapshot.earliest == 0
    driver.edit(add_state, AGENT, "Stroll", Basic("Jump")).advance(3)
    assert driver.snapshot.earliest == 10
    driver.teach("agent-1", "Shuttle").advance(2)
    assert driver.snapshot.earliest == driver.snapshot.tick
    assert driver.run().advance().snapshot.earliest == driver.snapshot.tick - 1


def test_other_edits_leave_the_past_as_it_is() -> None:
    looks = straight(30, "alone")
    driver = Driver(seed=3).advance(20).edit(rename_arm, "groups", "teams")
    assert at(driver, 9) == replace(looks[9], revision=1)


def test_a_behavior_that_is_deleted_while_it_runs_gives_way_to_another_and_it_is_gone_back_in_to_there() -> (
    None
):
    driver = Driver().advance(10).edit(delete_automaton, AGENT, "Stroll", "Signal").advance(2)
    shown = driver.look()
    assert driver.view("agent-1").behavior == "Signal"
    assert at(driver.advance(5), 12) == shown


# ------------------------------------------------------------------------------------------------ failures


def test_from_a_failure_it_is_gone_back_to_before_it() -> None:
    driver = Driver(breaks=50)
    driver.session.advance(80)
    driver.session.events()
    assert driver.snapshot.failure
    seen = at(driver, 45)
    assert (seen.tick, seen.failure) == (45, "")


def test_a_world_that_fails_on_the_way_says_so_and_stands_still() -> None:
    driver = Driver(breaks=50)
    driver.session.send(GoTo(70))
    driver.session.advance(100)
    assert "ZeroDivisionError" in driver.snapshot.failure
    assert (driver.snapshot.going_to, driver.snapshot.tick) == (None, 50)


# --------------------------------------------------------------------------------------------- what is kept


def timeline(session: Session) -> Timeline:
    found = session._world._timeline
    assert found is not None
    return found


def test_moments_are_bounded_in_number_and_the_first_is_always_kept() -> None:
    driver = Driver()
    for _ in range(40):
        driver.advance(20)
        ticks = timeline(driver.session).ticks
        assert ticks[0] == 0
        assert len(ticks) <= 6
    assert at(driver, 795).tick == 795


def test_moments_are_bounded_in_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(keyframes, "BUDGET", 1)
    driver = Driver().advance(500)
    assert len(timeline(driver.session).ticks) <= 3


def test_a_lesson_keeps_no_moments() -> None:
    driver = Driver().teach("agent-1", "Shuttle").advance(100)
    assert driver.session._world._timeline is None
