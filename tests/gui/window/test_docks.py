"""Panels by keys, and what the next start finds of them; colors from the menu."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QMenu
from pytestqt.qtbot import QtBot

from app.core.project import Project
from app.editor.studio import Studio
from app.editor.theme import ThemeMode
from app.editor.window.docks import DOCKS, has_keys
from app.editor.window.main_window import MainWindow
from app.engine.scenarios import open_scenario
from tests.gui.conftest import said
from tests.gui.window.next_start import next_start

#: Panels that only say what to do first, as long as nobody is selected and nothing is wrong.
NOTHING_YET = ("inspector", "problems")
ALT, NO_KEY = Qt.KeyboardModifier.AltModifier, Qt.KeyboardModifier.NoModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier


def in_sight(window: MainWindow, panel: str) -> bool:
    dock = window.docks[panel]
    return dock.isVisible() and not dock.visibleRegion().isEmpty()


@pytest.mark.parametrize(("panel", "keys"), [(row.id, row.keys) for row in DOCKS])
def test_alt_and_a_digit_brings_a_panel_to_the_front_and_hides_it_there(
    window: MainWindow, qtbot: QtBot, panel: str, keys: str
) -> None:
    key = Qt.Key(Qt.Key.Key_0 + int(keys.removeprefix("Alt+")))
    window.docks[panel].hide()
    qtbot.keyClick(window, key, ALT)
    qtbot.waitUntil(lambda: in_sight(window, panel))
    if panel not in NOTHING_YET:
        focus = QApplication.focusWidget()
        assert focus is not None
        assert window.docks[panel].isAncestorOf(focus)
    qtbot.keyClick(window, key, ALT)
    qtbot.waitUntil(lambda: not in_sight(window, panel))


def test_alt_and_a_digit_goes_into_a_panel_in_sight_before_it_hides_it(
    window: MainWindow, qtbot: QtBot
) -> None:
    window.canvas.setFocus()
    qtbot.keyClick(window.canvas, Qt.Key.Key_1, ALT)
    assert in_sight(window, "library")
    assert has_keys(window.docks["library"])
    qtbot.keyClick(window.docks["library"].widget(), Qt.Key.Key_1, ALT)
    assert not in_sight(window, "library")
    assert window.hasFocus()  # no field, which would take keys that are shortcuts


def test_the_entry_of_the_menu_hides_a_panel_wherever_the_keys_go(window: MainWindow) -> None:
    window.canvas.setFocus()
    window.studio.actions["view.library"].trigger()
    assert not in_sight(window, "library")


def test_f6_goes_through_the_world_and_all_panels_in_sight(window: MainWindow, qtbot: QtBot) -> None:
    places = {"world": window.canvas, **{name: dock.widget() for name, dock in window.docks.items()}}
    seen = [name for name in places if name == "world" or in_sight(window, name)]
    for keys in (NO_KEY, SHIFT):
        window.setFocus()
        met = []
        for _ in seen:
            qtbot.keyClick(QApplication.focusWidget() or window, Qt.Key.Key_F6, keys)
            met += [name for name, place in places.items() if has_keys(place)]
        assert set(met) == set(seen) - {"inspector"}
        assert met[0] == ("world" if keys is NO_KEY else seen[-1])


def test_panels_are_found_where_they_were_left_the_last_time(
    window: MainWindow, qtbot: QtBot, foraging: Project
) -> None:
    window.studio.actions["view.library"].trigger()
    qtbot.keyClick(window, Qt.Key.Key_9, ALT)
    window.addDockWidget(Qt.DockWidgetArea.LeftDockWidgetArea, window.docks["inspector"])
    qtbot.waitUntil(lambda: not in_sight(window, "library") and in_sight(window, "plots"))
    with next_start(window, qtbot, foraging) as later:
        qtbot.waitUntil(lambda: in_sight(later, "plots") and in_sight(later, "inspector"))
        assert later.docks["library"].isHidden()
        assert later.dockWidgetArea(later.docks["inspector"]) is Qt.DockWidgetArea.LeftDockWidgetArea


def test_the_tool_bar_is_there_again_when_another_project_is_opened_after_one_was_closed(
    window: MainWindow, qtbot: QtBot, foraging: Project
) -> None:
    assert window.toolbar.isVisible()
    qtbot.keyClick(window, Qt.Key.Key_W, Qt.KeyboardModifier.ControlModifier)
    qtbot.waitUntil(lambda: window.welcome.isVisible() and not window.toolbar.isVisible())
    window.studio.open(foraging, open_scenario(foraging), None)
    qtbot.waitUntil(lambda: in_sight(window, "library"))
    assert window.toolbar.isVisible()


def test_colors_are_chosen_in_the_menu_view(window: MainWindow, studio: Studio, qtbot: QtBot) -> None:
    menu = next(action.menu() for action in window.menuBar().actions() if said(action) == "View")
    assert isinstance(menu, QMenu)
    for text, mode in (("Dark theme", ThemeMode.DARK), ("Light theme", ThemeMode.LIGHT)):
        menu.popup(window.mapToGlobal(window.rect().topLeft()))
        entry = next(action for action in menu.actions() if said(action) == text)
        qtbot.mouseClick(menu, Qt.MouseButton.LeftButton, pos=menu.actionGeometry(entry).center())
        assert studio.theme.is_dark is (mode is ThemeMode.DARK)
        assert entry.isChecked()
        assert studio.settings.theme is mode
