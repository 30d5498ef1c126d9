"""Saving as a user meets it: what is kept, what is not overwritten, and what is said when it fails."""

import json
import os
import stat
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton
from pytestqt.qtbot import QtBot

from app.core.project import Project
from app.core.storage import FilesError, Problem, load
from app.editor.documents import claims, opening, private
from app.editor.documents.private import NAME
from app.editor.documents.save_as import SaveAs
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import FORAGING, PATIENCE

from .desk import answer, changed, idle, opened, press, question


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
    before = files_of_foraging()
    opened(desk, qtbot, FORAGING)
    changed(desk)
    desk.files.autosaving.keep()
    idle(desk, qtbot)
    assert desk.studio.document.autosaved is not None
    assert files_of_foraging() == before


def files_of_foraging() -> dict[Path, int]:
    """When each file was written. Folders are left out: on some file systems trying whether one can be written to shows."""
    return {path: path.stat().st_mtime_ns for path in FORAGING.rglob("*") if path.is_file()}


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


def test_that_a_folder_cannot_be_written_to_is_not_told_any_more_once_another_one_is_taken(
    desk: MainWindow, qtbot: QtBot, folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as context:
        context.setattr(opening, "writable", lambda _folder: False)
        with qtbot.waitSignal(desk.messages.shown, timeout=PATIENCE):
            desk.files.open(folder)
    changed(desk)
    idle(desk, qtbot)
    assert desk.messages.isVisible()
    desk.files.save_as()
    dialog = desk.findChild(SaveAs)
    assert isinstance(dialog, SaveAs)
    dialog.place.edit.setText(str(tmp_path / "elsewhere"))
    qtbot.keyClick(dialog.place.edit, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: desk.messages.current is None, timeout=PATIENCE)
    assert desk.studio.document.folder == tmp_path / "elsewhere"


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


def test_saving_elsewhere_takes_experiments_and_code_along(
    desk: MainWindow, qtbot: QtBot, folder: Path, tmp_path: Path
) -> None:
    (folder / "experiments").mkdir()
    (folder / "experiments" / "one.json").write_text(json.dumps({}), encoding="utf-8")
    opened(desk, qtbot, folder)
    desk.files.saving.into(tmp_path / "copy")
    qtbot.waitUntil(lambda: desk.studio.document.folder == tmp_path / "copy", timeout=PATIENCE)
    assert (tmp_path / "copy" / "experiments" / "one.json").exists()
