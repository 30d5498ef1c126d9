"""Whoever wants nodes explained asks in one place."""

from __future__ import annotations

from pytestqt.qtbot import QtBot

from app.editor.bridge import Bridge
from app.editor.document import Document
from app.editor.watching import Watching
from app.engine.commands import Command, Watch
from tests.corridor import corridor, project


class Recorder(Bridge):
    """A bridge that notes what is sent."""

    def __init__(self) -> None:
        super().__init__(Document(project(), corridor))
        self.sent: list[Command] = []

    @property
    def is_open(self) -> bool:
        return True

    def send(self, command: Command) -> int:
        self.sent.append(command)
        return len(self.sent)


def test_everybody_gets_what_they_want_in_one_command(qtbot: QtBot) -> None:
    bridge = Recorder()
    watching = Watching(bridge)
    watching.want("canvas", ("agent-1", "agent-2"))
    watching.want("inspector", ("agent-2", ""))
    watching.want("graph", ("group-1",))
    qtbot.waitUntil(lambda: bool(bridge.sent))
    assert bridge.sent == [Watch(("agent-1", "agent-2", "group-1"))]


def test_what_is_not_wanted_any_more_is_not_watched_and_nothing_is_told_twice(qtbot: QtBot) -> None:
    bridge = Recorder()
    watching = Watching(bridge)
    watching.want("canvas", ("agent-1",))
    qtbot.waitUntil(lambda: len(bridge.sent) == 1)
    watching.want("inspector", ("agent-1",))
    watching.want("canvas", ())
    watching.begin()
    assert bridge.sent[1:] == [Watch(("agent-1",))]
    watching.want("inspector", ())
    qtbot.waitUntil(lambda: len(bridge.sent) == 3)
    assert bridge.sent[-1] == Watch(())
