"""What a hand does in the forms of behaviors."""

from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.editor.forms.choosing import Chooser


def choose(chooser: Chooser, qtbot: QtBot, text: str) -> None:
    """Type over what stands there, and press Enter."""
    chooser.field.setFocus()
    chooser.field.selectAll()
    qtbot.keyClicks(chooser.field, text)
    qtbot.keyClick(chooser.field, Qt.Key.Key_Return)
