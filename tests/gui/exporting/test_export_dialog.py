"""Exporting from the window."""

import json
from pathlib import Path
from shlex import split

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QPushButton
from pytestqt.qtbot import QtBot

from app.editor.documents.asking import Question
from app.editor.exporting.command import command
from app.editor.exporting.dialog import ExportDialog
from app.editor.window.main_window import MainWindow
from app.export.library_file import read
from tests.gui.conftest import PATIENCE


@pytest.fixture
def dialog(window: MainWindow, qtbot: QtBot) -> ExportDialog:
    window.studio.actions["file.export"].trigger()
    (dialog,) = window.findChildren(ExportDialog)
    with qtbot.waitExposed(dialog):
        pass  # it has shown itself
    return dialog


def press_ok(dialog: ExportDialog, qtbot: QtBot) -> None:
    qtbot.mouseClick(dialog.buttons.button(QDialogButtonBox.StandardButton.Ok), Qt.MouseButton.LeftButton)


def write_to(dialog: ExportDialog, path: Path, qtbot: QtBot) -> None:
    dialog.path.selectAll()
    qtbot.keyClicks(dialog.path, str(path))


def test_the_arm_that_is_shown_is_offered_first_and_written(
    window: MainWindow, dialog: ExportDialog, qtbot: QtBot, tmp_path: Path
) -> None:
    assert dialog.what.currentText() == "Arm: independent"
    assert dialog.path.text().endswith("independent.json")
    write_to(dialog, tmp_path / "out.json", qtbot)
    with qtbot.waitSignal(window.messages.shown, timeout=PATIENCE) as shown:
        press_ok(dialog, qtbot)
    assert shown.args is not None
    line = command("run", str(tmp_path / "out.json"))
    assert line in shown.args[0]
    copy = next(b for b in window.messages.findChildren(QPushButton) if b.text() == "Copy the command")
    qtbot.mouseClick(copy, Qt.MouseButton.LeftButton)
    assert QApplication.clipboard().text() == line
    assert Path(split(line)[0]).is_file()  # it said "understudy", which no clone has in its terminal
    assert read(tmp_path / "out.json").project.arms[0].name == "independent"


def test_a_file_that_is_there_is_replaced_only_by_who_wants_that(
    window: MainWindow, dialog: ExportDialog, qtbot: QtBot, tmp_path: Path
) -> None:
    path = tmp_path / "out.json"
    path.write_text("mine")
    write_to(dialog, path, qtbot)
    for place, key in ((1, Qt.Key.Key_Escape), (0, Qt.Key.Key_Return)):
        press_ok(dialog, qtbot)
        qtbot.waitUntil(lambda: len(asked(dialog)) == 1, timeout=PATIENCE)
        (question,) = asked(dialog)
        assert path.read_text() == "mine"
        with qtbot.waitSignal(question.destroyed, timeout=PATIENCE):
            qtbot.keyClick(question.buttons[place], key)
    qtbot.waitUntil(lambda: path.read_text() != "mine", timeout=PATIENCE)
    assert read(path).project.arms[0].name == "independent"


def asked(dialog: ExportDialog) -> list[Question]:
    return [question for question in dialog.findChildren(Question) if question.isVisible()]


def test_a_behavior_is_chosen_by_keys(
    window: MainWindow, dialog: ExportDialog, qtbot: QtBot, tmp_path: Path
) -> None:
    dialog.what.setFocus()
    while not dialog.what.currentText().startswith("Behavior: Wander (agent)"):
        before = dialog.what.currentIndex()
        qtbot.keyClick(dialog.what, Qt.Key.Key_Down)
        assert dialog.what.currentIndex() != before
    assert dialog.path.text().endswith("wander.json")
    write_to(dialog, tmp_path / "w.json", qtbot)
    press_ok(dialog, qtbot)
    qtbot.waitUntil((tmp_path / "w.json").exists, timeout=PATIENCE)
    assert json.loads((tmp_path / "w.json").read_text())["arms"][0]["top"] == "Wander"


def test_examples_come_along_where_that_is_ticked(
    window: MainWindow, dialog: ExportDialog, qtbot: QtBot, tmp_path: Path
) -> None:
    write_to(dialog, tmp_path / "out.json", qtbot)
    qtbot.keyClick(dialog.examples, Qt.Key.Key_Space)
    with qtbot.waitSignal(window.messages.shown, timeout=PATIENCE):
        press_ok(dialog, qtbot)
    examples = read(tmp_path / "out.json").project.examples["agent"]
    there = window.studio.document.project.examples["agent"]
    assert {key: len(taught) for key, taught in examples.items()} == {
        key: len(there[key]) for key in examples
    }


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("out.txt", "end with .json"),
        ("nowhere/out.json", "there is no folder"),
        (f"{'n' * 300}/out.json", "the name is too long"),
        (f"{'n' * 300}.json", "the name is too long"),
    ],
)
def test_what_is_wrong_is_said_in_the_dialog(
    dialog: ExportDialog, qtbot: QtBot, tmp_path: Path, name: str, message: str
) -> None:
    write_to(dialog, tmp_path / name, qtbot)
    press_ok(dialog, qtbot)
    qtbot.waitUntil(lambda: message in dialog.trouble.text(), timeout=PATIENCE)
    qtbot.keyClicks(dialog.path, "x")
    assert dialog.trouble.text() == ""  # it was about another file
    dialog.reject()
