"""What tests of teaching share."""

import pytest
from pytestqt.qtbot import QtBot

from app.editor.window.main_window import MainWindow
from tests.gui.teach.hand import Hand


@pytest.fixture
def hand(window: MainWindow, qtbot: QtBot) -> Hand:
    """A hand in the window on the foraging project."""
    hand = Hand(window, qtbot)
    hand.settle()
    return hand
