"""The tree of the library: keys, dragging, folding."""

from __future__ import annotations

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtGui import QContextMenuEvent, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QAbstractItemView, QTreeView

from ..context_menus import menu_place


class LibraryTree(QTreeView):
    """A tree of groups and behaviors.

    Signals:
        asked: A key asked for an action, by its id.
        menu_wanted: The context menu is wanted at this place of the screen.
        released: A press ended without a drag.
        dragged: A drag has ended.

    Attributes:
        pressing: The mouse is down: whether it selects or drags is not known yet.
    """

    asked = Signal(str)
    menu_wanted = Signal(QPoint)
    released = Signal()
    dragged = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.pressing = False
        self.setObjectName("library-tree")
        self.setAccessibleName("Behaviors")
        self.setHeaderHidden(True)
        self.setIndentation(12)
        self.setMouseTracking(True)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setDragEnabled(True)
        self.setDragDropMode(QAbstractItemView.DragDropMode.DragOnly)
        self.setExpandsOnDoubleClick(False)  # a single click does

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter opens, F2 renames, Delete deletes, Ctrl+D duplicates."""
        plain = event.modifiers() in (Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.KeypadModifier)
        keys = {
            Qt.Key.Key_F2: "behavior.rename",
            Qt.Key.Key_Delete: "behavior.delete",
            Qt.Key.Key_Return: "behavior.open",
            Qt.Key.Key_Enter: "behavior.open",
        }
        wanted = keys.get(Qt.Key(event.key())) if plain else None
        if event.key() == Qt.Key.Key_D and event.modifiers() == Qt.KeyboardModifier.ControlModifier:
            wanted = "behavior.duplicate"
        if wanted is None or self.state() == QAbstractItemView.State.EditingState:
            super().keyPressEvent(event)
            return
        event.accept()
        self.asked.emit(wanted)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Wait: what is dragged into a graph must not change what the graph shows."""
        self.pressing = event.button() == Qt.MouseButton.LeftButton
        super().mousePressEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """It was a click."""
        super().mouseReleaseEvent(event)
        if self.pressing:
            self.pressing = False
            self.released.emit()

    def startDrag(self, actions: Qt.DropAction) -> None:
        """It is a drag."""
        super().startDrag(actions)
        self.pressing = False
        self.dragged.emit()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """By the right button or the menu key."""
        self.menu_wanted.emit(menu_place(self, event))
