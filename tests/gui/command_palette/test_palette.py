"""The command palette: everything is found by a few letters and done by Enter."""

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.editor.command_palette.catalog import Catalog, Entry, Section
from app.editor.command_palette.palette import Palette
from app.editor.preferences.dialog import Preferences
from app.editor.studio import Studio
from app.editor.theme import ThemeMode
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE


@pytest.fixture
def palette(window: MainWindow, qtbot: QtBot) -> Palette:
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow, timeout=PATIENCE)
    qtbot.keyClick(window, Qt.Key.Key_K, Qt.KeyboardModifier.ControlModifier)
    assert window.palette_search.isVisible()
    return window.palette_search


def first(palette: Palette, qtbot: QtBot, query: str) -> str:
    """What is found first by *query*, as "kind: text"."""
    palette.line.clear()
    qtbot.keyClicks(palette.line, query)
    entry = palette.model.entries[palette.list.currentIndex().row()]
    return f"{entry.kind}: {entry.text}"


@pytest.mark.parametrize(
    ("query", "found"),
    [
        ("rwb", "behavior: ReturnWithBox"),
        ("save as", "action: Save as…"),
        ("agent-17", "agent: agent-17"),
        ("two lev", "arm: two levels"),
        ("grab range", "parameter: grab range"),
        ("autosave", "setting: Autosave interval"),
    ],
)
def test_everything_is_found_by_a_few_letters(palette: Palette, qtbot: QtBot, query: str, found: str) -> None:
    assert first(palette, qtbot, query) == found


def test_enter_does_an_action(palette: Palette, qtbot: QtBot, studio: Studio) -> None:
    assert first(palette, qtbot, "dark theme") == "action: Dark theme"
    qtbot.keyClick(palette.line, Qt.Key.Key_Return)
    assert studio.settings.theme is ThemeMode.DARK
    assert not palette.isVisible()


def test_enter_selects_a_node_and_shows_a_behavior(palette: Palette, qtbot: QtBot, studio: Studio) -> None:
    first(palette, qtbot, "agent-17")
    qtbot.keyClick(palette.line, Qt.Key.Key_Return)
    assert studio.selection.nodes == ("agent-17",)
    palette.open()
    first(palette, qtbot, "gath")
    qtbot.keyClick(palette.line, Qt.Key.Key_Return)
    assert studio.selection.behavior is not None
    assert studio.selection.behavior.id == "gather-at"


def test_a_setting_opens_the_preferences_there(palette: Palette, qtbot: QtBot, window: MainWindow) -> None:
    first(palette, qtbot, "autosave")
    qtbot.keyClick(palette.line, Qt.Key.Key_Return)
    dialog = window.findChild(Preferences)
    assert isinstance(dialog, Preferences)
    qtbot.waitUntil(dialog.autosave.hasFocus, timeout=PATIENCE)
    dialog.close()


def test_a_parameter_is_changed_by_typing_and_the_arm_begins_again(
    palette: Palette, qtbot: QtBot, studio: Studio
) -> None:
    assert first(palette, qtbot, "boxes") == "parameter: boxes"
    qtbot.keyClick(palette.line, Qt.Key.Key_Return)
    qtbot.keyClicks(palette.line, "many")
    qtbot.keyClick(palette.line, Qt.Key.Key_Return)
    assert "whole number" in palette.problem.text()
    palette.line.selectAll()
    qtbot.keyClicks(palette.line, "3")
    with qtbot.waitSignal(studio.bridge.place_changed, timeout=PATIENCE):
        qtbot.keyClick(palette.line, Qt.Key.Key_Return)
    assert studio.snapshot is not None
    assert studio.snapshot.place.parameters["boxes"] == 3
    assert studio.document.history.undo_text == "Change arm independent"


def test_arrow_keys_move_and_escape_leaves(palette: Palette, qtbot: QtBot) -> None:
    first(palette, qtbot, "go")
    before = palette.list.currentIndex().row()
    qtbot.keyClick(palette.line, Qt.Key.Key_Down)
    assert palette.list.currentIndex().row() != before
    qtbot.keyClick(palette.line, Qt.Key.Key_Up)
    assert palette.list.currentIndex().row() == before
    qtbot.keyClick(palette.line, Qt.Key.Key_Escape)
    assert not palette.isVisible()


def test_what_is_not_there_is_said_to_be_not_there(palette: Palette, qtbot: QtBot) -> None:
    palette.line.clear()
    qtbot.keyClicks(palette.line, "xyzzyq")
    assert "Nothing is called" in palette.problem.text()
    qtbot.keyClick(palette.line, Qt.Key.Key_Return)
    assert palette.isVisible()


def test_the_field_in_the_menu_bar_opens_it(window: MainWindow, qtbot: QtBot) -> None:
    qtbot.mouseClick(window.search_field.button, Qt.MouseButton.LeftButton)
    assert window.palette_search.isVisible()
    assert window.palette_search.line.hasFocus()
    window.palette_search.leave()


def test_more_letters_narrow_down_what_fewer_found() -> None:
    texts = [f"agent-{number}" for number in range(1, 501)]
    grown = Catalog([Section("agent", texts, lambda at: Entry("agent", texts[at]))])
    fresh = Catalog([Section("agent", texts, lambda at: Entry("agent", texts[at]))])
    for end in range(1, len("agent-49") + 1):
        narrowed = grown.find("agent-49"[:end])
    assert narrowed == fresh.find("agent-49")
    assert narrowed[0].text == "agent-49"
