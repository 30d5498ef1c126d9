"""What tests of the canvas share."""

import pytest
from pytestqt.qtbot import QtBot

from app.editor.window.main_window import MainWindow
from tests.gui.canvas.pilot import Pilot


@pytest.fixture
def pilot(window: MainWindow, qtbot: QtBot) -> Pilot:
    """A user at the canvas of the foraging project, paused at tick 0."""
    pilot = Pilot(window, qtbot)
    pilot.wait(lambda: pilot.canvas.frame() is not None)
    return pilot
