"""Who has which color and shape."""

from __future__ import annotations

from pathlib import Path

import pytest

from app.core.storage import load
from app.editor.behavior_colors import BehaviorColors
from app.editor.canvas.coloring import BASICS, IDLES, RUNS, SHAPES, ColorBy, color_agents
from app.editor.canvas.scene import Scene
from app.engine.scenarios import open_scenario
from tests.corridor import corridor, project
from tests.unit.editor.canvas.worlds import scene

FORAGING = Path(__file__).parents[4] / "projects" / "foraging"


@pytest.fixture(scope="module")
def groups() -> Scene:
    """Foragers in groups, some way into a run."""
    foraging = load(FORAGING)
    return scene(foraging, open_scenario(foraging), "one level", 300)


@pytest.fixture(scope="module")
def colors() -> BehaviorColors:
    colors = BehaviorColors()
    colors.use(load(FORAGING))
    return colors


def names(scene: Scene, by: ColorBy, colors: BehaviorColors) -> dict[str, int]:
    """How many agents each line of the legend has."""
    coloring = color_agents(scene, by, colors)
    found = zip(coloring.entries, coloring.counts, strict=True)
    return {entry.words: count for entry, count in found if count}


@pytest.mark.parametrize("by", ColorBy)
def test_every_agent_is_counted_once_whatever_colors_tell(
    groups: Scene, colors: BehaviorColors, by: ColorBy
) -> None:
    coloring = color_agents(groups, by, colors)
    assert sum(coloring.counts) == groups.agents
    assert len(coloring.entry) == len(coloring.shape) == groups.agents


def test_an_agent_shows_what_the_state_of_its_outermost_automaton_holds(
    groups: Scene, colors: BehaviorColors
) -> None:
    outermost, shown = names(groups, ColorBy.OUTERMOST, colors), names(groups, ColorBy.CURRENT, colors)
    assert set(outermost) == {"Forage", "Goto"}
    assert set(shown) <= {"Wander", "ReturnWithBox", "Goto"}
    assert "Wander" in shown


def test_basic_behaviors_have_colors_that_no_automaton_has(groups: Scene, colors: BehaviorColors) -> None:
    basic = color_agents(groups, ColorBy.BASIC, colors)
    automata = color_agents(groups, ColorBy.INNERMOST, colors)
    used = [e.color for e, count in zip(basic.entries, basic.counts, strict=True) if count]
    others = {e.color for e, count in zip(automata.entries, automata.counts, strict=True) if count}
    assert len(set(used)) == len(used)
    assert not set(used) & others


def test_groups_are_told_apart_by_name(groups: Scene, colors: BehaviorColors) -> None:
    told = names(groups, ColorBy.GROUP, colors)
    assert len(told) == 10
    assert set(told.values()) == {5}
    assert "Group 1" in told


def test_shape_says_whether_an_agent_runs_an_automaton_or_idles_and_whether_it_is_attached(
    groups: Scene, colors: BehaviorColors
) -> None:
    coloring = color_agents(groups, ColorBy.CURRENT, colors)
    assert set((coloring.shape % SHAPES).tolist()) == {RUNS}
    assert ((coloring.shape >= SHAPES) == (groups.held >= 0)).all()
    assert coloring.attached == (groups.held >= 0).sum()


def test_agents_that_idle_or_only_carry_out_a_basic_behavior_have_shapes_of_their_own() -> None:
    from dataclasses import replace

    idle = replace(project(), arms=(replace(project().arm("alone"), top=""),))
    coloring = color_agents(scene(idle, corridor, "alone"), ColorBy.CURRENT, BehaviorColors())
    assert set(coloring.shape.tolist()) == {IDLES}
    basic = replace(project(), arms=(replace(project().arm("alone"), top="Up"),))
    coloring = color_agents(scene(basic, corridor, "alone", 1), ColorBy.CURRENT, BehaviorColors())
    assert set(coloring.shape.tolist()) == {BASICS}
