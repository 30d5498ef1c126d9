"""A box of choices does not go on looking as if the mouse were on it."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QCursor
from PySide6.QtWidgets import QApplication, QComboBox, QLineEdit, QVBoxLayout, QWidget
from pytestqt.qtbot import QtBot

from app.editor.left_boxes import _tell, tell_left_boxes
from tests.gui.conftest import PATIENCE


@pytest.fixture
def box(qapp: QApplication, qtbot: QtBot) -> Iterator[QComboBox]:
    """A box beside a field that has the keys."""
    tell_left_boxes(qapp)
    window = QWidget()
    qtbot.addWidget(window)
    box, field = QComboBox(), QLineEdit()
    column = QVBoxLayout(window)
    column.addWidget(field)
    column.addWidget(box)
    with qtbot.waitExposed(window):
        window.show()
    window.activateWindow()
    field.setFocus()
    qtbot.waitUntil(field.hasFocus, timeout=PATIENCE)
    yield box
    qapp.focusChanged.disconnect(_tell)


@pytest.mark.parametrize("stays", [True, False])
def test_a_box_that_gets_the_keys_back_from_its_list_knows_where_the_mouse_is(
    box: QComboBox, *, stays: bool
) -> None:
    QCursor.setPos(box.mapToGlobal(box.rect().center() if stays else QPoint(5, 400)))
    QApplication.processEvents()
    box.setAttribute(Qt.WidgetAttribute.WA_UnderMouse)  # as Qt leaves it where a list was open meanwhile
    box.setFocus()
    assert box.underMouse() is stays
