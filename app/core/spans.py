"""What a conjunction of tests leaves each feature: "between 5 and 12" rather than "at most 12, and not at most 5"."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import inf

from .conditions import AtMost, Condition, Equals, Guard, InArc


@dataclass(frozen=True, slots=True)
class Between:
    """Values above *low*, up to and including *high*."""

    low: float = -inf
    high: float = inf


@dataclass(frozen=True, slots=True)
class Arc:
    """Values from *start* upward to, not including, *end*, on a circle; none where they are equal."""

    start: float
    end: float


@dataclass(frozen=True, slots=True)
class Is:
    """Just this value."""

    value: float


@dataclass(frozen=True, slots=True)
class IsNot:
    """Any values but these, of which there is one at least."""

    values: tuple[float, ...]


Span = Between | Arc | Is | IsNot


def spans(guard: Guard, period: Callable[[str], float]) -> Iterator[tuple[str, Span]]:
    """Each tested feature with what the conditions on it leave, in the order in which they are tested first.

    A feature comes up more than once where one span cannot say it all: for two arcs, or tests that no value passes.

    Args:
        period: The period of a toroidal feature, by id.
    """
    by_feature: dict[str, list[Condition]] = {}
    for condition in guard:
        by_feature.setdefault(condition.test.feature, []).append(condition)
    for feature, conditions in by_feature.items():
        yield from ((feature, span) for span in _merged(conditions, period(feature)))


def _merged(conditions: Sequence[Condition], period: float) -> list[Span]:
    cuts = [condition for condition in conditions if isinstance(condition.test, AtMost)]
    arcs = [condition for condition in conditions if isinstance(condition.test, InArc)]
    values = [condition for condition in conditions if isinstance(condition.test, Equals)]
    return [*_between(cuts), *_arc(arcs, period), *_values(values)]


def _between(cuts: Sequence[Condition]) -> list[Span]:
    if not cuts:
        return []
    low = max((_threshold(cut) for cut in cuts if not cut.wanted), default=-inf)
    high = min((_threshold(cut) for cut in cuts if cut.wanted), default=inf)
    return [Between(low, high)] if low < high else [Between(low=low), Between(high=high)]


def _threshold(condition: Condition) -> float:
    assert isinstance(condition.test, AtMost)
    return condition.test.threshold


def _values(equals: Sequence[Condition]) -> list[Span]:
    tested = [(c.test.value, c.wanted) for c in equals if isinstance(c.test, Equals)]
    wanted = list(dict.fromkeys(value for value, is_wanted in tested if is_wanted))
    refused = tuple(dict.fromkeys(value for value, is_wanted in tested if not is_wanted))
    if wanted and not set(wanted) & set(refused):
        refused = ()
    return [*map(Is, wanted), *([IsNot(refused)] if refused else [])]


def _arc(arcs: Sequence[Condition], period: float) -> list[Span]:
    """One arc where they overlap in one; otherwise each for itself."""
    each = [_as_arc(condition) for condition in arcs if condition.wanted or not _is_empty(condition)]
    if not each or any(arc.start == arc.end for arc in each):
        return list(each)
    overlap = _pieces(each[0], period)
    for other in each[1:]:
        cut = [(max(a, c), min(b, d)) for a, b in overlap for c, d in _pieces(other, period)]
        overlap = [(a, b) for a, b in cut if a < b]
    whole = _joined(sorted(overlap), period)
    return [whole] if whole else list(each)


def _is_empty(condition: Condition) -> bool:
    return isinstance(condition.test, InArc) and condition.test.start == condition.test.end


def _as_arc(condition: Condition) -> Arc:
    """The arc of the test, or the rest of the circle."""
    test = condition.test
    assert isinstance(test, InArc)
    return Arc(test.start, test.end) if condition.wanted else Arc(test.end, test.start)


def _pieces(arc: Arc, period: float) -> list[tuple[float, float]]:
    """An arc as stretches that do not run through the seam."""
    if arc.start < arc.end:
        return [(arc.start, arc.end)]
    return [(a, b) for a, b in ((-period / 2, arc.end), (arc.start, period / 2)) if a < b]


def _joined(pieces: Sequence[tuple[float, float]], period: float) -> Arc | None:
    """The one arc that the stretches make up, if they do."""
    if len(pieces) == 1:
        (start, end) = pieces[0]
        return Arc(start, -period / 2 if end >= period / 2 else end)
    if len(pieces) == 2 and pieces[0][0] <= -period / 2 and pieces[1][1] >= period / 2:
        return Arc(pieces[1][0], pieces[0][1])
    return None
