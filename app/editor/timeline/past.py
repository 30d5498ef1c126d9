"""What is known of a run on both sides of now: what has passed, and after going back, what came then."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from ...core.automaton import START
from ...sim.doing import BehaviorRef, StateRef
from ..record import Point, Record

if TYPE_CHECKING:
    from ...engine.snapshots import Snapshot
#: What a node does, as it is shown.
Doing = BehaviorRef | StateRef


@dataclass(frozen=True, slots=True)
class Span:
    """A node doing the same from one tick to another.

    Attributes:
        doing: The state of its outermost automaton, or the basic behavior that it was told to do; None while it idles.
    """

    first: int
    last: int
    doing: Doing | None


class _Known:
    """The spans of a node as far as points have been looked at."""

    def __init__(self, version: int) -> None:
        self.version = version
        self.spans: list[Span] = []
        self.codes: list[int] = []
        self._numbers: dict[Doing | None, int] = {}

    @property
    def all_done(self) -> list[Doing | None]:
        """What the codes stand for."""
        return list(self._numbers)

    def go_on(self, tick: int, doing: Doing | None) -> None:
        """One more point."""
        self.codes.append(self._numbers.setdefault(doing, len(self._numbers)))
        last = self.spans[-1] if self.spans else None
        if last is not None:
            self.spans[-1] = replace(last, last=tick)
        if last is None or doing != last.doing:
            self.spans.append(Span(tick, tick, doing))


class Past:
    """Points of a run. Those ahead of now stay for as long as the run would come to the same again."""

    def __init__(self) -> None:
        self._record = Record()
        self._run: tuple[object, ...] = ()
        self._moved = False
        self._known: dict[str, _Known] = {}

    @property
    def points(self) -> Sequence[Point]:
        """In the order of their ticks."""
        return self._record.points

    @property
    def version(self) -> int:
        """Grows whenever points other than the last have changed."""
        return self._record.version

    def clear(self) -> None:
        """It is another world."""
        self._record.clear()
        self._moved = False

    def move(self, tick: int) -> None:
        """Something was moved by hand, which going back repeats."""
        self._moved = True
        self.end_at(tick)

    def moved_back(self, tick: int) -> None:
        """Perhaps something that was moved by hand was moved back."""
        if self._moved:
            self.end_at(tick)

    def end_at(self, tick: int) -> None:
        """What came after *tick* will be different."""
        if self.points and self.points[-1].tick > tick:
            self._record.cut(tick)

    def take(self, snapshot: Snapshot) -> bool:
        """Take in the world as it is now; whether there is anything new."""
        run = snapshot.revision, snapshot.lesson is None
        if run != self._run:
            self._run = run
            self.end_at(snapshot.tick)
        if self.points and snapshot.tick <= self.points[-1].tick:
            return False
        return self._record.add(Point(snapshot.tick, snapshot.measures, snapshot.doing))

    def at(self, tick: int) -> Point | None:
        """The world as it was seen last before or at a tick."""
        place = bisect_right(self.points, tick, key=lambda point: point.tick)
        return self.points[place - 1] if place else None

    def spans(self, node: str) -> list[Span]:
        """What a node did, one span after the other."""
        return self._known_of(node).spans

    def codes(self, node: str) -> tuple[Sequence[int], Sequence[Doing | None]]:
        """What a node did at each of the points, as numbers, and what the numbers stand for."""
        known = self._known_of(node)
        return known.codes, known.all_done

    def _known_of(self, node: str) -> _Known:
        known = self._known.get(node)
        if known is None or known.version != self.version:
            known = self._known[node] = _Known(self.version)
        for point in self.points[len(known.codes) :]:
            known.go_on(point.tick, done_by(point, node))
        return known

    def look_at(self, nodes: Collection[str]) -> None:
        """Forget the spans of all nodes but these."""
        self._known = {node: known for node, known in self._known.items() if node in nodes}

    def counted(self, measure: str) -> list[int]:
        """The ticks at which a measure was seen to have grown."""
        values = [point.measures.get(measure, 0.0) for point in self.points]
        return [
            point.tick
            for point, before, now in zip(self.points[1:], values, values[1:], strict=False)
            if now > before
        ]


def done_by(point: Point, node: str) -> Doing | None:
    """What a node did; None if it idled, which Start is, too, or was not there."""
    all_do, row = point.doing, point.doing.rows.get(node)
    if row is None:
        return None
    state, behavior = int(all_do.state[row, 0]), int(all_do.behavior[row, 0])
    if state >= 0:
        return None if all_do.states[state].state == START else all_do.states[state]
    return all_do.behaviors[behavior] if behavior >= 0 else None
