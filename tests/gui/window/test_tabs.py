"""Panels that stand as tabs can be taken out of their place, dragged by their title, and put back."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtWidgets import QApplication, QMenu, QTabBar
from pytestqt.qtbot import QtBot

from app.core.project import Project
from app.editor.window.docks import has_keys
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE
from tests.gui.window.next_start import next_start

LEFT, CONTROL = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.ControlModifier


def tab_of(window: MainWindow, panel: str) -> tuple[QTabBar, QPoint] | None:
    """The bar with the tab of a panel, and where that is."""
    title = window.docks[panel].windowTitle()
    for bar in window.findChildren(QTabBar, options=Qt.FindChildOption.FindDirectChildrenOnly):
        for tab in range(bar.count()):
            if bar.isVisible() and bar.tabText(tab) == title:
                return bar, bar.tabRect(tab).center()
    return None


def find_tab(window: MainWindow, qtbot: QtBot, panel: str) -> tuple[QTabBar, QPoint]:
    qtbot.waitUntil(lambda: tab_of(window, panel) is not None, timeout=PATIENCE)
    found = tab_of(window, panel)
    assert found is not None
    return found


def floats(window: MainWindow, panel: str) -> Callable[[], bool]:
    dock = window.docks[panel]
    return lambda: dock.isFloating() and dock.isVisible() and dock.title.isVisible()


def let_float(window: MainWindow, qtbot: QtBot, panel: str) -> None:
    bar, at = find_tab(window, qtbot, panel)
    qtbot.mouseClick(bar, LEFT, pos=at)
    qtbot.mouseDClick(bar, LEFT, pos=at)
    qtbot.waitUntil(floats(window, panel), timeout=PATIENCE)


@pytest.mark.parametrize("panel", ["examples", "timeline", "plots", "problems"])
def test_a_double_click_on_a_tab_lets_its_panel_float_and_one_on_its_title_puts_it_back(
    window: MainWindow, qtbot: QtBot, panel: str
) -> None:
    let_float(window, qtbot, panel)
    qtbot.waitUntil(lambda: tab_of(window, panel) is None, timeout=PATIENCE)
    dock = window.docks[panel]
    qtbot.mouseDClick(dock.title, LEFT)
    qtbot.waitUntil(lambda: not dock.isFloating() and tab_of(window, panel) is not None, timeout=PATIENCE)


def test_the_menu_of_a_tab_lets_it_float_or_hides_it(window: MainWindow, qtbot: QtBot) -> None:
    for words, is_so in (
        ("Let it float", floats(window, "plots")),
        ("Hide it", window.docks["timeline"].isHidden),
    ):
        bar, at = find_tab(window, qtbot, "plots" if words == "Let it float" else "timeline")
        event = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, at, bar.mapToGlobal(at))
        QApplication.sendEvent(bar, event)
        menu = QApplication.activePopupWidget()
        assert isinstance(menu, QMenu)
        entry = next(entry for entry in menu.actions() if entry.text() == words)
        qtbot.mouseClick(menu, LEFT, pos=menu.actionGeometry(entry).center())
        qtbot.waitUntil(is_so, timeout=PATIENCE)


def test_the_panel_with_the_keys_floats_and_is_put_back_without_a_mouse(
    window: MainWindow, qtbot: QtBot
) -> None:
    window.canvas.setFocus()
    told: list[str] = []
    window.studio.said.connect(lambda message: told.append(message.text))
    qtbot.keyClick(window.canvas, Qt.Key.Key_F6, CONTROL)
    assert "click into a panel and press Ctrl+F6" in told[-1]
    dock = window.docks["library"]
    window.show_panel("library")
    qtbot.waitUntil(lambda: has_keys(dock), timeout=PATIENCE)
    qtbot.keyClick(dock.widget(), Qt.Key.Key_F6, CONTROL)
    qtbot.waitUntil(floats(window, "library"), timeout=PATIENCE)
    qtbot.waitUntil(lambda: has_keys(dock), timeout=PATIENCE)
    assert dock.screen().availableGeometry().contains(dock.pos())
    qtbot.keyClick(dock.widget(), Qt.Key.Key_F6, CONTROL)
    qtbot.waitUntil(lambda: not dock.isFloating(), timeout=PATIENCE)


def test_what_floated_floats_at_the_next_start_and_has_its_edge(
    window: MainWindow, qtbot: QtBot, foraging: Project
) -> None:
    let_float(window, qtbot, "plots")
    with next_start(window, qtbot, foraging) as later:
        qtbot.waitUntil(floats(later, "plots"), timeout=PATIENCE)
        assert later.docks["plots"].contentsMargins().top() == 1
