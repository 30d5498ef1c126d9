"""A list whose entries are chosen, moved, removed and renamed."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeyEvent, QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHBoxLayout,
    QListWidget,
    QListWidgetItem,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ..icons import icon
from .buttons import stand_back
from .parts import framed

if TYPE_CHECKING:
    from ..theme import Theme

KEY = int(Qt.ItemDataRole.UserRole)


@dataclass(frozen=True, slots=True)
class Item:
    """One entry of an ordered list.

    Attributes:
        fixed: It can neither be moved nor removed.
    """

    key: str
    text: str
    tip: str = ""
    fixed: bool = False


class OrderedList(QWidget):
    """A list whose entries can be chosen and removed, and moved up and down and renamed where that is allowed.

    Signals:
        chosen: Another entry is current; its key, or an empty one.
        moved: An entry was moved: its key and its new place.
        removed: The user wants an entry to go; its key.
        renamed: The user gave an entry another text: its key and the text.
    """

    chosen = Signal(str)
    moved = Signal(str, int)
    removed = Signal(str)
    renamed = Signal(str, str)

    def __init__(
        self, name: str, theme: Theme, *, editable: bool = False, movable: bool = True, empty: str = ""
    ) -> None:
        """A list.

        Args:
            empty: What it says while nothing is in it.
        """
        super().__init__()
        self._theme = theme
        self.empty = empty
        self._items: tuple[Item, ...] = ()
        self._editable, self._movable = editable, movable
        self._filling = False
        self.list = _List(self)
        self.list.setAccessibleName(name)
        self.list.setSpacing(1)
        framed(self.list, theme)
        self.list.currentItemChanged.connect(self._current_changed)
        self.list.itemChanged.connect(self._item_changed)
        self.up = self._button("arrow-up", f"Move up (Alt+Up): {name}", lambda: self.shift(-1))
        self.down = self._button("arrow-down", f"Move down (Alt+Down): {name}", lambda: self.shift(1))
        self.remove = self._button("delete-outline", f"Remove (Delete): {name}", self.take_out)
        buttons = QHBoxLayout()
        buttons.setSpacing(2)
        for button in (self.up, self.down, self.remove) if movable else (self.remove,):
            buttons.addWidget(button)
        buttons.addStretch(1)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(4)
        column.addWidget(self.list, 1)
        column.addLayout(buttons)
        theme.changed.connect(self._dress)
        self._dress()

    def _button(self, name: str, tip: str, do: object) -> QToolButton:
        button = QToolButton()
        button.setProperty("flat", "true")
        button.setProperty("icon-name", name)
        button.setToolTip(tip)
        button.setAccessibleName(tip)
        button.clicked.connect(do)
        stand_back(button)
        return button

    def _dress(self) -> None:
        for button in (self.up, self.down, self.remove):
            button.setIcon(icon(str(button.property("icon-name")), self._theme))

    def show_items(self, items: Iterable[Item], current: str = "") -> None:
        """Show these entries; *current*, or else the one that was chosen, is the current one."""
        shown = tuple(items)
        wanted = current or self.current
        if shown != self._items:
            self._items = shown
            self._filling = True
            self.list.clear()
            for item in shown:
                entry = QListWidgetItem(item.text)
                entry.setData(KEY, item.key)
                entry.setToolTip(item.tip)
                if self._editable and not item.fixed:
                    entry.setFlags(entry.flags() | Qt.ItemFlag.ItemIsEditable)
                self.list.addItem(entry)
            self._filling = False
        self.choose(wanted if any(item.key == wanted for item in shown) else shown[0].key if shown else "")

    @property
    def current(self) -> str:
        """The key of the current entry; empty if there is none."""
        return str(self.list.currentItem().data(KEY)) if self.list.currentRow() >= 0 else ""

    def choose(self, key: str) -> None:
        """Make an entry the current one."""
        at = next((k for k, item in enumerate(self._items) if item.key == key), -1)
        if at != self.list.currentRow():
            self.list.setCurrentRow(at)
        else:
            self._current_changed()

    def edit(self, key: str) -> None:
        """Let the user type over an entry."""
        self.choose(key)
        self.list.setFocus()
        self.list.editItem(self.list.currentItem())

    def shift(self, steps: int) -> None:
        """Move the current entry up or down."""
        at = self.list.currentRow()
        to = at + steps
        there = self._movable and 0 <= at < len(self._items) and 0 <= to < len(self._items)
        if there and not (self._items[at].fixed or self._items[to].fixed):
            self.moved.emit(self.current, to)

    def take_out(self) -> None:
        """Remove the current entry."""
        at = self.list.currentRow()
        if 0 <= at < len(self._items) and not self._items[at].fixed:
            self.removed.emit(self.current)

    def _current_changed(self) -> None:
        if self._filling:
            return
        at = self.list.currentRow()
        free = 0 <= at < len(self._items) and not self._items[at].fixed
        self.remove.setEnabled(free)
        self.up.setEnabled(free and at > 0 and not self._items[at - 1].fixed)
        self.down.setEnabled(free and at < len(self._items) - 1)
        self.chosen.emit(self.current)

    def _item_changed(self, entry: QListWidgetItem) -> None:
        if not self._filling:
            self._typed_over(entry)

    def _typed_over(self, entry: QListWidgetItem) -> None:
        key = str(entry.data(KEY))
        before = next(item.text for item in self._items if item.key == key)
        if entry.text() != before:
            new = entry.text()
            self._filling = True
            entry.setText(before)  # until whoever hears of it has done it
            self._filling = False
            self.renamed.emit(key, new)


class _List(QListWidget):
    """Alt with an arrow moves, Delete removes."""

    def __init__(self, owner: OrderedList) -> None:
        super().__init__(owner)
        self._owner = owner
        self.setEditTriggers(
            QAbstractItemView.EditTrigger.EditKeyPressed | QAbstractItemView.EditTrigger.DoubleClicked
        )

    def paintEvent(self, event: QPaintEvent) -> None:
        """An empty list says what it is for."""
        super().paintEvent(event)
        if not self.count() and self._owner.empty:
            painter = QPainter(self.viewport())
            painter.setPen(self.palette().color(QPalette.ColorRole.PlaceholderText))
            words = Qt.AlignmentFlag.AlignTop | Qt.TextFlag.TextWordWrap
            painter.drawText(self.viewport().rect().adjusted(9, 7, -9, -7), words, self._owner.empty)
            painter.end()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """See above."""
        alt = event.modifiers() == Qt.KeyboardModifier.AltModifier
        if alt and event.key() in (Qt.Key.Key_Up, Qt.Key.Key_Down):
            self._owner.shift(-1 if event.key() == Qt.Key.Key_Up else 1)
        elif event.key() == Qt.Key.Key_Delete and self.state() != QAbstractItemView.State.EditingState:
            self._owner.take_out()
        else:
            super().keyPressEvent(event)
            return
        event.accept()
