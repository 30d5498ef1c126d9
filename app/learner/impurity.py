"""Entropy, information gain and split information (Quinlan 1993), for many candidate splits at once.

Class weights stand in arrays of shape (classes, candidates): sums over classes are then sums of long rows.
"""

from dataclasses import dataclass

import numpy as np

from .dataset import Floats, Integers

#: Gains and ratios (bits) that differ by less are equal: their order would be decided by rounding alone.
TOLERANCE = 1e-9
#: The gain of a candidate that is not allowed.
NOT_ALLOWED = -np.inf

_TINY = np.finfo(np.float64).tiny


def xlog2(x: Floats) -> Floats:
    """x log2 x, and 0 at 0; rounding that left x just below 0 counts as 0."""
    found = np.maximum(x, _TINY)
    np.log2(found, out=found)
    found *= x
    return found


def disorder(weights: Floats) -> Floats:
    """Entropy (bits) of the class weights along the first axis, times their sum."""
    return np.asarray(xlog2(weights.sum(axis=0)) - xlog2(weights).sum(axis=0), np.float64)


@dataclass(frozen=True, slots=True, eq=False)
class Whole:
    """What is split: class weights of nodes, (classes, nodes), and what follows from them."""

    weights: Floats
    sum: Floats
    disorder: Floats

    def of(self, chosen: Integers) -> "Whole":
        """Nodes by number, in the shape of *chosen*; one node can come up many times."""
        return Whole(self.weights.take(chosen, axis=1), self.sum[chosen], self.disorder[chosen])


def whole(weights: Floats) -> Whole:
    """Nodes with these class weights."""
    return Whole(weights, weights.sum(axis=0), disorder(weights))


def gain_and_information(inside: Floats, nodes: Whole, least: float) -> tuple[Floats, Floats]:
    """Information gain and split information (bits) of splits into *inside* and the rest of a node.

    Args:
        inside: Class weights on one side, (classes, candidates...).
        nodes: The node that each candidate splits; its shapes broadcast against *inside*.
        least: A side with less weight than this is not allowed; such candidates gain `NOT_ALLOWED`.
    """
    outside = nodes.weights - inside
    within, without = inside.sum(axis=0), outside.sum(axis=0)
    of_sums = xlog2(within) + xlog2(without)
    after = of_sums - xlog2(inside).sum(axis=0) - xlog2(outside).sum(axis=0)
    gain = (nodes.disorder - after) / nodes.sum
    information = (xlog2(nodes.sum) - of_sums) / nodes.sum
    allowed = (within >= least) & (without >= least)
    return np.where(allowed, gain, NOT_ALLOWED), information


def best_in_each(gain: Floats, information: Floats, starts: Integers) -> Integers:
    """The best candidate of each group: the highest gain, of equals the most even split, of equals the first.

    "Most even" is the largest split information. It decides where nothing gains (exclusive or), and halves such a node
    instead of peeling single examples off.

    Args:
        starts: Where each group begins; no group is empty.
    """
    sizes = np.concatenate((starts[1:], [len(gain)])) - starts
    highest = np.repeat(np.maximum.reduceat(gain, starts), sizes)
    even = np.where(gain >= highest - TOLERANCE, information, -1.0)
    most_even = np.repeat(np.maximum.reduceat(even, starts), sizes)
    best = np.flatnonzero(even >= most_even - TOLERANCE)
    return best[np.searchsorted(best, starts)]
