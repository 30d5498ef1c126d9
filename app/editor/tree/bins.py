"""The histogram of the examples at a node, by label: pure, as arrays."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...core.conditions import AtMost, InArc
from ...core.predicates import is_of_nobody
from ...core.vocabulary import Feature

BINS = 24
#: Room beyond the least and the greatest value, as a share of what lies between.
MARGIN = 0.06


@dataclass(frozen=True, slots=True, eq=False)
class Histogram:
    """How many examples of each label have values where.

    Attributes:
        low, high: What is shown; values that mean "nobody" are beyond it.
        counts: Bins x labels.
        nobody: By label, how many have the value that says that there is no target.
    """

    low: float
    high: float
    counts: NDArray[np.int64]
    nobody: NDArray[np.int64]

    @property
    def most(self) -> int:
        """The height of the highest bar."""
        return int(max(self.counts.sum(axis=1).max(initial=0), self.nobody.sum(), 1))

    def place(self, value: float) -> float:
        """Where a value is, from 0 at the left to 1 at the right; cut to that."""
        return min(1.0, max(0.0, (value - self.low) / (self.high - self.low)))

    def value(self, place: float) -> float:
        """The value at a place."""
        return self.low + min(1.0, max(0.0, place)) * (self.high - self.low)


def histogram(
    values: NDArray[np.float64],
    labels: NDArray[np.int64],
    many: int,
    test: AtMost | InArc,
    feature: Feature,
) -> Histogram:
    """The histogram of *values*, of which each belongs to one of *many* labels."""
    absent = np.array([is_of_nobody(feature, value) for value in values.tolist()], np.bool_)
    there = values[~absent]
    if isinstance(test, InArc):
        low, high = -feature.period / 2, feature.period / 2
    else:
        low, high = _range(there, test.threshold)
    counts = np.zeros((BINS, many), np.int64)
    bins = np.clip(((there - low) / (high - low) * BINS).astype(np.int64), 0, BINS - 1)
    np.add.at(counts, (bins, labels[~absent]), 1)
    return Histogram(low, high, counts, np.bincount(labels[absent], minlength=many).astype(np.int64))


def _range(values: NDArray[np.float64], threshold: float) -> tuple[float, float]:
    low, high = float(values.min(initial=threshold)), float(values.max(initial=-np.inf))
    high = high if np.isfinite(high) else threshold
    low = min(low, high)
    room = (high - low) * MARGIN or max(1.0, abs(high)) * MARGIN
    return low - room, high + room
