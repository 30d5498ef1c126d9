"""Headless runs: settings, curves, stalling, progress and cancelling."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import pytest

from app.core.errors import EditError, ParameterError, ScenarioError, SessionError
from app.core.project import Arm, LevelTable, Project, Value
from app.engine.runs import RunResult, Treatment, run, slices, start_engine, treatment
from app.sim.scenario import Column, Per, Scenario, World
from app.sim.scenarios.foraging import scenario as foraging
from tests.bare_scenario import empty
from tests.foragers import BUSY, libraries
from tests.samples import AGENT, TYPES

INDEPENDENT = Arm("independent", LevelTable((6,), (AGENT,)), "Forage")
PROJECT = Project(
    "Foraging",
    "foraging",
    TYPES,
    worlds={"": BUSY, "heavy": {"pullers": 3}},
    libraries=libraries(),
    arms=(INDEPENDENT,),
)


def settled(arm: Arm = INDEPENDENT, project: Project = PROJECT, **settings: Value) -> Mapping[str, Value]:
    return treatment(project, foraging, arm, {f"world.{name}": v for name, v in settings.items()}).parameters


# ----------------------------------------------------------------------------------------------- settings


def test_settings_go_over_the_arms_parameters_those_over_its_world_and_that_over_the_projects() -> None:
    plain, heavy = INDEPENDENT, replace(INDEPENDENT, world="heavy")
    own = replace(heavy, parameters={"pullers": 4})
    assert [settled(arm)["pullers"] for arm in (plain, heavy, own)] == [2, 3, 4]
    assert settled(own, pullers=5)["pullers"] == 5
    assert settled(own)["width"] == 40.0
    assert settled(own)["sight"] == 10.0


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"boxes": 3}, "there is no setting 'boxes'; there are: physics, engine, world.NAME"),
        ({"world.walls": 3}, "scenario 'foraging' has no parameter 'walls'; there are: "),
        ({"world.boxes": -3}, "boxes must be 0 or more, but it is -3"),
        ({"world.big_boxes": 7}, "big_boxes must be 6 or less, as many as there are boxes, but it is 7"),
    ],
)
def test_bad_settings_are_refused_by_name(settings: dict[str, Any], message: str) -> None:
    with pytest.raises(ParameterError) as error:
        treatment(PROJECT, foraging, INDEPENDENT, settings)
    assert str(error.value).startswith(message)


def test_an_arm_in_a_world_that_is_not_there_is_refused() -> None:
    with pytest.raises(EditError, match=r"arm 'independent' names the world 'moon'; there are: '', 'heavy'"):
        treatment(PROJECT, foraging, replace(INDEPENDENT, world="moon"))


def test_physics_is_a_setting() -> None:
    fluid = treatment(PROJECT, foraging, INDEPENDENT, {"physics": "fluid"})
    with pytest.raises(ScenarioError, match="there is no physics 'fluid'"):
        start_engine(fluid, seed=1)


def test_another_top_behavior_can_be_chosen() -> None:
    engine = start_engine(treatment(PROJECT, foraging, INDEPENDENT, top="Wander"), seed=1)
    assert {actor.run.behavior.name for actor in engine.machine.actors.values() if actor.run} == {"Wander"}


def test_a_top_behavior_that_is_not_there_is_refused() -> None:
    with pytest.raises(SessionError, match="has no 'Fly'"):
        start_engine(treatment(PROJECT, foraging, INDEPENDENT, top="Fly"), seed=1)


def test_an_idle_world_has_no_top_behavior() -> None:
    engine = start_engine(treatment(PROJECT, foraging, INDEPENDENT), seed=1, idle=True)
    assert [actor.run for actor in engine.machine.actors.values()] == [None] * 6


# --------------------------------------------------------------------------------------------------- runs


def busy_run(ticks: int = 400, seed: int = 1, **arguments: Any) -> RunResult:
    return run(treatment(PROJECT, foraging, INDEPENDENT), seed, ticks, **arguments)


def test_a_run_ends_with_its_measures_and_its_world() -> None:
    result = busy_run()
    assert (result.seed, result.ticks) == (1, 400)
    assert result.measures["boxes"] > 0
    assert result.world["boxes_delivered"] == (result.measures["boxes"],)
    assert result.world["clock"][2] == 400


def test_a_runs_result_does_not_depend_on_how_it_is_sampled() -> None:
    coarse, fine = busy_run(points=1), busy_run(points=37)
    assert (coarse.world, coarse.measures, coarse.stalled) == (fine.world, fine.measures, fine.stalled)


def test_a_curve_begins_at_zero_and_ends_with_the_measures() -> None:
    result = busy_run(points=10)
    assert result.curve.ticks == (0, 40, 80, 120, 160, 200, 240, 280, 320, 360, 400)
    assert result.curve.values.keys() == result.measures.keys() == {"boxes", "weight"}
    boxes = result.curve.values["boxes"]
    assert (boxes[0], boxes[-1]) == (0.0, result.measures["boxes"])
    assert list(boxes) == sorted(boxes)


def test_progress_is_told_between_slices() -> None:
    told: list[int] = []
    busy_run(ticks=40, points=4, progress=told.append)
    assert told == [10, 20, 30, 40]


def test_a_cancelled_run_ends_with_what_it_has() -> None:
    answers = iter([False, False, True])
    result = busy_run(ticks=40, points=4, cancelled=lambda: next(answers))
    assert (result.ticks, result.curve.ticks) == (20, (0, 10, 20))


def test_a_run_of_no_ticks_is_the_beginning() -> None:
    result = busy_run(ticks=0)
    assert (result.ticks, result.curve.ticks, result.measures["boxes"]) == (0, (0,), 0.0)


@pytest.mark.parametrize("ticks", [1, 7, 99, 100, 101, 12_345])
@pytest.mark.parametrize("points", [1, 3, 100])
def test_slices_rise_and_end_at_the_last_tick(ticks: int, points: int) -> None:
    cut = slices(ticks, points)
    assert list(cut) == sorted(set(cut))
    assert cut[0] > 0
    assert cut[-1] == ticks
    assert len(cut) <= points


# ----------------------------------------------------------------------------------------------- stalling


def progressing_at(tick: int) -> Treatment:
    """A scenario that makes progress once, in this tick."""

    def progress(world: World) -> None:
        if world.clock[2] == tick:
            world.progressed[0] = tick
            world.total[0] += 1.0

    scenario: Scenario = empty(columns=(Column("total", per=Per.WORLD),), measures={"total": "total"})
    scenario.after_tick(progress)
    project = Project("Test", "test", TYPES)
    return treatment(project, scenario, Arm("one", LevelTable((1,), (AGENT,)), ""))


@pytest.mark.parametrize(("tick", "stalled"), [(99, False), (70, False), (69, True), (0, True), (-5, True)])
def test_a_run_without_progress_in_its_last_30_percent_is_stalled(tick: int, stalled: bool) -> None:
    assert run(progressing_at(tick), seed=1, ticks=100).stalled is stalled


@pytest.mark.parametrize("ticks", [10, 30, 70, 110, 1000, 2000, 10_000])
def test_the_last_30_percent_begin_at_the_same_share_of_every_run(ticks: int) -> None:
    first = ticks * 7 // 10
    assert not run(progressing_at(first), 1, ticks, points=2).stalled
    assert run(progressing_at(first - 1), 1, ticks, points=2).stalled
