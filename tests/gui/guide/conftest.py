"""The guided first lesson, begun."""

import pytest
from pytestqt.qtbot import QtBot

from app.editor.window.main_window import MainWindow
from tests.gui.guide.newcomer import begin


@pytest.fixture
def lesson(window: MainWindow, qtbot: QtBot) -> MainWindow:
    """The lesson has begun."""
    begin(window, qtbot)
    return window
