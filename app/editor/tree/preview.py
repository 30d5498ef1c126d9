"""What a state's tree would be with another pruning confidence, learned in the background; late answers are dropped."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from PySide6.QtCore import QObject, Signal

from ...core.automaton import Automaton
from ...core.cuts import with_cuts
from ...core.examples import Example
from ...core.tree import Tree
from ...core.vocabulary import Vocabulary
from ...engine.worker import IsCancelled, Worker
from ...learner.dataset import columns_of, dataset, sift
from ...learner.registry import fit


@dataclass(frozen=True, slots=True, eq=False)
class Question:
    """A state of an automaton, and how strongly its tree is to be pruned."""

    automaton: Automaton
    state: str
    examples: Sequence[Example]
    vocabulary: Vocabulary
    confidence: float | None


@dataclass(frozen=True, slots=True, eq=False)
class Answer:
    """The tree that would be learned; None if it is no tree, or nothing is learned."""

    question: Question
    tree: Tree | None
    problem: str = ""


class Preview(QObject):
    """Answers the last question.

    Signals:
        came: The answer.
    """

    came = Signal(object)
    _ready = Signal()

    def __init__(self) -> None:
        super().__init__()
        self._worker: Worker[Question, Answer] | None = None
        self._full: tuple[Question, Tree | None] | None = None  # only the thread looks at it
        self._ready.connect(self._take)

    def ask(self, question: Question) -> None:
        """Learn; an earlier question that is still open is given up."""
        if self._worker is None:
            self._worker = Worker(self._answer, _broken, self._ready.emit, "preview")
        self._worker.ask(question)

    def close(self) -> None:
        """Give up what is open and end the thread."""
        if self._worker is not None:
            self._worker.close()
            self._worker = None
            self._full = None

    def _take(self) -> None:
        for answer in self._worker.answers() if self._worker is not None else ():
            self.came.emit(answer)

    def _answer(self, question: Question, cancelled: IsCancelled) -> Answer:
        full = self._unpruned(question, cancelled)
        cuts = question.automaton.cuts_of(question.state)
        if full is None or question.confidence is None:
            return Answer(question, None if full is None else with_cuts(full, cuts))
        from ...learner.pruning import pruned  # noqa: PLC0415 - scipy.special takes long to load

        return Answer(question, with_cuts(pruned(full, question.confidence), cuts))

    def _unpruned(self, question: Question, cancelled: IsCancelled) -> Tree | None:
        """The tree without pruning, learned once for all confidences."""
        kept = self._full
        if kept is not None and _alike(kept[0], question):
            return kept[1]
        automaton = question.automaton
        found = [e for e in sift(automaton, question.examples).kept if e.source == question.state]
        if not found:
            return None
        columns = columns_of(automaton.features, question.vocabulary)
        data = dataset(found, [state.id for state in automaton.states], columns)
        fitted = fit(data, replace(automaton.settings, pruning_confidence=None), cancelled)
        tree = fitted if isinstance(fitted, Tree) else None
        self._full = question, tree
        return tree


def _alike(a: Question, b: Question) -> bool:
    same = a.automaton is b.automaton and a.examples is b.examples
    return same and a.state == b.state and a.vocabulary is b.vocabulary


def _broken(question: Question, why: str) -> Answer:
    return Answer(question, None, why)
