"""What a window that was killed, or told to end, had not saved."""

import signal
import subprocess
import sys
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton
from pytestqt.qtbot import QtBot

from app.core.edits import note_project
from app.core.project import Project
from app.core.storage import load
from app.editor.application import close_when_told
from app.editor.documents import autosaves, claims
from app.editor.documents.claims import Owner
from app.editor.documents.private import NAME
from app.editor.settings import Settings
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE

from .desk import answer, idle, opened, press, question

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


def test_a_window_that_is_told_to_end_does_so_also_while_a_message_is_open(
    desk: MainWindow, qtbot: QtBot, folder: Path
) -> None:
    (folder / "project.json").write_text("{", encoding="utf-8")
    desk.files.open(folder)
    question(desk, qtbot)
    with qtbot.waitSignal(desk.closed, timeout=PATIENCE):
        close_when_told(desk)


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


def test_who_says_at_the_start_that_a_project_is_to_be_recovered_is_not_asked_again(
    desk: MainWindow, qtbot: QtBot, settings: Settings, folder: Path, small: Project
) -> None:
    ours = claims.new_owner()
    gone = Owner(2**22 + 1, ours.host, "1", ours.since, "gone")
    autosaves.write(folder / NAME, note_project(small, "kept"), folder, gone, None)
    autosaves.note(settings.state, gone, folder / NAME)
    with qtbot.waitSignal(desk.messages.shown, timeout=PATIENCE) as shown:
        desk.files.offer_left_over()
    assert shown.args is not None
    assert f"without saving Small in {folder}" in shown.args[0]  # several may be called so
    button = next(b for b in desk.messages.findChildren(QPushButton) if b.text() == "Recover")
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: desk.studio.document.project.note == "kept", timeout=PATIENCE)
    assert desk.studio.document.folder == folder


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


def test_of_a_damaged_autosave_it_is_said_and_the_project_opens_as_it_was_saved(
    desk: MainWindow, qtbot: QtBot, folder: Path, small: Project
) -> None:
    ours = claims.new_owner()
    gone = Owner(2**22 + 1, ours.host, "1", ours.since, "gone")
    autosaves.write(folder / NAME, note_project(small, "kept"), folder, gone, None)
    damaged = folder / NAME / "autosave" / "project.json"
    damaged.write_text("{", encoding="utf-8")
    desk.files.open(folder)
    answer(desk, qtbot, "Recover")
    asked = question(desk, qtbot)
    assert asked.windowTitle() == "What was autosaved cannot be read"  # the project was said to be damaged
    assert asked.details is not None
    assert str(damaged) in asked.details.toPlainText()
    answer(desk, qtbot, "Open as it was saved")
    qtbot.waitUntil(lambda: desk.studio.document.folder == folder, timeout=PATIENCE)
    assert damaged.exists()


def test_unsaved_work_is_autosaved_by_itself_every_so_many_seconds(
    desk: MainWindow, qtbot: QtBot, folder: Path, settings: Settings
) -> None:
    settings.autosave_seconds = 1
    opened(desk, qtbot, folder)
    desk.studio.document.do(note_project, "kept by itself")
    qtbot.waitUntil(lambda: desk.studio.document.autosaved is not None, timeout=PATIENCE)
    assert (folder / NAME / "autosave").exists()
    assert load(folder).note == ""
    assert desk.isWindowModified()
