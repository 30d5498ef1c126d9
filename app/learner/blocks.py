"""Blocks: the parts of one column that no split parts further, in every node of a level of the tree at once.

A level's nodes are worked on together, because a call into numpy costs more than the arithmetic of a small node. Every
split that the learner tries is a sum over blocks: of those below a cut, of one, or of a run of them.
"""

from dataclasses import dataclass

import numpy as np

from .dataset import Flags, Floats, Integers


@dataclass(frozen=True, slots=True, eq=False)
class Level:
    """What all columns have in common in a level.

    Attributes:
        node: The nodes of the open examples, ascending: whatever the column they are sorted by, this is the same.
        node_begins: Where another node begins.
        y: As in the dataset.
        weight: As in the dataset; None where all weigh 1.
        classes: The number of labels.
    """

    node: Integers
    node_begins: Flags
    y: Integers
    weight: Floats | None
    classes: int


def level_of(node: Integers, y: Integers, weight: Floats, classes: int) -> Level:
    """The level whose open examples are in these nodes, given in ascending order."""
    return Level(node, _begins(node), y, weight if np.any(weight != 1.0) else None, classes)


@dataclass(frozen=True, slots=True, eq=False)
class Blocks:
    """Blocks in ascending order of (node, value).

    Attributes:
        rows: The examples, sorted by (node, value).
        start: Where each block begins in *rows*; one entry more than there are blocks, for where the last one ends.
        node: The node that a block belongs to.
        weight: Class weights, (classes, blocks).
        below: Class weights of the lower blocks of the same node, (classes, blocks).
        lowest: Whether it is the lowest of its node.
        boundary: Whether the gap below it (below the lowest: around the circle to the highest) parts different labels.
    """

    rows: Integers
    start: Integers
    node: Integers
    weight: Floats
    below: Floats
    lowest: Flags
    boundary: Flags

    def of_node(self, block: int) -> slice:
        """The blocks of the node that *block* belongs to."""
        first, end = np.searchsorted(self.node, [self.node[block], self.node[block] + 1]).tolist()
        return slice(first, end)


def blocks(level: Level, rows: Integers, rank: Integers, *, merged: bool) -> Blocks:
    """The blocks of a column.

    Args:
        rows: The open examples, sorted by (node, value).
        rank: For each example, the rank of its value in the column; equal values have equal ranks.
        merged: Whether neighboring values share a block where all their examples have the same label. A cut of the
            highest gain never parts such values (Fayyad and Irani 1992), and neither does a cut of the best arc.
            Otherwise each value is a block.
    """
    y = level.y.take(rows)
    start = np.append(np.flatnonzero(_begins(rank.take(rows)) | level.node_begins), len(rows))
    lowest = level.node_begins[start[:-1]]
    boundary = _boundaries(y, start, lowest)
    if merged:
        kept = boundary | lowest
        start, lowest, boundary = np.append(start[:-1][kept], len(rows)), lowest[kept], boundary[kept]
    weight = _class_weights(
        start, y, None if level.weight is None else level.weight.take(rows), level.classes
    )
    return Blocks(rows, start, level.node[start[:-1]], weight, _below(weight, lowest), lowest, boundary)


def starts_of_runs(numbers: Integers) -> Integers:
    """Where each run of equal *numbers* begins."""
    return np.flatnonzero(_begins(numbers))


def sizes_of_runs(starts: Integers, count: int) -> Integers:
    """The lengths of runs that begin at *starts*, the last one of which ends at *count*."""
    return np.concatenate((starts[1:], [count])) - starts


def _begins(numbers: Integers) -> Flags:
    begins = np.ones(len(numbers), np.bool_)
    np.not_equal(numbers[1:], numbers[:-1], out=begins[1:])
    return begins


def _boundaries(y: Integers, start: Integers, lowest: Flags) -> Flags:
    """Gaps between two values, unless all examples of both have the same label; a single value has no gap."""
    firsts = np.flatnonzero(lowest)
    previous = np.arange(-1, len(lowest) - 1)
    previous[firsts] = np.append(firsts[1:], len(lowest)) - 1
    changes = np.cumsum(np.concatenate(([False], y[1:] != y[:-1])), dtype=np.int32)
    mixed = changes[start[:-1]] != changes[start[1:] - 1]
    label = y[start[:-1]]
    parts = mixed | mixed[previous] | (label != label[previous])
    return np.asarray(parts & (previous != np.arange(len(previous))), np.bool_)


def _class_weights(start: Integers, y: Integers, weight: Floats | None, classes: int) -> Floats:
    count = len(start) - 1
    block = np.repeat(np.arange(count), start[1:] - start[:-1])
    sums = np.bincount(y * count + block, weight, classes * count)
    return np.asarray(sums.reshape(classes, count), np.float64)


def _below(weight: Floats, lowest: Flags) -> Floats:
    """Running sums that begin anew at every node."""
    before = np.cumsum(weight, axis=1) - weight
    firsts = np.flatnonzero(lowest)
    return before - np.repeat(before[:, firsts], sizes_of_runs(firsts, len(lowest)), axis=1)
