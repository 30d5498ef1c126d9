"""Where agents have been, as arrays; no Qt."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...engine.place import Place
from .scene import Scene

#: Places that are remembered of all agents together, and of each at most and at least.
ALTOGETHER, MOST, LEAST = 600_000, 240, 30
#: If more ticks than this passed between two places, nobody saw the way from one to the other.
SEEN = 100

Floats = NDArray[np.float32]


class Trails:
    """The latest places of all agents, one a scene that was shown."""

    def __init__(self) -> None:
        self._place: Place | None = None
        self._ticks: list[int] = []
        self._x: Floats = np.empty((1, 0), np.float32)  # scenes x agents, in a ring
        self._y: Floats = self._x
        self._next = 0

    def add(self, scene: Scene) -> None:
        """Remember where the agents are; of another world, or of one that went back in time, forget what came later."""
        if scene.place is not self._place:
            self._begin(scene)
        while self._ticks and self._ticks[-1] >= scene.tick:
            self._ticks.pop()
            self._next -= 1
        row = self._next % len(self._x)
        self._x[row], self._y[row] = scene.x[: scene.agents], scene.y[: scene.agents]
        self._ticks = [*self._ticks[1 - len(self._x) :], scene.tick]
        self._next += 1

    def _begin(self, scene: Scene) -> None:
        many = min(max(ALTOGETHER // max(scene.agents, 1), LEAST), MOST)
        self._place, self._ticks, self._next = scene.place, [], 0
        self._x, self._y = (np.empty((many, scene.agents), np.float32) for _ in range(2))

    def of(self, agents: NDArray[np.int64], newest: int = MOST) -> tuple[Floats, Floats]:
        """Where these agents have been, the *newest* places of each: times x agents, the oldest first."""
        seen = min(len(self._ticks), newest)
        rows = np.arange(self._next - seen, self._next)[:, None] % len(self._x)
        if not seen:  # there may be no such agents either
            return np.empty((0, len(agents)), np.float32), np.empty((0, len(agents)), np.float32)
        return self._x[rows, agents], self._y[rows, agents]

    def are_ways(self, newest: int = MOST) -> NDArray[np.bool_]:
        """Whether the way to each of the *newest* places but the first was seen: a line from the place before tells it."""
        return np.diff(np.asarray(self._ticks[-newest:], np.int64)) <= SEEN
