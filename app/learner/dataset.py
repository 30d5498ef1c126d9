"""From the examples of one state to arrays, and the reasons why an example is not learned from.

A state's dataset has one column for each of the automaton's features, and no other. `TicksInState` and flags are used
only where the user chose them: a continuation is recorded on entry, where `TicksInState` is always 0, so adding it
unasked would separate every transition from every continuation and hide what the demonstrator looked at.

Rows are sorted by their contents, so everything that is learned depends on which examples there are, not on their order.
"""

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from math import isfinite
from operator import attrgetter, itemgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.automaton import START, Automaton, Basic, RaiseFlag, State
from ..core.errors import ExampleError
from ..core.examples import Example
from ..core.features import FeatureUse, declaration
from ..core.vocabulary import FeatureKind, Vocabulary

Floats = NDArray[np.float64]
Integers = NDArray[np.signedinteger[Any]]
Flags = NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class Column:
    """How the values of one feature are compared."""

    feature: str
    kind: FeatureKind
    period: float = 0.0


@dataclass(frozen=True, slots=True, eq=False)
class Dataset:
    """The examples of one state as arrays, one row each.

    Attributes:
        labels: Ids of the states that examples lead to, in the automaton's order.
        columns: One a feature, in the automaton's order.
        x: Values, rows by columns.
        y: For each row, the place of its label in *labels*.
        weight: Above 0.
        continuation: Whether a row says "keep doing this".
        examples: What each row was made from.
    """

    labels: tuple[str, ...]
    columns: tuple[Column, ...]
    x: Floats
    y: Integers
    weight: Floats
    continuation: Flags
    examples: tuple[Example, ...]

    def __len__(self) -> int:
        return len(self.examples)

    @property
    def one_class(self) -> bool:
        """Whether all rows have the same label."""
        return bool(np.all(self.y == self.y[:1]))

    def counts(self) -> tuple[float, ...]:
        """Sums of weights, by label."""
        return tuple(np.bincount(self.y, self.weight, len(self.labels)).tolist())

    def rows(self, chosen: Integers) -> "Dataset":
        """The same labels and columns, with only these rows."""
        return Dataset(
            self.labels,
            self.columns,
            self.x[chosen],
            self.y[chosen],
            self.weight[chosen],
            self.continuation[chosen],
            tuple(self.examples[row] for row in chosen.tolist()),
        )


@dataclass(frozen=True, slots=True)
class LeftOut:
    """An enabled example that is not learned from, and why."""

    example: str
    reason: str


@dataclass(frozen=True, slots=True)
class Sifted:
    """The examples that are learned from, and the enabled ones that are not."""

    kept: tuple[Example, ...]
    left_out: tuple[LeftOut, ...]


def sift(automaton: Automaton, examples: Sequence[Example]) -> Sifted:
    """Tell the examples that can be learned from from those that cannot; disabled ones are in neither list.

    Left out are examples that mention a state which is gone, and those without a value for a feature in use.
    """
    states = {state.id for state in automaton.states}
    features = dict.fromkeys(use.id for use in automaton.features)
    kept: list[Example] = []
    left_out: list[LeftOut] = []
    for example in examples:
        if not example.enabled:
            continue
        if example.source in states and example.label in states and features.keys() <= example.values.keys():
            kept.append(example)
        else:
            left_out.append(LeftOut(example.id, _missing(example, states, features)))
    return Sifted(tuple(kept), tuple(left_out))


def _missing(example: Example, states: Collection[str], features: Iterable[str]) -> str:
    for state in (example.source, example.label):
        if state not in states:
            return f"the state {state!r} is gone"
    feature = next(feature for feature in features if feature not in example.values)
    return f"it has no value for the feature {feature!r}"


def columns_of(features: Sequence[FeatureUse], scenario: Vocabulary) -> tuple[Column, ...]:
    """One column a feature, in order.

    Raises:
        ScenarioError: The scenario lacks one of the features.
    """
    declared = ((use.id, declaration(use.source, scenario)) for use in features)
    return tuple(
        Column(feature, found.kind, found.period if found.kind is FeatureKind.TOROIDAL else 0.0)
        for feature, found in declared
    )


def datasets(automaton: Automaton, kept: Sequence[Example], columns: Sequence[Column]) -> dict[str, Dataset]:
    """A dataset for each state that has examples, in the order of the states.

    Args:
        kept: Examples that `sift` kept and `refuse_unlearnable` did not refuse.
    """
    by_source: dict[str, list[Example]] = {}
    for example in kept:
        by_source.setdefault(example.source, []).append(example)
    order = [state.id for state in automaton.states]
    return {source: dataset(by_source[source], order, columns) for source in order if source in by_source}


def dataset(examples: Sequence[Example], states: Sequence[str], columns: Sequence[Column]) -> Dataset:
    """The examples of one state as arrays, sorted by their contents.

    Args:
        states: All states of the automaton, in whose order the labels come.
    """
    seen = {example.label for example in examples}
    labels = tuple(state for state in states if state in seen)
    place = {label: number for number, label in enumerate(labels)}
    unsorted = Dataset(
        labels,
        tuple(columns),
        matrix(examples, [column.feature for column in columns]),
        np.array([place[example.label] for example in examples], np.int64),
        np.array([example.weight for example in examples], np.float64),
        np.array([example.continuation for example in examples], np.bool_),
        tuple(examples),
    )
    return unsorted.rows(_by_contents(unsorted))


def matrix(examples: Sequence[Example], features: Sequence[str]) -> Floats:
    """The values of these features, examples by features."""
    rows = map(reader(features), map(attrgetter("values"), examples))
    shape = len(examples), len(features)
    return np.fromiter(chain.from_iterable(rows), np.float64, shape[0] * shape[1]).reshape(shape)


def reader(features: Sequence[str]) -> Callable[[Mapping[str, float]], tuple[float, ...]]:
    """Reads the values of these features, in order; of several at once, as thousands of examples are read after every edit."""
    if len(features) > 1:
        return itemgetter(*features)
    return lambda values: tuple(values[feature] for feature in features)


def _by_contents(data: Dataset) -> Integers:
    """The order by values, the first column first, then label, continuation and weight."""
    keys = (data.weight, data.continuation, data.y, *reversed(data.x.T))
    return np.lexsort(keys).astype(np.int64)


# ---------------------------------------------------------------------------------------------- refusing


def refuse_unlearnable(automaton: Automaton, kept: Sequence[Example], vocabulary: Vocabulary) -> None:
    """Raise an `ExampleError` for the first example that no model may be learned from.

    Those are examples with a value or weight that is not a finite number, from a state that raises a flag (it is left
    within its tick), or to Start (only a raised flag leads there).
    """
    raising = {state.id for state in automaton.states if _raises(state, vocabulary)}
    features = [use.id for use in automaton.features]
    read = reader(features)
    for example in kept:
        suspect = (
            example.source in raising
            or example.label == START
            or not isfinite(sum(read(example.values)) + example.weight)
            or example.weight <= 0.0
        )
        if suspect and (problem := _problem(example, raising, features)):
            where = f"behavior {automaton.name!r}, state {example.source!r}, example {example.id!r}"
            raise ExampleError(f"{where}: {problem}")


def _raises(state: State, vocabulary: Vocabulary) -> bool:
    content = state.content
    if isinstance(content, Basic) and content.behavior in vocabulary.behaviors:
        return vocabulary.behaviors[content.behavior].raises is not None
    return isinstance(content, RaiseFlag)


def _problem(example: Example, raising: set[str], features: Sequence[str]) -> str:
    if example.source in raising:
        return (
            "this state raises a flag and is left at once, so nothing is learned from it; disable the example"
        )
    if example.label == START:
        return "it leads to Start, where only a raised flag leads; disable the example"
    for feature in features:
        if not isfinite(value := example.values[feature]):
            return f"the value of the feature {feature!r} is {value}; it must be a finite number"
    if not (isfinite(example.weight) and example.weight > 0.0):
        return f"its weight is {example.weight}; it must be a finite number above 0"
    return ""


def conflicts(data: Dataset) -> tuple[tuple[str, ...], ...]:
    """Groups of example ids with equal values in every column but different labels."""
    return tuple(
        tuple(example.id for example in data.examples[start:end]) for start, end in _torn_runs(data.x, data.y)
    )


def contradictory(x: Floats, y: Integers) -> Integers:
    """The rows that have the same values in every column as another one, but not the same label."""
    order = np.lexsort((y, *reversed(x.T)))
    runs = [order[start:end] for start, end in _torn_runs(x[order], y[order])]
    return np.concatenate(runs) if runs else np.empty(0, np.int64)


def _torn_runs(x: Floats, y: Integers) -> Iterator[tuple[int, int]]:
    """Where runs of equal rows of several labels begin and end, in rows that are sorted."""
    if not len(x):
        return
    starts = np.concatenate(([0], np.flatnonzero(np.any(x[1:] != x[:-1], axis=1)) + 1))
    torn = np.minimum.reduceat(y, starts) < np.maximum.reduceat(y, starts)
    ends = np.append(starts[1:], len(x))
    yield from zip(starts[torn].tolist(), ends[torn].tolist(), strict=True)


def values_of(columns: Sequence[Column], row: Sequence[float]) -> Mapping[str, float]:
    """A row of a dataset as feature id -> value."""
    return {column.feature: float(value) for column, value in zip(columns, row, strict=True)}
