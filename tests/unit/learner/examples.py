"""Examples and datasets written down in a line, for the learner's tests."""

from collections.abc import Mapping, Sequence
from math import pi

from app.core.conditions import Values
from app.core.examples import Example
from app.core.vocabulary import FeatureKind
from app.learner.dataset import Column, Dataset, dataset

CONTINUOUS, TOROIDAL = FeatureKind.CONTINUOUS, FeatureKind.TOROIDAL
BOOLEAN, CATEGORICAL = FeatureKind.BOOLEAN, FeatureKind.CATEGORICAL


def column(feature: str, kind: FeatureKind = CONTINUOUS) -> Column:
    return Column(feature, kind, 2 * pi if kind is TOROIDAL else 0.0)


def example(
    number: int,
    label: str,
    values: Mapping[str, float],
    *,
    continuation: bool = False,
    weight: float = 1.0,
    source: str = "here",
) -> Example:
    return Example(str(number), source, label, values, continuation, weight=weight)


def of_one_feature(kind: FeatureKind, *points: tuple[float, str], continuations: str = "") -> Dataset:
    """Points (value, label) of the feature "f"; those with the label *continuations* are continuations."""
    made = [
        example(number, label, {"f": value}, continuation=label == continuations)
        for number, (value, label) in enumerate(points)
    ]
    return of(made, column("f", kind))


def at(value: float) -> Values:
    """The feature "f" has this value."""
    return {"f": value}.__getitem__


def of(examples: Sequence[Example], *columns: Column) -> Dataset:
    return dataset(examples, sorted({e.label for e in examples}), columns)
