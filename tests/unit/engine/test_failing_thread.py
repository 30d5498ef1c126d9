"""A thread whose session breaks, or cannot be made, is never dead with somebody waiting."""

from typing import Any

import pytest

from app.core.errors import SessionError
from app.engine.commands import Command, Pause, Play, Reset, RunArm, Step
from app.engine.session import Session
from app.engine.snapshots import Refused, Snapshot
from tests.corridor import corridor, project
from tests.driver import UNCOMPILED
from tests.unit.engine.threads import Make, answered, newest


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
        thread.wait_for(lambda s, ticket=ticket: s.acknowledged >= ticket)  # type: ignore[misc]  # mypy gives no type to lambdas with defaults
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


class Failing(Session):
    """A session of a corridor that breaks in tick 4."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        kwargs["settings"] = {"world.breaks": 4, **UNCOMPILED}
        super().__init__(*args, **kwargs)


def test_a_scenario_that_fails_is_told_and_who_waits_hears_of_it(start: Make) -> None:
    thread = start(Failing)
    thread.send(Play(None))
    with pytest.raises(SessionError, match=r"go_wrong in corridor.py, line \d+: ZeroDivisionError"):
        thread.wait_for(lambda s: s.tick >= 100)


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
