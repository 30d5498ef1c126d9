"""The kernel without numba: its own text, maybe with a mistake put into it, run by Python over lists."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any
from unittest.mock import patch

from app.sim.kernel import deciding, entering, features, flat, tick
from app.sim.kernel.calls import ENTITIES, FAULT
from app.sim.kernel.flat import FlatWorld
from app.sim.kernel.source import SIZES, kernel_source, scenario_functions
from app.sim.kernel.state import RUN_COLUMNS
from app.sim.kernel.tick import WHOLE
from app.sim.program.tables import TABLE_COLUMNS
from tests.playground import scenario as playground

#: A module comes before those that it imports from: what these define then takes the place of what was imported.
TEXT = "\n\n".join(
    Path(str(module.__file__)).read_text(encoding="utf-8") for module in (tick, entering, deciding, features)
)
Run = Callable[[Any, Any, Any, int, int], None]


def run_of(text: str) -> tuple[Run, ModuleType]:
    """What passes ticks in a kernel of this text, and the module with the types of its named tuples."""
    kernel = ModuleType("kernel")
    vars(kernel)["__package__"] = tick.__package__
    exec(compile(text, "tick.py", "exec"), vars(kernel))  # noqa: S102 - our own text
    generated = ModuleType("generated")
    vars(generated).update(scenario_functions(playground))
    vars(generated).update(
        compiled=lambda function: function,
        inlined=lambda function: function,
        linked=lambda **instead: vars(kernel).update(instead),
    )
    return kernel.run, generated


@contextmanager
def plain_kernel(text: str = TEXT) -> Iterator[None]:
    """Let kernel engines of the playground run *text* uncompiled."""
    run, generated = run_of(text)

    def passed(self: FlatWorld, ticks: int) -> bool:
        runs = {name: column.tolist() for name, column in self.runs.items()}
        runs["once"][FAULT] = 0
        runs["once"][ENTITIES] = len(self.numbers("x"))
        tables = {name: self.program.columns[name].tolist() for name in TABLE_COLUMNS}
        sizes = dict(zip(SIZES, self.sizes, strict=True))
        columns = {name: self.numbers(name) for name in self.world}
        world = self.shape._replace(**columns)
        run(
            world,
            SimpleNamespace(**tables, **sizes),
            SimpleNamespace(**runs),
            ticks,
            WHOLE,
        )
        for name, column in self.world.items():
            column[: len(columns[name])] = columns[name]
        for name in RUN_COLUMNS:
            self.runs[name][:] = runs[name]
        return bool(runs["once"][FAULT] == 0)

    def built(scenario: Any, layout: Any, *_: object) -> None:
        if "kernel" not in vars(generated):
            exec(kernel_source(scenario, layout), vars(generated))  # noqa: S102 - our own text

    with patch.object(FlatWorld, "run", passed), patch.object(flat, "build", built):
        yield
