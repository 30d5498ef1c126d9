"""The best arc of a toroidal column: two cuts of the circle, the best pair of all.

Between b cuts there are b (b - 1) / 2 pairs. Nodes with few cuts are searched in bulk, all pairs of all nodes with about
as many cuts at once. In nodes with many, runs of neighboring cuts are compared first: a bound on what any pair
from two runs can gain rules most of them out, and the rest is searched pair by pair. Both are exact. Beyond `MOST_CUTS`
cuts, only that many at equal quantiles of the examples are tried.

The bound: in a node of weight n with class shares t, an arc of weight m has class weights that deviate by d from m t. Its
gain is (m D(inside) + (n - m) D(outside)) / n, where D is the relative entropy of the labels on one side to t. With
x = sqrt(sum(d^2 / t)), which is the same on both sides, m D is at most m log(1 + x^2 / m^2) by Jensen's inequality; and at
most (1 + e/3 + 2 e^2/3) x^2 / (2 m) by Taylor's theorem, where e is the largest share by which a class falls short of
what is expected. Seen as points ``d / sqrt(t)``, cuts have x as their distance, so two runs of cuts, each within a ball
around its middle, bound it by the triangle inequality.
"""

from collections.abc import Iterator
from functools import lru_cache

import numpy as np

from .blocks import Blocks, sizes_of_runs, starts_of_runs
from .dataset import Floats, Integers
from .impurity import NOT_ALLOWED, TOLERANCE, Whole, best_in_each, gain_and_information

#: Beyond this many cuts in a node, only those at quantiles are tried.
MOST_CUTS = 2000
#: Nodes with more cuts than this are searched with bounds.
FEW_CUTS = 128
#: The widths of tables of cuts.
WIDTHS = np.array([2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, FEW_CUTS])
#: Cuts in a run, at first and each time that runs are divided.
RUNS = (64, 16, 4)
#: Pairs that are looked at together; more would fall out of the processor's cache.
AT_ONCE = 1 << 13

#: For some nodes: their numbers, gains, split informations, and the blocks above the lower and the upper cut.
Arcs = tuple[Integers, Floats, Floats, Integers, Integers]
#: Lower and upper cuts, gains and split informations.
Pairs = tuple[Integers, Integers, Floats, Floats]

_NOTHING = 1e-9


def best_arcs(found: Blocks, nodes: Whole, least: float) -> Arcs:
    """The best arc of each node that has two cuts or more, in no particular order of nodes."""
    cuts = np.flatnonzero(found.boundary)
    starts = starts_of_runs(found.node[cuts])
    sizes = sizes_of_runs(starts, len(cuts))
    parts = [_empty()]
    for table in _tables(cuts, starts, sizes):
        parts += (_all_pairs(rows, found, nodes, least) for rows in _portions(table))
    for number in np.flatnonzero(sizes > FEW_CUTS).tolist():
        mine = thinned(cuts[starts[number] : starts[number] + sizes[number]], found)
        parts.append(_bounded(mine, found, nodes, least))
    return tuple(np.concatenate(column) for column in zip(*parts, strict=True))  # type: ignore[return-value] # as many arrays as `Arcs` has


def _empty() -> Arcs:
    numbers, floats = np.empty(0, np.int64), np.empty(0)
    return numbers, floats, floats, numbers, numbers


@lru_cache(maxsize=FEW_CUTS + 1)
def _pairs(count: int) -> tuple[Integers, Integers]:
    """All pairs of numbers below *count*, the smaller first."""
    low, high = np.triu_indices(count, 1)
    return low.astype(np.int64), high.astype(np.int64)


# ------------------------------------------------------------------------------------ few cuts: every pair


def _tables(cuts: Integers, starts: Integers, sizes: Integers) -> Iterator[Integers]:
    """The cuts of nodes with few of them, one node a row, nodes with about as many cuts in one table.

    Rows are filled up with their last cut: the empty arc that it makes with itself gains nothing and is never taken.
    """
    few = np.flatnonzero(sizes <= FEW_CUTS)
    width = WIDTHS[np.searchsorted(WIDTHS, sizes[few])]
    for size in np.unique(width).tolist():
        rows = few[width == size]
        yield cuts[starts[rows][:, None] + np.minimum(np.arange(size), sizes[rows][:, None] - 1)]


def _portions(table: Integers) -> Iterator[Integers]:
    """The rows of *table*, as many at a time as have `AT_ONCE` pairs."""
    count, size = table.shape
    step = max(1, 2 * AT_ONCE // (size * size))
    return (table[row : row + step] for row in range(0, count, step))


def _all_pairs(table: Integers, found: Blocks, nodes: Whole, least: float) -> Arcs:
    """The best arcs of nodes whose cuts are the rows of *table*."""
    count, size = table.shape
    low, high = _pairs(size)
    below = found.below.take(table, axis=1)
    node = found.node[table[:, 0]]
    inside = below.take(high, axis=2) - below.take(low, axis=2)
    gain, information = gain_and_information(inside, nodes.of(node[:, None]), least)
    gain, information = gain.ravel(), information.ravel()
    best = best_in_each(gain, information, np.arange(count) * len(low))
    pair = best % len(low)
    rows = np.arange(count)
    return node, gain[best], information[best], table[rows, low[pair]], table[rows, high[pair]]


# ------------------------------------------------------------------------------------ many cuts: with bounds


def thinned(cuts: Integers, found: Blocks) -> Integers:
    """At most `MOST_CUTS` of the *cuts* of a node, at equal quantiles of its examples."""
    if len(cuts) <= MOST_CUTS:
        return cuts
    weight = found.below[:, cuts].sum(axis=0)
    wanted = np.linspace(weight[0], weight[-1], MOST_CUTS)
    return np.asarray(cuts[np.unique(np.searchsorted(weight, wanted).clip(max=len(cuts) - 1))], np.int64)


def _bounded(cuts: Integers, found: Blocks, nodes: Whole, least: float) -> Arcs:
    """The best arc of one node."""
    node = found.node[cuts[:1]]
    search = _Search(found.below.take(cuts, axis=1), nodes.of(node), least)
    low, high, gain, information = search.near_best()
    order = np.lexsort((high, low))
    best = order[best_in_each(gain[order], information[order], np.zeros(1, np.int64))]
    return node, gain[best], information[best], cuts[low[best]], cuts[high[best]]


class _Search:
    """The search for the best arc of one node, by runs of neighboring cuts that are divided as long as needed.

    Attributes:
        below: Class weights below each cut, (classes, cuts).
        whole: The node.
        highest: The highest gain seen.
    """

    def __init__(self, below: Floats, whole: Whole, least: float) -> None:
        self.below = below
        self.whole = whole
        self.highest = NOT_ALLOWED
        self._least = least
        self._near: list[Pairs] = []
        present = whole.weights[:, 0] > 0.0
        shares = whole.weights[present] / whole.sum
        self._rarest = float(shares.min())
        self._weight = below.sum(axis=0)
        self._points = (below[present] - shares * self._weight) / np.sqrt(shares)

    def near_best(self) -> Pairs:
        """Pairs of cuts with their gains and split informations; all of the best ones are among them."""
        count = self.below.shape[1]
        first, second = np.triu_indices(-(-count // RUNS[0]))
        for length, finer in zip(RUNS, (*RUNS[1:], 1), strict=True):
            runs = np.minimum(np.arange(0, count, length)[:, None] + np.arange(length), count - 1)
            self._evaluate(runs[first, length // 2], runs[second, length // 2])
            bound = self._bounds(runs, first, second)
            hopeful = np.flatnonzero(bound >= self.highest - TOLERANCE)
            first, second, bound = first[hopeful], second[hopeful], bound[hopeful]
            if finer > 1:
                first, second = _divided(first, second, length // finer, -(-count // finer))
        order = np.argsort(-bound, kind="stable")
        self._evaluate_within(runs, first[order], second[order], bound[order])
        low, high, gain, information = (np.concatenate(column) for column in zip(*self._near, strict=True))
        return low, high, gain, information

    def _evaluate_within(self, runs: Integers, first: Integers, second: Integers, bound: Floats) -> None:
        """Evaluate every pair of cuts from pairs of runs, which come by falling bound."""
        length = runs.shape[1]
        step = AT_ONCE // (length * length)
        for start in range(0, len(first), step):
            if bound[start] < self.highest - TOLERANCE:
                break
            some = slice(start, start + step)
            self._evaluate(
                np.repeat(runs[first[some]], length, axis=1).ravel(),
                np.tile(runs[second[some]], length).ravel(),
            )

    def _evaluate(self, low: Integers, high: Integers) -> None:
        """Note those pairs, of the ones in which *low* is lower, that are as good as any seen."""
        pairs = low < high
        low, high = low[pairs], high[pairs]
        inside = self.below.take(high, axis=1) - self.below.take(low, axis=1)
        gain, information = gain_and_information(inside, self.whole, self._least)
        self.highest = float(gain.max(initial=self.highest))
        near = gain >= self.highest - TOLERANCE
        self._near.append((low[near], high[near], gain[near], information[near]))

    def _bounds(self, runs: Integers, first: Integers, second: Integers) -> Floats:
        """The most that a pair of cuts, one from each run, can gain."""
        middles = self._points.take(runs[:, runs.shape[1] // 2], axis=1)
        radii = np.sqrt(((self._points[:, runs] - middles[:, :, None]) ** 2).sum(axis=0).max(axis=1))
        apart = np.sqrt(((middles.take(first, axis=1) - middles.take(second, axis=1)) ** 2).sum(axis=0))
        reach = apart + radii[first] + radii[second]
        total = float(self.whole.sum[0])
        inside = self._weight[runs[second, 0]] - self._weight[runs[first, -1]]
        outside = total - (self._weight[runs[second, -1]] - self._weight[runs[first, 0]])
        # Arcs within one run may weigh next to nothing: they are not bounded.
        inside = np.maximum(inside, _NOTHING)
        bound = (self._divergence(reach, inside) + self._divergence(reach, outside)) / (total * np.log(2.0))
        return np.where(inside > _NOTHING, bound, np.inf)

    def _divergence(self, reach: Floats, weight: Floats) -> Floats:
        """The most that m D can be, for a distance of at most *reach* and an m of at least *weight*."""
        shortfall = np.minimum(1.0, reach / (weight * np.sqrt(self._rarest)))
        by_taylor = (1.0 + shortfall / 3 + shortfall**2 * (2 / 3)) * reach**2 / (2 * weight)
        square = (reach / weight) ** 2
        # Falls with the weight, if that is not smaller still: then it has its summit in between.
        by_jensen = np.where(square < 3.92, weight * np.log1p(square), 0.805 * reach)
        return np.asarray(np.minimum(by_taylor, by_jensen), np.float64)


def _divided(first: Integers, second: Integers, parts: int, count: int) -> tuple[Integers, Integers]:
    """All pairs of the parts of two runs, without those beyond the *count* that there are."""
    first = (first[:, None, None] * parts + np.arange(parts)[:, None] + np.zeros(parts, np.int64)).ravel()
    second = (second[:, None, None] * parts + np.arange(parts) + np.zeros((parts, 1), np.int64)).ravel()
    there = (first <= second) & (second < count)
    return first[there], second[there]
