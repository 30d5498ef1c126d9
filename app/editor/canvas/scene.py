"""What is drawn: a world and what its nodes do, live or of a stored moment; no Qt."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.examples import Moment
from ...core.hierarchy import Hierarchy, Node
from ...core.project import Project
from ...engine.place import Place
from ...engine.snapshots import Snapshot
from ...sim.columns import AGENT, Kind
from ...sim.doing import NONE, BehaviorRef, Doing, StateRef
from ...sim.engine import Columns
from ...sim.look import settled
from ...sim.scenario import Scenario
from .camera import Extent

#: A world without walls gets this share of its extent around it; one without height is this share of its width high.
AROUND, FLAT = 0.06, 0.25


@dataclass(frozen=True, eq=False)  # no slots: what is derived is kept once it was asked for
class Scene:
    """A world and what its nodes do, at one tick."""

    place: Place = field(repr=False)
    columns: Columns = field(repr=False)
    doing: Doing = field(repr=False)
    tick: int

    @property
    def agents(self) -> int:
        """How many; they are the first entities."""
        return len(self.place.spans[AGENT])

    @cached_property
    def x(self) -> NDArray[np.float64]:
        """Of all entities, units."""
        return np.asarray(self.columns["x"], np.float64)

    @cached_property
    def y(self) -> NDArray[np.float64]:
        """Of all entities, units."""
        return np.asarray(self.columns["y"], np.float64)

    @cached_property
    def held(self) -> NDArray[np.int64]:
        """For each agent the entity that it is attached to, -1 if it is free."""
        name = self.place.look.held
        if not name:
            return np.full(self.agents, NONE)
        return np.asarray(self.columns[name][: self.agents], np.int64)

    def node(self, entity: int) -> str:
        """The id of the agent that an entity is; empty if it is none."""
        return self.place.agents[entity] if 0 <= entity < self.agents else ""

    def kind(self, entity: int) -> str:
        """What kind an entity is of."""
        return next(kind for kind, span in self.place.spans.items() if entity in span)

    def called(self, entity: int) -> str:
        """What the user calls an entity: an agent by its name, ``box 3``, or just ``deposit`` where there is but one."""
        return self.place.entity_called(entity)

    def entity(self, node: str) -> int:
        """The entity of an agent, -1 if the node is none."""
        row = self.place.rows.get(node, -1) - self.doing.controllers
        return row if row >= 0 else NONE

    def reach(self, kind: str) -> float:
        """Radius of a kind, units; 0 where the scenario does not say."""
        return self.place.look.diameters.get(kind, 0.0) / 2

    def extent(self) -> Extent:
        """The world's walls, or what is around everything in it."""
        look = self.place.look
        if look.width > 0.0 and look.height > 0.0:
            return Extent(0.0, 0.0, look.width, look.height)
        if not self.x.size:
            return Extent(0.0, 0.0, 1.0, 1.0)
        left, right = float(self.x.min()), float(self.x.max())
        bottom, top = float(self.y.min()), float(self.y.max())
        size = max(right - left, top - bottom, 1.0)
        more = AROUND * size
        across, down = max(0.0, size * FLAT - (right - left)) / 2, max(0.0, size * FLAT - (top - bottom)) / 2
        return Extent(left - across - more, bottom - down - more, right + across + more, top + down + more)


def live(snapshot: Snapshot) -> Scene:
    """The world of a snapshot."""
    return Scene(snapshot.place, snapshot.columns, snapshot.doing, snapshot.tick)


# --------------------------------------------------------------------------------------------- stored moments


def remembered(moment: Moment, project: Project, scenario: Scenario) -> Scene:
    """The world of a stored moment. Nodes that the project's arm does not have any more go by their numbers."""
    columns = {name: np.asarray(values) for name, values in moment.world.items() if name != "clock"}
    counts = {kind.name: _count(kind, moment.parameters) for kind in scenario.kinds}
    agents = len(columns["x"]) - sum(counts.values())
    forest = _forest(moment, project, agents)
    spans, first = {AGENT: range(agents)}, agents
    for kind, count in counts.items():
        spans[kind], first = range(first, first + count), first + count
    look = settled(scenario.look, scenario.kinds, moment.parameters)
    physics = str(moment.parameters.get("physics", ""))
    place = Place(moment.scenario, moment.arm, forest, moment.parameters, spans, physics, look)
    return Scene(place, columns, _doing(moment, place, project), int(moment.world["clock"][2]))


def _count(kind: Kind, parameters: Mapping[str, Any]) -> int:
    return int(parameters[kind.count]) if isinstance(kind.count, str) else kind.count


def _forest(moment: Moment, project: Project, agents: int) -> Hierarchy:
    """The arm's, as long as it has just the nodes of the moment; otherwise agents by number."""
    nodes: Any = moment.machine.get("nodes", {})
    for arm in project.arms:
        if arm.name == moment.arm:
            forest = arm.forest()
            if {node.id for node in forest.walk()} == set(nodes) and len(forest.agents()) == agents:
                return forest
    return Hierarchy(tuple(Node(f"agent-{number + 1}", AGENT) for number in range(agents)))


def _doing(moment: Moment, place: Place, project: Project) -> Doing:
    """What the nodes of a moment did, as arrays."""
    types = {node.id: node.type for node in place.hierarchy.walk()}
    nodes: Any = moment.machine.get("nodes", {})
    behaviors: dict[BehaviorRef, int] = {}
    states: dict[StateRef, int] = {}
    paths = []
    for node in place.ids:
        refs = _path(nodes.get(node, {}).get("run"), types[node], project)
        paths.append(
            [
                (
                    behaviors.setdefault(ref, len(behaviors)),
                    NONE if at is None else states.setdefault(at, len(states)),
                )
                for ref, at in refs
            ]
        )
    shape = len(paths), max(1, max(map(len, paths), default=1))
    behavior, state = np.full(shape, NONE, np.int32), np.full(shape, NONE, np.int32)
    for row, path in enumerate(paths):
        for level, (what, where) in enumerate(path):
            behavior[row, level], state[row, level] = what, where
    flags = np.zeros((len(paths), 0), np.bool_)
    controllers = len(place.ids) - len(place.agents)
    return Doing(tuple(behaviors), tuple(states), behavior, state, flags, (), place.rows, controllers)


def _path(
    run: Mapping[str, Any] | None, kind: str, project: Project
) -> Iterator[tuple[BehaviorRef, StateRef | None]]:
    while run is not None:
        automaton = run["automaton"]
        if automaton is None:
            yield BehaviorRef(kind, "", run["basic"] or ""), None
        else:
            known = project.library(kind).automata.get(automaton)
            name = known.name if known is not None else automaton
            yield BehaviorRef(kind, automaton, name), StateRef(kind, automaton, run["state"])
        run = run["child"]
