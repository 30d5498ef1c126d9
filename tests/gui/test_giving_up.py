"""What is worked out beside the window is given up by the very edit that makes it worthless: the window has the turn."""

from __future__ import annotations

from typing import Any

import pytest
from pytestqt.qtbot import QtBot

from app.core.edits import disable_examples, weight_examples
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from app.editor.window.main_window import MainWindow
from app.engine.worker import Worker
from tests.gui.conftest import PATIENCE

WANDER = BehaviorKey("agent", "wander")


class Interrupter:
    """Changes the project in the moment in which a certain worker has been asked something."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
        self.name = name
        self.studio: Studio | None = None
        self.was_busy_then: bool | None = None
        self._names: dict[Worker[Any, Any], str] = {}
        begin, ask = Worker.__init__, Worker.ask

        def begin_known(worker: Worker[Any, Any], *args: Any) -> None:
            begin(worker, *args)
            self._names[worker] = args[-1]

        def ask_and_change(worker: Worker[Any, Any], question: Any) -> None:
            ask(worker, question)
            if self._names.get(worker) == self.name and self.studio is not None:
                studio, self.studio = self.studio, None
                studio.document.do(weight_examples, WANDER.type, WANDER.id, ["1"], 2.0)
                self.was_busy_then = worker.busy

        monkeypatch.setattr(Worker, "__init__", begin_known)
        monkeypatch.setattr(Worker, "ask", ask_and_change)


@pytest.mark.parametrize("name", ["relearner", "problems", "judge"])
def test_what_is_out_of_date_is_not_worked_on(
    name: str, monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest, qtbot: QtBot
) -> None:
    interrupter = Interrupter(monkeypatch, name)
    window: MainWindow = request.getfixturevalue("window")
    window.studio.selection.select_behavior(WANDER)
    interrupter.studio = window.studio
    window.studio.document.do(disable_examples, WANDER.type, WANDER.id, ["2"])
    qtbot.waitUntil(lambda: interrupter.was_busy_then is not None, timeout=PATIENCE)
    assert interrupter.was_busy_then is False


def test_learning_that_was_given_up_begins_anew_and_is_told_as_one(window: MainWindow, qtbot: QtBot) -> None:
    studio, told = window.studio, []
    studio.relearning.changed.connect(lambda: told.append(studio.relearning.busy))
    studio.document.do(disable_examples, WANDER.type, WANDER.id, ["2"])
    studio.relearning.learn()
    studio.document.do(weight_examples, WANDER.type, WANDER.id, ["1"], 3.0)
    assert studio.relearning.busy
    qtbot.waitUntil(lambda: not studio.relearning.busy, timeout=PATIENCE)
    assert told[:2] == [True, False]
    assert studio.document.project.examples_of(WANDER.type, WANDER.id)[0].weight == 3.0


def test_where_nothing_is_learned_by_itself_an_edit_ends_learning(window: MainWindow, qtbot: QtBot) -> None:
    studio = window.studio
    studio.settings.learns_by_itself = False
    studio.document.do(disable_examples, WANDER.type, WANDER.id, ["2"])
    studio.relearning.learn()
    studio.document.do(weight_examples, WANDER.type, WANDER.id, ["1"], 3.0)
    assert not studio.relearning.busy
