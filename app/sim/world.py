"""Worlds: the arrays of a scenario, as named columns.

The reference engine keeps columns as Python lists, which plain Python reads several times faster than arrays. Frozen
worlds are plain tuples, the same whatever engine made them.
"""

from collections import namedtuple
from collections.abc import Mapping, Sequence
from functools import cache
from math import isfinite
from typing import Any, SupportsFloat

import numpy as np
from numpy.typing import NDArray

from ..core.chance import world_key
from ..core.errors import ParameterError, ScenarioError
from ..core.hierarchy import Hierarchy
from ..core.project import Value
from .columns import AGENT, Column, Kind, Per, span_names
from .failure import failed
from .scenario import Scenario, World

#: Column name -> its numbers.
FrozenWorld = Mapping[str, tuple[float, ...] | tuple[int, ...]]

SEED, WORLD_NUMBER, TICK, KEY = range(4)
_CLOCK = Column("clock", whole=True)
#: Seeds are int64 in the clock, as whole columns are: numbers from minus this up to, but not, it.
_MOST = 2**63
#: Whole numbers below this are floats without rounding; so are all that numpy makes floats of, among floats.
_EXACT = 2.0**53


def new_world(
    scenario: Scenario, parameters: Mapping[str, Value], hierarchy: Hierarchy, seed: int, number: int = 0
) -> World:
    """A world as the scenario resets it.

    Args:
        parameters: All of the scenario's parameters, as `Scenario.settle` returns them.
        hierarchy: Gives the number of agents and their groups.
        seed: Chooses the run's chance; any whole number from 0 to 2**63 - 1.
        number: Tells worlds of the same seed apart.

    Raises:
        ParameterError: The seed or number is out of range.
        ScenarioError: The scenario has no reset, or it raised.
    """
    world = empty_world(scenario, parameters, hierarchy)
    begin(world, scenario, seed, number)
    return world


def begin(world: World, scenario: Scenario, seed: int, number: int = 0) -> None:
    """Reset an empty world, see `new_world`."""
    for what, value in (("seed", seed), ("world number", number)):
        if not 0 <= value < _MOST:
            raise ParameterError(
                f"a {what} is a whole number from 0 to {_MOST - 1:,}, but this one is {value:,}"
            )
    reset = scenario.stages.get("reset")
    if reset is None:
        raise ScenarioError(f"scenario {scenario.name!r} declares no reset, which says how a world begins")
    world.clock[:] = [seed, number, 0, world_key(seed, number)]
    try:
        reset(world)
    except Exception as error:
        raise failed(scenario.name, "reset", reset, error) from error


def empty_world(scenario: Scenario, parameters: Mapping[str, Value], hierarchy: Hierarchy) -> World:
    """A world whose columns hold their initial values, agents grouped as in *hierarchy*."""
    agents = len(hierarchy.agents())
    spans, entities = _spans(scenario.kinds, parameters, agents)
    columns = {
        column.name: [int(column.initial) if column.whole else float(column.initial)]
        * (entities if column.per is Per.ENTITY else 1)
        for column in scenario.columns
    }
    columns["members"][:agents] = range(agents)
    columns["group_size"][:agents] = group_sizes(hierarchy)
    params = _params_type(scenario)(**{name: _number(scenario, name, v) for name, v in parameters.items()})
    return _world_type(scenario)(clock=[0, 0, 0, 0], agents=agents, params=params, **spans, **columns)


def group_sizes(hierarchy: Hierarchy) -> list[int]:
    """For each agent, how many agents its level-1 controller has; 1 without one."""
    sizes = {
        agent.id: len(group.children)
        for group in hierarchy.controllers()
        if group.level == 1
        for agent in group.children
    }
    return [sizes.get(agent.id, 1) for agent in hierarchy.agents()]


def freeze(world: World, scenario: Scenario) -> FrozenWorld:
    """A copy of the clock and all columns: floats, and ints where the column is whole.

    Raises:
        ScenarioError: The scenario has put something else there.
    """
    return {column.name: _plain(column, getattr(world, column.name), scenario) for column in _all(scenario)}


def thaw(world: World, frozen: Mapping[str, Sequence[float] | Sequence[int]], scenario: Scenario) -> None:
    """Put frozen columns back into a world of the same shape.

    Raises:
        ScenarioError: A column is missing, has another length, or holds what it cannot; nothing has changed then.
    """
    plain = {}
    for column in _all(scenario):
        name, length = column.name, len(getattr(world, column.name))
        if name not in frozen or len(frozen[name]) != length:
            found = "missing" if name not in frozen else f"{len(frozen[name])} long"
            raise ScenarioError(
                f"a stored world of {scenario.name!r}: column {name!r} is {found}, not {length} long"
            )
        plain[name] = _plain(column, frozen[name], scenario)
    for name, values in plain.items():
        getattr(world, name)[:] = values


def _all(scenario: Scenario) -> tuple[Column, ...]:
    return (_CLOCK, *scenario.columns)


def _plain(column: Column, values: Sequence[Any], scenario: Scenario) -> tuple[float, ...] | tuple[int, ...]:
    """The entries of a column as plain Python numbers of its own kind."""
    try:
        plain = tuple(map(int if column.whole else float, values))
        if plain == tuple(values) and _holds(plain, whole=column.whole):
            return plain
    except (TypeError, ValueError, OverflowError):
        pass
    wanted = "whole numbers" if column.whole else "finite numbers"
    place, found = next((k, v) for k, v in enumerate(values) if not _fits(v, whole=column.whole))
    raise ScenarioError(
        f"scenario {scenario.name!r}: column {column.name!r} holds {wanted}, but entry {place} is {found!r}"
    )


def as_arrays(world: World, scenario: Scenario) -> dict[str, NDArray[Any]]:
    """The same as arrays: float64, and int64 where the column is whole.

    Raises:
        ScenarioError: The scenario has put something else there.
    """
    return {column.name: _array(column, getattr(world, column.name), scenario) for column in _all(scenario)}


def _array(column: Column, values: Sequence[Any], scenario: Scenario) -> NDArray[Any]:
    dtype = np.dtype(np.int64 if column.whole else np.float64)
    try:
        found = np.array(values)
    except (ValueError, OverflowError):  # what that is, is told below
        found = np.zeros(0, np.bool_)
    if found.ndim == 1 and found.dtype == dtype and (column.whole or np.all(np.abs(found) < _EXACT)):
        return found
    return np.array(_plain(column, values, scenario), dtype)


def _fits(value: object, *, whole: bool) -> bool:
    if not isinstance(value, SupportsFloat) or isinstance(value, complex):
        return False
    number = float(value)
    return isfinite(number) and number == (int(number) if whole else value) and _holds((number,), whole=whole)


def _holds(numbers: Sequence[float], *, whole: bool) -> bool:
    """Whether a column could hold them: whole ones have 63 bits and a sign."""
    if not whole:
        return all(map(isfinite, numbers))
    return min(numbers, default=0) >= -_MOST and max(numbers, default=0) < _MOST


def spans(world: World, scenario: Scenario) -> Mapping[str, range]:
    """The entities of each kind, agents included."""
    others = {
        k.name: range(getattr(world, f"first_{k.name}"), getattr(world, f"end_{k.name}"))
        for k in scenario.kinds
    }
    return {AGENT: range(world.agents), **others}


def _spans(
    kinds: tuple[Kind, ...], parameters: Mapping[str, Value], agents: int
) -> tuple[dict[str, int], int]:
    spans, first = {}, agents
    for kind in kinds:
        count = int(parameters[kind.count]) if isinstance(kind.count, str) else kind.count
        spans[f"first_{kind.name}"], spans[f"end_{kind.name}"] = first, first + count
        first += count
    return spans, first


def _number(scenario: Scenario, name: str, value: Value) -> float | int:
    """A parameter as the functions read it: one of several choices is its place among them."""
    if isinstance(value, str):
        choices: tuple[str, ...] = scenario.parameter_fields()[name].metadata["choices"]
        return choices.index(value)
    return value


@cache
def _params_type(scenario: Scenario) -> Any:
    return namedtuple("Params", list(scenario.parameter_fields()))  # noqa: PYI024 - its fields come from the scenario


@cache
def _world_type(scenario: Scenario) -> Any:
    names = [
        "clock",
        "agents",
        "params",
        *span_names(scenario.kinds),
        *(column.name for column in scenario.columns),
    ]
    return namedtuple("World", names)  # noqa: PYI024 - its fields come from the scenario
