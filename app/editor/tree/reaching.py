"""Which examples reach a node of a tree: as arrays, so that it is quick for many examples and deep trees."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ...core.conditions import Guard
from ...core.examples import Example
from ...learner.prediction import holds

Floats = NDArray[np.float64]


class Reaching:
    """The enabled examples of one state, column by column.

    Attributes:
        examples: Those of the state that a model is learned from.
    """

    def __init__(self, examples: Sequence[Example], state: str, features: Sequence[str]) -> None:
        self.examples = tuple(
            example
            for example in examples
            if example.enabled
            and example.source == state
            and all(feature in example.values for feature in features)
        )
        self._columns: dict[str, Floats] = {}

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
