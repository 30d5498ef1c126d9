"""Promises that a scenario's functions break are found by trying them out."""

from collections.abc import Callable
from itertools import count
from typing import Any

import pytest

from app.core.vocabulary import NO_ENTITY
from app.sim.scenario import Column, FeatureKind, Per, Scenario, World, uniform
from app.sim.trial import faults
from tests.bare_scenario import empty, one_feature

MARKS = (Column("mark"), Column("other"), Column("total", per=Per.WORLD))
CALLS = count()


def fault_of(scenario: Scenario) -> str:
    found = faults(scenario, ticks=10)
    assert len(found) == 1
    return found[0]


def with_behavior(*functions: Callable[..., Any]) -> Scenario:
    scenario = empty(columns=MARKS)
    for function in functions:
        scenario.behavior(function.__name__)(function)
    return scenario


def writes(world: World, me: int) -> float:
    world.mark[me] = world.mark[me] + 1.0
    return 0.0


def test_a_feature_that_writes() -> None:
    message = fault_of(one_feature(writes, columns=MARKS))
    assert message.startswith("scenario 'test', feature 'F', writes in test_trial.py, line ")
    assert message.endswith("it writes 'mark', but only behaviors and stages write")


def test_a_target_that_writes() -> None:
    def target(world: World, first: int, end: int, me: int) -> int:
        writes(world, me)
        return NO_ENTITY

    scenario = empty(columns=MARKS)
    scenario.target("t")(target)
    assert "target 't'" in fault_of(scenario)


def test_a_behavior_that_writes_what_is_anothers() -> None:
    def push(world: World, me: int) -> None:
        world.mark[0] = 1.0 + me

    assert "it writes entry 0 of 'mark', but agent 4 acts" in fault_of(with_behavior(push))


def test_a_behavior_that_writes_what_is_the_worlds() -> None:
    def tally(world: World, me: int) -> None:
        world.total[0] += 1.0

    assert "it writes entry 0 of 'total', but agent 4 acts" in fault_of(with_behavior(tally))


def test_a_behavior_that_reads_what_anothers_writes() -> None:
    def lead(world: World, me: int) -> None:
        world.mark[me] = 1.0 + world.clock[2]

    def follow(world: World, me: int) -> None:
        world.other[me] = world.mark[0]

    message = fault_of(with_behavior(lead, follow))
    assert "column 'other' depends on the order in which agents act" in message
    assert "follow" in message


def test_a_negative_index() -> None:
    def before(world: World, me: int) -> float:
        return float(world.x[me - 1])

    assert "IndexError: the index is -1; allowed: 0 and up" in fault_of(one_feature(before))


def test_a_negative_index_in_a_stage() -> None:
    def wipe(world: World) -> None:
        world.x[-1] = 0.0

    scenario = empty()
    scenario.after_tick(wipe)
    assert "scenario 'test', after_tick, wipe" in fault_of(scenario)


def test_an_index_beyond_the_last_entity() -> None:
    def after(world: World, me: int) -> float:
        return float(world.x[me + 1])

    assert "IndexError" in fault_of(one_feature(after))


def test_a_boolean_that_is_neither_true_nor_false() -> None:
    def half(world: World, me: int) -> float:
        return 0.5

    assert "it gave 0.5; allowed: 0 or 1" in fault_of(one_feature(half, FeatureKind.BOOLEAN))


def test_a_fraction_in_a_column_of_whole_numbers() -> None:
    def halve(world: World) -> None:
        world.group_size[0] = 0.5

    scenario = empty()
    scenario.kinematics(halve)
    assert "column 'group_size' holds whole numbers, but entry 0 is 0.5" in fault_of(scenario)


def test_state_that_is_kept_outside_of_the_columns() -> None:
    def remember(world: World) -> None:
        world.x[0] = float(next(CALLS))

    scenario = empty()
    scenario.kinematics(remember)
    assert "column 'x' is not the same when a run is repeated" in fault_of(scenario)


@pytest.mark.parametrize("stage", ["reset", "resolve", "kinematics", "after_tick"])
def test_a_stage_that_raises(stage: str) -> None:
    def fail(world: World) -> None:
        raise ValueError("so it is")

    scenario = empty()
    scenario.stages.pop("reset" if stage == "reset" else "", None)
    getattr(scenario, stage)(fail)
    assert fault_of(scenario).endswith("ValueError: so it is")


def test_what_keeps_all_promises_has_no_fault() -> None:
    def walk(world: World, me: int) -> None:
        world.drive[me] = 1.0

    def jump(world: World, me: int) -> None:
        world.mark[me] = uniform(world.clock, me, 1)

    def move(world: World) -> None:
        for agent in range(world.agents):
            world.x[agent] += world.drive[agent] + world.mark[agent]

    scenario = with_behavior(walk, jump)
    scenario.kinematics(move)
    assert faults(scenario) == []
