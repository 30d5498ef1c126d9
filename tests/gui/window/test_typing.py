"""What is typed into a field counts for the command that follows, though the keys are still in the field."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLineEdit
from pytestqt.qtbot import QtBot

from app.editor.graph.panel import GraphPanel
from app.editor.selection import BehaviorKey
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE
from tests.gui.graph.author import CTRL, Author

FORAGE = BehaviorKey("agent", "forage")


@pytest.fixture
def note(window: MainWindow, qtbot: QtBot) -> QLineEdit:
    """The note on a state, with the keys in it."""
    panel = window.docks["graph"].widget()
    assert isinstance(panel, GraphPanel)
    author = Author(panel, qtbot)
    author.settle()
    window.studio.selection.select_behavior(FORAGE)
    author.settle()
    author.click(author.named("Wander"))
    author.trigger("graph.edit")
    field = panel.form.state.note
    qtbot.waitUntil(field.isVisible, timeout=PATIENCE)
    field.setFocus()
    qtbot.waitUntil(field.hasFocus, timeout=PATIENCE)
    return field


def noted(window: MainWindow) -> str:
    automaton = window.studio.document.automaton(FORAGE.type, FORAGE.id)
    assert automaton is not None
    return automaton.state("wander").note


def test_a_note_counts_before_what_a_shortcut_does(window: MainWindow, note: QLineEdit, qtbot: QtBot) -> None:
    assert not window.studio.actions["file.save"].isEnabled()
    qtbot.keyClicks(note, "look for boxes")
    assert noted(window) == ""
    qtbot.keyPress(note, Qt.Key.Key_Control, CTRL)
    assert noted(window) == ""
    qtbot.keyClick(note, Qt.Key.Key_L, CTRL)
    assert noted(window) == "look for boxes"
    assert window.studio.actions["file.save"].isEnabled()


@pytest.mark.parametrize(
    ("keys", "key", "modifiers"),
    [
        ("F9", Qt.Key.Key_F9, Qt.KeyboardModifier.NoModifier),
        ("Meta+J", Qt.Key.Key_J, Qt.KeyboardModifier.MetaModifier),
    ],
)
def test_a_note_counts_before_what_ones_own_keys_do(
    window: MainWindow, note: QLineEdit, qtbot: QtBot, keys: str, key: Qt.Key, modifiers: Qt.KeyboardModifier
) -> None:
    seen: list[str] = []
    window.studio.settings.set_key("run.step", keys)
    window.studio.actions["run.step"].triggered.connect(lambda: seen.append(noted(window)))
    qtbot.keyClicks(note, "look for boxes")
    assert noted(window) == ""
    qtbot.keyClick(note, key, modifiers)
    assert seen == ["look for boxes"]


def test_a_note_counts_when_the_window_is_closed(window: MainWindow, note: QLineEdit, qtbot: QtBot) -> None:
    qtbot.keyClicks(note, "look for boxes")
    window.close()
    assert noted(window) == "look for boxes"
    assert window.isVisible()  # it asks first whether that is to be saved
