"""What is drawn: live worlds of every shape, and stored moments."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from app.core.project import Arm, LevelTable, Project
from app.core.storage import load
from app.editor.canvas.scene import remembered
from app.engine.scenarios import open_scenario
from tests.corridor import corridor, project
from tests.unit.editor.canvas.worlds import scene


@pytest.fixture(scope="module")
def foraging() -> Project:
    return load(Path(__file__).parents[4] / "projects" / "foraging")


def test_a_world_with_walls_is_as_large_as_they_are(foraging: Project) -> None:
    extent = scene(foraging, open_scenario(foraging), "independent").extent()
    assert (extent.left, extent.bottom, extent.right, extent.top) == (0.0, 0.0, 200.0, 200.0)


def test_a_world_without_walls_is_as_large_as_what_is_in_it_and_never_flat() -> None:
    extent = scene(project(), corridor, "squads").extent()
    assert extent.left < 0.0
    assert extent.right > 50.0
    assert extent.height > 10.0


def test_things_are_called_by_what_they_are(foraging: Project) -> None:
    world = scene(foraging, open_scenario(foraging), "independent")
    assert world.called(0) == "Agent 1"
    assert world.called(50) == "box 1"
    assert world.called(60) == "deposit"


def test_a_stored_moment_shows_what_every_node_did(foraging: Project) -> None:
    example = next(e for e in foraging.examples_of("agent", "forage") if e.snapshot)
    moment = foraging.moments[example.snapshot]
    world = remembered(moment, foraging, open_scenario(foraging))
    assert world.tick == example.tick
    assert world.agents == len(foraging.arm(moment.arm).forest().agents())
    ran = world.doing.behavior[world.doing.row(example.node)]
    assert example.node in world.place.agents
    assert len(ran)


def test_a_moment_of_a_forest_that_is_gone_still_shows_its_agents_by_number(foraging: Project) -> None:
    example = next(e for e in foraging.examples_of("agent", "forage") if e.snapshot)
    moment = foraging.moments[example.snapshot]
    changed = replace(
        foraging,
        arms=(Arm(moment.arm, LevelTable((1,), ("agent",)), "Forage"),),
    )
    world = remembered(moment, changed, open_scenario(foraging))
    assert world.agents == len(moment.world["x"]) - 11
    assert world.called(0) == "Agent 1"
