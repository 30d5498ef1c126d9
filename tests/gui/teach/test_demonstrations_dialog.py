"""The demonstrations are listed, put in order, noted and removed, each as a step that can be undone."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.editor.teach.demonstrations_dialog import DemonstrationsDialog
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE


@pytest.fixture
def dialog(window: MainWindow, qtbot: QtBot) -> Iterator[DemonstrationsDialog]:
    qtbot.waitUntil(window.studio.actions["behavior.demonstrations"].isEnabled, timeout=PATIENCE)
    window.studio.actions["behavior.demonstrations"].trigger()
    (dialog,) = window.findChildren(DemonstrationsDialog)
    qtbot.waitExposed(dialog)
    yield dialog
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
