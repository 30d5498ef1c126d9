"""What GUI tests share: a studio on a project, with the real engine, and its window."""

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QObject, QTimer
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.core.project import Project
from app.core.storage import load
from app.editor.application import SWITCH
from app.editor.settings import Settings
from app.editor.studio import Studio
from app.editor.theme import Theme, ThemeMode
from app.editor.window.main_window import MainWindow
from app.engine.compiling import compile_ahead
from app.engine.scenarios import open_scenario
from app.sim.physics import KINEMATIC
from tests import patient_bot
from tests.patient_bot import have_done_what_is_due

FORAGING = Path(__file__).parents[2] / "projects" / "foraging"
#: Milliseconds that a test waits at most.
PATIENCE = patient_bot.PATIENCE


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """What the offscreen platform cannot do, such as raising windows, is no fault of the program."""
    for item in items:
        if item.path.is_relative_to(Path(__file__).parent):
            item.add_marker(pytest.mark.qt_log_ignore("This plugin does not support"))


@pytest.fixture(scope="module", autouse=True)
def responsive() -> Iterator[None]:
    """Threads take turns as often as they do in the studio."""
    before = sys.getswitchinterval()
    sys.setswitchinterval(SWITCH)
    yield
    sys.setswitchinterval(before)


@pytest.fixture
def settings(tmp_path: Path) -> Settings:
    settings = Settings(tmp_path / "settings.ini")
    settings.theme = ThemeMode.LIGHT
    settings.autosave_seconds = 0
    return settings


@pytest.fixture(scope="session")
def foraging() -> Project:
    """The shipped project, loaded once: it is a value."""
    return load(FORAGING)


@pytest.fixture(scope="session", autouse=True)
def kernel(foraging: Project) -> None:
    """The kernel is there, as on every day but the first: no test is told in its middle that it is being compiled."""
    compile_ahead(open_scenario(foraging), KINEMATIC, lambda _: None, lambda: False)


@pytest.fixture
def empty_studio(qapp: QApplication, qtbot: QtBot, settings: Settings) -> Iterator[Studio]:
    """A studio without a project."""
    studio = Studio(Theme(qapp, settings.theme), settings)
    yield studio
    studio.shut_down()


@pytest.fixture
def studio(empty_studio: Studio, foraging: Project, qtbot: QtBot) -> Studio:
    """A studio with the foraging project open, its first arm standing at tick 0."""
    empty_studio.open(foraging, open_scenario(foraging), FORAGING)
    qtbot.waitUntil(lambda: empty_studio.snapshot is not None, timeout=PATIENCE)
    have_done_what_is_due()
    return empty_studio


@pytest.fixture
def window(studio: Studio, qtbot: QtBot) -> Iterator[MainWindow]:
    """A window on the same studio, on the screen."""
    window = MainWindow(studio)
    qtbot.addWidget(window)
    window.resize(1440, 900)
    with qtbot.waitExposed(window):
        window.show()
    with qtbot.waitSignal(_moment(window).timeout):  # in which docks take the sizes that they have at first
        pass
    have_done_what_is_due()
    yield window
    window.hide()


def said(action: QAction) -> str:
    """What an entry of a menu says, without the mark of its letter."""
    return action.text().replace("&", "")


def _moment(owner: QObject) -> QTimer:
    """A timer that comes after all that wait by now."""
    timer = QTimer(owner, interval=0, singleShot=True)
    timer.start()
    return timer
