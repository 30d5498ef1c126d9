"""The window of experiments over a project that can be written to."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.core.project import Project
from app.editor.experiments.window import ExperimentsWindow
from app.editor.studio import Studio
from app.editor.window.main_window import MainWindow
from app.engine.scenarios import open_scenario
from tests.gui.conftest import FORAGING, PATIENCE
from tests.patient_bot import have_done_what_is_due


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A copy of the foraging project that can be written to."""
    ignored = shutil.ignore_patterns("results", "*.sqlite*", "reports")
    return Path(shutil.copytree(FORAGING, tmp_path / "foraging", ignore=ignored))


@pytest.fixture
def shown(
    empty_studio: Studio, foraging: Project, folder: Path, qtbot: QtBot
) -> Iterator[tuple[MainWindow, ExperimentsWindow]]:
    """The window over the copied project, asked for by its shortcut."""
    window = MainWindow(empty_studio)
    qtbot.addWidget(window)
    window.show()
    empty_studio.open(foraging, open_scenario(foraging), folder)
    qtbot.waitUntil(lambda: empty_studio.snapshot is not None, timeout=PATIENCE)
    qtbot.waitUntil(empty_studio.actions["experiment.show"].isEnabled, timeout=PATIENCE)
    keys = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier
    qtbot.keyClick(window, Qt.Key.Key_X, keys)
    experiments = window.experiments.window
    assert experiments is not None
    have_done_what_is_due()
    yield window, experiments
    experiments.close()
