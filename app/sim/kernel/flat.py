"""A world and what its nodes do, as columns that a kernel steps."""

from collections.abc import Iterable, Mapping
from pathlib import Path

import numpy as np

from ..physics import Physics
from ..program.tables import TABLE_COLUMNS, Column, Program, Sizes
from ..scenario import Scenario, World
from .build import Addresses, Notice, build
from .records import TABLE_RECORDS, Record, addresses, laid_out, packed, records
from .source import MEMORY, MEMORY_RECORD, SIZES, layout_of
from .state import RUN_RECORDS
from .tick import AFTER_MOVING, BEFORE_MOVING, ENTITIES, FAULT, WHOLE


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
        self._parameters = {
            letter: np.array(
                [v for n, v in world.params._asdict().items() if layout.parameters[n] == letter] or [0],
                _DTYPES[letter],
            )
            for letter in ("f", "i")
        }
        self._scalars = [int(getattr(world, name)) for name in layout.scalars]
        lengths = dict.fromkeys(MEMORY, self._lengths["heading"])
        self._memory = laid_out(lengths, MEMORY, [MEMORY_RECORD])
        self._memory["known_cos"][:] = 1.0  # bits that are all 0 are a heading of 0.0
        found = {**self.world, **self._parameters, **self._memory}
        self._world_at = _addresses(found, records(found, [MEMORY_RECORD]))
        self.runs: Mapping[str, Column] = {}
        self.sizes: list[int] = []
        self._program: Program | None = None
        self._tables: Mapping[str, Column] = {}
        self._tables_at = self._runs_at = self._whole = np.zeros(0, np.int64)

    def use(self, program: Program, runs: Mapping[str, Column]) -> None:
        """Let the nodes do what *runs* say."""
        if program is not self._program:
            self._program = program
            self._tables = packed(program.columns, TABLE_COLUMNS, TABLE_RECORDS)
            self._tables_at = _addresses(self._tables, TABLE_RECORDS)
            self.sizes = _sizes(program.sizes)
            self._whole = np.array([*self._scalars, *self.sizes], np.int64)
        self.runs = runs
        self.runs["once"][ENTITIES] = self._lengths["x"]
        self._runs_at = _addresses(runs, RUN_RECORDS)

    @property
    def program(self) -> Program:
        """The program in use."""
        assert self._program is not None
        return self._program

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
        self._kernel(self._world_at, self._tables_at, self._runs_at, self._whole, ticks, part)

    def read(self, world: World) -> None:
        """Take over the columns of a plain world."""
        for name, column in self.world.items():
            column[: self._lengths[name]] = getattr(world, name)

    def write(self, world: World) -> None:
        """Put the columns back into a plain world."""
        for name in self.world:
            getattr(world, name)[:] = self.numbers(name)

    def numbers(self, name: str) -> list[float] | list[int]:
        """A column of the world as plain numbers."""
        numbers: list[float] | list[int] = self.world[name][: self._lengths[name]].tolist()
        return numbers

    def copy(self) -> list[Column]:
        """A copy of everything."""
        return [column.copy() for column in (*self.world.values(), *self.runs.values())]

    def paste(self, copy: list[Column]) -> None:
        """Go back to a copy."""
        for column, before in zip((*self.world.values(), *self.runs.values()), copy, strict=True):
            column[:] = before


_DTYPES = {"f": np.float64, "i": np.int64}


def _addresses(columns: Mapping[str, Column], shape: Iterable[Record]) -> Addresses:
    return np.array(addresses(columns, shape), np.int64)


def _sizes(sizes: Sizes) -> list[int]:
    named = {"slots_most": sizes.slots}
    return [named[name] if name in named else getattr(sizes, name) for name in SIZES]
