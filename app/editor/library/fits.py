"""How well what was learned fits the examples: worked out beside the window, kept until something it depends on changes."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QObject, QTimer, Signal

from ...core.amounts import counted
from ...core.automaton import Automaton
from ...core.errors import UnderstudyError
from ...core.examples import Example
from ...core.project import Project
from ...core.tree import Forest, Tree, trees_of
from ...core.vocabulary import Vocabulary
from ...engine.turns import AFTER_EDITS
from ...engine.worker import IsCancelled, Worker
from ...learner.dataset import Dataset, columns_of, conflicts, datasets, sift
from ...learner.freshness import Freshness
from ...learner.prediction import predicted
from ...learner.trainer import Key, every_automaton, refit

#: Milliseconds without another change before anything is worked out, as with learning: what is learned changes it again.
PATIENCE = 120
#: A share that differs from all by no more is all.
ROUNDING = 1e-9
#: The place of a label that no example has.
NOWHERE = -1


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
        return f"fits all {self.learned_from:,} examples" if self.learned_from > 1 else "fits its example"

    @property
    def words(self) -> str:
        """All of it, for a tool tip."""
        if self.problem:
            return self.problem
        if self.share is None:
            return "not learned yet" if self.learned_from else "no examples yet"
        said = f"fits {self.share:.0%} of {counted(self.learned_from, 'example')}"
        if self.left_out:
            said += f"; {self.left_out:,} cannot be learned from"
        if self.conflicts:
            said += f"; {self.conflicts:,} contradict each other: equal features, another label"
        return said + ("; changed since it was learned" if self.stale else "")


def fit_of(project: Project, scenario: Vocabulary, key: Key, freshness: Freshness) -> Fit:
    """How well the stored models of an automaton fit its examples as they are now."""
    automaton, examples = project.library(key[0]).get(key[1]), project.examples_of(*key)
    found, stale = freshness.fingerprint(project, key), freshness.is_stale(project, key)
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
    tested = {test for tree in trees_of(model) for test in tree.features()}
    if not tested <= {column.feature for column in rows.columns}:
        return 0.0  # the model is of before a feature was dropped
    labels = model.labels if isinstance(model, Tree | Forest) else rows.labels
    place = {label: number for number, label in enumerate(rows.labels)}
    places = np.array([place.get(label, NOWHERE) for label in labels])
    return sum(rows.weight[places[predicted(classifier, rows)] == rows.y].tolist())


@dataclass(frozen=True, slots=True, eq=False)
class _Known:
    automaton: Automaton
    examples: tuple[Example, ...]
    fit: Fit

    def holds(self, project: Project, key: Key) -> bool:
        automaton = project.library(key[0]).automata.get(key[1])
        if automaton is None or self.examples is not project.examples_of(*key):
            return False
        return automaton is self.automaton or _same(self.automaton, automaton)


def _same(old: Automaton, new: Automaton) -> bool:
    """Whether all that a fit depends on is the same: not the automaton's name, nor what its states hold or are called."""
    return (
        old.features is new.features
        and old.settings is new.settings
        and old.cuts is new.cuts
        and old.learned is new.learned
        and old.learned_from == new.learned_from
        and [state.id for state in old.states] == [state.id for state in new.states]
    )


class Fits(QObject):
    """The fits of all automata of a project, as far as they are known.

    Signals:
        changed: The fits of these automata are known now; a tuple of keys.
    """

    changed = Signal(object)
    _ready = Signal()

    def __init__(self, freshness: Freshness, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._freshness = freshness
        self._known: dict[Key, _Known] = {}
        self._done: deque[tuple[Key, _Known]] = deque()
        self._worker: Worker[tuple[Project, Vocabulary, tuple[Key, ...]], None] = Worker(
            AFTER_EDITS.taken(self._work), lambda _question, _why: None, self._ready.emit, "fits"
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
        keys = set(every_automaton(project))
        for gone in self._known.keys() - keys:
            del self._known[gone]
        if self._unknown(project):
            self._worker.give_up()  # what it is at may be among them; the rest is asked for again
            self._soon.start()
        else:
            self._soon.stop()

    def _unknown(self, project: Project) -> tuple[Key, ...]:
        known = self._known
        keys = every_automaton(project)
        return tuple(key for key in keys if key not in known or not known[key].holds(project, key))

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
            fit = fit_of(project, scenario, key, self._freshness)
            automaton = project.library(key[0]).get(key[1])
            self._done.append((key, _Known(automaton, project.examples_of(*key), fit)))
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
