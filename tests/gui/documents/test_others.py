"""Other windows and other people at the same project."""

import os
from pathlib import Path

from PySide6.QtCore import Qt
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
