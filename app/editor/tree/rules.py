"""The authored rules of the state that is shown, in the order in which they are tried."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QDropEvent, QFocusEvent, QKeyEvent
from PySide6.QtWidgets import QListWidget, QListWidgetItem

from ...core.edits import order_rules, remove_rule
from ...core.wording import rule_words
from .subject import Subject

if TYPE_CHECKING:
    from ..studio import Studio

#: So many rules are seen without scrolling above a tree, and where there is none.
MOST_ROWS, MOST_ALONE, ROW = 4, 10, 24
STEPS = {Qt.Key.Key_Up: -1, Qt.Key.Key_Down: 1}


class RuleList(QListWidget):
    """The rules of a state. Dragging, or Alt and an arrow key, tries one earlier or later; Delete removes it.

    Signals:
        taken: The user turns to them.
    """

    taken = Signal()

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self._subject: Subject | None = None
        self.setDragDropMode(QListWidget.DragDropMode.InternalMove)
        self.setDefaultDropAction(Qt.DropAction.MoveAction)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setTextElideMode(Qt.TextElideMode.ElideRight)
        self.setAccessibleName("Rules of the state, in order")
        self.setToolTip(
            "Rules are tried in this order before the tree; drag them, or press Alt and an arrow key"
        )
        self.hide()

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Tell that keys come here now."""
        super().focusInEvent(event)
        if event.reason() is not Qt.FocusReason.ActiveWindowFocusReason:
            self.taken.emit()

    def show_subject(self, subject: Subject | None) -> None:
        """Show the rules of a state; nothing where there are none."""
        row = self.currentRow()
        self._subject = subject
        self.clear()
        rules = () if subject is None else subject.automaton.rules_of(subject.state)
        for order, rule in enumerate(rules, 1):
            assert subject is not None
            words = rule_words(rule, subject.automaton, subject.vocabulary)
            item = QListWidgetItem(f"{order}.  {words} → {subject.name(rule.target)}")
            item.setData(Qt.ItemDataRole.UserRole, rule.id)
            item.setToolTip(item.text())
            self.addItem(item)
        self.setCurrentRow(min(row, len(rules) - 1))
        most = MOST_ALONE if subject is None or subject.tree is None else MOST_ROWS
        self.setFixedHeight(ROW * min(most, len(rules)) + 6)
        self.setVisible(bool(rules))

    @property
    def ids(self) -> list[str]:
        """The ids of the rules as they stand in the list."""
        return [self.item(row).data(Qt.ItemDataRole.UserRole) for row in range(self.count())]

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Reorder and remove."""
        alt = bool(event.modifiers() & Qt.KeyboardModifier.AltModifier)
        if alt and event.key() in STEPS:
            self._shift(STEPS[Qt.Key(event.key())])
        elif event.key() == Qt.Key.Key_Delete and self.currentRow() >= 0:
            self._remove(self.ids[self.currentRow()])
        else:
            super().keyPressEvent(event)
            return
        event.accept()

    def dropEvent(self, event: QDropEvent) -> None:
        """A rule was dragged to another place."""
        super().dropEvent(event)
        self._order(self.ids)

    def _shift(self, by: int) -> None:
        row, ids = self.currentRow(), self.ids
        if row >= 0 and 0 <= row + by < len(ids):
            ids.insert(row + by, ids.pop(row))
            self.setCurrentRow(row + by)
            self._order(ids)

    def _order(self, ids: list[str]) -> None:
        subject = self._subject
        if subject is not None and ids != [rule.id for rule in subject.automaton.rules_of(subject.state)]:
            where = subject.type, subject.automaton.id, subject.state
            self._studio.document.attempt(order_rules, *where, ids)

    def _remove(self, rule_id: str) -> None:
        if self._subject is not None:
            where = self._subject.type, self._subject.automaton.id
            self._studio.document.attempt(remove_rule, *where, rule_id)
