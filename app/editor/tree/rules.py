"""The authored rules of the state that is shown, in the order in which they are tried."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QListWidget, QListWidgetItem

from ...core.wording import rule_words
from .subject import Subject

if TYPE_CHECKING:
    from ..studio import Studio

#: So many rules are seen without scrolling.
MOST_ROWS, ROW = 4, 22


class RuleList(QListWidget):
    """The rules of a state."""

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self.setAccessibleName("Rules of the state, in order")
        self.setToolTip("Rules are tried in this order before the tree")
        self.hide()

    def show_subject(self, subject: Subject | None) -> None:
        """Show the rules of a state; nothing where there are none."""
        row = self.currentRow()
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
        self.setFixedHeight(ROW * min(MOST_ROWS, len(rules)) + 6)
        self.setVisible(bool(rules))
