"""Opening projects: damaged ones, ones with code, shipped and recent ones."""

import json
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QPushButton
from pytestqt.qtbot import QtBot

from app.core.automaton import Nested
from app.core.edits import add_automaton, add_state
from app.core.project import Project
from app.core.storage import save
from app.editor.documents.private import NAME
from app.editor.problems.model import FIX, WHAT
from app.editor.problems.panel import ProblemsPanel
from app.editor.window.main_window import MainWindow
from app.engine.shipped import shipped_projects
from tests.gui.conftest import FORAGING, PATIENCE, said

from .desk import answer, idle, opened, press, question

CODE = "from understudy.sim.scenarios.foraging import scenario\n"


def test_a_damaged_project_is_told_with_file_place_and_what_is_allowed(
    desk: MainWindow, qtbot: QtBot, folder: Path
) -> None:
    text = (folder / "project.json").read_text(encoding="utf-8")
    (folder / "project.json").write_text(text.replace('"top"', '"topp"'), encoding="utf-8")
    desk.files.open(folder)
    asked = question(desk, qtbot)
    assert asked.details is not None
    said = asked.details.toPlainText()
    assert "project.json: arms[0]: unknown key 'topp'; did you mean 'top'?" in said
    qtbot.mouseClick(
        next(b for b in asked.findChildren(QPushButton) if b.text() == "Copy"), Qt.MouseButton.LeftButton
    )
    assert QApplication.clipboard().text() == said
    answer(desk, qtbot, "Close")
    assert not desk.studio.is_open
    assert not (folder / NAME).exists()


def test_escape_leaves_the_message_that_a_project_is_damaged(
    desk: MainWindow, qtbot: QtBot, folder: Path
) -> None:
    (folder / "project.json").write_text("{", encoding="utf-8")
    desk.files.open(folder)
    asked = question(desk, qtbot)
    with qtbot.waitSignal(asked.destroyed, timeout=PATIENCE):
        qtbot.keyClick(asked, Qt.Key.Key_Escape)
    idle(desk, qtbot)  # it was tried again, and the same message came, for ever
    assert not desk.files.is_asking


def test_behaviors_that_hold_each_other_are_told_and_parted_by_one_click(
    desk: MainWindow, qtbot: QtBot, folder: Path, small: Project
) -> None:
    project, first = add_automaton(small, "agent", "Wait")
    project, second = add_automaton(project, "agent", "Look")
    project, _ = add_state(project, "agent", first, Nested(second))
    save(project, folder)
    file = folder / "libraries" / "agent" / f"{second}.json"
    waits = json.loads((folder / "libraries" / "agent" / f"{first}.json").read_text(encoding="utf-8"))
    looks = json.loads(file.read_text(encoding="utf-8"))
    text = json.dumps({**looks, "states": waits["states"]}).replace(f'"{second}"', f'"{first}"')
    file.write_text(text.replace(f'"id": "{first}"', f'"id": "{second}"', 1), encoding="utf-8")
    opened(desk, qtbot, folder)
    problems = desk.docks["problems"].widget()
    assert isinstance(problems, ProblemsPanel)
    desk.show_panel("problems")
    qtbot.waitUntil(lambda: any("recursion" in f.problem.message for f in problems.model.findings))
    row = next(k for k, f in enumerate(problems.model.findings) if "recursion" in f.problem.message)
    said = str(problems.model.index(row, WHAT).data())
    assert said == "Recursion is not permitted, but Look holds Wait holds Look"
    qtbot.keyClick(desk, Qt.Key.Key_Space)  # what does not run does no harm
    idle(desk, qtbot)
    place = problems.list.visualRect(problems.model.index(row, FIX)).center()
    qtbot.mouseClick(problems.list.viewport(), Qt.MouseButton.LeftButton, pos=place)
    qtbot.waitUntil(lambda: not any("recursion" in f.problem.message for f in problems.model.findings))


def test_a_behavior_has_the_same_color_when_its_project_is_opened_again(
    desk: MainWindow, qtbot: QtBot, folder: Path
) -> None:
    opened(desk, qtbot, folder)
    studio = desk.studio
    for name in ("Wander", "Approach"):  # the later one comes first in the folder
        studio.document.do(add_automaton, "agent", name)
    before = {name: studio.colors.of_name(name).name() for name in ("Wander", "Approach")}
    press(desk, qtbot, "file.save", Qt.Key.Key_S)
    qtbot.waitUntil(lambda: not desk.isWindowModified(), timeout=PATIENCE)
    idle(desk, qtbot)
    with qtbot.waitSignal(studio.opened, timeout=PATIENCE):
        desk.files.reload()
    assert {name: studio.colors.of_name(name).name() for name in before} == before


def test_a_message_stays_in_sight_when_a_project_takes_the_place_of_the_welcome_page(
    desk: MainWindow, qtbot: QtBot, folder: Path
) -> None:
    desk.studio.warn("something to answer", (("Later", lambda: None),))
    opened(desk, qtbot, folder)
    bar = desk.messages
    assert bar.isVisible()
    found = QApplication.widgetAt(bar.mapToGlobal(bar.words.geometry().center()))
    assert found is not None
    assert found is bar or bar.isAncestorOf(found)


def test_pictures_of_projects_are_there_when_the_welcome_page_comes_back(
    desk: MainWindow, qtbot: QtBot, folder: Path
) -> None:
    opened(desk, qtbot, folder)  # before any picture is drawn
    desk.files.close()
    qtbot.waitUntil(desk.welcome.isVisible, timeout=PATIENCE)
    qtbot.waitUntil(lambda: set(desk.welcome.previews) == set(shipped_projects()), timeout=PATIENCE)


def test_code_that_a_project_carries_runs_only_after_it_was_read_and_trusted(
    desk: MainWindow, qtbot: QtBot, folder: Path
) -> None:
    text = (folder / "project.json").read_text(encoding="utf-8")
    (folder / "project.json").write_text(text.replace('"foraging"', '"scenario.py"'), encoding="utf-8")
    (folder / "scenario.py").write_text(CODE, encoding="utf-8")
    desk.files.open(folder)
    asked = question(desk, qtbot)
    assert str(folder / "scenario.py") in asked.text
    assert asked.details is not None
    assert asked.details.toPlainText() == CODE
    qtbot.keyClick(asked, Qt.Key.Key_Return)  # what is standard is safe
    idle(desk, qtbot)
    assert not desk.studio.is_open
    desk.files.open(folder)
    answer(desk, qtbot, "Trust once")
    qtbot.waitUntil(lambda: desk.studio.is_open, timeout=PATIENCE)


def test_loading_can_be_cancelled(desk: MainWindow, qtbot: QtBot, folder: Path) -> None:
    desk.files.open(folder)
    assert desk.busy.isVisible()
    qtbot.mouseClick(desk.busy.cancel, Qt.MouseButton.LeftButton)
    assert desk.welcome.isVisible()
    qtbot.waitUntil(lambda: not desk.files.background._jobs, timeout=PATIENCE)
    assert not desk.studio.is_open


def test_a_shipped_project_opens_by_its_picture_and_recent_ones_can_be_forgotten(
    desk: MainWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    gone = tmp_path / "gone"
    desk.studio.settings.remember(gone)
    assert not desk.welcome.recent[gone].isEnabled()
    qtbot.mouseClick(desk.welcome.removers[gone], Qt.MouseButton.LeftButton)
    assert gone not in desk.welcome.recent
    qtbot.mouseClick(desk.welcome.shipped[FORAGING], Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: desk.studio.document.folder == FORAGING, timeout=PATIENCE)


def test_a_damaged_project_opens_at_another_try_once_it_is_mended(
    desk: MainWindow, qtbot: QtBot, folder: Path
) -> None:
    project = folder / "project.json"
    whole = project.read_text(encoding="utf-8")
    project.write_text(whole.replace("{", "[", 1), encoding="utf-8")
    desk.files.open(folder)
    assert question(desk, qtbot).details is not None
    project.write_text(whole, encoding="utf-8")
    answer(desk, qtbot, "Try again")
    qtbot.waitUntil(lambda: desk.studio.document.folder == folder, timeout=PATIENCE)


def test_recent_projects_are_in_the_file_menu(desk: MainWindow, qtbot: QtBot, folder: Path) -> None:
    desk.studio.settings.remember(folder)
    desk.recent.aboutToShow.emit()
    (entry,) = desk.recent.actions()
    entry.trigger()
    qtbot.waitUntil(lambda: desk.studio.document.folder == folder, timeout=PATIENCE)


def test_recent_projects_where_nobody_may_look_any_more_cannot_be_chosen(
    desk: MainWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    refused = tmp_path / ("n" * 300)
    desk.studio.settings.remember(refused)
    assert not desk.welcome.recent[refused].isEnabled()
    desk.recent.aboutToShow.emit()
    assert [action.isEnabled() for action in desk.recent.actions()] == [False]


def test_recent_projects_of_one_name_are_told_apart_and_the_one_that_is_open_is_left_out(
    desk: MainWindow, qtbot: QtBot, folder: Path, tmp_path: Path
) -> None:
    twins = [tmp_path / where / "foraging" for where in ("here", "there")]
    for twin in twins:
        desk.studio.settings.remember(twin)
    opened(desk, qtbot, folder)
    desk.recent.aboutToShow.emit()
    assert {said(action) for action in desk.recent.actions()} == {f"foraging in {t.parent}" for t in twins}
