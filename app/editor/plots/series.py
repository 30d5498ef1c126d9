"""From what was seen of a run to lines: measures, shares of behaviors, shares of an automaton's states."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..record import Point

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from ...core.hierarchy import Node
    from ...sim.doing import Doing

#: What a line is about: a measure, a behavior's type, id and name, or a state of an automaton.
LineKey = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class MeasureOf:
    """A measure of the scenario, of the world as a whole."""

    name: str


@dataclass(frozen=True, slots=True)
class BehaviorShares:
    """Which share of the agents shows each behavior."""


@dataclass(frozen=True, slots=True)
class StateShares:
    """Which share of the nodes that run an automaton is in each of its states."""

    type: str
    automaton: str


Subject = MeasureOf | BehaviorShares | StateShares


def values_at(
    point: Point, subject: Subject, rows: Callable[[Doing], NDArray[np.int64] | None]
) -> Mapping[LineKey, float]:
    """The values of all lines of *subject* at one moment.

    Args:
        rows: The rows of the nodes that count; None for all.
    """
    match subject:
        case MeasureOf(name):
            return {("measure", name): point.measures[name]} if name in point.measures else {}
        case BehaviorShares():
            return _behaviors(point.doing, rows(point.doing))
        case StateShares(kind, automaton):
            return _states(point.doing, rows(point.doing), kind, automaton)


def _behaviors(doing: Doing, rows: NDArray[np.int64] | None) -> Mapping[LineKey, float]:
    shown = doing.shown[doing.controllers :] if rows is None else doing.shown[rows[rows >= doing.controllers]]
    if not len(shown):
        return {}
    counts = np.bincount(shown[shown >= 0], minlength=len(doing.behaviors)).tolist()
    shares: dict[LineKey, float] = {}
    for ref, count in zip(doing.behaviors, counts, strict=True):
        if count:
            key = ("behavior", ref.type, ref.id, ref.name)
            shares[key] = shares.get(key, 0.0) + count / len(shown)
    return shares


def _states(
    doing: Doing, rows: NDArray[np.int64] | None, kind: str, automaton: str
) -> Mapping[LineKey, float]:
    states = doing.state if rows is None else doing.state[rows]
    counts = np.bincount(states[states >= 0], minlength=len(doing.states)).tolist()
    found = {
        ref.state: count
        for ref, count in zip(doing.states, counts, strict=True)
        if count and (ref.type, ref.automaton) == (kind, automaton)
    }
    total = sum(found.values())
    return {("state", kind, automaton, state): count / total for state, count in found.items()}


def rows_below(node: Node | None) -> Callable[[Doing], NDArray[np.int64] | None]:
    """The rows of a node and all below it, in whatever doing they are asked of; all rows for no node."""
    if node is None:
        return lambda _: None
    ids = [below.id for below in node.walk()]

    def rows(doing: Doing) -> NDArray[np.int64]:
        return np.array([doing.rows[i] for i in ids if i in doing.rows], np.int64)

    return rows


class Lines:
    """The lines of one subject over the points of a record, worked out once a point.

    Attributes:
        keys: What there are lines of, in the order in which they came up.
    """

    def __init__(
        self, subject: Subject, rows: Callable[[Doing], NDArray[np.int64] | None] = lambda _: None
    ) -> None:
        self.subject = subject
        self.keys: dict[LineKey, None] = {}
        self._rows = rows
        self._ticks: list[int] = []
        self._values: list[Mapping[LineKey, float]] = []
        self._columns: dict[LineKey, list[float]] = {}
        self._version = -1

    def follow(self, points: Sequence[Point], version: int) -> None:
        """Take in points that have come since; all of them where *version* is another."""
        if version != self._version:
            known = dict(zip(self._ticks, self._values, strict=True))
            self._version = version
            self._ticks, self._values, self._columns = [], [], {}
            for point in points:
                self._take(point, known.get(point.tick))
            return
        for point in points[len(self._ticks) :]:
            self._take(point, None)

    def _take(self, point: Point, known: Mapping[LineKey, float] | None) -> None:
        values = values_at(point, self.subject, self._rows) if known is None else known
        for key in values.keys() - self._columns.keys():
            self._columns[key] = [0.0] * len(self._ticks)
        for key, column in self._columns.items():
            column.append(values.get(key, 0.0))
        self._ticks.append(point.tick)
        self._values.append(values)
        self.keys |= dict.fromkeys(values)

    def line(self, key: LineKey) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Ticks and values of one line; 0 where nobody was there."""
        values = self._columns.get(key) or [0.0] * len(self._ticks)
        return np.array(self._ticks, np.float64), np.array(values, np.float64)
