"""Closing a window: nothing is lost unasked."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.core.storage import load
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE

from .desk import answer, changed, opened, question


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


def test_closing_with_everything_saved_does_not_ask(desk: MainWindow, qtbot: QtBot, folder: Path) -> None:
    opened(desk, qtbot, folder)
    with qtbot.waitSignal(desk.closed, timeout=PATIENCE):
        desk.close()


def test_closing_while_learning_says_so_and_can_wait(
    desk: MainWindow, qtbot: QtBot, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened(desk, qtbot, folder)
    relearning = desk.studio.relearning
    relearning.busy = True
    desk.files.close()
    answer(desk, qtbot, "Wait for it")
    assert desk.studio.is_open
    relearning.busy = False
    relearning.changed.emit()
    assert not desk.studio.is_open
