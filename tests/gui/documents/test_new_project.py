"""A new project from the form."""

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog
from pytestqt.qtbot import QtBot

from app.core.storage import load
from app.editor.documents.new_project import NewProject
from app.editor.window.main_window import MainWindow
from app.engine.scenarios import OWN_CODE
from tests.gui.conftest import PATIENCE
from tests.unit.sim.test_manual import example

from .desk import CONTROL, question


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


def test_a_new_project_can_live_in_a_world_of_ones_own(
    desk: MainWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    code = tmp_path / "line.py"
    code.write_text(example(), encoding="utf-8")
    desk.files.ask_new()
    form = desk.findChild(NewProject)
    assert isinstance(form, NewProject)
    form.scenario.setFocus()
    qtbot.keyClick(form.scenario, Qt.Key.Key_End)  # what asks for a file
    dialog = form.findChild(QFileDialog)
    assert dialog is not None
    dialog.fileSelected.emit(str(code))
    dialog.reject()
    assert form.scenario.currentText() == "line.py"
    assert f"runs {code}" in form.about.text()
    qtbot.keyClick(form.name, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: desk.studio.is_open, timeout=PATIENCE)
    assert desk.studio.document.scenario.title == "On a line"
    assert (tmp_path / "my-project" / OWN_CODE).read_bytes() == code.read_bytes()


def test_who_chooses_no_file_stays_with_the_scenario_of_before(desk: MainWindow, qtbot: QtBot) -> None:
    desk.files.ask_new()
    form = desk.findChild(NewProject)
    assert isinstance(form, NewProject)
    before = form.scenario.currentText()
    form.scenario.setFocus()
    qtbot.keyClick(form.scenario, Qt.Key.Key_End)
    dialog = form.findChild(QFileDialog)
    assert dialog is not None
    dialog.reject()
    assert form.scenario.currentText() == before
    assert form.order.scenario == "foraging"


def test_a_file_of_ones_own_that_fails_is_told_by_its_line_and_nothing_is_made(
    desk: MainWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    code = tmp_path / "line.py"
    code.write_text("\n1 / 0", encoding="utf-8")
    desk.files.ask_new()
    form = desk.findChild(NewProject)
    assert isinstance(form, NewProject)
    form.take(code)
    qtbot.keyClick(form.name, Qt.Key.Key_Return)
    asked = question(desk, qtbot)
    assert asked.details is not None
    assert f"{code}, line 2: ZeroDivisionError" in asked.details.toPlainText()
    assert not (tmp_path / "my-project").exists()
