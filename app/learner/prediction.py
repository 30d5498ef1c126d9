"""What models say about whole datasets: the same walk as `app.core.tree`, for many rows at once."""

from collections.abc import Mapping, Sequence
from typing import Protocol, runtime_checkable

import numpy as np

from ..core.conditions import AtMost, Equals, Test
from ..core.transition import Classifier
from ..core.tree import Branch, Forest, Tree, shares
from .dataset import Dataset, Flags, Floats, Integers, values_of


@runtime_checkable
class Batched(Protocol):
    """A classifier that evaluates many rows faster than one by one."""

    def probabilities(self, x: Floats) -> Floats:
        """The probabilities of its labels, rows by labels."""


def probabilities(model: Classifier, data: Dataset) -> Floats:
    """The probabilities of the model's labels for each row of *data*, rows by labels."""
    if isinstance(model, Tree | Forest):
        return _stored(model, data.x, [column.feature for column in data.columns])
    if isinstance(model, Batched):
        return model.probabilities(data.x)
    rows = (values_of(data.columns, row) for row in data.x.tolist())
    return np.array([model.decide(row.__getitem__).probabilities for row in rows]).reshape(len(data), -1)


def predicted(model: Classifier, data: Dataset) -> Integers:
    """For each row the place of its most probable label in the model's labels, of equals the first."""
    return np.asarray(np.argmax(probabilities(model, data), axis=1), np.int64)


def most_probable(model: Tree | Forest, x: Floats, features: Sequence[str]) -> Integers:
    """The same for rows of values of *features*, among which are all that the model tests."""
    return np.asarray(np.argmax(_stored(model, x, features), axis=1), np.int64)


def _stored(model: Tree | Forest, x: Floats, features: Sequence[str]) -> Floats:
    place = {feature: number for number, feature in enumerate(features)}
    if isinstance(model, Tree):
        return _of_tree(model, x, place)
    totals = np.zeros((len(x), len(model.labels)))
    for tree in model.trees:
        totals += _of_tree(tree, x, place)
    return totals / len(model.trees) if model.trees else totals


def _of_tree(tree: Tree, x: Floats, place: Mapping[str, int]) -> Floats:
    found = np.zeros((len(x), len(tree.labels)))
    stack = [(tree.root, np.arange(len(x)))]
    while stack:
        node, rows = stack.pop()
        if isinstance(node, Branch):
            passes = holds(node.test, x[rows, place[node.test.feature]])
            stack += ((node.yes, rows[passes]), (node.no, rows[~passes]))
        else:
            found[rows] = shares(node.counts)
    return found


def holds(test: Test, values: Floats) -> Flags:
    """Whether each value passes the test."""
    if isinstance(test, AtMost):
        return np.asarray(values <= test.threshold, np.bool_)
    if isinstance(test, Equals):
        return np.asarray(values == test.value, np.bool_)
    above, under = values >= test.start, values < test.end
    return np.asarray(above & under if test.start <= test.end else above | under, np.bool_)
