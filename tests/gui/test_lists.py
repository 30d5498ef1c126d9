"""Lists that boxes open can be read."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QColor, QImage, QStandardItemModel
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QComboBox
from pytestqt.qtbot import QtBot

from app.editor.behavior_colors import luminance
from app.editor.forms.word_list import WordList
from app.editor.problems.panel import ProblemList
from app.editor.studio import Studio
from app.editor.theme import ThemeMode, chosen_ground
from tests.gui.conftest import PATIENCE


@pytest.mark.parametrize("mode", [ThemeMode.LIGHT, ThemeMode.DARK])
def test_the_row_that_is_chosen_in_an_open_list_can_be_read(
    empty_studio: Studio, qtbot: QtBot, mode: ThemeMode
) -> None:
    empty_studio.theme.use(mode)
    box = QComboBox()
    qtbot.addWidget(box)
    box.addItems(["alpha", "beta", "gamma"])
    box.setCurrentIndex(1)
    with qtbot.waitExposed(box):
        box.show()
    QTest.keyClick(box, Qt.Key.Key_Down, Qt.KeyboardModifier.AltModifier)
    view = box.view()
    qtbot.waitUntil(view.isVisible, timeout=PATIENCE)
    row = view.visualRect(box.model().index(1, 0))
    seen = view.viewport().grab(row.adjusted(4, 4, -4, -4)).toImage()  # without the frame
    assert contrast_in(seen) >= 4.5
    QTest.keyClick(view, Qt.Key.Key_Escape)


@pytest.mark.parametrize("mode", [ThemeMode.LIGHT, ThemeMode.DARK])
def test_a_list_opens_below_its_box_with_one_line_around_it(
    empty_studio: Studio, qtbot: QtBot, mode: ThemeMode
) -> None:
    theme = empty_studio.theme
    theme.use(mode)
    box = QComboBox()
    qtbot.addWidget(box)
    box.addItems(["alpha", "beta", "gamma"])
    with qtbot.waitExposed(box):
        box.show()
    QTest.keyClick(box, Qt.Key.Key_Down, Qt.KeyboardModifier.AltModifier)
    view = box.view()
    qtbot.waitUntil(view.isVisible, timeout=PATIENCE)
    around = view.window()
    assert around.y() >= box.mapToGlobal(box.rect().bottomLeft()).y()
    seen = around.grab().toImage()
    row = view.visualRect(box.model().index(2, 0)).translated(view.viewport().mapTo(around, QPoint()))
    side = [seen.pixelColor(x, row.center().y()).name() for x in range(3)]
    below = [seen.pixelColor(seen.width() - 4, seen.height() - 1 - y).name() for y in range(3)]
    line, ground = theme.palette.hairline, theme.palette.raised
    assert side == below == [line, ground, ground]
    QTest.keyClick(view, Qt.Key.Key_Escape)


@pytest.mark.parametrize("many", [3, 30])
def test_words_of_a_list_are_not_cut_off_however_narrow_its_box_is(
    empty_studio: Studio, qtbot: QtBot, many: int
) -> None:
    box = WordList()
    qtbot.addWidget(box)
    box.addItems([f"go to the nearest visible box number {k}" for k in range(many)])
    box.setMaximumWidth(60)
    screen = box.screen().availableGeometry()
    box.move(screen.right() - 70, screen.top() + 100)  # at the edge, as the list of arms in the tool bar
    with qtbot.waitExposed(box):
        box.show()
    QTest.keyClick(box, Qt.Key.Key_Down, Qt.KeyboardModifier.AltModifier)
    view = box.view()
    qtbot.waitUntil(view.isVisible, timeout=PATIENCE)
    assert view.viewport().width() >= view.sizeHintForColumn(0)
    assert screen.contains(view.window().frameGeometry())
    QTest.keyClick(view, Qt.Key.Key_Escape)


def contrast_in(image: QImage) -> float:
    """Between the darkest and the brightest color of a picture."""
    colors = {QColor(image.pixel(x, y)).name() for x in range(image.width()) for y in range(image.height())}
    levels = [luminance(QColor(name)) for name in colors]
    return (max(levels) + 0.05) / (min(levels) + 0.05)


@pytest.mark.parametrize("mode", [ThemeMode.LIGHT, ThemeMode.DARK])
def test_the_row_that_keys_are_at_is_one_plain_stripe(
    empty_studio: Studio, qtbot: QtBot, mode: ThemeMode
) -> None:
    empty_studio.theme.use(mode)
    listed, model = ProblemList(), QStandardItemModel(3, 3)
    qtbot.addWidget(listed)
    listed.setModel(model)
    with qtbot.waitExposed(listed):
        listed.show()
    listed.activateWindow()
    listed.setFocus()
    listed.setCurrentIndex(model.index(1, 0))
    qtbot.waitUntil(listed.hasFocus, timeout=PATIENCE)
    row = listed.visualRect(model.index(1, 0))
    seen = listed.viewport().grab(row).toImage()
    colors = {seen.pixelColor(row.width() // 2, y).name() for y in range(seen.height())}
    assert colors == {chosen_ground(empty_studio.theme.palette).name()}
