"""Where agents have been; no Qt."""

from __future__ import annotations

from collections import deque

import numpy as np
from numpy.typing import NDArray

from ...engine.place import Place
from .scene import Scene

#: Places that are remembered of all agents together, and of each at most and at least.
ALTOGETHER, MOST, LEAST = 600_000, 240, 30

Floats = NDArray[np.float32]


class Trails:
    """The latest places of all agents, one a scene that was shown."""

    def __init__(self) -> None:
        self._place: Place | None = None
        self._seen: deque[tuple[int, Floats, Floats]] = deque()

    def add(self, scene: Scene) -> None:
        """Remember where the agents are; of another world, or of one that went back in time, forget what came later."""
        if scene.place is not self._place:
            self._place = scene.place
            many = min(max(ALTOGETHER // max(scene.agents, 1), LEAST), MOST)
            self._seen = deque(maxlen=many)
        while self._seen and self._seen[-1][0] >= scene.tick:
            self._seen.pop()
        agents = scene.agents
        self._seen.append(
            (scene.tick, scene.x[:agents].astype(np.float32), scene.y[:agents].astype(np.float32))
        )

    def of(self, agents: NDArray[np.int64], newest: int = MOST) -> tuple[Floats, Floats]:
        """Where these agents have been, the *newest* places of each: times x agents, the oldest first."""
        seen = list(self._seen)[-newest:]
        if not seen:
            return np.empty((0, len(agents)), np.float32), np.empty((0, len(agents)), np.float32)
        return np.stack([x[agents] for _, x, _ in seen]), np.stack([y[agents] for _, _, y in seen])
