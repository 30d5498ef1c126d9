"""The learner's splits by definition: every cut, arc and value, one at a time, in plain Python.

Slow and obvious; the builder must find splits that are as good at every node.
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import log2

from app.core.vocabulary import FeatureKind
from app.learner.dataset import Column

EQUAL = 1e-9


@dataclass(frozen=True)
class Row:
    values: dict[str, float]
    label: str
    weight: float = 1.0


Offer = tuple[float, float]
"""Gain and split information."""


def entropy(rows: Sequence[Row]) -> float:
    counts: defaultdict[str, float] = defaultdict(float)
    for row in rows:
        counts[row.label] += row.weight
    total = sum(counts.values())
    return -sum(c / total * log2(c / total) for c in counts.values())


def weight(rows: Sequence[Row]) -> float:
    return sum(row.weight for row in rows)


def offer(inside: Sequence[Row], outside: Sequence[Row]) -> Offer:
    whole = [*inside, *outside]
    shares = [weight(side) / weight(whole) for side in (inside, outside)]
    gain = entropy(whole) - shares[0] * entropy(inside) - shares[1] * entropy(outside)
    return gain, -sum(share * log2(share) for share in shares)


def ways_to_split(rows: Sequence[Row], column: Column) -> Iterator[set[float]]:
    """The values inside, for every test of a column that parts the rows."""
    values = sorted({row.values[column.feature] for row in rows})
    count = len(values)
    if column.kind is FeatureKind.CONTINUOUS:
        yield from (set(values[:end]) for end in range(1, count))
    elif column.kind is FeatureKind.TOROIDAL:
        arcs = ((first, end) for first in range(count) for end in range(first + 1, count + 1))
        yield from (set(values[first:end]) for first, end in arcs if end - first < count)
    elif count > 1:
        yield from ({value} for value in values)


def best_offer(rows: Sequence[Row], column: Column, min_leaf: float = 0.0) -> Offer | None:
    """The highest gain of any split, and of the splits with that gain the largest split information."""
    offers = []
    for passing in ways_to_split(rows, column):
        inside = [row for row in rows if row.values[column.feature] in passing]
        outside = [row for row in rows if row.values[column.feature] not in passing]
        if min(weight(inside), weight(outside)) >= min_leaf:
            offers.append(offer(inside, outside))
    if not offers:
        return None
    highest = max(gain for gain, _ in offers)
    return highest, max(information for gain, information in offers if gain >= highest - EQUAL)


def worths(rows: Sequence[Row], columns: Sequence[Column], *, gain_ratio: bool = True) -> dict[str, float]:
    """What the split of each feature is worth: the one of the highest worth is to be taken."""
    offers = {column.feature: found for column in columns if (found := best_offer(rows, column)) is not None}
    gaining = {feature: gain for feature, (gain, _) in offers.items() if gain > EQUAL}
    if not gaining:
        return {feature: information for feature, (_, information) in offers.items()}
    if not gain_ratio:
        return gaining
    average = sum(gaining.values()) / len(gaining)
    return {f: gain / offers[f][1] for f, gain in gaining.items() if gain >= average - EQUAL}
