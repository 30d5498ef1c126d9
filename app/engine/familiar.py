"""How far what a node sees is from what it was taught with: 0 the same, 1 as far apart as the examples are."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import inf

import numpy as np
from numpy.typing import NDArray

from ..core.automaton import Automaton
from ..core.examples import Example
from ..core.features import FeatureUse, Sense, declaration
from ..core.vocabulary import Feature, FeatureKind, Vocabulary
from ..learner.dataset import sift

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Nearest:
    """The nearest example of a state.

    Attributes:
        distance: The greatest of the features' distances; infinite if the state has no example.
        feature: Id of the feature in which it is greatest; empty if there is none.
        examples: How many the state has.
    """

    distance: float = inf
    feature: str = ""
    examples: int = 0


class Familiar:
    """The enabled examples of one automaton, to be compared with what is seen.

    A continuous feature is scaled by the range of its values among all of them, a toroidal one by half its circle;
    others are the same or not. The default of a feature whose target is nobody is as far from all other values as
    those are from each other at most.
    """

    def __init__(self, automaton: Automaton, examples: Sequence[Example], vocabulary: Vocabulary) -> None:
        """Look at the examples once.

        Raises:
            ScenarioError: The scenario lacks one of the automaton's features.
        """
        kept = sift(automaton, examples).kept
        self._scales = [_Scale(use, declaration(use.source, vocabulary), kept) for use in automaton.features]
        self._by_state: dict[str, list[Example]] = {}
        for example in kept:
            self._by_state.setdefault(example.source, []).append(example)
        self._columns: dict[str, list[Floats]] = {}

    def nearest(self, state: str, values: Mapping[str, float]) -> Nearest:
        """The example of *state* that is nearest to what is seen; features without a value are left out."""
        examples = self._by_state.get(state, [])
        if not examples:
            return Nearest()
        if state not in self._columns:
            self._columns[state] = [scale.column(examples) for scale in self._scales]
        far = [
            (scale.use.id, scale.distances(column, values[scale.use.id]))
            for scale, column in zip(self._scales, self._columns[state], strict=True)
            if scale.use.id in values
        ]
        if not far:
            return Nearest(0.0, "", len(examples))
        rows = np.stack([distances for _, distances in far])
        greatest = rows.max(axis=0)
        best = int(greatest.argmin())
        return Nearest(float(greatest[best]), far[int(rows[:, best].argmax())][0], len(examples))


class _Scale:
    """How the values of one feature are compared."""

    def __init__(self, use: FeatureUse, feature: Feature, examples: Sequence[Example]) -> None:
        self.use = use
        self._kind = feature.kind
        self._period = feature.period
        self._nobody = feature.default if _may_be_of_nobody(use, feature) else None
        values = [example.values[use.id] for example in examples]
        told = [value for value in values if value != self._nobody]
        self._range = max(told) - min(told) if told else 0.0

    def column(self, examples: Sequence[Example]) -> Floats:
        return np.array([example.values[self.use.id] for example in examples], np.float64)

    def distances(self, column: Floats, value: float) -> Floats:
        """From *value* to each of the column's."""
        apart: Floats = np.abs(column - value)
        if self._kind is FeatureKind.TOROIDAL:
            apart = np.minimum(apart, self._period - apart)
            return apart / (self._period / 2.0)
        same_or_not = (apart > 0.0).astype(np.float64)
        if self._kind is not FeatureKind.CONTINUOUS or self._range <= 0.0:
            return same_or_not
        if self._nobody is None:
            return apart / self._range
        if value == self._nobody:
            return same_or_not
        return np.where(column == self._nobody, 1.0, apart / self._range)


def _may_be_of_nobody(use: FeatureUse, feature: Feature) -> bool:
    """Whether the feature has a default that stands for "no target"."""
    return (
        isinstance(use.source, Sense) and bool(feature.parameters) and feature.kind is FeatureKind.CONTINUOUS
    )
