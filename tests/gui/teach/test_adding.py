"""The list of what can be added to a lesson."""

from PySide6.QtCore import QPoint
from PySide6.QtGui import QColor
from pytestqt.qtbot import QtBot

from app.core.automaton import Nested
from app.editor.teach.adding import AddList
from app.editor.teach.choices import Choice

LONG = "Gather at the box that is farthest from everything else"


def test_a_name_that_has_no_room_is_in_the_tool_tip(qtbot: QtBot) -> None:
    offered = AddList()
    qtbot.addWidget(offered)
    offered.open([(Choice(LONG, Nested("far")), QColor("red"))], QPoint(0, 0))
    item = offered.list.item(0)
    assert offered.list.fontMetrics().horizontalAdvance(item.text()) > offered.list.viewport().width()
    assert LONG in item.toolTip()
