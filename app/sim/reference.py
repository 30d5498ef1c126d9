"""The plain-Python engine: slow, obvious, and the specification of every other one."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from math import isfinite
from typing import Any

from ..core.errors import ScenarioError
from ..core.machine import Action, Classifiers, Leaving, Machine, Senses, stored_classifiers
from ..core.machine_state import MachineState
from ..core.machine_state import freeze as freeze_machine
from ..core.machine_state import thaw as thaw_machine
from .doing import Doing, Roster
from .engine import FREE, Columns, Control, Departed, Start
from .failure import failed
from .motion import with_rest
from .physics import physics_of, with_columns
from .scenario import World
from .sensing import WorldSenses
from .world import KEY, TICK, FrozenWorld, as_arrays, freeze, new_world, spans, thaw


class ReferenceEngine:
    """One world stepped by `app.core.machine` and the scenario's uncompiled functions.

    Attributes:
        observed: Whether somebody is to be told who leaves a state.
        departed: Never told anything: the observer is told of all ticks.
        obstacle: Why this engine has to do instead of one that compiles, if so.
        compiled: It never is.
    """

    compiled = False

    def __init__(
        self, start: Start, leaving: Leaving | None = None, classifiers: Classifiers = stored_classifiers
    ) -> None:
        start = with_columns(start)
        self.start = start
        self.observed = leaving is not None
        self.departed: Departed | None = None
        self.obstacle = ""
        self._roster = Roster()
        self._scenario = start.scenario
        self.world: World = new_world(
            start.scenario, start.parameters, start.hierarchy, start.seed, start.world
        )
        self.physics = physics_of(start, self.world)
        self.senses = WorldSenses(start.scenario, self.world)
        self.machine = Machine(start.hierarchy, start.types, self.world.clock[KEY], classifiers, leaving)
        if start.top:
            for root in start.hierarchy.roots:
                self.machine.direct(root.id, start.top, start.arguments)

    @property
    def tick(self) -> int:
        """The tick that comes next; as many have passed."""
        return int(self.world.clock[TICK])

    @property
    def shown(self) -> Machine:
        """What all nodes do now, only to be looked at."""
        return self.machine

    def step(self, ticks: int = 1, control: Control = FREE) -> None:
        """Pass ticks: sense and decide, act, resolve, move, after-tick rules."""
        for _ in range(ticks):
            actions = self.machine.tick(self.senses, self.tick, control.picks, control.taught, control.still)
            self._act(actions)
            self._stage("resolve")
            self._move()
            self._stage("after_tick")
            self.world.clock[TICK] += 1
            control = replace(control, picks={})

    def _act(self, actions: list[Action]) -> None:
        agents = self.world.agents
        self.world.drive[:agents] = [0.0] * agents
        self.world.turn[:agents] = [0.0] * agents
        for action in actions:
            function = self._scenario.behaviors[action.behavior]
            try:
                function(self.world, action.agent, *action.targets)
            except Exception as error:
                what = f"behavior {action.behavior!r}"
                raise failed(self._scenario.name, what, function, error) from error

    def _move(self) -> None:
        if self.physics is None:
            self._stage("kinematics")
        else:
            self.physics.step_plain(self.world)

    def _stage(self, name: str, *arguments: float) -> None:
        stage = self._scenario.stages.get(name)
        if stage is not None:
            try:
                stage(self.world, *arguments)
            except Exception as error:
                raise failed(self._scenario.name, name, stage, error) from error

    def frozen_world(self) -> FrozenWorld:
        """A copy of the world."""
        return freeze(self.world, self._scenario)

    def frozen_nodes(self) -> MachineState:
        """A copy of what all nodes do now."""
        return freeze_machine(self.machine)

    def columns(self) -> Columns:
        """The same as arrays."""
        columns = as_arrays(self.world, self._scenario)
        for column in columns.values():
            column.flags.writeable = False
        return columns

    def doing(self) -> Doing:
        """What all nodes do now, as arrays."""
        return self._roster.doing(self.machine.actors)

    def watch(self, nodes: Iterable[str]) -> tuple[Machine, Senses]:  # noqa: ARG002 - it knows of all
        """What these nodes and all below them do and can sense now."""
        return self.machine, self.senses

    def restore(
        self, world: Mapping[str, Sequence[float] | Sequence[int]], machine: Mapping[str, Any]
    ) -> None:
        """Go back to a copied world, and to what all nodes did then; chance goes on as it did there."""
        thaw(self.world, world if self.physics is None else with_rest(world), self._scenario)
        if self.physics is not None:
            self.physics.forget()
        self.machine.key = self.world.clock[KEY]
        thaw_machine(self.machine, machine)

    def move(self, entity: int, x: float, y: float) -> None:
        """Put an entity somewhere else, in world units, as far as the scenario allows."""
        if not 0 <= entity < len(self.world.x):
            kinds = ", ".join(
                f"{kind} {span.start} to {span.stop - 1}" for kind, span in self.spans().items() if span
            )
            raise ScenarioError(f"there is no entity {entity}; there are: {kinds}")
        if not (isfinite(x) and isfinite(y)):
            raise ScenarioError(f"an entity cannot be put at ({x}, {y}); allowed: finite numbers")
        if "moved" in self._scenario.stages:
            self._stage("moved", entity, float(x), float(y))
        else:
            self.world.x[entity], self.world.y[entity] = float(x), float(y)

    def move_all(self, moves: Sequence[tuple[int, float, float]]) -> None:
        """Put entities somewhere else, one after the other."""
        for entity, x, y in moves:
            self.move(entity, x, y)

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
