"""A scenario's function that fails is named with its line, and no value passes that cannot be."""

from collections.abc import Callable
from dataclasses import dataclass
from math import inf, nan
from typing import Any

import pytest

from app.core.errors import ParameterError, ScenarioError
from app.core.library import Types
from app.sim.engine import Start
from app.sim.reference import ReferenceEngine
from app.sim.scenario import Column, FeatureKind, Kind, Per, Scenario, World, quantity
from tests.foragers import alone
from tests.samples import TYPES


@dataclass(frozen=True, slots=True)
class Parameters:
    count: int = quantity(1, "", 0, 9)


def line_of(function: Callable[..., Any], offset: int) -> str:
    return f"{function.__name__} in test_failures.py, line {function.__code__.co_firstlineno + offset}"


def broken(world: World, *arguments: int) -> float:
    return deeper(world)


def deeper(world: World) -> float:
    return float(1 / (world.agents - world.agents))


def reset(world: World) -> None: ...


BROKEN = f"{line_of(deeper, 1)}: ZeroDivisionError: division by zero"


def engine(declare: Callable[[Scenario], object], top: str = "", **fields: Any) -> ReferenceEngine:
    """One agent in a scenario that *declare* adds to."""
    scenario = Scenario("bad", "Bad", Parameters, (Kind("box", "count"),), **fields)
    declare(scenario)
    if "reset" not in scenario.stages:
        scenario.reset(reset)
    start = Start(
        scenario, scenario.settle({}), alone(), Types(TYPES, {}, scenario.vocabulary), seed=1, top=top
    )
    return ReferenceEngine(start)


def message_of(act: Callable[[], object]) -> str:
    with pytest.raises(ScenarioError) as error:
        act()
    return str(error.value)


def test_a_reset_that_raises() -> None:
    message = message_of(lambda: engine(lambda s: s.reset(broken)))
    assert message == f"scenario 'bad', reset, {BROKEN}"


@pytest.mark.parametrize("stage", ["resolve", "kinematics", "after_tick"])
def test_a_stage_that_raises(stage: str) -> None:
    running = engine(lambda s: getattr(s, stage)(broken))
    assert message_of(running.step) == f"scenario 'bad', {stage}, {BROKEN}"


def test_a_behavior_that_raises() -> None:
    running = engine(lambda s: s.behavior("Walk")(broken), top="Walk")
    assert message_of(running.step) == f"scenario 'bad', behavior 'Walk', {BROKEN}"


def test_a_feature_that_raises() -> None:
    running = engine(lambda s: s.feature("F", FeatureKind.BOOLEAN)(broken))
    assert message_of(lambda: running.senses.feature("F", 0, ())) == f"scenario 'bad', feature 'F', {BROKEN}"


def test_a_group_feature_that_raises() -> None:
    running = engine(lambda s: s.group_feature("F", FeatureKind.BOOLEAN)(broken))
    message = message_of(lambda: running.senses.group_feature("F", range(1)))
    assert message == f"scenario 'bad', feature 'F', {BROKEN}"


def test_a_target_that_raises() -> None:
    running = engine(lambda s: s.target("t")(broken))
    assert (
        message_of(lambda: running.senses.target("t", range(1), 0)) == f"scenario 'bad', target 't', {BROKEN}"
    )


def test_a_rule_for_dragging_that_raises() -> None:
    running = engine(lambda s: s.moved(broken))
    assert message_of(lambda: running.move(0, 1.0, 1.0)) == f"scenario 'bad', moved, {BROKEN}"


def test_a_check_that_raises() -> None:
    assert message_of(lambda: engine(lambda s: s.check(no_parameter))) == (
        f"scenario 'bad', check, {line_of(no_parameter, 1)}: "
        "AttributeError: 'Parameters' object has no attribute 'girth'"
    )


def no_parameter(parameters: Any) -> str:
    return str(parameters.girth)


def test_a_check_refuses_as_a_parameter_error() -> None:
    def never(parameters: Any) -> str:
        return "never"

    with pytest.raises(ParameterError, match=r"^never$"):
        engine(lambda s: s.check(never))


def test_what_raises_elsewhere_is_told_by_the_line_that_called_it() -> None:
    def asks(world: World, me: int) -> float:
        return float(Column(world.nothing).initial)

    running = engine(lambda s: s.feature("F", FeatureKind.BOOLEAN)(asks))
    assert line_of(asks, 1) in message_of(lambda: running.senses.feature("F", 0, ()))


def test_a_scenario_without_a_reset() -> None:
    scenario = Scenario("bad", "Bad", Parameters)
    start = Start(scenario, scenario.settle({}), alone(), Types(TYPES, {}, scenario.vocabulary), seed=1)
    assert message_of(lambda: ReferenceEngine(start)).startswith("scenario 'bad' declares no reset")


# --------------------------------------------------------------------------------------------- bad values


@pytest.mark.parametrize(
    ("kind", "value", "allowed"),
    [
        ("continuous", nan, "a finite number"),
        ("continuous", inf, "a finite number"),
        ("continuous", -inf, "a finite number"),
        ("boolean", 2.0, "0 or 1"),
        ("boolean", nan, "0 or 1"),
        ("categorical", 3.0, "a whole number from 0 to 2"),
        ("categorical", -1.0, "a whole number from 0 to 2"),
        ("toroidal", 2.0, "a number in [-2, 2)"),
        ("toroidal", -2.5, "a number in [-2, 2)"),
    ],
)
def test_a_feature_whose_value_cannot_be(kind: str, value: float, allowed: str) -> None:
    def give(world: World, me: int) -> float:
        return value

    categories = ("a", "b", "c") if kind == "categorical" else ()
    running = engine(
        lambda s: s.feature("F", FeatureKind(kind), categories=categories, period=4.0)(give),
    )
    assert message_of(lambda: running.senses.feature("F", 0, ())) == (
        f"scenario 'bad', feature 'F', {line_of(give, 0)}: it gave {value!r} for agent 0; allowed: {allowed}"
    )


@pytest.mark.parametrize("value", ["1", None, [1.0], 1j])
def test_a_feature_whose_value_is_no_number(value: Any) -> None:
    def give(world: World, me: int) -> Any:
        return value

    running = engine(lambda s: s.feature("F", FeatureKind.CONTINUOUS)(give))
    assert "scenario 'bad', feature 'F', give in" in message_of(lambda: running.senses.feature("F", 0, ()))


def test_a_group_feature_whose_value_cannot_be() -> None:
    def give(world: World, first: int, end: int) -> float:
        return nan

    running = engine(lambda s: s.group_feature("F", FeatureKind.CONTINUOUS)(give))
    message = message_of(lambda: running.senses.group_feature("F", range(1)))
    assert "it gave nan for agents 0 to 0; allowed: a finite number" in message


@pytest.mark.parametrize("value", [True, 1, 1.0])
def test_numbers_of_any_sort_become_floats(value: Any) -> None:
    def give(world: World, me: int) -> Any:
        return value

    running = engine(lambda s: s.feature("F", FeatureKind.BOOLEAN)(give))
    assert type(running.senses.feature("F", 0, ())) is float


@pytest.mark.parametrize("entity", [2, -2, 0.5, nan, None, "box"])
def test_a_target_that_is_no_entity(entity: Any) -> None:
    def give(world: World, first: int, end: int, me: int) -> Any:
        return entity

    running = engine(lambda s: s.target("t")(give))
    message = message_of(lambda: running.senses.target("t", range(1), 0))
    assert message == (
        f"scenario 'bad', target 't', {line_of(give, 0)}: it gave {entity!r} for agent 0; allowed: -1 to 1"
    )


# -------------------------------------------------------------------------------------------- bad columns


@pytest.mark.parametrize(
    ("column", "value", "message"),
    [
        (Column("c", whole=True), 0.5, "column 'c' holds whole numbers, but entry 0 is 0.5"),
        (Column("c", whole=True), inf, "column 'c' holds whole numbers, but entry 0 is inf"),
        (Column("c"), nan, "column 'c' holds finite numbers, but entry 0 is nan"),
        (Column("c", per=Per.WORLD), "1", "column 'c' holds finite numbers, but entry 0 is '1'"),
    ],
)
def test_a_world_with_what_a_column_cannot_hold_is_not_shown(
    column: Column, value: Any, message: str
) -> None:
    def spoil(world: World) -> None:
        world.c[0] = value

    running = engine(lambda s: s.after_tick(spoil), columns=(column,))
    running.step()
    assert message_of(running.frozen_world) == f"scenario 'bad': {message}"
