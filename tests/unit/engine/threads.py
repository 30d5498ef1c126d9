"""How a test speaks with a thread of the engine."""

from collections.abc import Callable

from app.engine.commands import Command
from app.engine.snapshots import Snapshot
from app.engine.thread import EngineThread

Make = Callable[..., EngineThread]


def answered(thread: EngineThread, command: Command) -> Snapshot:
    """The first snapshot after a command was dealt with."""
    ticket = thread.send(command)
    return thread.wait_for(lambda snapshot: snapshot.acknowledged >= ticket)


def newest(thread: EngineThread) -> Snapshot:
    """The newest snapshot of a thread that has begun."""
    assert thread.newest is not None
    return thread.newest
