"""Timings that other programs on the machine disturb as little as can be."""

from collections.abc import Callable, Sequence
from statistics import median

from .subject import Clock

#: Work to be timed.
Work = Callable[[], object]
#: Makes ready for work, untimed; every time anew, so that each time the same is done.
Prepare = Callable[[], Work]


def least(prepare: Prepare, rounds: int, clock: Clock, pieces: int = 1) -> float:
    """The shortest of several times of the same work, in seconds; see `taking_turns`."""
    return taking_turns((prepare,), rounds, clock, pieces)[0]


def taking_turns(rivals: Sequence[Prepare], rounds: int, clock: Clock, pieces: int = 1) -> Sequence[float]:
    """The shortest times of several works that are done in turn, A B A B, so that all meet the same disturbance.

    Args:
        pieces: How often a work, once ready, is done on end. The shortest time of each piece counts: short ones are left
            alone by other programs now and then, all of a long work hardly ever.
    """
    shortest = [[float("inf")] * pieces for _ in rivals]
    for _ in range(rounds):
        for times, prepare in zip(shortest, rivals, strict=True):
            work = prepare()
            for piece in range(pieces):
                began = clock()
                work()
                times[piece] = min(times[piece], clock() - began)
    return [sum(times) for times in shortest]


def ratio(
    first: Sequence[Prepare], second: Sequence[Prepare], rounds: int, clock: Clock, pieces: int = 1
) -> float:
    """How many times as long all works of *first* take as those of *second*, pair by pair."""
    times = [taking_turns(pair, rounds, clock, pieces) for pair in zip(first, second, strict=True)]
    return sum(one for one, _ in times) / sum(other for _, other in times)


def side_by_side(first: Work, second: Work, pairs: int, clock: Clock) -> float:
    """How many times as long *first* takes as *second*, in the median of pairs; who begins takes turns, too.

    For what takes long to make ready: both go on from where they are, through the same work.
    """
    return median(_pair(first, second, clock, swapped=number % 2 == 1) for number in range(pairs))


def _pair(first: Work, second: Work, clock: Clock, *, swapped: bool) -> float:
    order = (second, first) if swapped else (first, second)
    began = clock()
    order[0]()
    between = clock()
    order[1]()
    times = (between - began, clock() - between)
    return times[1] / times[0] if swapped else times[0] / times[1]
