"""A window that is closed, and the one that the next start of the program opens."""

from collections.abc import Iterator
from contextlib import contextmanager

from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.core.project import Project
from app.editor.studio import Studio
from app.editor.theme import Theme
from app.editor.window.main_window import MainWindow
from app.engine.scenarios import open_scenario


@contextmanager
def next_start(window: MainWindow, qtbot: QtBot, project: Project) -> Iterator[MainWindow]:
    """Close a window, and open another one with the settings that it leaves, as large and on a project."""
    application, settings = QApplication.instance(), window.studio.settings
    assert isinstance(application, QApplication)
    with qtbot.waitSignal(window.closed):
        window.close()
    studio = Studio(Theme(application, settings.theme), settings)
    later = MainWindow(studio)
    qtbot.addWidget(later)
    later.resize(window.size())
    later.show()
    studio.open(project, open_scenario(project), None, saved=True)
    yield later
    later.hide()
    studio.shut_down()
