"""Projects on disk as a user meets them: opening, saving, closing, crashes, other windows, other people."""

import json
import os
import signal
import stat
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QPushButton
from pytestqt.qtbot import QtBot

from app.core.edits import add_automaton, note_project
from app.core.project import Project
from app.core.storage import FilesError, Problem, load, save
from app.editor.application import close_when_told
from app.editor.documents import autosaves, claims, opening, private
from app.editor.documents.asking import Question
from app.editor.documents.claims import Owner
from app.editor.documents.new_project import NewProject
from app.editor.documents.private import NAME
from app.editor.documents.save_as import SaveAs
from app.editor.settings import Settings
from app.editor.studio import Studio
from app.editor.theme import Theme
from app.editor.window.main_window import MainWindow
from app.engine.fresh import fresh_project
from app.engine.shipped import shipped_projects
from app.sim.scenarios import shipped
from tests.gui.conftest import FORAGING, PATIENCE

CONTROL = Qt.KeyboardModifier.ControlModifier
CODE = "from understudy.sim.scenarios.foraging import scenario\n"


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


def opened(desk: MainWindow, qtbot: QtBot, folder: Path) -> None:
    desk.files.open(folder)
    qtbot.waitUntil(lambda: desk.studio.document.folder == folder, timeout=PATIENCE)


def question(desk: MainWindow, qtbot: QtBot) -> Question:
    """The one that is asked now; one that was answered may not be gone yet."""

    def asked() -> list[Question]:
        return [found for found in desk.findChildren(Question) if found.isVisible()]

    qtbot.waitUntil(lambda: len(asked()) == 1, timeout=PATIENCE)
    return asked()[0]


def answer(desk: MainWindow, qtbot: QtBot, text: str) -> None:
    """Click an answer, and wait until the question is gone."""
    asked = question(desk, qtbot)
    button = next(b for b in asked.findChildren(QPushButton) if b.text() == text)
    with qtbot.waitSignal(asked.destroyed, timeout=PATIENCE):
        qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def changed(desk: MainWindow, text: str = "changed") -> None:
    desk.studio.document.do(note_project, text)


def press(desk: MainWindow, qtbot: QtBot, action: str, key: Qt.Key) -> None:
    """Press a shortcut with Ctrl once its action is possible."""
    qtbot.waitUntil(desk.studio.actions[action].isEnabled, timeout=PATIENCE)
    desk.activateWindow()
    qtbot.waitUntil(desk.isActiveWindow, timeout=PATIENCE)
    qtbot.keyClick(desk, key, CONTROL)


def idle(desk: MainWindow, qtbot: QtBot) -> None:
    qtbot.waitUntil(lambda: not desk.files.background.busy, timeout=PATIENCE)


def test_ctrl_s_saves_and_the_mark_of_unsaved_changes_goes(
    desk: MainWindow, qtbot: QtBot, folder: Path
) -> None:
    opened(desk, qtbot, folder)
    changed(desk)
    assert desk.isWindowModified()
    press(desk, qtbot, "file.save", Qt.Key.Key_S)
    qtbot.waitUntil(lambda: not desk.isWindowModified(), timeout=PATIENCE)
    assert load(folder).note == "changed"


def test_opening_a_project_that_ships_writes_nothing_into_it(desk: MainWindow, qtbot: QtBot) -> None:
    before = {path: path.stat().st_mtime_ns for path in FORAGING.rglob("*")}
    opened(desk, qtbot, FORAGING)
    changed(desk)
    desk.files.autosaving.keep()
    idle(desk, qtbot)
    assert desk.studio.document.autosaved is not None
    assert {path: path.stat().st_mtime_ns for path in FORAGING.rglob("*")} == before


def test_an_open_project_leaves_nothing_behind_once_it_is_closed(
    desk: MainWindow, qtbot: QtBot, folder: Path
) -> None:
    before = sorted(folder.rglob("*"))
    opened(desk, qtbot, folder)
    assert (folder / NAME / "lock").exists()
    changed(desk)
    desk.files.autosaving.keep()
    idle(desk, qtbot)
    desk.files.close()
    answer(desk, qtbot, "Discard")
    assert not desk.studio.is_open
    idle(desk, qtbot)
    assert sorted(folder.rglob("*")) == before


def test_closing_with_unsaved_work_asks_and_cancel_keeps_the_window(
    desk: MainWindow, qtbot: QtBot, folder: Path
) -> None:
    opened(desk, qtbot, folder)
    changed(desk)
    desk.close()
    assert "unsaved changes" in question(desk, qtbot).text
    answer(desk, qtbot, "Cancel")
    assert desk.isVisible()
    assert desk.studio.document.project.note == "changed"


def test_closing_with_unsaved_work_can_save_it_first(desk: MainWindow, qtbot: QtBot, folder: Path) -> None:
    opened(desk, qtbot, folder)
    changed(desk)
    with qtbot.waitSignal(desk.closed, timeout=PATIENCE):
        desk.close()
        qtbot.keyClick(question(desk, qtbot), Qt.Key.Key_Return)
    assert load(folder).note == "changed"


def test_closing_with_everything_saved_does_not_ask(desk: MainWindow, qtbot: QtBot, folder: Path) -> None:
    opened(desk, qtbot, folder)
    with qtbot.waitSignal(desk.closed, timeout=PATIENCE):
        desk.close()


def test_closing_while_learning_says_so_and_can_wait(
    desk: MainWindow, qtbot: QtBot, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened(desk, qtbot, folder)
    relearning = desk.studio.relearning
    relearning.busy = True
    desk.files.close()
    answer(desk, qtbot, "Wait for it")
    assert desk.studio.is_open
    relearning.busy = False
    relearning.changed.emit()
    assert not desk.studio.is_open


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


def test_two_windows_on_one_project_are_noticed_and_the_second_may_look_only(
    desk: MainWindow, qtbot: QtBot, folder: Path
) -> None:
    other = claims.new_owner()  # this very process, so it lives
    assert claims.claim(folder / NAME, other) is None
    desk.files.open(folder)
    assert f"process {os.getpid()}" in question(desk, qtbot).text
    assert not desk.busy.isVisible()  # it waits for the user, not the user for it
    answer(desk, qtbot, "Open read-only")
    qtbot.waitUntil(lambda: desk.studio.is_open, timeout=PATIENCE)
    assert "(read-only)" in desk.windowTitle()
    changed(desk)
    press(desk, qtbot, "file.save", Qt.Key.Key_S)
    assert desk.findChild(SaveAs) is not None
    assert claims.holder_of(folder / NAME) == other


def test_a_lock_of_a_dead_process_is_taken_over(desk: MainWindow, qtbot: QtBot, folder: Path) -> None:
    ours = claims.new_owner()
    gone = Owner(2**22 + 1, ours.host, "1", ours.since, "gone")
    claims.claim(folder / NAME, gone)
    opened(desk, qtbot, folder)
    assert claims.holder_of(folder / NAME) == desk.files.owner


def test_files_changed_by_somebody_else_are_not_overwritten_unasked(
    desk: MainWindow, qtbot: QtBot, folder: Path, small: Project
) -> None:
    opened(desk, qtbot, folder)
    changed(desk, "mine")
    save(note_project(small, "theirs"), folder)
    desk.files.save()
    asked = question(desk, qtbot)
    assert asked.details is not None
    assert "changed: project.json" in asked.details.toPlainText()
    assert load(folder).note == "theirs"
    answer(desk, qtbot, "Overwrite")
    qtbot.waitUntil(lambda: desk.studio.document.is_saved, timeout=PATIENCE)
    assert load(folder).note == "mine"


def test_files_changed_by_somebody_else_can_be_loaded_instead(
    desk: MainWindow, qtbot: QtBot, folder: Path, small: Project
) -> None:
    opened(desk, qtbot, folder)
    changed(desk, "mine")
    save(note_project(small, "theirs"), folder)
    desk.files.save()
    answer(desk, qtbot, "Reload")
    qtbot.waitUntil(lambda: desk.studio.document.project.note == "theirs", timeout=PATIENCE)
    assert desk.studio.document.is_saved


def test_coming_back_to_the_window_tells_of_changed_files(
    desk: MainWindow, qtbot: QtBot, folder: Path, small: Project
) -> None:
    opened(desk, qtbot, folder)
    idle(desk, qtbot)
    save(note_project(small, "theirs"), folder)
    with qtbot.waitSignal(desk.messages.shown, timeout=PATIENCE) as shown:
        desk.files.look_outside()
    assert shown.args is not None
    assert "somebody else changed" in shown.args[0]


@pytest.mark.parametrize("why", ["the disk is full", "permission denied"])
def test_a_save_that_fails_says_why_and_loses_nothing(
    desk: MainWindow, qtbot: QtBot, folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, why: str
) -> None:
    def refused(_project: Project, folder: Path, _previous: Project | None) -> None:
        raise FilesError(folder, [Problem("project.json", "", f"cannot be written: {why}")])

    opened(desk, qtbot, folder)
    changed(desk)
    monkeypatch.setattr("app.editor.documents.saving.save", refused)
    desk.files.save()
    asked = question(desk, qtbot)
    assert asked.details is not None
    assert why in asked.details.toPlainText()
    monkeypatch.undo()
    answer(desk, qtbot, "Save elsewhere…")
    dialog = desk.findChild(SaveAs)
    assert isinstance(dialog, SaveAs)
    dialog.place.edit.setText(str(tmp_path / "elsewhere"))
    qtbot.keyClick(dialog.place.edit, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: desk.studio.document.is_saved, timeout=PATIENCE)
    assert load(tmp_path / "elsewhere").note == "changed"
    assert claims.holder_of(folder / NAME) is None


def test_a_folder_that_nothing_can_be_written_to_is_told_at_once(
    desk: MainWindow, qtbot: QtBot, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(private, "writable", lambda _folder: False)
    monkeypatch.setattr(opening, "writable", lambda _folder: False)
    with qtbot.waitSignal(desk.messages.shown, timeout=PATIENCE) as shown:
        desk.files.open(folder)
    assert shown.args is not None
    assert f"{folder} cannot be written to" in shown.args[0]
    button = next(b for b in desk.messages.findChildren(QPushButton) if b.text() == "Save elsewhere…")
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert desk.findChild(SaveAs) is not None


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


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_without_write_permission_is_opened_and_told_when_saving(
    desk: MainWindow, qtbot: QtBot, folder: Path
) -> None:
    folder.chmod(stat.S_IRUSR | stat.S_IXUSR)
    try:
        opened(desk, qtbot, folder)
        changed(desk)
        desk.files.save()
        assert "could not be saved" in question(desk, qtbot).windowTitle()
    finally:
        folder.chmod(stat.S_IRWXU)


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


CRASHING = """
import os, sys
from pathlib import Path
from PySide6.QtWidgets import QApplication
from app.core.edits import add_automaton, note_project
from app.editor.application import make_window
from app.editor.settings import Settings

application = QApplication([])
window = make_window(application, Settings(Path(sys.argv[1])))
window.files.open(Path(sys.argv[2]))
document = window.studio.document

def until(ready):
    while not ready():
        application.processEvents()

until(lambda: document.folder is not None)
document.do(note_project, "nearly lost")
window.files.autosaving.keep()
until(lambda: document.autosaved is not None)
print("autosaved", flush=True)
until(lambda: False)
"""


def test_what_a_killed_window_had_autosaved_is_offered_and_recovering_it_can_be_undone(
    desk: MainWindow, qtbot: QtBot, folder: Path, settings: Settings
) -> None:
    killed = subprocess.Popen(
        [sys.executable, "-c", CRASHING, str(settings.state.parent / "settings.ini"), str(folder)],
        stdout=subprocess.PIPE,
        text=True,
    )
    assert killed.stdout is not None
    with killed.stdout:
        assert killed.stdout.readline() == "autosaved\n"
        killed.send_signal(signal.SIGKILL)
        killed.wait()
    assert load(folder).note == ""
    assert [kept.folder for kept in autosaves.left_over(settings.state)] == [folder]
    desk.files.open(folder)
    answer(desk, qtbot, "Recover")
    qtbot.waitUntil(lambda: desk.studio.document.project.note == "nearly lost", timeout=PATIENCE)
    assert desk.isWindowModified()
    press(desk, qtbot, "edit.undo", Qt.Key.Key_Z)
    qtbot.waitUntil(lambda: desk.studio.document.project.note == "", timeout=PATIENCE)
    desk.studio.redo()
    desk.files.save()
    qtbot.waitUntil(lambda: desk.studio.document.is_saved, timeout=PATIENCE)
    assert load(folder).note == "nearly lost"
    idle(desk, qtbot)
    assert not (folder / NAME / "autosave").exists()


def test_a_window_that_is_told_to_end_keeps_what_is_unsaved_before_it_asks(
    desk: MainWindow, qtbot: QtBot, folder: Path
) -> None:
    opened(desk, qtbot, folder)
    desk.studio.document.do(note_project, "nearly lost")
    close_when_told(desk)
    assert question(desk, qtbot).isVisible()
    qtbot.waitUntil(lambda: desk.studio.document.autosaved is not None, timeout=PATIENCE)
    assert (folder / NAME / "autosave").exists()


def test_a_project_that_was_never_saved_is_offered_after_a_crash(
    desk: MainWindow, qtbot: QtBot, settings: Settings, small: Project
) -> None:
    ours = claims.new_owner()
    gone = Owner(2**22 + 1, ours.host, "1", ours.since, "gone")
    autosaves.write(settings.state / "unnamed" / "gone", small, None, gone, None)
    with qtbot.waitSignal(desk.messages.shown, timeout=PATIENCE) as shown:
        desk.files.offer_left_over()
    assert shown.args is not None
    assert "without saving Small" in shown.args[0]
    button = next(b for b in desk.messages.findChildren(QPushButton) if b.text() == "Recover")
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: desk.studio.is_open, timeout=PATIENCE)
    assert desk.studio.document.project == small
    assert desk.isWindowModified()


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


def test_saving_elsewhere_takes_experiments_and_code_along(
    desk: MainWindow, qtbot: QtBot, folder: Path, tmp_path: Path
) -> None:
    (folder / "experiments").mkdir()
    (folder / "experiments" / "one.json").write_text(json.dumps({}), encoding="utf-8")
    opened(desk, qtbot, folder)
    desk.files.saving.into(tmp_path / "copy")
    qtbot.waitUntil(lambda: desk.studio.document.folder == tmp_path / "copy", timeout=PATIENCE)
    assert (tmp_path / "copy" / "experiments" / "one.json").exists()


def test_recent_projects_are_in_the_file_menu(desk: MainWindow, qtbot: QtBot, folder: Path) -> None:
    desk.studio.settings.remember(folder)
    desk.recent.aboutToShow.emit()
    (entry,) = desk.recent.actions()
    entry.trigger()
    qtbot.waitUntil(lambda: desk.studio.document.folder == folder, timeout=PATIENCE)


def test_of_a_damaged_project_the_autosave_can_be_opened_instead(
    desk: MainWindow, qtbot: QtBot, folder: Path, small: Project
) -> None:
    ours = claims.new_owner()
    gone = Owner(2**22 + 1, ours.host, "1", ours.since, "gone")
    autosaves.write(folder / NAME, note_project(small, "kept"), folder, gone, None)
    (folder / "project.json").write_text("{", encoding="utf-8")
    desk.files.open(folder)
    answer(desk, qtbot, "Open the autosave")
    qtbot.waitUntil(lambda: desk.studio.document.project.note == "kept", timeout=PATIENCE)
    assert desk.isWindowModified()
