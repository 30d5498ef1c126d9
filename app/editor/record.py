"""What has been seen of a run: snapshots thinned out evenly, so that memory stays the same however long it goes on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ..sim.doing import Doing

#: At most so many points are kept, fewer of large worlds: together they have so many entries of what nodes do.
MOST_POINTS, MOST_ENTRIES = 1200, 12_000_000
FEWEST_POINTS = 100


@dataclass(frozen=True, slots=True)
class Point:
    """A world at one moment."""

    tick: int
    measures: Mapping[str, float]
    doing: Doing


class Record:
    """Points in the order of their ticks.

    Attributes:
        points: Those that are kept.
        version: Grows whenever points other than the last have changed.
    """

    def __init__(self) -> None:
        self.points: list[Point] = []
        self.version = 0
        self._stride = 1  # ticks between two points that are kept

    def clear(self) -> None:
        """Begin anew: it is another world."""
        self.points = []
        self.version += 1
        self._stride = 1

    def add(self, point: Point) -> bool:
        """Take in a moment, unless it comes too soon after the last; whether anything has changed.

        Going back in time forgets what came after.
        """
        self.cut(point.tick)
        if self.points and point.tick - self.points[-1].tick < self._stride:
            return False
        self.points.append(point)
        if len(self.points) > self._most(point.doing):
            self._thin_out()
        return True

    def cut(self, tick: int) -> None:
        """Forget what came after *tick*."""
        while self.points and self.points[-1].tick > tick:
            self.points.pop()
            self.version += 1

    def _most(self, doing: Doing) -> int:
        return max(FEWEST_POINTS, min(MOST_POINTS, MOST_ENTRIES // max(1, 2 * doing.behavior.size)))

    def _thin_out(self) -> None:
        """Keep every other point, and take half as many from now on."""
        span = self.points[-1].tick - self.points[0].tick
        self.points = self.points[::2]
        self._stride = max(2 * self._stride, 2 * span // max(1, 2 * len(self.points)))
        self.version += 1
