"""How well what was learned fits the examples: worked out beside the window, kept until something it depends on changes."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

from PySide6.QtCore import QObject, QTimer, Signal

from ...core.amounts import counted
from ...core.errors import UnderstudyError
from ...core.project import Project
from ...core.tree import Forest, Tree
from ...core.vocabulary import Vocabulary
from ...engine.worker import IsCancelled, Worker
from ...learner.dataset import Dataset, columns_of, conflicts, datasets, sift
from ...learner.prediction import predicted
from ...learner.trainer import Key, fingerprint, refit

#: Milliseconds without another change before anything is worked out, as with learning: what is learned changes it again.
PATIENCE = 120
#: A share that differs from all by no more is all.
ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class Fit:
    """How well an automaton's models fit its examples.

    Attributes:
        fingerprint: Of what the automaton would be learned from now.
        stale: It has changed since it was learned.
        learned_from: How many examples it can learn from.
        left_out: Enabled examples that it cannot learn from.
        share: Of their weight, the share that the models get right; None if there is nothing to get right.
        conflicts: How many examples contradict others: equal features, another label.
        problem: Why nothing can be said; empty if it can.
    """

    fingerprint: str = ""
    stale: bool = False
    learned_from: int = 0
    left_out: int = 0
    share: float | None = None
    conflicts: int = 0
    problem: str = ""

    @property
    def brief(self) -> str:
        """In few words, such as "fits all 12 examples"; empty if nothing was learned, or something else than this."""
        if self.share is None or self.stale or self.problem:
            return ""
        if self.share < 1.0 - ROUNDING:
            return f"fits {self.share:.0%} of {counted(self.learned_from, 'example')}"
        return f"fits all {self.learned_from} examples" if self.learned_from > 1 else "fits its example"

    @property
    def words(self) -> str:
        """All of it, for a tool tip."""
        if self.problem:
            return self.problem
        if self.share is None:
            return "not learned yet" if self.learned_from else "no examples yet"
        said = f"fits {self.share:.0%} of {counted(self.learned_from, 'example')}"
        if self.left_out:
            said += f"; {self.left_out} cannot be learned from"
        if self.conflicts:
            said += f"; {self.conflicts} contradict each other: equal features, another label"
        return said + ("; changed since it was learned" if self.stale else "")


def fit_of(project: Project, scenario: Vocabulary, key: Key) -> Fit:
    """How well the stored models of an automaton fit its examples as they are now."""
    automaton, examples = project.library(key[0]).get(key[1]), project.examples_of(*key)
    found = fingerprint(automaton, examples)
    stale = bool(examples) and automaton.learned_from != found
    try:
        sifted = sift(automaton, examples)
        data = datasets(automaton, sifted.kept, columns_of(automaton.features, scenario))
        right = [_right(project, scenario, key, state, rows) for state, rows in data.items()]
    except UnderstudyError as error:
        return Fit(found, stale, problem=str(error))
    weight = sum(float(rows.weight.sum()) for rows in data.values())
    share = sum(right) / weight if weight and automaton.learned else None
    torn = sum(len(group) for rows in data.values() for group in conflicts(rows))
    return Fit(found, stale, len(sifted.kept), len(sifted.left_out), share, torn)


def _right(project: Project, scenario: Vocabulary, key: Key, state: str, rows: Dataset) -> float:
    """The weight of the examples of one state whose label its model finds most probable."""
    model = project.library(key[0]).get(key[1]).learned.get(state)
    if model is None:
        return 0.0
    classifier = model if isinstance(model, Tree | Forest) else refit(project, scenario, *key, state)
    if classifier is None:
        return 0.0
    tested = {test for tree in _trees(model) for test in tree.features()}
    if not tested <= {column.feature for column in rows.columns}:
        return 0.0  # the model is of before a feature was dropped
    labels = model.labels if isinstance(model, Tree | Forest) else rows.labels
    guessed = predicted(classifier, rows).tolist()
    pairs = zip(guessed, rows.y.tolist(), rows.weight.tolist(), strict=True)
    return sum(weight for guess, true, weight in pairs if labels[guess] == rows.labels[true])


def _trees(model: object) -> tuple[Tree, ...]:
    if isinstance(model, Forest):
        return model.trees
    return (model,) if isinstance(model, Tree) else ()


@dataclass(frozen=True, slots=True, eq=False)
class _Known:
    made_of: tuple[object, ...]
    states: tuple[str, ...]
    fit: Fit

    def holds(self, project: Project, key: Key) -> bool:
        if key[1] not in project.library(key[0]).automata:
            return False
        made_of = _made_of(project, key)
        same = all(old is new for old, new in zip(self.made_of, made_of, strict=True))
        return same and self.states == _states(project, key)


def _made_of(project: Project, key: Key) -> tuple[object, ...]:
    """All that a fit depends on, besides states: not the automaton's name, nor how it is drawn or noted."""
    automaton = project.library(key[0]).get(key[1])
    return (
        automaton.features,
        automaton.settings,
        automaton.cuts,
        automaton.learned,
        automaton.learned_from,
        project.examples_of(*key),
    )


def _states(project: Project, key: Key) -> tuple[str, ...]:
    """What a fit depends on of states, as learning does: what they hold, and so what they are called, may change."""
    return tuple(state.id for state in project.library(key[0]).get(key[1]).states)


def _keys(project: Project) -> list[Key]:
    return [
        (node_type.name, automaton_id)
        for node_type in project.types
        for automaton_id in project.library(node_type.name).automata
    ]


class Fits(QObject):
    """The fits of all automata of a project, as far as they are known.

    Signals:
        changed: The fits of these automata are known now; a tuple of keys.
    """

    changed = Signal(object)
    _ready = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._known: dict[Key, _Known] = {}
        self._done: deque[tuple[Key, _Known]] = deque()
        self._worker: Worker[tuple[Project, Vocabulary, tuple[Key, ...]], None] = Worker(
            self._work, lambda _question, _why: None, self._ready.emit, "fits"
        )
        self._ready.connect(self._take)
        self._newest: tuple[Project, Vocabulary] | None = None
        self._is_closed = False
        self._soon = QTimer(self, interval=PATIENCE, singleShot=True)
        self._soon.timeout.connect(self._ask)

    def of(self, key: Key) -> Fit | None:
        """What is known; it may be of a moment ago."""
        known = self._known.get(key)
        return None if known is None else known.fit

    def now(self, key: Key, project: Project) -> Fit | None:
        """What is known of an automaton as it is in *project*; None while that is being found out."""
        known = self._known.get(key)
        return known.fit if known is not None and known.holds(project, key) else None

    def follow(self, project: Project, scenario: Vocabulary) -> None:
        """Find out about all automata of which nothing is known as they are now; nothing any more once it is closed."""
        if self._is_closed:
            return
        self._newest = project, scenario
        keys = set(_keys(project))
        for gone in self._known.keys() - keys:
            del self._known[gone]
        if self._unknown(project):
            self._worker.give_up()  # what it is at may be among them; the rest is asked for again
            self._soon.start()
        else:
            self._soon.stop()

    def _unknown(self, project: Project) -> tuple[Key, ...]:
        known = self._known
        return tuple(key for key in _keys(project) if key not in known or not known[key].holds(project, key))

    def _ask(self) -> None:
        if self._newest is not None:
            project, scenario = self._newest
            self._worker.ask((project, scenario, self._unknown(project)))

    def close(self) -> None:
        """End the thread."""
        self._is_closed = True
        self._soon.stop()
        self._worker.close()

    def _work(self, question: tuple[Project, Vocabulary, tuple[Key, ...]], cancelled: IsCancelled) -> None:
        project, scenario, keys = question
        for key in keys:
            if cancelled():
                return
            fit = fit_of(project, scenario, key)
            self._done.append((key, _Known(_made_of(project, key), _states(project, key), fit)))
            self._ready.emit()

    def _take(self) -> None:
        self._worker.answers()
        keys = []
        while self._done:
            key, known = self._done.popleft()
            if self._newest is None or not known.holds(self._newest[0], key):
                continue  # it has changed meanwhile, or changed back
            before = self._known.get(key)
            self._known[key] = known
            if before is None or before.fit != known.fit:
                keys.append(key)
        if keys:
            self.changed.emit(tuple(keys))
