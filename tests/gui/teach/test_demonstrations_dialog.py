"""The demonstrations are listed, put in order, noted and removed, each as a step that can be undone."""

import threading
from collections.abc import Iterator
from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from app.core.edits import disable_examples, remove_demonstration, replace_demonstration
from app.editor.teach.demonstrations_dialog import DemonstrationsDialog
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE


@pytest.fixture
def dialog(window: MainWindow, qtbot: QtBot) -> Iterator[DemonstrationsDialog]:
    qtbot.waitUntil(window.studio.actions["behavior.demonstrations"].isEnabled, timeout=PATIENCE)
    window.studio.actions["behavior.demonstrations"].trigger()
    (dialog,) = window.findChildren(DemonstrationsDialog)
    with qtbot.waitExposed(dialog):
        pass  # it has shown itself
    yield dialog
    if isValid(dialog):
        dialog.close()


def listed(dialog: DemonstrationsDialog) -> list[str]:
    return [dialog.list.list.item(row).text() for row in range(dialog.list.list.count())]


def test_all_are_listed_with_what_they_are(dialog: DemonstrationsDialog, window: MainWindow) -> None:
    assert listed(dialog) == [d.id for d in window.studio.document.project.demonstrations]
    dialog.list.choose("wander-1")
    assert dialog.facts.text() == (
        "Wander (agent) was taught in the arm independent, seed 1: 5 picks in 451 ticks, 10 examples."
    )
    assert dialog.note.text() == "Ahead, a turn left, ahead, a turn right, ahead."


def test_they_are_put_in_order_and_removed_by_keys(
    dialog: DemonstrationsDialog, window: MainWindow, qtbot: QtBot
) -> None:
    before = listed(dialog)
    dialog.list.choose(before[1])
    qtbot.keyClick(dialog.list.list, Qt.Key.Key_Up, Qt.KeyboardModifier.AltModifier)
    assert listed(dialog) == [before[1], before[0], *before[2:]]
    qtbot.keyClick(dialog.list.list, Qt.Key.Key_Delete)
    assert listed(dialog) == [before[0], *before[2:]]
    assert window.studio.document.history.undo_text == f"Remove demonstration {before[1]}"
    window.studio.undo()
    window.studio.undo()
    assert listed(dialog) == before


def test_a_note_is_kept(dialog: DemonstrationsDialog, window: MainWindow, qtbot: QtBot) -> None:
    dialog.list.choose("wander-1")
    dialog.note.setFocus()
    dialog.note.selectAll()
    qtbot.keyClicks(dialog.note, "Round and round.")
    qtbot.keyClick(dialog.note, Qt.Key.Key_Return)
    found = {d.id: d.note for d in window.studio.document.project.demonstrations}
    assert found["wander-1"] == "Round and round."


# ------------------------------------------------------------------------------------------ the check by playing


@pytest.fixture
def short(dialog: DemonstrationsDialog, window: MainWindow) -> DemonstrationsDialog:
    """The dialog with one short demonstration."""
    document = window.studio.document
    for shown in document.project.demonstrations:
        if shown.id != "wander-1":
            document.do(remove_demonstration, shown.id)
    return dialog


def ends(thread: threading.Thread) -> bool:
    thread.join(PATIENCE / 1000)
    return not thread.is_alive()


def played(dialog: DemonstrationsDialog, qtbot: QtBot) -> str:
    with qtbot.waitSignal(dialog.check.ended, timeout=PATIENCE):
        qtbot.mouseClick(dialog.check.start, Qt.MouseButton.LeftButton)
        assert dialog.check.is_running
        assert dialog.check.stop.isVisible()
    assert not dialog.check.stop.isVisible()
    return dialog.check.words.text()


def test_playing_them_says_that_all_is_the_same_or_which_examples_are_not(
    short: DemonstrationsDialog, window: MainWindow, qtbot: QtBot
) -> None:
    before = window.studio.document.project
    assert played(short, qtbot) == "All is the same: 10 examples would be recorded just as they are."
    assert window.studio.document.project is before
    window.studio.document.do(disable_examples, "agent", "wander", ["3"])
    assert "has changed" in short.check.words.text()
    assert played(short, qtbot) == "1 difference among 10 examples:"
    assert "example 3" in short.check.differences.item(0).text()
    assert "as one to learn from" in short.check.differences.item(0).text()


def test_playing_is_cancelled_by_a_click_by_an_edit_and_by_closing(
    short: DemonstrationsDialog, window: MainWindow, qtbot: QtBot
) -> None:
    qtbot.mouseClick(short.check.start, Qt.MouseButton.LeftButton)
    qtbot.mouseClick(short.check.stop, Qt.MouseButton.LeftButton)
    assert not short.check.is_running
    assert "Cancelled" in short.check.words.text()
    qtbot.mouseClick(short.check.start, Qt.MouseButton.LeftButton)
    window.studio.document.do(disable_examples, "agent", "wander", ["3"])
    assert not short.check.is_running
    assert "given up" in short.check.words.text()
    qtbot.mouseClick(short.check.start, Qt.MouseButton.LeftButton)
    with qtbot.waitSignal(short.destroyed, timeout=PATIENCE):
        short.reject()
    assert all(
        thread.name.partition("_")[0] != "replayer" or ends(thread) for thread in threading.enumerate()
    )


def test_what_cannot_be_played_is_said(short: DemonstrationsDialog, window: MainWindow, qtbot: QtBot) -> None:
    (shown,) = window.studio.document.project.demonstrations
    picks = tuple(replace(pick, node="agent-99") for pick in shown.picks)
    window.studio.document.do(replace_demonstration, shown.id, replace(shown, picks=picks))
    assert "cannot be played: demonstration 'wander-1'" in played(short, qtbot)
    window.studio.document.do(remove_demonstration, shown.id)
    assert not short.check.start.isEnabled()
