"""The plain-Python engine: slow, obvious, and the specification of every other one (DESIGN section 6)."""

from collections.abc import Mapping, Sequence
from typing import Any

from ..core.chance import world_key
from ..core.errors import ScenarioError
from ..core.machine import Action, Classifiers, Leaving, Machine, stored_classifiers
from ..core.machine_state import thaw as thaw_machine
from .engine import FREE, Control, Start
from .scenario import World
from .sensing import WorldSenses, raised
from .world import TICK, FrozenWorld, freeze, new_world, spans, thaw


class ReferenceEngine:
    """One world stepped by `app.core.machine` and the scenario's uncompiled functions."""

    def __init__(
        self, start: Start, leaving: Leaving | None = None, classifiers: Classifiers = stored_classifiers
    ) -> None:
        if start.physics != "kinematic":
            raise ScenarioError(f"there is no physics {start.physics!r}; there is: kinematic")
        self.start = start
        self._scenario = start.scenario
        try:
            self.world: World = new_world(
                start.scenario, start.parameters, start.hierarchy, start.seed, start.world
            )
        except Exception as error:
            raise raised(start.scenario, "reset", error) from error
        self.senses = WorldSenses(start.scenario, self.world)
        key = world_key(start.seed, start.world)
        self.machine = Machine(start.hierarchy, start.types, key, classifiers, leaving)
        if start.top:
            for root in start.hierarchy.roots:
                self.machine.direct(root.id, start.top, start.arguments)

    @property
    def tick(self) -> int:
        """The tick that comes next; as many have passed."""
        return int(self.world.clock[TICK])

    def step(self, ticks: int = 1, control: Control = FREE) -> None:
        """Pass ticks: sense and decide, act, resolve, move, after-tick rules."""
        for _ in range(ticks):
            actions = self.machine.tick(self.senses, self.tick, control.picks, control.taught, control.still)
            self._act(actions)
            for stage in ("resolve", "kinematics", "after_tick"):
                self._stage(stage)
            self.world.clock[TICK] += 1
            control = Control(taught=control.taught, still=control.still)

    def _act(self, actions: list[Action]) -> None:
        agents = self.world.agents
        self.world.drive[:agents] = [0.0] * agents
        self.world.turn[:agents] = [0.0] * agents
        for action in actions:
            try:
                self._scenario.behaviors[action.behavior](self.world, action.agent, *action.targets)
            except Exception as error:
                raise raised(self._scenario, f"behavior {action.behavior!r}", error) from error

    def _stage(self, name: str) -> None:
        stage = self._scenario.stages.get(name)
        if stage is not None:
            try:
                stage(self.world)
            except Exception as error:
                raise raised(self._scenario, name, error) from error

    def frozen_world(self) -> FrozenWorld:
        """A copy of the world."""
        return freeze(self.world, self._scenario)

    def restore(
        self, world: Mapping[str, Sequence[float] | Sequence[int]], machine: Mapping[str, Any]
    ) -> None:
        """Go back to a copied world, and to what all nodes did then."""
        thaw(self.world, world, self._scenario)
        thaw_machine(self.machine, machine)

    def move(self, entity: int, x: float, y: float) -> None:
        """Put an entity somewhere else, in world units."""
        if not 0 <= entity < len(self.world.x):
            kinds = ", ".join(
                f"{kind} {span.start} to {span.stop - 1}" for kind, span in self.spans().items() if span
            )
            raise ScenarioError(f"there is no entity {entity}; there are: {kinds}")
        self.world.x[entity], self.world.y[entity] = float(x), float(y)

    def spans(self) -> Mapping[str, range]:
        """The entities of each kind."""
        return spans(self.world, self._scenario)

    def measures(self) -> Mapping[str, float]:
        """The scenario's measures now."""
        return {
            name: float(getattr(self.world, column)[0]) for name, column in self._scenario.measures.items()
        }

    @property
    def progressed(self) -> int:
        """The tick of the last progress, -1 if there was none."""
        return int(self.world.progressed[0])
