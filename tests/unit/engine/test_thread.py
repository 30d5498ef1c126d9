"""The background thread: asleep when paused, paced, answering while it runs, and never dead with somebody waiting."""

from collections.abc import Callable, Iterator
from threading import Condition, Event, current_thread
from threading import enumerate as threads
from time import monotonic

import pytest

from app.core.errors import SessionError
from app.engine.commands import (
    Command,
    MoveEntity,
    Pause,
    Pick,
    Play,
    Reset,
    RunArm,
    Step,
    Teach,
    UndoPick,
)
from app.engine.commands import Test as LearnAndTest
from app.engine.learning import WorkerLearner
from app.engine.pace import FRAME
from app.engine.session import Session
from app.engine.snapshots import Demonstrated, Edit, Mode, Picked, Refused, Relearned, Snapshot, edited
from app.engine.thread import EARLY, EngineThread
from tests.corridor import corridor, project
from tests.driver import UNCOMPILED

Make = Callable[..., EngineThread]


@pytest.fixture
def start() -> Iterator[Make]:
    """Makes threads, and closes them."""
    made: list[EngineThread] = []

    def make(
        kind: type[Session] = Session, clock: Callable[[], float] = monotonic, wake: Condition | None = None
    ) -> EngineThread:
        def session(nudge: Callable[[], None]) -> Session:
            return kind(project(), corridor, "alone", learner=WorkerLearner(nudge), settings=UNCOMPILED)

        thread = EngineThread(session, clock, wake)
        made.append(thread)
        return thread

    yield make
    for thread in made:
        thread.close()


def answered(thread: EngineThread, command: Command) -> Snapshot:
    """The first snapshot after a command was dealt with."""
    ticket = thread.send(command)
    return thread.wait_for(lambda snapshot: snapshot.acknowledged >= ticket)


def test_whoever_waits_for_an_answer_is_woken_by_it_and_by_the_tick_that_carries_it_out() -> None:
    woken = Event()
    thread = EngineThread(
        lambda _: Session(project(), corridor, "alone", settings=UNCOMPILED), answered=woken.set
    )
    try:
        for command in (Pause(), Step()):
            woken.clear()
            ticket = thread.send(command)
            assert woken.wait(60.0)
            assert newest(thread).acknowledged >= ticket
    finally:
        thread.close()


def newest(thread: EngineThread) -> Snapshot:
    """The newest snapshot of a thread that has begun."""
    assert thread.newest is not None
    return thread.newest


class Alarm(Condition):
    """A condition whose clock is its own: who would sleep for a while in the thread is at once that much later.

    Attributes:
        now: Seconds.
        naps: For how long the thread slept, each time; None until it is woken.
        end: At this time the thread sleeps until it is woken.
    """

    def __init__(self, end: float = 0.0) -> None:
        super().__init__()
        self.now, self.end = 0.0, end
        self.naps: list[float | None] = []

    def wait(self, timeout: float | None = None) -> bool:
        if current_thread().name != "engine":
            return super().wait(timeout)
        self.naps.append(timeout)
        if timeout is None or self.now >= self.end:
            return super().wait()
        self.now += timeout
        return False

    def clock(self) -> float:
        return self.now


# ------------------------------------------------------------------------------------------------- sleep and pace


def test_a_paused_thread_sleeps_until_it_is_woken(start: Make) -> None:
    alarm = Alarm()
    thread = start(clock=alarm.clock, wake=alarm)
    for _ in range(3):
        answered(thread, Pause())
    with alarm:
        assert set(alarm.naps) <= {None}
        assert len(alarm.naps) <= 4


def test_reading_snapshots_and_events_wakes_nobody(start: Make) -> None:
    alarm = Alarm()
    thread = start(clock=alarm.clock, wake=alarm)
    answered(thread, Pause())
    with alarm:
        before = len(alarm.naps)
    for _ in range(100):
        thread.events()
        assert newest(thread).tick == 0
    with alarm:
        assert len(alarm.naps) <= before + 1


def test_a_thread_sleeps_between_ticks_at_low_speed(start: Make) -> None:
    alarm = Alarm(end=10.0)
    thread = start(clock=alarm.clock, wake=alarm)
    thread.send(Play(1.0))
    snapshot = thread.wait_for(lambda s: s.tick >= 598)
    assert snapshot.speed == 1.0
    with alarm:
        assert len(alarm.naps) <= 620


@pytest.mark.parametrize("speed", [1.0, 10.0, 50.0])
def test_a_thread_keeps_pace(start: Make, speed: float) -> None:
    alarm = Alarm(end=2.0)
    thread = start(clock=alarm.clock, wake=alarm)
    thread.send(Play(speed))
    expected = int(120 * speed)
    snapshot = thread.wait_for(lambda s: s.tick >= 0.95 * expected)  # it begins slowly
    assert snapshot.tick <= 1.02 * expected


def test_a_step_passes_just_its_ticks_and_pauses(start: Make) -> None:
    thread = start()
    thread.send(Step())
    assert thread.wait_for(lambda s: s.tick == 1).speed == 0.0
    thread.send(Step(500))
    assert thread.wait_for(lambda s: s.tick == 501 and s.speed == 0.0).tick == 501


def test_as_fast_as_it_can_is_faster_than_real_time_and_shown_about_once_a_frame(start: Make) -> None:
    thread = start()
    thread.send(Play(None))
    began, seen = monotonic(), set()
    snapshot = thread.wait_for(lambda s: seen.add(s.tick) is None and s.tick >= 3000)  # type: ignore[func-returns-value]
    assert snapshot.speed is None
    assert len(seen) <= (monotonic() - began) / ((1.0 - EARLY) * FRAME) + 3


def test_the_rate_is_told(start: Make) -> None:
    alarm = Alarm(end=3.0)
    thread = start(clock=alarm.clock, wake=alarm)
    assert thread.rate == 0.0
    thread.send(Play(2.0))
    thread.wait_for(lambda s: s.tick >= 350)
    assert thread.rate == pytest.approx(120.0, rel=0.05)
    answered(thread, Pause())
    assert thread.rate == 0.0


# ------------------------------------------------------------------------------------------------------ answering


def test_commands_are_answered_while_it_runs_flat_out(start: Make) -> None:
    thread = start()
    thread.send(Play(None))
    thread.wait_for(lambda s: s.tick >= 200)
    for k in range(20):  # each after a slice at most, see `Pace`
        there = answered(thread, MoveEntity(0, float(k), 0.0))
        assert there.speed is None


def test_commands_are_obeyed_in_their_order(start: Make) -> None:
    thread = start()
    for k in range(50):
        thread.send(MoveEntity(0, float(k), 0.0))
    assert answered(thread, Pause()).world["x"][0] == 49.0


def test_a_lesson_in_the_background(start: Make) -> None:
    thread = start()
    answered(thread, Teach("agent", "Shuttle", ("agent-1",)))
    answered(thread, Pick("agent-1", "up"))
    thread.send(Step(3))
    thread.wait_for(lambda s: s.tick == 3)
    answered(thread, Pick("agent-1", "down"))
    thread.send(LearnAndTest())
    thread.send(Play(None))
    snapshot = thread.wait_for(lambda s: s.mode is Mode.TESTING and s.tick > 20)
    assert snapshot.nodes["agent-2"].behavior == "Shuttle"
    answered(thread, Pause())
    events = thread.events()
    assert [type(event) for event in events] == [Picked, Demonstrated, Picked, Demonstrated, Relearned]
    caller = project()
    for event in events:
        if isinstance(event, Edit):
            caller = edited(caller, event)
    assert len(caller.examples_of("agent", "Shuttle")) == 4
    assert thread.events() == []


def test_an_answer_wakes_a_paused_thread(start: Make) -> None:
    thread = start()
    thread.send(Teach("agent", "Shuttle", ("agent-1",)))
    thread.send(Pick("agent-1", "up"))
    thread.send(LearnAndTest())
    assert thread.wait_for(lambda s: s.mode is Mode.TESTING).tick == 0


def test_what_is_refused_is_told_with_its_ticket(start: Make) -> None:
    thread = start()
    ticket = thread.send(UndoPick())
    thread.wait_for(lambda s: s.acknowledged >= ticket)
    (event,) = thread.events()
    assert isinstance(event, Refused)
    assert event.ticket == ticket


def test_waiting_for_what_does_not_come_ends(start: Make) -> None:
    thread = start()
    answered(thread, Pause())
    with pytest.raises(TimeoutError, match=r"no such snapshot in 0\.01 s; the newest is at tick 0"):
        thread.wait_for(lambda s: s.tick > 0, timeout=0.01)


# -------------------------------------------------------------------------------------------------------- failing


class Unforeseen(Session):
    """A session that breaks where nobody foresaw it."""

    def pass_ticks(self, ticks: int) -> None:
        if self.tick + ticks > 5:
            raise KeyError("nobody foresaw this")
        super().pass_ticks(ticks)


class Quits(Session):
    """A session whose world wants to end the program."""

    def pass_ticks(self, ticks: int) -> None:
        raise SystemExit(ticks)


class Unshowable(Session):
    """A session that cannot even be shown once it has begun to run."""

    def snapshot(self) -> Snapshot:
        if self.acknowledged:
            raise RuntimeError("cannot be shown")
        return super().snapshot()


class Deaf(Session):
    """A session that breaks on a command."""

    def send(self, command: Command) -> int:
        ticket = super().send(command)
        if isinstance(command, RunArm):
            raise RuntimeError("did not hear that")
        return ticket


@pytest.mark.parametrize(
    ("kind", "why"),
    [
        (Unforeseen, "KeyError: 'nobody foresaw this'"),
        (Quits, "SystemExit: 1"),
        (Unshowable, "RuntimeError: cannot be shown"),
    ],
)
def test_what_nobody_foresaw_is_told_as_a_failure_and_who_waits_hears_of_it(
    start: Make, kind: type[Session], why: str
) -> None:
    thread = start(kind)
    thread.send(Play(None))
    with pytest.raises(SessionError, match="the engine stands still: "):
        thread.wait_for(lambda s: s.tick >= 100_000)
    assert newest(thread).failure == why
    assert newest(thread).speed == 0.0
    told = [event.message for event in thread.events() if isinstance(event, Refused)]
    assert told == [f"{why}. The world stands still; reset it to go on."]


def test_a_failure_is_told_once_even_if_it_cannot_be_shown(start: Make) -> None:
    thread = start(Unshowable)
    for _ in range(2):
        ticket = thread.send(Pause())
        thread.wait_for(lambda s, ticket=ticket: s.acknowledged >= ticket)  # type: ignore[misc]
    assert len(thread.events()) == 2


def test_after_a_failure_a_reset_goes_on(start: Make) -> None:
    thread = start(Unforeseen)
    thread.send(Play(None))
    with pytest.raises(SessionError):
        thread.wait_for(lambda s: s.tick > 10)
    assert answered(thread, Reset()).failure == ""
    thread.send(Step(2))
    assert thread.wait_for(lambda s: s.tick == 2).failure == ""


def test_commands_after_one_that_broke_the_session_are_still_answered(start: Make) -> None:
    thread = start(Deaf)
    thread.send(RunArm())
    thread.send(Reset())
    thread.send(Step(3))
    assert thread.wait_for(lambda s: s.tick == 3).acknowledged == 3


def test_a_scenario_that_fails_is_told_and_who_waits_hears_of_it(start: Make) -> None:
    thread = start(Failing)
    thread.send(Play(None))
    with pytest.raises(SessionError, match=r"go_wrong in corridor.py, line \d+: ZeroDivisionError"):
        thread.wait_for(lambda s: s.tick >= 100)


class Failing(Session):
    """A session of a corridor that breaks in tick 4."""

    def __init__(self, *args: object, **kwargs: object) -> None:
        kwargs["settings"] = {"world.breaks": 4, **UNCOMPILED}
        super().__init__(*args, **kwargs)  # type: ignore[arg-type]


class Nowhere(Session):
    """A session that cannot be made."""

    def __init__(self, *_args: object, **_kwargs: object) -> None:
        super().__init__(project(), corridor, "desert", settings=UNCOMPILED)


class Surprised(Session):
    """A session that nobody expected not to be made."""

    def __init__(self, *_args: object, **_kwargs: object) -> None:
        raise KeyError("nobody foresaw this")


@pytest.mark.parametrize(
    ("kind", "why"),
    [(Nowhere, "there is no arm 'desert'"), (Surprised, "KeyError: 'nobody foresaw this'")],
)
def test_a_session_that_cannot_be_made_is_told_and_who_waits_hears_of_it(
    start: Make, kind: type[Session], why: str
) -> None:
    thread = start(kind)
    with pytest.raises(SessionError, match=f"the engine could not begin: {why}"):
        thread.wait_for(lambda s: s.tick >= 0)
    assert thread.newest is None
    assert thread.broken.startswith(why)
    assert thread.events() == [Refused(0, thread.broken)]


def test_without_a_session_every_command_is_refused(start: Make) -> None:
    thread = start(Nowhere)
    tickets = [thread.send(Pause()), thread.send(Play())]
    thread.close()
    events = thread.events()
    assert [event.ticket for event in events if isinstance(event, Refused)] == [0, *tickets]
    assert all("no arm 'desert'" in event.message for event in events if isinstance(event, Refused))


def test_nobody_has_to_wait_until_the_session_has_begun() -> None:
    gate = Event()

    def make(nudge: Callable[[], None]) -> Session:
        gate.wait()
        return Session(project(), corridor, "alone", settings=UNCOMPILED)

    thread = EngineThread(make)
    try:
        assert (thread.newest, thread.rate, thread.events()) == (None, 0.0, [])
        ticket = thread.send(Step(2))
        with pytest.raises(TimeoutError, match="there is none yet"):
            thread.wait_for(lambda s: s.tick >= 0, timeout=0.01)
    finally:
        gate.set()
    assert thread.wait_for(lambda s: s.tick == 2).acknowledged == ticket
    thread.close()


# -------------------------------------------------------------------------------------------------------- closing


def test_closing_ends_everything(start: Make) -> None:
    thread = start()
    thread.send(Teach("agent", "Shuttle", ("agent-1",)))
    thread.send(Pick("agent-1", "up"))
    thread.send(LearnAndTest())
    thread.wait_for(lambda s: s.mode is Mode.TESTING)
    thread.send(Play(None))
    thread.close()
    assert not [t for t in threads() if t.name.startswith(("engine", "learner"))]
    thread.close()


def test_nobody_has_to_wait_for_a_thread_that_is_left(start: Make) -> None:
    thread = start()
    thread.send(Teach("agent", "Shuttle", ("agent-1",)))
    thread.send(Pick("agent-1", "up"))
    thread.send(LearnAndTest())
    thread.send(Play(None))
    thread.leave()
    with pytest.raises(SessionError, match="the engine is closed"):
        thread.send(Pause())
    thread._thread.join()
    assert not [t for t in threads() if t.name.startswith(("engine", "learner"))]


def test_closing_while_it_learns_ends_everything(start: Make) -> None:
    thread = start()
    thread.send(Teach("agent", "Shuttle", ("agent-1",)))
    thread.send(Pick("agent-1", "up"))
    thread.send(LearnAndTest())
    thread.close()
    assert not [t for t in threads() if t.name.startswith(("engine", "learner"))]


def test_a_closed_thread_takes_no_commands_and_lets_nobody_wait(start: Make) -> None:
    thread = start()
    thread.close()
    with pytest.raises(SessionError, match="the engine is closed; it takes no commands"):
        thread.send(Pause())
    with pytest.raises(SessionError, match="the engine is closed"):
        thread.wait_for(lambda s: s.tick > 0)
    assert thread.wait_for(lambda s: s.tick == 0).tick == 0
