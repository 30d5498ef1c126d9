"""Where a context menu opens."""

from PySide6.QtCore import QPoint
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtWidgets import QAbstractItemView


def menu_place(view: QAbstractItemView, event: QContextMenuEvent) -> QPoint:
    """The place on the screen: under the mouse, or below the current row where the menu key asked for it."""
    if event.reason() == QContextMenuEvent.Reason.Keyboard:
        rect = view.visualRect(view.currentIndex())
        return view.viewport().mapToGlobal(rect.bottomLeft())
    return event.globalPos()
