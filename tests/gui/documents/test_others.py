"""Other windows and other people at the same project."""

import os
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton
from pytestqt.qtbot import QtBot

from app.core.edits import note_project
from app.core.project import Project
from app.core.storage import load, save
from app.editor.documents import claims
from app.editor.documents.claims import Owner
from app.editor.documents.private import NAME
from app.editor.documents.save_as import SaveAs
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE

from .desk import answer, changed, idle, opened, press, question


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


def test_a_file_in_the_place_of_the_windows_own_folder_is_told_and_once_it_is_gone_the_project_is_claimed(
    desk: MainWindow, qtbot: QtBot, folder: Path
) -> None:
    (folder / NAME).write_text("not mine")
    told: list[str] = []
    desk.messages.shown.connect(told.append)
    opened(desk, qtbot, folder)
    qtbot.waitUntil(lambda: bool(told), timeout=PATIENCE)
    assert f"{folder / NAME} is a file, where Understudy needs a folder of that name" in told[-1]
    assert not desk.files.held.claimed
    changed(desk, "mine")
    press(desk, qtbot, "file.save", Qt.Key.Key_S)
    qtbot.waitUntil(lambda: desk.studio.document.is_saved, timeout=PATIENCE)
    assert (folder / NAME).read_text() == "not mine"
    assert len(told) == 1
    (folder / NAME).unlink()
    reload = next(b for b in desk.messages.findChildren(QPushButton) if b.text() == "Reload…")
    qtbot.mouseClick(reload, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: desk.files.held.claimed, timeout=PATIENCE)
    assert claims.holder_of(folder / NAME) == desk.files.owner
    assert desk.studio.document.project.note == "mine"


def test_saved_into_a_folder_where_a_file_is_in_the_way_of_the_claim_that_is_told(
    desk: MainWindow, qtbot: QtBot, folder: Path, tmp_path: Path
) -> None:
    opened(desk, qtbot, folder)
    (tmp_path / "there").mkdir()
    (tmp_path / "there" / NAME).write_text("not mine")
    with qtbot.waitSignal(desk.messages.shown, timeout=PATIENCE) as shown:
        desk.files.saving.into(tmp_path / "there")
    assert shown.args is not None
    assert "other windows are not told that this one has the project open" in shown.args[0]
    assert load(tmp_path / "there").name == "Small"


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
