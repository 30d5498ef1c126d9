"""Opening, closing and leaving by keys."""

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialogButtonBox, QFileDialog, QLineEdit
from pytestqt.qtbot import QtBot

from app.editor.window.main_window import MainWindow

from .desk import answer, changed, opened, press, question


def test_a_folder_is_chosen_and_opened(desk: MainWindow, qtbot: QtBot, folder: Path) -> None:
    press(desk, qtbot, "file.open", Qt.Key.Key_O)
    qtbot.waitUntil(lambda: bool(desk.findChildren(QFileDialog)))
    (chooser,) = desk.findChildren(QFileDialog)
    field = chooser.findChild(QLineEdit, "fileNameEdit")
    assert isinstance(field, QLineEdit)
    field.setText(str(folder))  # as if pasted
    box = chooser.findChild(QDialogButtonBox)
    assert isinstance(box, QDialogButtonBox)
    qtbot.mouseClick(box.button(QDialogButtonBox.StandardButton.Open), Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: desk.studio.document.folder == folder)


def test_a_project_is_closed_and_the_window_left(desk: MainWindow, qtbot: QtBot, folder: Path) -> None:
    opened(desk, qtbot, folder)
    changed(desk)
    press(desk, qtbot, "file.close", Qt.Key.Key_W)
    assert "unsaved changes" in question(desk, qtbot).text
    answer(desk, qtbot, "Discard")
    qtbot.waitUntil(desk.welcome.isVisible)
    assert not desk.studio.is_open
    with qtbot.waitSignal(desk.closed):
        press(desk, qtbot, "file.quit", Qt.Key.Key_Q)
