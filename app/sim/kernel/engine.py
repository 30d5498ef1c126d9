"""The compiled engine: free ticks in the kernel, all others by the reference engine on the same world and nodes.

There is one truth at a time, in columns or in plain Python; it is carried over when the other side is needed.
"""

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ...core.errors import ProgramError, ScenarioError
from ...core.library import Types
from ...core.machine import Classifiers, Leaving, Machine, Senses, stored_classifiers
from ...core.machine_state import MachineState
from ..doing import Doing
from ..engine import FREE, Columns, Control, Departed, Start
from ..program import Needs, Program, lower, needs_of
from ..program.tables import Column
from ..reference import ReferenceEngine
from ..scenario import World
from ..sensing import WorldSenses
from ..world import TICK, FrozenWorld
from .build import Notice
from .calls import MACHINE_KEY
from .flat import FlatCopy, FlatWorld
from .past import Lookout
from .state import FrozenRuns, put_back, put_back_some, runs_of
from .viewing import Viewer

#: The most ticks of nodes that pass in one call, about a tenth of a second: then Python hears an interrupt.
SLICE = 1_000_000


class KernelEngine:
    """One world stepped by the compiled kernel of its scenario.

    Ticks in which someone is taught, behaviors that have no flat form, and ticks in which an observer listens that cannot
    be told afterwards are left to the reference engine, with the same results.

    Attributes:
        obstacle: Why the last free ticks were left to the reference engine; empty if they were not.
    """

    def __init__(
        self,
        start: Start,
        leaving: Leaving | None = None,
        classifiers: Classifiers = stored_classifiers,
        notice: Notice | None = None,
        folder: Path | None = None,
        over: ReferenceEngine | None = None,
    ) -> None:
        """Begin a run, or go on with one.

        Args:
            leaving: Told of every change of state at the top of a node, in ticks whose control listens.
            notice: Told when the kernel has to be compiled.
            folder: Where compiled kernels are kept; the user's cache folder by default.
            over: A run that goes on compiled: its world, its nodes and its observer are taken over as they are.

        Raises:
            UncompilableError: The scenario cannot be compiled.
            ScenarioError: Its reset failed.
        """
        self.obstacle = ""
        self.departed: Departed | None = None
        self.senses: Senses = _FreshSenses(self)
        self._reference = over or ReferenceEngine(start, leaving, classifiers)
        self.start = self._reference.start  # with what its physics needs
        reference = self._reference
        self._flat = FlatWorld(self.start.scenario, reference.world, reference.physics, notice, folder)
        self._lowered: _Lowered | None = None
        self._in_columns = False  # where the truth is
        self._copied = True  # whether plain Python says the same

    # ---------------------------------------------------------------------------------------- passing ticks

    def step(self, ticks: int = 1, control: Control = FREE) -> None:
        """Pass ticks; picks take effect in the first of them."""
        goal = self.tick + ticks
        if not (control.picks or control.taught):
            self._step_compiled(goal, control)
        if self.tick < goal:
            self._to_python()
            self._reference.step(goal - self.tick, control)

    def _step_compiled(self, goal: int, control: Control) -> None:
        """Pass ticks up to *goal* as far as that is possible compiled."""
        heard = self._reference.observed and control.listen
        if heard and self.departed is None:
            return
        most = 1 if heard else max(1, SLICE // len(self._reference.machine.actors))
        while self.tick < goal and self._to_columns():
            assert self._lowered is not None
            still = self._lowered.rows_of(control.still)
            if still is None:
                return
            before = self._run(min(goal - self.tick, most), control, still)
            if heard and before is not None:
                self._look_back(before, control, still)

    def _run(self, ticks: int, control: Control, still: Column) -> FlatCopy | None:
        """Pass ticks in the kernel and return what was before them.

        If something goes wrong in one, nothing is returned: it goes back and lets the reference engine say what it is.
        """
        before, first = self._flat.copy(), self.tick
        self._copied = False
        try:
            if self._flat.run_without(still, ticks):
                return before
        except (ArithmeticError, ValueError, IndexError):
            pass
        passed = self.tick - first
        self._flat.paste(before)
        if self._reference.physics is not None:
            self._reference.physics.forget()
        self._flat.run_without(still, passed)
        self._to_python()
        self._reference.step(1, control)
        return None

    def _look_back(self, before: FlatCopy, control: Control, still: Column) -> None:
        assert self._lowered is not None
        past = self._lowered.lookout.past(before, self._flat.now(), control, still)
        if past is not None and self.departed is not None:
            self.departed(past)

    # ------------------------------------------------------------------------------------ carrying it over

    def _to_columns(self) -> bool:
        """Carry the truth over to the columns; False, with the reason, where it has no flat form."""
        if not self._in_columns:
            machine = self._reference.machine
            try:
                program = self._program(machine)
                runs = runs_of(machine, program)
            except ProgramError as error:
                self.obstacle = str(error)
                return False
            self._flat.use(program, runs)
            self._flat.read(self._reference.world)
            self._in_columns, self._copied, self.obstacle = True, True, ""
        return True

    def _program(self, machine: Machine) -> Program:
        needs = needs_of(machine)
        if self._lowered is None or not self._lowered.serves(machine, needs):
            self._lowered = _Lowered(self.start, machine, needs, self._reference.world)
        return self._lowered.program

    def _copy(self) -> None:
        """Let plain Python say the same as the columns."""
        if not self._copied:
            assert self._lowered is not None
            self._flat.write(self._reference.world)
            put_back(self._flat.runs, self._lowered.program, self._reference.machine, self.tick)
            self._copied = True

    def _to_python(self) -> None:
        self._copy()
        self._in_columns = False

    # --------------------------------------------------------------------------------------- looking at it

    @property
    def tick(self) -> int:
        """The tick that comes next; as many have passed."""
        return int(self._flat.world["clock"][TICK]) if self._in_columns else self._reference.tick

    @property
    def compiled(self) -> bool:
        """Whether free ticks are compiled."""
        return not self.obstacle

    @property
    def machine(self) -> Machine:
        """What all nodes do now; ask again after ticks have passed."""
        self._to_python()
        return self._reference.machine

    @property
    def shown(self) -> Machine:
        """What all nodes do now, only to be looked at: faster than `machine`, which may be changed."""
        self._copy()
        return self._reference.machine

    def frozen_world(self) -> FrozenWorld:
        """A copy of the world."""
        if not self._in_columns or not self._is_finite():
            self._copy()
            return self._reference.frozen_world()
        return {name: tuple(self._flat.numbers(name)) for name in self._flat.world}

    def frozen_nodes(self) -> MachineState:
        """A copy of what all nodes do now: of columns, which take a while to be put into words, when it is looked at.

        It is kept of worlds that run free, which go on in columns anyway.
        """
        if not self._to_columns():
            return self._reference.frozen_nodes()
        assert self._lowered is not None
        return FrozenRuns(self._flat.runs, self._lowered.program, self._reference.machine.actors, self.tick)

    def columns(self) -> Columns:
        """The same as arrays, much faster."""
        if not self._in_columns or not self._is_finite():
            self._copy()
            return self._reference.columns()
        return self._flat.arrays()

    def _is_finite(self) -> bool:
        columns = self._flat.world.values()
        return all(bool(np.isfinite(column).all()) for column in columns if column.dtype == np.float64)

    def doing(self) -> Doing:
        """What all nodes do now, as arrays."""
        if not self._in_columns:
            return self._reference.doing()
        assert self._lowered is not None
        return self._lowered.viewer.doing(self._flat.runs)

    def watch(self, nodes: Iterable[str]) -> tuple[Machine, Senses]:
        """What these nodes and all below them do and can sense now, only to be looked at until time passes."""
        machine = self._reference.machine
        if self._copied:
            return machine, self._reference.senses
        assert self._lowered is not None
        looked_at = (below.id for node_id in nodes for below in machine.actors[node_id].node.walk())
        rows = {node_id: self._lowered.viewer.row(node_id) for node_id in looked_at}
        put_back_some(self._flat.runs, self._lowered.program, machine, self.tick, rows)
        return machine, WorldSenses(self.start.scenario, self._flat.plain())

    def measures(self) -> Mapping[str, float]:
        """The scenario's measures now."""
        if not self._in_columns:
            return self._reference.measures()
        return {n: float(self._flat.world[column][0]) for n, column in self.start.scenario.measures.items()}

    @property
    def progressed(self) -> int:
        """The tick of the last progress, -1 if there was none."""
        return int(self._flat.world["progressed"][0]) if self._in_columns else self._reference.progressed

    def spans(self) -> Mapping[str, range]:
        """The entities of each kind."""
        return self._reference.spans()

    def sensed(self) -> Senses:
        """What can be sensed now, of the plain world."""
        self._copy()
        return self._reference.senses

    # ------------------------------------------------------------------------------------------ changing it

    def restore(
        self, world: Mapping[str, Sequence[float] | Sequence[int]], machine: Mapping[str, Any]
    ) -> None:
        """Go back to a copied world, and to what all nodes did then; chance goes on as it did there."""
        if self._in_columns and not machine["nodes"]:  # nobody does anything else for it
            self._reference.restore(world, machine)
            self._flat.read(self._reference.world)
            self._flat.runs["once"][MACHINE_KEY] = self._reference.machine.key
        else:
            self._to_python()
            self._reference.restore(world, machine)

    def move(self, entity: int, x: float, y: float) -> None:
        """Put an entity somewhere else, in world units, as far as the scenario allows."""
        self.move_all([(entity, x, y)])

    def move_all(self, moves: Sequence[tuple[int, float, float]]) -> None:
        """Put entities somewhere else, one after the other."""
        if not (self._in_columns and self._moved_in_columns(moves)):
            self._to_python()
            self._reference.move_all(moves)

    def _moved_in_columns(self, moves: Sequence[tuple[int, float, float]]) -> bool:
        """Move while the nodes stay in columns; False, and nothing is moved, where something is wrong with that."""
        world = self._reference.world
        copied, self._copied = self._copied, False
        self._flat.write(world)
        try:
            self._reference.move_all(moves)
            self._reference.columns()  # no column would hold what does not belong there
        except ScenarioError:
            return False
        self._flat.read(world)
        self._copied = copied
        return True


class _Lowered:
    """A program with what it was made of."""

    def __init__(self, start: Start, machine: Machine, needs: Needs, shape: World) -> None:
        self._types: Types = machine.types
        self._classifiers = machine.classifiers
        self._needs = needs
        actors = machine.actors.values()
        self.program = lower(actors, machine.types, start.scenario, machine.classifiers, needs)
        self.viewer = Viewer(self.program)
        self.lookout = Lookout(start, machine, self.program, shape)
        self._still: tuple[frozenset[str], Column | None] = frozenset(), np.zeros(0, np.int64)

    def rows_of(self, still: frozenset[str]) -> Column | None:
        """The rows of nodes that do not tick; None if one of them stands below one that ticks."""
        if still is not self._still[0] and still != self._still[0]:
            rows = np.array(
                [row for row, node_id in enumerate(self.program.nodes) if node_id in still], np.int64
            )
            parents = self.program.columns["parent"][rows]
            above = bool(np.isin(parents[parents >= 0], rows).all())
            self._still = still, rows if above else None
        return self._still[1]

    def serves(self, machine: Machine, needs: Needs) -> bool:
        """Whether nothing has changed that would need another program."""
        return (
            machine.types is self._types
            and machine.classifiers is self._classifiers
            and self._needs.covers(needs)
        )


class _FreshSenses:
    """What an engine's world is like at the moment of asking."""

    def __init__(self, engine: KernelEngine) -> None:
        self._engine = engine

    def feature(self, name: str, agent: int, targets: tuple[int, ...]) -> float:
        """An agent's feature."""
        return self._engine.sensed().feature(name, agent, targets)

    def group_feature(self, name: str, members: range) -> float:
        """A controller's own feature."""
        return self._engine.sensed().group_feature(name, members)

    def target(self, name: str, members: range, performer: int) -> int:
        """The entity a target name means."""
        return self._engine.sensed().target(name, members, performer)
