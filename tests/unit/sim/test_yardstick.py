"""The loop written by hand: the same world as the kernel's, to the bit, and only worlds that it knows."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from app.core.errors import ScenarioError
from app.core.hierarchy import from_table
from app.core.storage import load
from app.engine.bench.rates import start_of
from app.engine.runs import treatment
from app.sim.engine import Start
from app.sim.kernel import KernelEngine
from app.sim.kernel.yardstick import Yardstick
from app.sim.scenarios.foraging import scenario as foraging

FORAGER = Path(__file__).parents[3] / "resources" / "bench" / "forager"
SMALL: dict[str, Any] = {
    "world.width": 40.0,
    "world.height": 40.0,
    "world.deposit_x": 20.0,
    "world.deposit_y": 20.0,
}
#: So small and crowded that boxes are soon fought for, full and delivered, some of them against a wall.
CROWDED = {**SMALL, "world.pullers": 3, "world.boxes": 6}
TWO_SIZES = {**SMALL, "world.big_boxes": 2, "world.pullers": 2, "world.big_pullers": 7}
NEAR = {
    **SMALL,
    "world.deposit_x": 3.0,
    "world.pullers": 1,
    "world.grab_range": 2.0,
    "world.turn_degrees": 7.0,
}


def start(seed: int = 1, settings: Mapping[str, Any] | None = None) -> Start:
    project = load(FORAGER)
    return start_of(treatment(project, foraging, project.arm("independent"), settings), seed)


def differing(found: Yardstick, wanted: KernelEngine) -> list[str]:
    """Names of columns that are not the same to the bit."""
    world = wanted.frozen_world()
    return [name for name, column in found.columns.items() if not np.array_equal(column, world[name])]


@pytest.mark.parametrize(
    "settings", [{}, CROWDED, TWO_SIZES, NEAR], ids=["usual", "crowded", "two sizes", "near"]
)
@pytest.mark.parametrize("seed", [1, 2])
def test_it_gives_the_kernel_s_world_at_every_tick(seed: int, settings: dict[str, Any]) -> None:
    found, wanted = Yardstick(start(seed, settings)), KernelEngine(start(seed, settings))
    for tick in range(600):
        found.step(1)
        wanted.step(1)
        assert differing(found, wanted) == [], f"after tick {tick}"


@pytest.mark.parametrize("settings", [{}, CROWDED], ids=["usual", "crowded"])
def test_it_gives_the_kernel_s_world_after_a_long_run(settings: dict[str, Any]) -> None:
    found, wanted = Yardstick(start(3, settings)), KernelEngine(start(3, settings))
    found.step(50_000)
    wanted.step(50_000)
    assert differing(found, wanted) == []
    assert found.measures() == wanted.measures()
    assert found.measures()["boxes"] > 0.0


def test_its_result_does_not_depend_on_slices() -> None:
    whole, cut = Yardstick(start(1, CROWDED)), Yardstick(start(1, CROWDED))
    whole.step(3_000)
    for ticks in (0, 1, 999, 2_000):
        cut.step(ticks)
    assert all(np.array_equal(column, cut.columns[name]) for name, column in whole.columns.items())


@pytest.mark.parametrize(
    ("other", "named"),
    [
        (replace(start(), top="Wander"), "'Wander'"),
        (replace(start(), physics="rigid"), "'rigid'"),
        (replace(start(), hierarchy=from_table((2, 5), ("group", "agent"))), "controllers"),
        (start(1, {"world.placement": "ring"}), "'ring'"),
        (start(1, {"world.release": "full"}), "'full'"),
    ],
    ids=["another behavior", "another physics", "controllers", "another placement", "another rule"],
)
def test_worlds_that_it_does_not_know_are_refused(other: Start, named: str) -> None:
    with pytest.raises(ScenarioError, match=named):
        Yardstick(other)
