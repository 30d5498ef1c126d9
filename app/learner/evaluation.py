"""How good a learned transition function is: accuracy, cross-validation, confusion, conflicts, and the report.

All accuracies are shares of example weight. A prediction is the most probable label, so a leaf that holds two labels is
right about one of them.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..core.automaton import Settings
from ..core.transition import Classifier
from ..core.tree import trees_of
from .builder import IsCancelled, LearningCancelled, never
from .dataset import Dataset, Integers, LeftOut, conflicts
from .prediction import predicted
from .registry import fit

#: Up to this many examples each is held out by itself; with more, a tenth at a time.
LEAVE_ONE_OUT = 50
FOLDS = 10

Confusion = tuple[tuple[float, ...], ...]


@dataclass(frozen=True, slots=True)
class StateReport:
    """What was learned for one state, and how well.

    Attributes:
        state, name: Its id, and what the user calls it.
        examples: How many it was learned from.
        nodes: Of the tree, or of all trees; 0 for a classifier that is none.
        accuracy: On the examples it was learned from.
        cv_accuracy: On examples held out; None if that was not asked for, or if there was nothing to hold out.
        labels: Ids of the states it can predict.
        confusion: Weights of examples, by true label, then predicted one; of held-out predictions if there are any.
        conflicts: Groups of ids of examples with equal features but different labels.
    """

    state: str
    name: str
    examples: int
    nodes: int
    accuracy: float
    cv_accuracy: float | None
    labels: tuple[str, ...]
    confusion: Confusion
    conflicts: tuple[tuple[str, ...], ...] = ()


@dataclass(frozen=True, slots=True)
class BehaviorReport:
    """What was learned for one automaton.

    Attributes:
        type, automaton, name: Where it is, and what the user calls it.
        level: Of its type: 0 for agents.
        examples: How many it was learned from, in all states.
        left_out: Enabled examples that could not be learned from.
    """

    type: str
    automaton: str
    name: str
    level: int
    examples: int
    states: tuple[StateReport, ...] = ()
    left_out: tuple[LeftOut, ...] = ()


def report_on(
    data: Dataset,
    fitted: Classifier,
    state: tuple[str, str],
    held_out: Integers | None = None,
) -> StateReport:
    """The report on one state.

    Args:
        state: Its id and its name.
        held_out: What `cross_validated` gave, if it was asked.
    """
    guessed = predicted(fitted, data)
    return StateReport(
        *state,
        len(data),
        node_count(fitted),
        accuracy(data, guessed),
        None if held_out is None else accuracy(data, held_out),
        data.labels,
        confusion(data, guessed if held_out is None else held_out),
        conflicts(data),
    )


def node_count(fitted: Classifier) -> int:
    """The number of nodes of a tree or a forest; 0 for anything else."""
    return sum(1 for tree in trees_of(fitted) for _ in tree.nodes())


def accuracy(data: Dataset, guessed: Integers) -> float:
    """The share of weight whose label was guessed."""
    return float(data.weight[guessed == data.y].sum() / data.weight.sum())


def confusion(data: Dataset, guessed: Integers) -> Confusion:
    """Weights of examples by true label (rows) and guessed label (columns)."""
    classes = len(data.labels)
    table = np.bincount(data.y * classes + guessed, data.weight, classes * classes).reshape(classes, classes)
    return tuple(map(tuple, table.tolist()))


# ---------------------------------------------------------------------------------------------- cross-validation


def cross_validated(
    data: Dataset,
    settings: Settings,
    cancelled: IsCancelled = never,
    step: Callable[[float], None] = lambda _: None,
) -> Integers | None:
    """For each example the label that it would get from a classifier learned without it; None where none can be held out.

    Args:
        step: Told the share that is done.

    Raises:
        LearningCancelled: *cancelled* returned true.
    """
    fold = folds(data)
    count = int(fold.max(initial=0)) + 1
    if count < 2:
        return None
    guessed = np.zeros(len(data), np.int64)
    for number in range(count):
        if cancelled():
            raise LearningCancelled
        held_out = np.flatnonzero(fold == number)
        rest = data.rows(np.flatnonzero(fold != number))
        guessed[held_out] = predicted(fit(rest, settings, cancelled), data.rows(held_out))
        step((number + 1) / count)
    return guessed


def folds(data: Dataset) -> Integers:
    """For each example the number of the fold in which it is held out.

    Examples that one pick recorded describe the same moment and stay together. Labels are spread evenly, and the same
    examples always give the same folds.
    """
    groups: dict[object, list[int]] = {}
    for row, example in enumerate(data.examples):
        # Pick 0: it was not recorded by a pick.
        by_pick = (example.demonstration, example.node, example.tick, example.pick)
        groups.setdefault(by_pick if example.pick else row, []).append(row)
    ordered = sorted(groups.values(), key=lambda rows: (int(data.y[rows[0]]), rows[0]))
    count = len(ordered) if len(data) <= LEAVE_ONE_OUT else min(FOLDS, len(ordered))
    fold = np.zeros(len(data), np.int64)
    for number, rows in enumerate(ordered):
        fold[rows] = number % count
    return fold


# ---------------------------------------------------------------------------------------------- plain form


def plain(reports: Sequence[BehaviorReport]) -> dict[str, object]:
    """The reports as JSON-ready values, in the shape of ``train --json``."""
    return {"behaviors": [_plain_behavior(report) for report in reports]}


def _plain_behavior(report: BehaviorReport) -> Mapping[str, object]:
    return {
        "name": report.name,
        "type": report.type,
        "level": report.level,
        "examples": report.examples,
        "left_out": [{"example": left.example, "reason": left.reason} for left in report.left_out],
        "states": [_plain_state(state) for state in report.states],
    }


def _plain_state(report: StateReport) -> Mapping[str, object]:
    return {
        "state": report.name,
        "examples": report.examples,
        "nodes": report.nodes,
        "accuracy": report.accuracy,
        "cv_accuracy": report.cv_accuracy,
        "labels": list(report.labels),
        "confusion": [list(row) for row in report.confusion],
        "conflicts": [list(group) for group in report.conflicts],
    }
