"""A world and what its nodes do, as columns that a kernel steps."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..physics import Physics
from ..program.tables import TABLE_COLUMNS, Column, Program, Sizes
from ..scenario import Scenario, World
from .build import Block, Notice, build
from .calls import ENTITIES, FAULT
from .records import TABLE_RECORDS, addresses, laid_out, packed, records
from .source import MEMORY, SIZES, layout_of
from .state import RUN_RECORDS
from .tick import AFTER_MOVING, BEFORE_MOVING, WHOLE


class FlatCopy(NamedTuple):
    """A world and what its nodes did at one moment."""

    world: Mapping[str, Column]
    runs: Mapping[str, Column]


class FlatWorld:
    """Columns of one world, and the kernel that steps them.

    Attributes:
        world: Name -> column.
        runs: What the nodes do, name -> column.
        shape: A plain world of the same shape.
        sizes: Those of the program, in the order of `SIZES`.
    """

    def __init__(
        self,
        scenario: Scenario,
        world: World,
        physics: Physics | None = None,
        notice: Notice | None = None,
        folder: Path | None = None,
    ) -> None:
        """Make room for a world of this shape.

        Args:
            physics: Moves things in the place of the scenario's kinematics.
            notice: Told when the kernel has to be compiled.
            folder: Where compiled kernels are kept.

        Raises:
            UncompilableError: The scenario cannot be compiled.
        """
        self.shape = world
        self._physics = physics
        layout = layout_of(world, scenario)
        self._kernel = build(scenario, layout, notice, folder)
        self._lengths = {name: len(getattr(world, name)) for name in layout.columns}
        self.world = laid_out(self._lengths, layout.columns, records(layout.columns, ()))
        self._memory = laid_out(dict.fromkeys(MEMORY, self._lengths["heading"]), MEMORY, [tuple(MEMORY)])
        self._memory["known_cos"][:] = 1.0  # bits that are all 0 are a heading of 0.0
        columns = [column.ctypes.data for column in self.world.values()]
        scalars = [int(getattr(world, name)) for name in layout.scalars]
        self._world_block = _block(
            [*columns, *addresses(self._memory, [tuple(MEMORY)]), *scalars, *world.params]
        )
        self.runs: Mapping[str, Column] = {}
        self.sizes: list[int] = []
        self._program: Program | None = None
        self._tables: Mapping[str, Column] = {}
        self._tables_block = self._runs_block = _block([])

    def use(self, program: Program, runs: Mapping[str, Column]) -> None:
        """Let the nodes do what *runs* say."""
        if program is not self._program:
            self._program = program
            self._tables = packed(program.columns, TABLE_COLUMNS, TABLE_RECORDS)
            self.sizes = _sizes(program.sizes)
            self._tables_block = _block([*addresses(self._tables, TABLE_RECORDS), *self.sizes])
        self.runs = runs
        self.runs["once"][ENTITIES] = self._lengths["x"]
        self._runs_block = _block(addresses(runs, RUN_RECORDS))

    @property
    def program(self) -> Program:
        """The program in use."""
        assert self._program is not None
        return self._program

    def run_without(self, still: Column, ticks: int) -> bool:
        """As `run` does, while the nodes in the rows *still* do not tick and their subsidiaries have no controller.

        None of them stands below one that ticks.
        """
        if not len(still):
            return self.run(ticks)
        depth, kept = self.runs["depth"], self.runs["depth"][still]
        depth[still] = 0  # who runs nothing does nothing
        parents = self._tables["parent"]  # a copy of this world's own
        before = parents.copy()
        parents[np.isin(parents, still)] = -1
        try:
            return self.run(ticks)
        finally:
            depth[still], parents[:] = kept, before

    def run(self, ticks: int) -> bool:
        """Pass ticks; False if a function of the scenario answered with what it cannot mean."""
        once = self.runs["once"]
        once[FAULT] = 0
        if self._physics is None:
            self._step(ticks, WHOLE)
            return bool(once[FAULT] == 0)
        for _ in range(ticks):
            self._step(1, BEFORE_MOVING)
            if once[FAULT] != 0:
                return False
            self._physics.step(self.world)
            self._step(1, AFTER_MOVING)
        return True

    def _step(self, ticks: int, part: int) -> None:
        blocks = (self._world_block, self._tables_block, self._runs_block)
        self._kernel(*(block.ctypes.data for block in blocks), ticks, part)

    def read(self, world: World) -> None:
        """Take over the columns of a plain world."""
        for name, column in self.world.items():
            column[: self._lengths[name]] = getattr(world, name)

    def write(self, world: World) -> None:
        """Put the columns back into a plain world."""
        for name in self.world:
            getattr(world, name)[:] = self.numbers(name)

    def plain(self) -> World:
        """The world as plain Python reads it, without a copy: what is asked for is what the columns say at that moment."""
        views = {name: column.data[: self._lengths[name]] for name, column in self.world.items()}
        return self.shape._replace(**views)

    def arrays(self) -> dict[str, Column]:
        """Copies of all columns, read-only."""
        copies = {name: column[: self._lengths[name]].copy() for name, column in self.world.items()}
        for column in copies.values():
            column.flags.writeable = False
        return copies

    def numbers(self, name: str) -> list[float] | list[int]:
        """A column of the world as plain numbers."""
        numbers: list[float] | list[int] = self.world[name][: self._lengths[name]].tolist()
        return numbers

    def copy(self) -> FlatCopy:
        """A copy of everything."""
        return FlatCopy(*({n: column.copy() for n, column in of.items()} for of in (self.world, self.runs)))

    def now(self) -> FlatCopy:
        """Everything as it is, and will not be any more after the next tick."""
        return FlatCopy(self.world, self.runs)

    def paste(self, copy: FlatCopy) -> None:
        """Go back to a copy."""
        for mine, before in ((self.world, copy.world), (self.runs, copy.runs)):
            for name, column in mine.items():
                column[:] = before[name]


def _block(numbers: Sequence[float | int]) -> Block:
    """Words for compiled code: whole numbers as they are, others by their bits."""
    words = np.zeros(len(numbers), np.int64)
    for k, number in enumerate(numbers):
        words[k : k + 1].view(np.float64 if isinstance(number, float) else np.int64)[0] = number
    return words


def _sizes(sizes: Sizes) -> list[int]:
    named = {"slots_most": sizes.slots}
    return [named[name] if name in named else getattr(sizes, name) for name in SIZES]
