"""Bringing rows in another order by as few moves as can be: what is listed is told of every one, and each takes time."""

from bisect import bisect_left
from collections.abc import Iterator, Sequence


def moves(places: Sequence[int]) -> Iterator[tuple[int, int]]:
    """The fewest moves that sort *places*, all of which differ: pairs of where a row is taken from, and where it is then."""
    rows, staying = list(places), _longest_rising(places)
    for place in [place for place in places if place not in staying]:
        at = rows.index(place)
        del rows[at]
        to = next((k for k, other in enumerate(rows) if other in staying and other > place), len(rows))
        rows.insert(to, place)
        staying.add(place)
        if to != at:
            yield at, to


def _longest_rising(numbers: Sequence[int]) -> set[int]:
    """As many of the numbers as rise from each to the next."""
    ends: list[int] = []  # the smallest number that a run of each length can end with
    before: dict[int, int | None] = {}
    for number in numbers:
        length = bisect_left(ends, number)
        before[number] = ends[length - 1] if length else None
        ends[length : length + 1] = [number]
    found: set[int] = set()
    last = ends[-1] if ends else None
    while last is not None:
        found.add(last)
        last = before[last]
    return found
