"""The tree of the agents: keys, dragging, selecting several."""

from __future__ import annotations

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtGui import QContextMenuEvent, QKeyEvent
from PySide6.QtWidgets import QAbstractItemView, QTreeView

from ..context_menus import menu_place

#: Alt with an arrow moves the selected nodes.
ARROWS = {
    Qt.Key.Key_Up: "node.up",
    Qt.Key.Key_Down: "node.down",
    Qt.Key.Key_Left: "node.out",
    Qt.Key.Key_Right: "node.in",
}


class AgentTree(QTreeView):
    """A tree of nodes.

    Signals:
        asked: A key asked for an action, by its id.
        menu_wanted: The context menu is wanted at this place of the screen.
    """

    asked = Signal(str)
    menu_wanted = Signal(QPoint)

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("agent-tree")
        self.setAccessibleName("Agents and controllers")
        self.setHeaderHidden(True)
        self.setUniformRowHeights(True)
        self.setIndentation(14)
        self.setMouseTracking(True)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setDragEnabled(True)
        self.setAcceptDrops(True)
        self.setDropIndicatorShown(True)
        self.setDragDropMode(QAbstractItemView.DragDropMode.InternalMove)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """F2 renames, Delete removes, Ctrl+G groups, Ctrl+Shift+G dissolves, Alt with an arrow moves."""
        if self.state() == QAbstractItemView.State.EditingState:
            super().keyPressEvent(event)
            return
        wanted = self._wanted(event)
        if wanted:
            event.accept()
            self.asked.emit(wanted)
        else:
            super().keyPressEvent(event)

    def _wanted(self, event: QKeyEvent) -> str:
        key, held = Qt.Key(event.key()), event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
        control, shift = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
        if held == Qt.KeyboardModifier.AltModifier:
            return ARROWS.get(key, "")
        if held == Qt.KeyboardModifier.NoModifier:
            return {Qt.Key.Key_F2: "node.rename", Qt.Key.Key_Delete: "node.remove"}.get(key, "")
        if key == Qt.Key.Key_G:
            return {control: "node.group", control | shift: "node.dissolve"}.get(held, "")
        return ""

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """By the right button or the menu key."""
        self.menu_wanted.emit(menu_place(self, event))
