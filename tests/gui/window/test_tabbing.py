"""Tab goes through the window."""

from __future__ import annotations

from typing import TypeVar

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from app.editor.agents.panel import AgentsPanel
from app.editor.graph.view import GraphView
from app.editor.library.panel import LibraryPanel
from app.editor.teach.idle_page import IdlePage
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE
from tests.patient_bot import have_done_what_is_due

P = TypeVar("P", bound=QWidget)
#: More than there are controls.
MANY = 200
BOTH_WAYS = pytest.mark.parametrize("key", [Qt.Key.Key_Tab, Qt.Key.Key_Backtab])


def focused() -> QWidget:
    widget = QApplication.focusWidget()
    assert isinstance(widget, QWidget)
    return widget


def panel(window: MainWindow, kind: type[P]) -> P:
    found = window.findChild(kind)
    assert isinstance(found, kind)
    return found


def round_trip(window: QWidget, start: QWidget, key: Qt.Key, qtbot: QtBot) -> list[QWidget]:
    """Who gets the keys, one after the other, until it is *start* again."""
    window.activateWindow()
    start.setFocus()
    qtbot.waitUntil(start.hasFocus, timeout=PATIENCE)
    met = [start]
    for _ in range(MANY):
        QTest.keyClick(focused(), key)
        if focused() is start:
            return met
        met.append(focused())
    raise AssertionError([widget.accessibleName() for widget in met])


@BOTH_WAYS
def test_it_comes_to_every_control_in_sight_and_round_again(
    window: MainWindow, qtbot: QtBot, key: Qt.Key
) -> None:
    have_done_what_is_due()
    met = round_trip(window, window.canvas, key, qtbot)
    assert len(met) == len(set(met))
    bar = window.toolbar
    assert {bar.mode.teach, bar.mode.test, bar.slider, bar.seed} <= set(met)
    library, agents, idle = panel(window, LibraryPanel), panel(window, AgentsPanel), panel(window, IdlePage)
    assert {library.filter, library.tree, agents.filter, agents.tree, panel(window, GraphView)} <= set(met)
    assert {idle.teach, idle.filed, idle.keep} <= set(met)


@BOTH_WAYS
def test_it_goes_into_no_dock_behind_another_one(window: MainWindow, qtbot: QtBot, key: Qt.Key) -> None:
    window.resize(1280, 800)  # the tree is behind the automaton
    window.standard_layout()
    have_done_what_is_due()
    behind = [window.docks[name] for name in ("tree", "plots", "timeline", "problems")]
    for widget in round_trip(window, window.canvas, key, qtbot):
        assert not any(dock.isAncestorOf(widget) for dock in behind), widget


def test_it_stays_in_a_dock_that_floats(window: MainWindow, qtbot: QtBot) -> None:
    dock, library = window.docks["library"], panel(window, LibraryPanel)
    dock.setFloating(True)
    have_done_what_is_due()
    met = round_trip(dock, library.tree, Qt.Key.Key_Tab, qtbot)
    assert all(dock.isAncestorOf(widget) for widget in met)
    assert library.filter in met
