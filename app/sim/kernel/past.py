"""Compiled ticks that are looked back on: who left which state in one, and what it did and saw when that tick began."""

from collections.abc import Callable, Iterable

import numpy as np

from ...core.actor import Actor
from ...core.machine import Machine, Senses
from ..engine import Control, Start
from ..program.tables import Column, Program
from ..scenario import World
from ..sensing import WorldSenses
from ..world import TICK, FrozenWorld
from .calls import MACHINE_KEY
from .flat import FlatCopy
from .state import put_back, put_back_some

#: Told of who leaves a state, and of the machine at that instant.
Replayed = Callable[[Machine, Actor], None]


class Lookout:
    """Finds who leaves a state at the top of a node while one program runs, and has a machine to look back with."""

    def __init__(self, start: Start, machine: Machine, program: Program, shape: World) -> None:
        """See nothing yet.

        Args:
            machine: What the program was made of.
            shape: A plain world of the same shape.
        """
        self.program = program
        self.start = start
        self.shape = shape
        self.rows = {node_id: row for row, node_id in enumerate(program.nodes)}
        self._types, self._classifiers = machine.types, machine.classifiers
        self._machine: Machine | None = None
        self._leaving: Replayed | None = None

    def past(self, before: FlatCopy, after: FlatCopy, control: Control, still: Column) -> "KernelPast | None":
        """The tick between two moments, if somebody has left a state in it.

        Args:
            still: The rows of the nodes that stood still in it.
        """
        levels, tables = self.program.sizes.levels, self.program.columns
        state, what = before.runs["state"][::levels], before.runs["what"][::levels]
        changed = (state != after.runs["state"][::levels]) & (what >= 0) & (before.runs["depth"] > 0)
        rows = np.flatnonzero(changed)
        parents = tables["parent"][rows]
        rows = rows[(state[rows] != tables["start"][what[rows]]) & ((parents < 0) | np.isin(parents, still))]
        if not len(rows):
            return None
        nodes, automata = self.program.nodes, self.program.automata
        pairs = zip(rows.tolist(), what[rows].tolist(), strict=True)
        left = tuple((nodes[row], automata[number].automaton.id) for row, number in pairs)
        return KernelPast(self, before, left, control)

    def machine(self, leaving: Replayed | None = None) -> Machine:
        """A machine of the same nodes and behaviors as the one that the program was made of; it tells *leaving*."""
        self._leaving = leaving
        if self._machine is None:
            self._machine = Machine(self.start.hierarchy, self._types, 0, self._classifiers, self._tell)
        return self._machine

    def _tell(self, actor: Actor, _next: str) -> None:
        if self._leaving is not None and self._machine is not None:
            self._leaving(self._machine, actor)


class KernelPast:
    """One tick that has passed.

    Attributes:
        tick: Its number.
        left: See `app.sim.engine.Past`; in the order in which they ticked.
    """

    def __init__(
        self, lookout: Lookout, before: FlatCopy, left: tuple[tuple[str, str], ...], control: Control
    ) -> None:
        self.tick = int(before.world["clock"][TICK])
        self.left = left
        self._lookout = lookout
        self._before = before
        self._control = control

    def watch(self, nodes: Iterable[str]) -> tuple[Machine, Senses]:
        """What these nodes and all below them did and sensed when the tick began; until something else is looked at."""
        lookout, machine = self._lookout, self._lookout.machine()
        below = (node.id for node_id in nodes for node in machine.actors[node_id].node.walk())
        rows = {node_id: lookout.rows[node_id] for node_id in below}
        put_back_some(self._before.runs, lookout.program, machine, self.tick, rows)
        machine.key = int(self._before.runs["once"][MACHINE_KEY])
        return machine, self._senses()

    def replay(self, leaving: Replayed) -> None:
        """Let all nodes decide once more as they did, and tell who leaves a state at its top, before it happens."""
        lookout, control = self._lookout, self._control
        machine = lookout.machine(leaving)
        put_back(self._before.runs, lookout.program, machine, self.tick)
        machine.key = int(self._before.runs["once"][MACHINE_KEY])
        machine.tick(self._senses(), self.tick, control.picks, control.taught, control.still)

    def frozen_world(self) -> FrozenWorld:
        """The world when the tick began."""
        return {
            name: tuple(column[: len(getattr(self._lookout.shape, name))].tolist())
            for name, column in self._before.world.items()
        }

    def _senses(self) -> Senses:
        shape = self._lookout.shape
        views = {n: column.data[: len(getattr(shape, n))] for n, column in self._before.world.items()}
        return WorldSenses(self._lookout.start.scenario, shape._replace(**views))
