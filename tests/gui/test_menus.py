"""Menus tell what is on."""

from __future__ import annotations

import pytest
from PySide6.QtGui import QAction, QImage
from PySide6.QtWidgets import QApplication, QMenu, QWidget
from pytestqt.qtbot import QtBot

from app.editor.icons import icon
from app.editor.theme import Theme, ThemeMode
from tests.gui.test_lists import contrast_in

MODES = pytest.mark.parametrize("mode", [ThemeMode.LIGHT, ThemeMode.DARK])


def shown_entry(qapp: QApplication, qtbot: QtBot, mode: ThemeMode, *, on: bool, pictured: bool) -> QImage:
    """How an entry that can be on or off looks, without its words."""
    theme = Theme(qapp, mode)
    window = QWidget()
    theme.dress(window)
    qtbot.addWidget(window)
    menu, entry = QMenu(window), QAction("Grid", window, checkable=True, checked=on)
    if pictured:
        entry.setIcon(icon("school-outline", theme))
    menu.addAction(entry)
    menu.ensurePolished()
    menu.resize(menu.sizeHint())
    row = menu.actionGeometry(entry)
    return menu.grab(
        row.adjusted(0, 0, menu.fontMetrics().horizontalAdvance("Grid") - row.width(), 0)
    ).toImage()


@MODES
@pytest.mark.parametrize("pictured", [False, True])
def test_an_entry_that_is_on_looks_unlike_one_that_is_off(
    qapp: QApplication, qtbot: QtBot, mode: ThemeMode, pictured: bool
) -> None:
    on = shown_entry(qapp, qtbot, mode, on=True, pictured=pictured)
    assert on != shown_entry(qapp, qtbot, mode, on=False, pictured=pictured)


@MODES
def test_the_tick_of_what_is_on_can_be_seen(qapp: QApplication, qtbot: QtBot, mode: ThemeMode) -> None:
    tick = shown_entry(qapp, qtbot, mode, on=True, pictured=False).copy(0, 0, 24, 24)
    assert contrast_in(tick) >= 4.5
