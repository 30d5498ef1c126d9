"""The demonstrations of the project: what was taught where, in the order in which they are played."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QFormLayout, QLabel, QLineEdit, QVBoxLayout, QWidget

from ...core.amounts import counted
from ...core.edits import move_demonstration, remove_demonstration, replace_demonstration
from ...core.project import Demonstration, Project
from ..actions import ActionRow, when_open
from ..forms.buttons import closing
from ..forms.ordered_list import Item, OrderedList
from ..forms.parts import caption
from ..room import resize_within
from .replay_check import ReplayCheck

if TYPE_CHECKING:
    from ..studio import Studio

EMPTY = "There are none yet. What is taught in a lesson is kept as one, unless that is switched off in the panel Teach."


def show_demonstrations(studio: Studio, parent: QWidget) -> None:
    """Open the dialog, or bring it to the front."""
    window = parent.window()
    dialog = window.findChild(DemonstrationsDialog) or DemonstrationsDialog(studio, window)
    dialog.show()
    dialog.raise_()
    dialog.activateWindow()


def demonstration_rows(parent: QWidget) -> tuple[ActionRow, ...]:
    """The dialog."""
    return (
        ActionRow(
            "behavior.demonstrations",
            "Demonstrations…",
            "Behavior",
            lambda studio: show_demonstrations(studio, parent),
            "demonstrations",
            tip="What was taught where, in the order in which it is played again",
            icon="movie-open-outline",
            enabled=when_open,
        ),
    )


def facts(project: Project, demonstration: Demonstration) -> str:
    """What a demonstration is, in words."""
    automaton = project.library(demonstration.type).automata.get(demonstration.automaton)
    examples = project.examples_of(demonstration.type, demonstration.automaton)
    filed = sum(example.demonstration == demonstration.id for example in examples)
    picks = sum(pick.act in ("pick", "answer") for pick in demonstration.picks)
    taught = automaton.name if automaton else demonstration.automaton
    return (
        f"{taught} ({demonstration.type}) was taught in the arm {demonstration.arm}, seed {demonstration.seed}: "
        f"{counted(picks, 'pick')} in {counted(demonstration.ticks, 'tick')}, {counted(filed, 'example')}."
    )


class DemonstrationsDialog(QDialog):
    """A window that stays open beside the work; every change is done at once and can be undone.

    Attributes:
        list: All demonstrations, in the order in which they are played.
        facts, note: What the chosen one is, and what the user says of it.
        check: Plays them, and compares.
    """

    def __init__(self, studio: Studio, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setObjectName("demonstrations")
        self.setWindowTitle("Demonstrations")
        self._studio = studio
        self.list = OrderedList("Demonstrations", studio.theme, empty=EMPTY)
        self.list.chosen.connect(lambda _: self._show_chosen())
        self.list.moved.connect(lambda name, to: studio.document.attempt(move_demonstration, name, to))
        self.list.removed.connect(lambda name: studio.document.attempt(remove_demonstration, name))
        self.facts = QLabel()
        self.facts.setWordWrap(True)
        self.facts.setTextFormat(Qt.TextFormat.PlainText)
        self.note = QLineEdit()
        self.note.setAccessibleName("Note on the demonstration")
        self.note.setToolTip("What it shows")
        self.note.editingFinished.connect(self._noted)
        words = caption(
            "They are played from top to bottom by “understudy demonstrate”. Examples stay when one is removed."
        )
        self.check = ReplayCheck(studio)
        form = QFormLayout()
        form.addRow(self.facts)
        form.addRow("Note", self.note)
        column = QVBoxLayout(self)
        column.addWidget(words)
        column.addWidget(self.list, 1)
        column.addLayout(form)
        column.addWidget(self.check)
        column.addWidget(closing(self))
        resize_within(self, 560, 520)
        studio.document.project_changed.connect(self.refresh)
        studio.opened.connect(self.close)
        studio.closing.connect(self.close)
        self.refresh()

    def done(self, result: int) -> None:
        """Nobody waits for what is played any more."""
        self.check.close()
        super().done(result)

    @property
    def chosen(self) -> Demonstration | None:
        """The current one."""
        found = self._studio.document.project.demonstrations
        return next((d for d in found if d.id == self.list.current), None)

    def refresh(self) -> None:
        """Show the demonstrations as they are now."""
        found = self._studio.document.project.demonstrations
        self.list.show_items([Item(d.id, d.id) for d in found])
        self._show_chosen()

    def _show_chosen(self) -> None:
        chosen = self.chosen
        self.facts.setText("" if chosen is None else facts(self._studio.document.project, chosen))
        self.note.setEnabled(chosen is not None)
        if not self.note.hasFocus():
            self.note.setText("" if chosen is None else chosen.note)

    def _noted(self) -> None:
        chosen, note = self.chosen, self.note.text().strip()
        if chosen is not None and note != chosen.note:
            self._studio.document.attempt(replace_demonstration, chosen.id, replace(chosen, note=note))
