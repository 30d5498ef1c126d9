"""A foraging world for tests: entities stand where they are put, and agents do just what they are told."""

from math import degrees, radians
from typing import Any

from app.core.hierarchy import Hierarchy
from app.sim.reference import ReferenceEngine
from tests.foragers import alone, start


class Arena:
    """Agents begin in a row at the bottom, boxes in the corner at the top right, the deposit is in the middle."""

    APART = 1.0

    def __init__(self, agents: int | Hierarchy = 1, seed: int = 1, **parameters: Any) -> None:
        forest = alone(agents) if isinstance(agents, int) else agents
        self.engine = self.make(forest, seed, {"boxes": 1} | parameters)
        self.world = self.engine.world
        self.names = [node.id for node in forest.agents()]
        for agent in range(self.world.agents):
            self.place(agent, 20.0 + self.APART * agent, 20.0)
        for box in range(self.world.end_box - self.world.first_box):
            self.place_box(box, 200.0, 200.0)

    def make(self, forest: Hierarchy, seed: int, parameters: dict[str, Any]) -> ReferenceEngine:
        """The engine that is tested."""
        return ReferenceEngine(start(forest, seed=seed, **parameters))

    def place(self, agent: int, x: float, y: float, heading: float = 0.0) -> None:
        """Put an agent somewhere, looking to *heading* in degrees, 0 along x, counterclockwise."""
        self.world.x[agent], self.world.y[agent] = x, y
        self.world.heading[agent] = radians(heading)

    def place_box(self, box: int, x: float, y: float, *held_by: int) -> None:
        """Put a box somewhere, with these agents attached to it; boxes are numbered from 0 here."""
        entity = self.box(box)
        self.world.x[entity], self.world.y[entity] = x, y
        for agent in held_by:
            self.world.held[agent] = entity
        self.world.pulling[entity] = self.world.held[: self.world.agents].count(entity)

    def box(self, number: int = 0) -> int:
        """The entity that a box is."""
        return int(self.world.first_box) + number

    def tell(self, behavior: str, *agents: int) -> None:
        """Let agents do something from now on; all of them if none is named."""
        for agent in agents or range(self.world.agents):
            self.engine.machine.direct(self.names[agent], behavior)

    def tick(self, ticks: int = 1) -> None:
        """Let time pass."""
        self.engine.step(ticks)

    def do(self, behavior: str, *agents: int) -> None:
        """Let agents do something for one tick."""
        self.tell(behavior, *agents)
        self.tick()

    def at(self, entity: int) -> tuple[float, float]:
        """Where an entity is."""
        return self.world.x[entity], self.world.y[entity]

    def heading(self, agent: int = 0) -> float:
        """Where an agent looks, in degrees."""
        return degrees(self.world.heading[agent])

    def attached(self, box: int = 0) -> list[int]:
        """The agents attached to a box."""
        return [agent for agent in range(self.world.agents) if self.world.held[agent] == self.box(box)]

    def sees(self, feature: str, agent: int = 0, *targets: int) -> float:
        """The value of an agent's feature."""
        return self.engine.senses.feature(feature, agent, targets)

    def means(self, target: str, agent: int = 0, owner: range | None = None) -> int:
        """The entity that a target name means to an agent, bound by itself or by the owner of some agents."""
        return self.engine.senses.target(target, owner or range(agent, agent + 1), agent)

    def counts(self) -> dict[str, float]:
        """The measures so far."""
        return dict(self.engine.measures())
