"""A foraging world with bodies, for tests."""

from dataclasses import replace
from math import cos, pi, sin
from typing import Any

from app.core.hierarchy import Hierarchy
from app.sim.reference import ReferenceEngine
from tests.arena import Arena
from tests.foragers import start


class RigidArena(Arena):
    """As `Arena`; agents begin two units apart so that none touches another."""

    APART = 2.0

    def make(self, forest: Hierarchy, seed: int, parameters: dict[str, Any]) -> ReferenceEngine:
        """The engine that is tested."""
        return ReferenceEngine(replace(start(forest, seed=seed, **parameters), physics="rigid"))

    def ring(self, box: int, x: float, y: float, *agents: int, distance: float = 4.0) -> None:
        """Put a box somewhere with agents attached all around it, looking along x."""
        for k, agent in enumerate(agents):
            angle = 2.0 * pi * k / len(agents)
            self.place(agent, x + distance * cos(angle), y + distance * sin(angle))
        self.place_box(box, x, y, *agents)
