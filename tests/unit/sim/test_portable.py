"""What engines would not do alike is found by reading a scenario's functions."""

import math
import random
from math import fmod, hypot
from typing import Any

import pytest

from app.sim.portable import faults
from app.sim.scenario import FeatureKind, Phrases, World, uniform
from tests.bare_scenario import one_feature

SPEED, FRICTION = 3, 0.5
PLACES = [1, 2, 3]
WORDS = Phrases()


def root(world: World, me: int) -> float:
    return math.sqrt(world.x[me] * SPEED) + FRICTION - uniform(world.clock, me, 0) + abs(helper(world.y[me]))


def helper(value: float) -> float:
    near: float = min(value, 1.0)
    for k in range(3):
        near += k
    while near > 2.0 and near != 5.0:
        near -= 1.0
    return -near if near < 0.0 else near


def hypotenuse(world: World, me: int) -> float:
    return hypot(world.x[me], world.y[me])


def hypotenuse_by_module(world: World, me: int) -> float:
    return math.hypot(world.x[me], world.y[me])


def remainder(world: World, me: int) -> float:
    return fmod(world.x[me], 2.0)


def square(world: World, me: int) -> float:
    return float(world.x[me] ** 2)


def squared(world: World, me: int) -> float:
    x = world.x[me]
    x **= 2
    return float(x)


def last(world: World, me: int) -> float:
    return float(world.x[-1])


def length(world: World, me: int) -> float:
    return float(len(world.x))


def dice(world: World, me: int) -> float:
    return random.random()


def listed(world: World, me: int) -> float:
    return float(max([world.x[me], 1.0]))


def remembered(world: World, me: int) -> float:
    return float(PLACES[me])


def worded(world: World, me: int) -> float:
    return float(WORDS is None)


def text(world: World, me: int) -> float:
    return 1.0 if world.x[me] == "far" else 0.0


def attempt(world: World, me: int) -> float:
    try:
        return 1.0 / float(world.x[me])
    except ZeroDivisionError:
        return 0.0


def counting(world: World, me: int) -> float:
    global SPEED  # noqa: PLW0603 - just this is refused
    SPEED += 1
    return float(SPEED)


def lazy(world: World, me: int) -> float:
    inner = lambda value: value + 1.0  # noqa: E731 - just this is refused
    return float(inner(world.x[me]))


def imported(world: World, me: int) -> float:
    from time import time

    return time()


def deep(world: World, me: int) -> float:
    return hypotenuse(world, me)


def test_numbers_loops_math_and_functions_of_the_same_sort_are_fine() -> None:
    assert faults(one_feature(root)) == []


@pytest.mark.parametrize(
    ("function", "line", "fault"),
    [
        (hypotenuse, 1, "hypotenuse, line {}: hypot differs when compiled"),
        (hypotenuse_by_module, 1, "hypotenuse_by_module, line {}: math.hypot differs when compiled"),
        (remainder, 1, "remainder, line {}: fmod differs when compiled"),
        (square, 1, "square, line {}: ** rounds differently when compiled"),
        (squared, 2, "squared, line {}: ** rounds differently when compiled"),
        (last, 1, "last, line {}: no negative indices"),
        (length, 1, "length, line {}: len is not among the functions that can be used: abs, bool, float, "),
        (dice, 1, "dice, line {}: random is module: only numbers, and functions of the same sort"),
        (listed, 1, "listed, line {}: no lists"),
        (remembered, 1, "remembered, line {}: PLACES is list: only numbers, and functions of the same sort"),
        (worded, 1, "worded, line {}: WORDS is Phrases: only numbers, and functions of the same sort"),
        (text, 1, "text, line {}: only numbers, not 'far'"),
        (attempt, 1, "attempt, line {}: no exceptions"),
        (counting, 1, "counting, line {}: state is in columns, and nowhere else"),
        (lazy, 1, "lazy, line {}: no nested functions"),
        (imported, 1, "imported, line {}: imports belong to the beginning of the module"),
    ],
)
def test_what_differs_is_found_with_its_line(function: Any, line: int, fault: str) -> None:
    expected = fault.format(function.__code__.co_firstlineno + line)
    assert faults(one_feature(function))[0].startswith(f"scenario 'test', {expected}")


def test_functions_that_are_called_are_read_as_well() -> None:
    assert [fault.split(": ")[0].split(", ")[1] for fault in faults(one_feature(deep))] == ["hypotenuse"]


def test_a_function_within_a_function_cannot_use_what_is_around_it() -> None:
    around = 3.0

    def inner(world: World, me: int) -> float:
        return around

    assert "around belongs to a function around it" in faults(one_feature(inner))[0]


def test_a_function_whose_source_is_lost_is_named() -> None:
    module: dict[str, Any] = {}
    exec("def lost(world, me):\n    '''Lost.'''\n    return 0.0", module)  # noqa: S102 - made without a file
    assert faults(one_feature(module["lost"])) == ["scenario 'test', lost: its source cannot be read"]


def test_checks_of_parameters_are_never_compiled() -> None:
    scenario = one_feature(root)
    scenario.check(words)
    assert faults(scenario) == []


def words(parameters: Any) -> str:
    return f"{parameters}" if parameters is None else ""


def test_features_behaviors_targets_and_stages_are_all_read() -> None:
    scenario = one_feature(square)
    scenario.group_feature("G", FeatureKind.BOOLEAN)(group)
    scenario.behavior("B")(last)
    scenario.target("t")(whom)
    scenario.kinematics(stage)
    found = [fault.split(", ")[1] for fault in faults(scenario)]
    assert found == ["square", "group", "last", "whom", "stage"]


def group(world: World, first: int, end: int) -> float:
    return float(first**2)


def whom(world: World, first: int, end: int, me: int) -> int:
    return int(first**2)


def stage(world: World) -> None:
    world.x[0] = world.x[0] ** 2
