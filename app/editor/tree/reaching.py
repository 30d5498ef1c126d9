"""Which examples reach a node of a tree: as arrays, so that it is quick for many examples and deep trees."""

from collections.abc import Sequence
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ...core.conditions import Guard
from ...core.examples import Example
from ...core.tree import Branch, Tree, TreeNode
from ...learner.prediction import holds
from .shape import ROOT, Key

Floats = NDArray[np.float64]


class Reaching:
    """The enabled examples of one state, column by column; they are looked for once somebody asks."""

    def __init__(self, examples: Sequence[Example], state: str, features: Sequence[str]) -> None:
        self._all, self._state, self._features = examples, state, features
        self._columns: dict[str, Floats] = {}

    @cached_property
    def examples(self) -> tuple[Example, ...]:
        """Those of the state that a model is learned from."""
        return tuple(
            example
            for example in self._all
            if example.enabled
            and example.source == self._state
            and all(feature in example.values for feature in self._features)
        )

    def column(self, feature: str) -> Floats:
        """The values of a feature, example by example."""
        if feature not in self._columns:
            self._columns[feature] = np.array([e.values[feature] for e in self.examples], np.float64)
        return self._columns[feature]

    def rows(self, guard: Guard) -> NDArray[np.bool_]:
        """Which of the examples pass all tests."""
        passing = np.ones(len(self.examples), np.bool_)
        for condition in guard:
            passing &= holds(condition.test, self.column(condition.test.feature)) == condition.wanted
        return passing

    def ids(self, guard: Guard) -> tuple[str, ...]:
        """The ids of those that pass all tests."""
        return tuple(self.examples[row].id for row in np.flatnonzero(self.rows(guard)).tolist())


def passed(tree: Tree, examples: Sequence[Example]) -> frozenset[Key]:
    """The nodes that any of the examples passes, which have values of all that is tested."""
    found: set[Key] = set()
    columns: dict[str, Floats] = {}
    stack: list[tuple[Key, TreeNode, NDArray[np.bool_]]] = [
        (ROOT, tree.root, np.ones(len(examples), np.bool_))
    ]
    while stack:
        key, node, here = stack.pop()
        if not here.any():
            continue
        found.add(key)
        if isinstance(node, Branch):
            feature = node.test.feature
            if feature not in columns:
                columns[feature] = np.array([e.values[feature] for e in examples], np.float64)
            yes = holds(node.test, columns[feature])
            stack += [(2 * key + 1, node.yes, here & yes), (2 * key, node.no, here & ~yes)]
    return frozenset(found)
