"""The best split of every node by one column, for each kind of feature, and where its cuts are placed.

*Continuous*: one cut; the test is `AtMost`. *Toroidal*: two cuts; the test is `InArc` (see `arcs`). *Boolean* and
*categorical*: one value against all others; the test is `Equals`. Splitting off one value at a time, instead of growing
a branch for every value as C4.5 does, keeps trees binary, so that one walk serves all features, and does not scatter the
few examples that a demonstration gives over as many branches as there are categories; a category that was never seen
goes with "none of these". Nothing is lost: further down the other values can be split off.
"""

from dataclasses import dataclass
from math import inf, nextafter

import numpy as np

from ..core.conditions import AtMost, Equals, InArc, Test
from ..core.vocabulary import FeatureKind
from .arcs import best_arcs
from .blocks import Blocks, sizes_of_runs, starts_of_runs
from .dataset import Column, Flags, Floats, Integers
from .impurity import NOT_ALLOWED, Whole, best_in_each, gain_and_information

#: Kinds whose values are parted by cuts.
ORDERED = (FeatureKind.CONTINUOUS, FeatureKind.TOROIDAL)


@dataclass(frozen=True, slots=True, eq=False)
class Best:
    """The best split of each node by one column.

    Attributes:
        gain, information: Bits; a node that the column cannot split gains `NOT_ALLOWED`.
        low: The block just above the (lower) cut, or the one with the value that is split off.
        high: For an arc, the block just above its upper cut.
    """

    gain: Floats
    information: Floats
    low: Integers
    high: Integers


def best_splits(column: Column, found: Blocks, nodes: Whole, least: float) -> Best:
    """The best split of each node by *column*.

    Args:
        least: The least weight of examples on either side.
    """
    if column.kind is FeatureKind.TOROIDAL:
        groups, gain, information, low, high = best_arcs(found, nodes, least)
        return _scattered(nodes, groups, gain, information, low, high)
    if column.kind is FeatureKind.CONTINUOUS:
        candidates = np.flatnonzero(found.boundary & ~found.lowest)
        return _best(candidates, found.below.take(candidates, axis=1), found, nodes, least)
    candidates = _values_to_split_off(found)
    return _best(candidates, found.weight.take(candidates, axis=1), found, nodes, least)


def _values_to_split_off(found: Blocks) -> Integers:
    """Every value of a node; of two only the higher ("true"), since splitting the other off is the same split."""
    firsts = np.flatnonzero(found.lowest)
    sizes = sizes_of_runs(firsts, len(found.lowest))
    several = np.repeat(sizes, sizes)
    return np.flatnonzero((several > 2) | ((several == 2) & ~found.lowest))


def _best(candidates: Integers, inside: Floats, found: Blocks, nodes: Whole, least: float) -> Best:
    node = found.node[candidates]
    starts = starts_of_runs(node)
    if not len(starts):
        return _scattered(nodes, starts, np.empty(0), np.empty(0), starts, starts)
    gain, information = gain_and_information(inside, nodes.of(node), least)
    best = best_in_each(gain, information, starts)
    block = candidates[best]
    return _scattered(nodes, node[starts], gain[best], information[best], block, block)


def _scattered(
    nodes: Whole, groups: Integers, gain: Floats, information: Floats, low: Integers, high: Integers
) -> Best:
    """Results of some nodes as arrays with an entry for all."""
    count = len(nodes.sum)
    best = Best(
        np.full(count, NOT_ALLOWED), np.zeros(count), np.zeros(count, np.int64), np.zeros(count, np.int64)
    )
    best.gain[groups], best.information[groups] = gain, information
    best.low[groups], best.high[groups] = low, high
    return best


def inside(column: Column, found: Blocks, low: int, high: int) -> Integers:
    """The examples of a node that pass the test of the split (*low*, *high*)."""
    match column.kind:
        case FeatureKind.CONTINUOUS:
            begin, end = found.of_node(low).start, low
        case FeatureKind.TOROIDAL:
            begin, end = low, high
        case _:
            begin, end = low, low + 1
    return found.rows[found.start[begin] : found.start[end]]


# ---------------------------------------------------------------------------------------------- placing cuts


@dataclass(frozen=True, slots=True)
class Side:
    """The examples with one value, next to a cut: the value, and whether all of them are continuations."""

    value: float
    continuing: bool


def test_for(column: Column, values: Floats, continuation: Flags, found: Blocks, low: int, high: int) -> Test:
    """The test that parts the blocks of a node as the split (*low*, *high*) does.

    Args:
        values: The column, by example.
        continuation: Whether each example is one.
    """
    blocks_of_node = found.of_node(low)
    begin, end = found.start[blocks_of_node.start], found.start[blocks_of_node.stop]
    rows = found.rows[begin:end]
    mine = values[rows]

    def side(place: int) -> Side:
        equal = rows[mine == mine[place]]
        return Side(float(mine[place]), bool(continuation[equal].all()))

    def gap(block: int) -> tuple[Side, Side]:
        place = int(found.start[block] - begin)
        return side(place - 1), side(place)

    match column.kind:
        case FeatureKind.CONTINUOUS:
            return AtMost(column.feature, threshold(*gap(low)))
        case FeatureKind.TOROIDAL:
            start = seam_cut(*gap(low), column.period) if found.lowest[low] else cut(*gap(low))
            return InArc(column.feature, start, cut(*gap(high)))
        case _:
            return Equals(column.feature, float(mine[found.start[low] - begin]))


def threshold(low: Side, high: Side) -> float:
    """Where `AtMost` cuts between two neighboring values: at least the lower one and less than the higher one.

    Midway; but if exactly one side says "continue" only, the cut sits right beside the other, the transition: as the
    demonstrator went on over a wide range and switched at its edge, everything up to that edge still continues.
    """
    if low.continuing and not high.continuing:
        return nextafter(high.value, -inf)
    if high.continuing and not low.continuing:
        return low.value
    return max(low.value, min(midway(low.value, high.value), nextafter(high.value, -inf)))


def cut(low: Side, high: Side) -> float:
    """Where an arc begins or ends between two neighboring values: above the lower one and at most the higher one.

    An arc holds its start and not its end, so such a cut lets either side be inside. It is placed as by `threshold`.
    """
    return nextafter(threshold(low, high), inf)


def seam_cut(last: Side, first: Side, period: float) -> float:
    """Where an arc begins in the gap that holds the seam, from the highest value around to the lowest one.

    The cut is midway on the circle, or beside a transition as in `threshold`, and given as an angle of its own: either
    above the highest value, or at most the lowest one.
    """
    half = period / 2
    if first.continuing and not last.continuing:
        beside = nextafter(last.value, inf)
        return beside if beside < half else min(-half, first.value)
    if last.continuing and not first.continuing:
        return first.value
    middle = midway(last.value, first.value + period)
    if last.value < middle < half:
        return middle
    return min(max(middle - period, -half), first.value)


def midway(low: float, high: float) -> float:
    """The middle of two numbers, however large."""
    return low / 2 + high / 2
