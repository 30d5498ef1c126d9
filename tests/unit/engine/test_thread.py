"""The background thread: asleep when paused, paced, answering while it runs, gone once it is closed."""

from collections.abc import Callable
from threading import Condition, Event, current_thread
from threading import enumerate as threads
from time import monotonic

import pytest

from app.core.errors import SessionError
from app.engine.commands import MoveEntities, Pause, Pick, Play, Step, Teach, UndoPick
from app.engine.commands import Test as LearnAndTest
from app.engine.pace import FRAME
from app.engine.session import Session
from app.engine.snapshots import Demonstrated, Edit, Mode, Picked, Refused, Relearned, Snapshot, edited
from app.engine.thread import EARLY, EngineThread
from tests.corridor import corridor, project
from tests.driver import UNCOMPILED
from tests.unit.engine.threads import Make, answered, newest


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
    began, seen = monotonic(), set[int]()

    def is_far(snapshot: Snapshot) -> bool:
        seen.add(snapshot.tick)
        return snapshot.tick >= 3000

    snapshot = thread.wait_for(is_far)
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
        there = answered(thread, MoveEntities({0: (float(k), 0.0)}))
        assert there.speed is None


def test_commands_are_obeyed_in_their_order(start: Make) -> None:
    thread = start()
    for k in range(50):
        thread.send(MoveEntities({0: (float(k), 0.0)}))
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
