"""All prunes and moved cuts of the automaton in one place, where they can be taken back."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from ...core.edits import prune_weak, remove_cut, remove_prune
from ..number_box import roomy
from .subject import Subject
from .words import cut_words, prune_words

if TYPE_CHECKING:
    from ..studio import Studio

NOTHING = "Nothing is pruned, and no cut was moved. In the tree, Delete prunes the node that is selected."


class PrunePage(QWidget):
    """Lists prunes and cuts, takes them back, and prunes what few examples speak for.

    Attributes:
        listed: One row each.
        back, weak: Buttons.
        support: The least number of examples.
    """

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self._subject: Subject | None = None
        self.listed = _List(self)
        self.listed.setWordWrap(True)
        self.listed.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.listed.setAccessibleName("Prunes and moved cuts")
        self.listed.setToolTip(
            "All prunes and moved cuts of the behavior; Enter or a double click shows its state, Delete takes it back"
        )
        self.back = QPushButton("Take back")
        self.back.setToolTip("Take back the prune or cut that is selected")
        self.back.clicked.connect(self.take_back)
        self.support = roomy(QSpinBox())
        self.support.setRange(1, 9_999)
        self.support.setPrefix("fewer than ")
        self.support.setSuffix(" examples")
        self.support.setValue(2)
        self.support.setAccessibleName("Least number of examples")
        self.support.setToolTip("Prune transitions that fewer examples than this speak for")
        self.weak = QPushButton("Prune all")
        self.weak.setToolTip(
            "Prune all transitions that fewer examples speak for, in all states of the behavior"
        )
        self.weak.clicked.connect(self._prune_weak)
        self._nothing = QLabel(NOTHING)
        self._nothing.setProperty("role", "empty")
        self._nothing.setWordWrap(True)
        self._nothing.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._lay_out()
        self.listed.currentRowChanged.connect(lambda row: self.back.setEnabled(row >= 0))
        self.listed.itemActivated.connect(lambda _: self._show_state())

    def _lay_out(self) -> None:
        below = QHBoxLayout()
        below.addWidget(self.back)
        below.addStretch(1)
        below.addWidget(self.support)
        below.addWidget(self.weak)
        column = QVBoxLayout(self)
        column.setContentsMargins(8, 0, 8, 4)
        column.setSpacing(4)
        column.addWidget(self._nothing, 1)
        column.addWidget(self.listed, 1)
        column.addLayout(below)

    @property
    def count(self) -> int:
        """How many there are."""
        return self.listed.count()

    def show_subject(self, subject: Subject | None) -> None:
        """List those of the automaton of a state."""
        self._subject = subject
        row = self.listed.currentRow()
        self.listed.clear()
        if subject is not None:
            automaton = subject.automaton
            for prune in automaton.prunes:
                words = prune_words(prune, automaton, subject.library, subject.vocabulary)
                self._add(words, ("prune", prune.id))
            for cut in automaton.cuts:
                self._add(cut_words(cut, automaton, subject.library, subject.vocabulary), ("cut", cut.id))
        self._nothing.setVisible(not self.listed.count())
        self.listed.setVisible(bool(self.listed.count()))
        self.listed.setCurrentRow(min(max(row, 0), self.listed.count() - 1))
        self.back.setEnabled(self.listed.count() > 0)
        self.setFocusProxy(self.listed if self.listed.count() else self.weak)  # a field would take Delete
        self.weak.setEnabled(subject is not None and bool(subject.automaton.learned))

    def _add(self, words: str, what: tuple[str, str]) -> None:
        item = QListWidgetItem(words)
        item.setToolTip(words)
        item.setData(Qt.ItemDataRole.UserRole, what)
        self.listed.addItem(item)

    def _show_state(self) -> None:
        """Show the tree that the selected prune or cut is about."""
        if self.listed.currentRow() >= 0 and self._subject is not None:
            kind, number = self.listed.currentItem().data(Qt.ItemDataRole.UserRole)
            automaton = self._subject.automaton
            found = automaton.prunes if kind == "prune" else automaton.cuts
            for what in found:
                if what.id == number:
                    self._studio.selection.select_state(what.source)

    def take_back(self) -> None:
        """Take back what is selected."""
        if self.listed.currentRow() < 0 or self._subject is None:
            return
        kind, number = self.listed.currentItem().data(Qt.ItemDataRole.UserRole)
        edit = remove_prune if kind == "prune" else remove_cut
        self._studio.document.attempt(edit, self._subject.type, self._subject.automaton.id, number)

    def _prune_weak(self) -> None:
        if self._subject is None:
            return
        before = self._studio.document.project
        where = self._subject.type, self._subject.automaton.id
        self._studio.document.attempt(prune_weak, *where, float(self.support.value()))
        if self._studio.document.project is before:
            self._studio.say(f"no transition has fewer than {self.support.value()} examples")


class _List(QListWidget):
    """Takes back on Delete."""

    def __init__(self, page: PrunePage) -> None:
        super().__init__()
        self._page = page

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Delete takes back what is selected."""
        if event.key() == Qt.Key.Key_Delete:
            self._page.take_back()
            event.accept()
        else:
            super().keyPressEvent(event)
