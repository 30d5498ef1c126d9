"""Worlds: the arrays of a scenario, as named columns.

The reference engine keeps columns as Python lists, which plain Python reads several times faster than arrays. Frozen
worlds are plain tuples, the same whatever engine made them.
"""

from collections import namedtuple
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

from ..core.chance import world_key
from ..core.errors import ScenarioError
from ..core.hierarchy import Hierarchy
from ..core.project import Value
from .scenario import Kind, Per, Scenario, World

#: Column name -> its numbers.
FrozenWorld = Mapping[str, tuple[float, ...] | tuple[int, ...]]

SEED, WORLD_NUMBER, TICK, KEY = range(4)


def new_world(
    scenario: Scenario, parameters: Mapping[str, Value], hierarchy: Hierarchy, seed: int, number: int = 0
) -> World:
    """A world as the scenario resets it.

    Args:
        parameters: All of the scenario's parameters, as `Scenario.settle` returns them.
        hierarchy: Gives the number of agents and their groups.
        seed: Chooses the run's chance; any whole number from 0 to 2**63 - 1.
        number: Tells worlds of the same seed apart.
    """
    world = empty_world(scenario, parameters, hierarchy)
    world.clock[:] = [seed, number, 0, world_key(seed, number)]
    scenario.stages["reset"](world)
    return world


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
    """For each agent, how many agents its level-1 controller has below it; 1 without one."""
    parents = hierarchy.parents()
    sizes = {node.id: len(list(node.agents())) for node in hierarchy.controllers()}
    return [sizes[parents[agent.id]] if agent.id in parents else 1 for agent in hierarchy.agents()]


def freeze(world: World, scenario: Scenario) -> FrozenWorld:
    """A copy of all columns and the clock."""
    frozen = {column.name: tuple(getattr(world, column.name)) for column in scenario.columns}
    return {"clock": tuple(world.clock), **frozen}


def thaw(world: World, frozen: Mapping[str, Sequence[float] | Sequence[int]], scenario: Scenario) -> None:
    """Put frozen columns back into a world of the same shape.

    Raises:
        ScenarioError: A column is missing or has another length.
    """
    for name in ("clock", *(column.name for column in scenario.columns)):
        into = getattr(world, name)
        if name not in frozen or len(frozen[name]) != len(into):
            found = "missing" if name not in frozen else f"{len(frozen[name])} long"
            raise ScenarioError(
                f"a stored world of {scenario.name!r}: column {name!r} is {found}, not {len(into)} long"
            )
        into[:] = frozen[name]


def spans(world: World, scenario: Scenario) -> Mapping[str, range]:
    """The entities of each kind, agents included."""
    others = {
        k.name: range(getattr(world, f"first_{k.name}"), getattr(world, f"end_{k.name}"))
        for k in scenario.kinds
    }
    return {"agent": range(world.agents), **others}


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
    ends = [f"{edge}_{kind.name}" for kind in scenario.kinds for edge in ("first", "end")]
    names = ["clock", "agents", "params", *ends, *(column.name for column in scenario.columns)]
    return namedtuple("World", names)  # noqa: PYI024 - its fields come from the scenario
