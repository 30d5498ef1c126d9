"""The tree as it would be with the pruning confidence that the hand is on, until it is learned so."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from ...core.amounts import counted
from ...core.tree import Branch, Tree
from .confidence_page import ConfidencePage
from .preview import Answer, Preview, Question
from .pruning import Pruning
from .subject import Subject

if TYPE_CHECKING:
    from ..studio import Studio


class Previewing(QObject):
    """Keeps the previewed tree of the state that is shown.

    Attributes:
        tree: The tree that is previewed; None if the learned one is shown.

    Signals:
        changed: Another tree is to be shown.
    """

    changed = Signal()

    def __init__(self, studio: Studio, page: ConfidencePage, pruning: Pruning) -> None:
        super().__init__()
        self._studio, self._page, self._pruning = studio, page, pruning
        self.tree: Tree | None = None
        self._instead_of: object = None
        self._subject: Subject | None = None
        self._preview = Preview()
        self._preview.came.connect(self._came)
        page.dragged.connect(self._ask)
        page.dropped.connect(lambda confidence: self._keep(confidence, ""))
        page.stepped.connect(lambda confidence: self._keep(confidence, "pruning confidence"))
        page.settled.connect(studio.document.end_gesture)

    def shown(self, subject: Subject | None) -> Subject | None:
        """What is shown of a subject: the previewed tree, until what is learned is another one."""
        self._subject = subject
        if subject is None or self.tree is None or subject.model is not self._instead_of:
            self.tree = None
            return subject
        return replace(subject, tree=self.tree)

    def forget(self) -> None:
        """Another state is shown."""
        self.tree = None

    def close(self) -> None:
        """Learn nothing more."""
        self._preview.close()

    def _ask(self, confidence: float | None) -> None:
        subject = self._subject
        if subject is not None:
            document = self._studio.document
            examples = document.project.examples_of(subject.type, subject.automaton.id)
            vocabulary = document.scenario.vocabulary
            self._preview.ask(Question(subject.automaton, subject.state, examples, vocabulary, confidence))

    def _came(self, answer: Answer) -> None:
        subject = self._subject
        if subject is None or not _is_about(answer, subject):
            return
        learned = subject.model
        if answer.tree is None or not isinstance(learned, Tree):
            self._page.tell(answer.problem or "There is no single tree in this state.")
            return
        self.tree, self._instead_of = answer.tree, learned
        before, after = _tests(learned), _tests(answer.tree)
        self._page.tell(f"{counted(before, 'test')} in the tree now, {after} then.")
        self.changed.emit()

    def _keep(self, confidence: float | None, gesture: str) -> None:
        subject = self._subject
        if subject is None:
            return
        if subject.automaton.settings.pruning_confidence == confidence:
            self.tree = None
            self.changed.emit()
        self._pruning.confidence(subject, confidence, gesture)


def _is_about(answer: Answer, subject: Subject) -> bool:
    asked = answer.question
    return asked.automaton is subject.automaton and asked.state == subject.state


def _tests(tree: Tree) -> int:
    return sum(isinstance(node, Branch) for node in tree.nodes())
