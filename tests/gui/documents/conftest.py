"""A window on the welcome page, and a small project."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.core.project import Project
from app.core.storage import save
from app.editor.settings import Settings
from app.editor.studio import Studio
from app.editor.theme import Theme
from app.editor.window.main_window import MainWindow
from app.engine.fresh import fresh_project
from app.sim.scenarios import shipped


@pytest.fixture(scope="module")
def small() -> Project:
    return fresh_project("Small", shipped("foraging"), agents=3)


@pytest.fixture
def folder(tmp_path: Path, small: Project) -> Path:
    save(small, tmp_path / "small")
    return tmp_path / "small"


@pytest.fixture
def desk(qapp: QApplication, qtbot: QtBot, settings: Settings, tmp_path: Path) -> Iterator[MainWindow]:
    """A window on the welcome page."""
    settings.projects_folder = tmp_path
    studio = Studio(Theme(qapp, settings.theme), settings)
    window = MainWindow(studio)
    qtbot.addWidget(window)
    window.resize(1280, 800)
    with qtbot.waitExposed(window):
        window.show()
    yield window
    window.files.shut_down()
    window.hide()
    studio.shut_down()
