"""What a user does at a window with projects on disk."""

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton
from pytestqt.qtbot import QtBot

from app.core.edits import note_project
from app.editor.documents.asking import Question
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE

CONTROL = Qt.KeyboardModifier.ControlModifier


def opened(desk: MainWindow, qtbot: QtBot, folder: Path) -> None:
    desk.files.open(folder)
    qtbot.waitUntil(lambda: desk.studio.document.folder == folder, timeout=PATIENCE)


def question(desk: MainWindow, qtbot: QtBot) -> Question:
    """The one that is asked now; one that was answered may not be gone yet."""

    def asked() -> list[Question]:
        return [found for found in desk.findChildren(Question) if found.isVisible()]

    qtbot.waitUntil(lambda: len(asked()) == 1, timeout=PATIENCE)
    return asked()[0]


def answer(desk: MainWindow, qtbot: QtBot, text: str) -> None:
    """Click an answer, and wait until the question is gone."""
    asked = question(desk, qtbot)
    button = next(b for b in asked.findChildren(QPushButton) if b.text() == text)
    with qtbot.waitSignal(asked.destroyed, timeout=PATIENCE):
        qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def changed(desk: MainWindow, text: str = "changed") -> None:
    desk.studio.document.do(note_project, text)


def press(desk: MainWindow, qtbot: QtBot, action: str, key: Qt.Key) -> None:
    """Press a shortcut with Ctrl once its action is possible."""
    qtbot.waitUntil(desk.studio.actions[action].isEnabled, timeout=PATIENCE)
    desk.activateWindow()
    qtbot.waitUntil(desk.isActiveWindow, timeout=PATIENCE)
    qtbot.keyClick(desk, key, CONTROL)


def idle(desk: MainWindow, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: not desk.files.background.busy, timeout=PATIENCE)
