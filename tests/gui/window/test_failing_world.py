"""A scenario that raises while time passes: what the window says, and how to go on."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.core.edits import set_world
from app.editor.studio import Studio
from app.editor.window.main_window import MainWindow
from app.editor.window.status_bar import StatusBar
from tests.corridor import corridor, project

BREAKS = 5


@pytest.fixture
def window(empty_studio: Studio, qtbot: QtBot) -> Iterator[MainWindow]:
    """A window on a project whose scenario divides by zero in a tick."""
    window = MainWindow(empty_studio)
    qtbot.addWidget(window)
    window.resize(1280, 800)
    with qtbot.waitExposed(window):
        window.show()
    broken = project(worlds={"": {"breaks": BREAKS}})
    empty_studio.open(broken, corridor, None, saved=False, arm="alone")
    qtbot.waitUntil(lambda: empty_studio.snapshot is not None)
    yield window
    window.hide()


def test_a_scenario_that_raises_is_told_with_its_place_and_once_it_is_mended_time_passes(
    window: MainWindow, qtbot: QtBot
) -> None:
    studio, banner, bar = window.studio, window.canvas.on_top.failure, window.statusBar()
    assert isinstance(bar, StatusBar)
    before = studio.document.project
    told: list[str] = []
    window.messages.shown.connect(told.append)
    qtbot.keyClick(window, Qt.Key.Key_Space)
    qtbot.waitUntil(banner.isVisible)
    assert not [words for words in told if "ZeroDivisionError" in words]  # the banner says it, and stays
    for words in ("corridor", "go_wrong in corridor.py, line", "ZeroDivisionError"):
        assert words in banner.words.text()
    qtbot.waitUntil(lambda: bar.rate.text() == "stopped")
    with qtbot.waitSignal(window.messages.shown) as shown:
        qtbot.keyClick(window, Qt.Key.Key_Space)
    assert shown.args is not None
    assert "Reset it to go on" in shown.args[0]
    assert studio.document.project is before
    studio.document.do(set_world, "", {})
    qtbot.mouseClick(banner.button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: not banner.isVisible())
    qtbot.keyClick(window, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: studio.snapshot is not None and studio.snapshot.tick > 2 * BREAKS)
    qtbot.keyClick(window, Qt.Key.Key_Space)
