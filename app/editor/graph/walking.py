"""Where the arrow keys lead from a state."""

from collections.abc import Iterable
from typing import TypeVar

from .arrangement import Point

Key = TypeVar("Key")
#: How much farther something aside counts than something ahead.
ASIDE = 2.0


def next_one(start: Point, others: Iterable[tuple[Key, Point]], way: Point) -> Key | None:
    """The nearest of *others* in the direction *way*, a unit vector along an axis; None if there is nothing there."""
    found: list[tuple[float, int, Key]] = []
    for number, (key, at) in enumerate(others):
        dx, dy = at[0] - start[0], at[1] - start[1]
        ahead = dx * way[0] + dy * way[1]
        aside = abs(dx * way[1]) + abs(dy * way[0])
        if ahead > 1.0 and aside <= 3.0 * ahead:
            found.append((ahead + ASIDE * aside, number, key))
    return min(found, key=lambda entry: entry[:2])[2] if found else None
