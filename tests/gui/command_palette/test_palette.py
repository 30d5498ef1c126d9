"""The command palette: everything is found by a few letters and done by Enter."""

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.editor.command_palette.catalog import Catalog, Entry, Section, catalog_of
from app.editor.command_palette.other_words import OTHER_WORDS, SETTING_WORDS
from app.editor.command_palette.palette import Palette
from app.editor.preferences.dialog import SETTINGS, Preferences
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
        ("agent-17", "agent: Agent 17"),
        ("17 agent", "agent: Agent 17"),
        ("two lev", "arm: two levels"),
        ("grab range", "parameter: grab range"),
        ("autosave", "setting: Autosave interval"),
    ],
)
def test_everything_is_found_by_a_few_letters(palette: Palette, qtbot: QtBot, query: str, found: str) -> None:
    assert first(palette, qtbot, query) == found


#: What newcomers type, and what they are after.
TYPED = {
    "undo": "Undo",
    "dark theme": "Dark theme",
    "theme dark": "Dark theme",
    "night mode": "Dark theme",
    "save as": "Save as…",
    "copy project": "Save as…",
    "load project": "Open…",
    "exit": "Quit",
    "export c": "Export…",
    "share behavior": "Export…",
    "import library": "Import behaviors…",
    "record": "Teach",
    "replay": "Demonstrations…",
    "fast": "Faster",
    "speed": "Faster",
    "slower": "Slower",
    "slow down": "Slower",
    "pause": "Play",
    "restart": "Reset",
    "random seed": "Reset with the next seed",
    "collisions": "Rigid physics",
    "autosave": "Autosave interval",
    "font": "Size",
    "shortcuts": "Keys",
    "keys": "Keys",
    "tutorial": "Guided first lesson",
    "version": "About Understudy…",
    "new behavior": "New automaton…",
    "add agent": "Add node",
    "number of agents": "Arms and worlds…",
    "world size": "Arms and worlds…",
    "compare": "Experiments…",
    "statistics runs": "Experiments…",
    "plot": "Plot over time",
    "chart": "Plot over time",
    "trail": "Trails of the selected",
    "hulls": "Group hulls",
    "sight": "sight",
    "reset layout": "Standard layout",
    "explain": "Show the examples that decide",
    "ctrl+s": "Save",
}


def test_newcomers_find_what_they_are_after_by_their_own_words(palette: Palette, qtbot: QtBot) -> None:
    missed = {}
    for query, wanted in TYPED.items():
        palette.line.clear()
        qtbot.keyClicks(palette.line, query)
        found = [entry.text for entry in palette.model.entries[:3]]
        if wanted not in found:
            missed[query] = found
    assert not missed


def test_scattered_letters_find_something_only_where_words_do_not(palette: Palette, qtbot: QtBot) -> None:
    assert first(palette, qtbot, "speed") == "action: Faster"
    assert "Show the examples that decide" not in [entry.text for entry in palette.model.entries]
    assert first(palette, qtbot, "rtrnbx") == "behavior: ReturnWithBox"


def test_what_is_not_possible_now_says_why(palette: Palette, qtbot: QtBot) -> None:
    palette.line.clear()
    qtbot.keyClicks(palette.line, "undo")
    (undo,) = [entry for entry in palette.model.entries if entry.text == "Undo"]
    assert (undo.do, undo.detail) == (None, "not now: nothing has been done yet")


def test_other_words_are_those_of_actions_and_settings_that_there_are(
    palette: Palette, studio: Studio
) -> None:
    assert set(OTHER_WORDS) <= set(studio.actions.rows)
    assert set(SETTING_WORDS) == {text for _, text, _ in SETTINGS}


def test_every_action_is_found_by_its_name_with_the_words_turned_around(
    palette: Palette, studio: Studio
) -> None:
    catalog = catalog_of(studio)
    names = {
        action: studio.actions.text_of(action) for action in studio.actions.rows if action != "help.palette"
    }
    missed = [
        name
        for name in names.values()
        if name not in [entry.text for entry in catalog.find(" ".join(reversed(name.rstrip("…").split())))]
    ]
    assert not missed


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
    assert "Nothing is found by" in palette.problem.text()
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


def test_an_agent_is_found_by_all_of_its_words_among_ten_thousand() -> None:
    names = [f"Agent {number}" for number in range(1, 10001)]
    ids = [name.lower().replace(" ", "-") for name in names]
    catalog = Catalog([Section("agent", names, lambda at: Entry("agent", names[at]), others=ids)])
    for query in ("Agent 9876", "9876", "9876 agent", "agent-9876", "a9876"):
        assert catalog.find(query)[0].text == "Agent 9876"
