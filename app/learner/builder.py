"""Decision trees in the style of C4.5 (Quinlan 1993), as the paper learns its transition functions.

A node that holds examples of several labels is split. Each feature offers its split of the highest information gain.
Among the offers that gain at least the average of all offers that gain anything, the one of the highest gain ratio
(gain over split information) is taken; of equals the one that gains more, then the feature that comes first. Within a
feature, equal gains are decided for the more even split, then for the lower cut. Numbers closer than `TOLERANCE` bits
are equal, so rounding decides nothing, and since a dataset is sorted by contents, the order of examples neither.

Differences from C4.5, all on purpose:
* Where no split gains anything (exclusive or), the most even one is taken instead of a leaf. So every set of examples
  without conflict is reproduced exactly, which is what a demonstrator expects; only examples with equal features and
  different labels share a leaf, which then holds the counts of both.
* Release 8's charge of log2(cuts)/n bits on continuous features is left out: with ten examples it would forbid nearly
  every threshold.
* Splits are binary (see `splits`), and toroidal features are split by arcs.
* Cuts beside continuations are not midway (see `splits.threshold`).
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np

from ..core.conditions import Test
from ..core.tree import Branch, Leaf, Tree, TreeNode
from .blocks import Blocks, blocks, level_of
from .dataset import Dataset, Floats, Integers
from .impurity import NOT_ALLOWED, TOLERANCE, whole
from .splits import ORDERED, Best, best_splits, inside, test_for

#: Asked now and then while something is learned; true stops it.
IsCancelled = Callable[[], bool]


class LearningCancelled(Exception):  # noqa: N818 - it is the answer to a request, not an error
    """Learning was asked to stop."""


@dataclass(frozen=True, slots=True)
class Growth:
    """How a tree grows.

    Attributes:
        min_leaf: The least weight of examples at a leaf; up to 1, one example is enough whatever its weight. Above 1,
            examples without conflict need not be reproduced.
        max_depth: The most tests on a way down; 0 for no limit.
        gain_ratio: Whether splits are chosen by gain ratio; otherwise by gain.
    """

    min_leaf: float = 1.0
    max_depth: int = 0
    gain_ratio: bool = True

    @property
    def least(self) -> float:
        """The least weight on either side of a split, with room for rounding."""
        return self.min_leaf - TOLERANCE if self.min_leaf > 1.0 else 0.0


def never() -> bool:
    """For `cancelled`: go on."""
    return False


def build(data: Dataset, growth: Growth = Growth(), cancelled: IsCancelled = never) -> Tree:
    """The decision tree of a dataset with at least one row.

    Raises:
        LearningCancelled: *cancelled* returned true; it is asked once a column of every level.
    """
    sketch = _Sketch()
    ranks = _ranks(data)
    frontier = _root(data, ranks, sketch)
    depth = 0
    while len(frontier.numbers) and not (growth.max_depth and depth == growth.max_depth):
        frontier = _grown(frontier, data, ranks, growth, sketch, cancelled)
        depth += 1
    return Tree(data.labels, sketch.assembled())


# ---------------------------------------------------------------------------------------------- one level


@dataclass(frozen=True, slots=True, eq=False)
class _Frontier:
    """The nodes of one level that hold several labels.

    Attributes:
        numbers: Of the nodes, in the sketch.
        node: For each row of the dataset, its node's place in *numbers*, or -1.
        sorted_rows: For each column, the rows that are in such nodes, sorted by (node, value).
    """

    numbers: Integers
    node: Integers
    sorted_rows: tuple[Integers, ...]


@dataclass(frozen=True, slots=True)
class _Split:
    """A node's test, and the rows that pass it."""

    node: int
    test: Test
    passing: Integers


@dataclass(slots=True)
class _Sketch:
    """A tree while it grows: parallel lists, a parent before its children."""

    counts: list[tuple[float, ...]] = field(default_factory=list)
    tests: dict[int, tuple[Test, int]] = field(default_factory=dict)

    def add(self, counts: Floats) -> int:
        """Add nodes with these class weights, (nodes, classes); return the first one's number."""
        first = len(self.counts)
        self.counts += map(tuple, counts.tolist())
        return first

    def assembled(self) -> TreeNode:
        """The root, with all below. Children have higher numbers, so they are there when their parent is made."""
        nodes: list[TreeNode] = [Leaf(counts) for counts in self.counts]
        for number in sorted(self.tests, reverse=True):
            test, yes = self.tests[number]
            nodes[number] = Branch(test, nodes[yes], nodes[yes + 1], self.counts[number])
        return nodes[0]


def _ranks(data: Dataset) -> tuple[Integers, ...]:
    """For each column, the ranks of its values: small integers are faster to compare and to fetch."""
    return tuple(np.unique(values, return_inverse=True)[1].astype(np.int32) for values in data.x.T)


def _root(data: Dataset, ranks: Sequence[Integers], sketch: _Sketch) -> _Frontier:
    sketch.add(np.array([data.counts()]))
    closed = data.one_class or not data.columns
    return _Frontier(
        np.zeros(0 if closed else 1, np.int64),
        np.zeros(len(data), np.int32),
        tuple(np.argsort(rank, kind="stable") for rank in ranks),
    )


def _grown(
    frontier: _Frontier,
    data: Dataset,
    ranks: Sequence[Integers],
    growth: Growth,
    sketch: _Sketch,
    cancelled: IsCancelled,
) -> _Frontier:
    """Split the nodes of the frontier; return the next one."""
    rows = frontier.sorted_rows[0]
    node = frontier.node[rows]
    totals = _counts(node, rows, data, len(frontier.numbers))
    level = level_of(node, data.y, data.weight, len(data.labels))
    nodes = whole(totals.T)
    found, offers = [], []
    for column, rows, rank in zip(data.columns, frontier.sorted_rows, ranks, strict=True):
        if cancelled():
            raise LearningCancelled
        found.append(blocks(level, rows, rank, merged=column.kind in ORDERED))
        offers.append(best_splits(column, found[-1], nodes, growth.least))
    splits = _splits(_chosen(offers, growth), data, found, offers)
    return _descended(frontier, data, splits, sketch)


def _chosen(offers: Sequence[Best], growth: Growth) -> Integers:
    """The column that splits each node, or -1."""
    gain = np.array([offer.gain for offer in offers])
    information = np.array([offer.information for offer in offers])
    gains = gain > TOLERANCE
    average = np.where(gains, gain, 0.0).sum(axis=0) / np.maximum(gains.sum(axis=0), 1)
    if growth.gain_ratio:
        worth = np.where(
            gains & (gain >= average - TOLERANCE), gain / np.maximum(information, TOLERANCE), NOT_ALLOWED
        )
    else:
        worth = np.where(gains, gain, NOT_ALLOWED)
    without_gain = np.where(gain > NOT_ALLOWED, information, NOT_ALLOWED)
    worth = np.where(gains.any(axis=0), worth, without_gain)
    best = worth >= worth.max(axis=0) - TOLERANCE
    gain_of_best = np.where(best, gain, NOT_ALLOWED)
    best &= gain >= gain_of_best.max(axis=0) - TOLERANCE
    return np.where((gain > NOT_ALLOWED).any(axis=0), best.argmax(axis=0), -1)


def _splits(chosen: Integers, data: Dataset, found: Sequence[Blocks], offers: Sequence[Best]) -> list[_Split]:
    """The splits of the nodes that are split, in order."""
    splits = []
    for node, place in enumerate(chosen.tolist()):
        if place >= 0:
            column, there, offer = data.columns[place], found[place], offers[place]
            low, high = int(offer.low[node]), int(offer.high[node])
            test = test_for(column, data.x[:, place], data.continuation, there, low, high)
            splits.append(_Split(node, test, inside(column, there, low, high)))
    return splits


# ---------------------------------------------------------------------------------------------- going down


def _descended(frontier: _Frontier, data: Dataset, splits: Sequence[_Split], sketch: _Sketch) -> _Frontier:
    """Enter the splits into the sketch and send the examples down; return the children that hold several labels."""
    child = _children(frontier, splits)
    rows = np.flatnonzero(child >= 0)
    counts = _counts(child[rows], rows, data, 2 * len(splits))
    first = sketch.add(counts)
    for number, split in enumerate(splits):
        sketch.tests[int(frontier.numbers[split.node])] = (split.test, first + 2 * number)
    open_children = np.flatnonzero(np.count_nonzero(counts, axis=1) > 1)
    place = np.full(len(counts) + 1, -1, np.int32)
    place[open_children] = np.arange(len(open_children))
    node = place[child]
    return _Frontier(
        first + open_children,
        node,
        tuple(_resorted(rows, node, len(open_children)) for rows in frontier.sorted_rows),
    )


def _children(frontier: _Frontier, splits: Sequence[_Split]) -> Integers:
    """For each row of the dataset, the number of the child it goes to (yes before no), or -1."""
    no = np.full(len(frontier.numbers) + 1, -1, np.int32)
    no[[split.node for split in splits]] = 2 * np.arange(len(splits)) + 1
    child = no[frontier.node]
    for split in splits:
        child[split.passing] -= 1
    return child


def _counts(group: Integers, rows: Integers, data: Dataset, groups: int) -> Floats:
    """Class weights, (groups, classes), of rows of which each is in a group."""
    classes = len(data.labels)
    sums = np.bincount(group * classes + data.y[rows], data.weight[rows], groups * classes)
    return np.asarray(sums.reshape(groups, classes), np.float64)


def _resorted(rows: Integers, node: Integers, nodes: int) -> Integers:
    """The rows of open nodes, sorted by (node, value), when *rows* is sorted by (parent, value)."""
    key = node.take(rows)
    there = key >= 0
    rows = rows[there]
    if nodes <= 1:
        return rows
    # Numpy sorts 16-bit integers by radix, in linear time.
    return rows[np.argsort(key[there].astype(np.uint16 if nodes < 1 << 16 else np.uint32), kind="stable")]
