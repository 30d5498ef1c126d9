"""Closing a window: nothing is lost unasked."""

from pathlib import Path
from threading import Event
from typing import Any

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.core.edits import disable_examples
from app.core.project import Project
from app.core.storage import load, save
from app.editor.window.main_window import MainWindow
from app.engine import relearning
from app.learner.trainer import learn
from tests.gui.conftest import PATIENCE

from .desk import answer, changed, opened, press, question


def test_closing_with_unsaved_work_asks_and_cancel_keeps_the_window(
    desk: MainWindow, qtbot: QtBot, folder: Path
) -> None:
    opened(desk, qtbot, folder)
    changed(desk)
    desk.close()
    assert "unsaved changes" in question(desk, qtbot).text
    answer(desk, qtbot, "Cancel")
    assert desk.isVisible()
    assert desk.studio.document.project.note == "changed"


def test_closing_with_unsaved_work_can_save_it_first(desk: MainWindow, qtbot: QtBot, folder: Path) -> None:
    opened(desk, qtbot, folder)
    changed(desk)
    with qtbot.waitSignal(desk.closed, timeout=PATIENCE):
        desk.close()
        qtbot.keyClick(question(desk, qtbot), Qt.Key.Key_Return)
    assert load(folder).note == "changed"


def test_enter_gives_the_answer_that_has_the_keys(desk: MainWindow, qtbot: QtBot, folder: Path) -> None:
    opened(desk, qtbot, folder)
    changed(desk)
    desk.close()
    (cancel,) = (button for button in question(desk, qtbot).buttons if button.text() == "Cancel")
    cancel.setFocus(Qt.FocusReason.TabFocusReason)
    qtbot.keyClick(cancel, Qt.Key.Key_Return)
    assert desk.isVisible()
    assert load(folder).note != "changed"


def test_closing_with_everything_saved_does_not_ask(desk: MainWindow, qtbot: QtBot, folder: Path) -> None:
    opened(desk, qtbot, folder)
    with qtbot.waitSignal(desk.closed, timeout=PATIENCE):
        desk.close()


def test_closing_while_learning_says_so_and_can_wait(
    desk: MainWindow, qtbot: QtBot, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened(desk, qtbot, folder)
    busy = desk.studio.relearning
    busy.busy = True
    desk.files.close()
    answer(desk, qtbot, "Wait for it")
    assert desk.studio.is_open
    busy.busy = False
    busy.changed.emit()
    assert not desk.studio.is_open


def test_what_was_waited_for_is_not_lost_by_closing_then(
    desk: MainWindow, qtbot: QtBot, tmp_path: Path, foraging: Project, monkeypatch: pytest.MonkeyPatch
) -> None:
    stale, folder = disable_examples(foraging, "agent", "wander", ["1"]), tmp_path / "stale"
    save(stale, folder)
    opened(desk, qtbot, folder)
    before = stale.library("agent").get("wander").learned_from
    may_go_on = Event()

    def learn_later(*told: Any, **more: Any) -> Any:
        assert may_go_on.wait(300.0)  # as long as all that is clicked meanwhile may take
        return learn(*told, **more)

    monkeypatch.setattr(relearning, "learn", learn_later)
    desk.studio.relearning.learn()
    press(desk, qtbot, "file.close", Qt.Key.Key_W)
    answer(desk, qtbot, "Wait for it")
    assert desk.studio.is_open
    may_go_on.set()
    assert "unsaved changes" in question(desk, qtbot).text
    answer(desk, qtbot, "Save")
    qtbot.waitUntil(lambda: not desk.studio.is_open, timeout=PATIENCE)
    assert load(folder).library("agent").get("wander").learned_from not in ("", before)
