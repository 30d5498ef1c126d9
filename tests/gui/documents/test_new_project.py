"""A new project from the form."""

from pathlib import Path

from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.core.storage import load
from app.editor.documents.new_project import NewProject
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE

from .desk import CONTROL


def test_a_new_project_is_made_from_the_form(desk: MainWindow, qtbot: QtBot, tmp_path: Path) -> None:
    qtbot.keyClick(desk, Qt.Key.Key_N, CONTROL)
    form = desk.findChild(NewProject)
    assert isinstance(form, NewProject)
    form.name.selectAll()
    qtbot.keyClicks(form.name, "My Ants")
    form.groups.setFocus()
    qtbot.keyClick(form.groups, Qt.Key.Key_Up)
    assert form.agents.value() == 5
    qtbot.keyClick(form.name, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: desk.studio.is_open, timeout=PATIENCE)
    project = load(tmp_path / "my-ants")
    assert project.name == "My Ants"
    assert len(project.arms[0].forest().agents()) == 5
    assert len(project.arms[0].forest().controllers()) == 1


def test_a_new_project_is_not_put_where_something_is(desk: MainWindow, qtbot: QtBot, folder: Path) -> None:
    desk.files.ask_new()
    form = desk.findChild(NewProject)
    assert isinstance(form, NewProject)
    form.place.edit.setText(str(folder))
    assert "something is in this folder" in form.problem
    assert not form._form.fine.isEnabled()
