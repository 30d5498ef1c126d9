"""Preferences hold at once, and keys are never given to two actions."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from pytestqt.qtbot import QtBot

from app.editor.icons import icon
from app.editor.preferences.dialog import Preferences, open_preferences
from app.editor.studio import Studio
from app.editor.theme import ThemeMode
from app.editor.window.main_window import MainWindow
from app.engine.commands import Play
from tests.gui.conftest import PATIENCE

CONTROL = Qt.KeyboardModifier.ControlModifier


@pytest.fixture
def preferences(window: MainWindow, qtbot: QtBot) -> Iterator[Preferences]:
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow, timeout=PATIENCE)
    qtbot.keyClick(window, Qt.Key.Key_Comma, CONTROL)
    qtbot.waitUntil(lambda: window.findChild(Preferences) is not None, timeout=PATIENCE)
    dialog = window.findChild(Preferences)
    assert isinstance(dialog, Preferences)
    yield dialog
    dialog.close()


def press(preferences: Preferences, qtbot: QtBot, action: str, key: Qt.Key) -> None:
    """Give an action other keys as a user does."""
    preferences.show_setting("keys")
    preferences.keys.select(action)
    preferences.keys.edit.setFocus()
    with qtbot.waitSignal(preferences.keys.edit.editingFinished, timeout=PATIENCE):
        qtbot.keyClick(preferences.keys.edit, key, CONTROL | Qt.KeyboardModifier.AltModifier)


def test_the_theme_changes_at_once(preferences: Preferences, qtbot: QtBot, studio: Studio) -> None:
    preferences.theme.setFocus()
    qtbot.keyClick(preferences.theme, Qt.Key.Key_Down)
    assert studio.settings.theme is ThemeMode.DARK
    assert studio.theme.is_dark


def test_the_size_of_text_and_controls_is_kept(
    preferences: Preferences, qtbot: QtBot, studio: Studio
) -> None:
    preferences.size_of_all.addItem("125%", 125)  # the screen of tests is small
    preferences.size_of_all.setFocus()
    qtbot.keyClick(preferences.size_of_all, Qt.Key.Key_End)
    assert studio.settings.size_percent == 125


def test_autosave_and_learning_are_kept(preferences: Preferences, qtbot: QtBot, studio: Studio) -> None:
    preferences.autosave.setFocus()
    qtbot.keyClick(preferences.autosave, Qt.Key.Key_Up)
    assert studio.settings.autosave_seconds == 5
    preferences.learns.setFocus()
    qtbot.keyClick(preferences.learns, Qt.Key.Key_Space)
    assert not studio.settings.learns_by_itself


def test_an_action_gets_other_keys_and_its_own_back(
    preferences: Preferences, qtbot: QtBot, studio: Studio
) -> None:
    press(preferences, qtbot, "run.reset", Qt.Key.Key_J)
    assert studio.actions["run.reset"].shortcut() == QKeySequence("Ctrl+Alt+J")
    qtbot.mouseClick(preferences.keys.reset, Qt.MouseButton.LeftButton)
    assert studio.actions["run.reset"].shortcut() == QKeySequence("Ctrl+R")
    assert studio.settings.keys == {}


def test_what_is_going_on_is_still_shown_after_keys_or_the_theme_were_changed(
    preferences: Preferences, qtbot: QtBot, studio: Studio
) -> None:
    def shown() -> str:
        """What the icon of Play looks like: "play", "pause", or something else."""
        looks = studio.actions["run.play"].icon().pixmap(16).toImage()
        names = ("play", "pause")
        return next((name for name in names if icon(name, studio.theme).pixmap(16).toImage() == looks), "")

    studio.bridge.send(Play(0.5))
    qtbot.waitUntil(lambda: shown() == "pause")
    press(preferences, qtbot, "run.reset", Qt.Key.Key_J)
    assert shown() == "pause"
    studio.settings.theme = ThemeMode.DARK
    assert shown() == "pause"


def test_keys_that_another_action_has_are_refused_with_its_name(
    preferences: Preferences, qtbot: QtBot, studio: Studio
) -> None:
    press(preferences, qtbot, "run.reset", Qt.Key.Key_J)
    press(preferences, qtbot, "run.play", Qt.Key.Key_J)
    assert "is taken by Reset" in preferences.keys.conflict.text()
    assert studio.actions["run.play"].shortcut() == QKeySequence("Space")


def test_escape_is_no_shortcut_but_goes_back_to_the_actions(
    preferences: Preferences, qtbot: QtBot, studio: Studio
) -> None:
    preferences.show_setting("keys")
    preferences.keys.select("run.reset")
    preferences.keys.edit.setFocus()
    qtbot.keyClick(preferences.keys.edit, Qt.Key.Key_Escape)
    assert preferences.isVisible()
    assert preferences.focusWidget() is preferences.keys.table
    assert preferences.keys.conflict.text() == ""
    assert studio.actions["run.reset"].shortcut() == QKeySequence("Ctrl+R")


def test_all_keys_are_put_back_at_once(preferences: Preferences, qtbot: QtBot, studio: Studio) -> None:
    press(preferences, qtbot, "run.reset", Qt.Key.Key_J)
    preferences.keys.select("run.play")
    qtbot.mouseClick(preferences.keys.none, Qt.MouseButton.LeftButton)
    assert studio.actions["run.play"].shortcut().isEmpty()
    qtbot.mouseClick(preferences.keys.reset_all, Qt.MouseButton.LeftButton)
    assert studio.settings.keys == {}
    assert studio.actions["run.play"].shortcut() == QKeySequence("Space")


def test_the_table_lists_every_action_and_can_be_filtered(
    preferences: Preferences, qtbot: QtBot, studio: Studio
) -> None:
    table = preferences.keys.table
    assert table.rowCount() == len(studio.actions.rows)
    qtbot.keyClicks(preferences.keys.filter, "Save as")
    assert [k for k in range(table.rowCount()) if not table.isRowHidden(k)] == [
        preferences.keys._ids.index("file.save_as")
    ]


def test_keys_go_to_the_action_that_the_filter_has_left_in_sight(
    preferences: Preferences, qtbot: QtBot, studio: Studio
) -> None:
    preferences.show_setting("keys")
    page, before = preferences.keys, studio.actions.keys_of("file.close")
    page.select("file.close")
    qtbot.keyClicks(page.filter, "Save as")
    assert page.whose.text() == "Keys of Save as"
    assert page.edit.keySequence() == QKeySequence(studio.actions.keys_of("file.save_as"))
    qtbot.mouseClick(page.none, Qt.MouseButton.LeftButton)
    assert studio.actions.keys_of("file.save_as") == ""
    assert studio.actions.keys_of("file.close") == before  # it lost them, out of sight
    qtbot.keyClicks(page.filter, " nowhere")
    assert not page.edit.isEnabled()
    assert "No action has these words" in page.whose.text()
    page.filter.clear()
    assert page.edit.isEnabled()


def test_preferences_are_opened_once(preferences: Preferences, window: MainWindow, studio: Studio) -> None:
    assert open_preferences(studio, window, "keys") is preferences
    assert preferences.pages.currentWidget() is preferences.keys
