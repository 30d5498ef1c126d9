"""What rigid physics has to know of a scenario, told by naming the scenario's own columns and parameters."""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import Field, dataclass, fields
from typing import Any

from ..core.errors import ScenarioError
from .columns import Column, Kind, Per


@dataclass(frozen=True, slots=True)
class Bodies:
    """Agents, the loads that they drag, and walls around [0, width] x [0, height].

    Entities of other kinds are places: nothing bumps into them.

    Attributes:
        loads: The kind of entity that agents drag.
        held: Column of whole numbers: the load that an agent is attached to, or `NO_ENTITY`.
        needed: Column of whole numbers: how many agents it takes to move a load.
        speed: Parameter, units per tick: how fast agents drive when nothing is in their way.
        agent_diameter, load_diameter, width, height: Parameters, units.
        contact: Parameter, true or false: whether agents bump into each other.
        reserve: Parameter, between 0 and 1: a load gives way to this much less than the pull of all that it needs.
    """

    loads: str
    held: str
    needed: str
    speed: str
    agent_diameter: str
    load_diameter: str
    width: str
    height: str
    contact: str
    reserve: str


_COLUMNS = ("held", "needed")


def refuse_bad_bodies(
    bodies: Bodies,
    kinds: Iterable[Kind],
    columns: Iterable[Column],
    parameters: Mapping[str, "Field[Any]"],
) -> None:
    """Raise a `ScenarioError` if bodies name what the scenario does not have."""
    _refuse_missing("loads", bodies.loads, "kind of entity", [kind.name for kind in kinds])
    whole = [column.name for column in columns if column.whole and column.per is Per.ENTITY]
    for named in fields(bodies):
        if named.name in _COLUMNS:
            _refuse_missing(named.name, getattr(bodies, named.name), "column of whole numbers", whole)
        elif named.name != "loads":
            wanted = bool if named.name == "contact" else float
            fitting = [name for name, declared in parameters.items() if type(declared.default) is wanted]
            word = "true or false" if wanted is bool else "a number"
            _refuse_missing(
                named.name, getattr(bodies, named.name), f"parameter that is {word}", sorted(fitting)
            )


def _refuse_missing(what: str, name: str, kind: str, there: Collection[str]) -> None:
    if name not in there:
        raise ScenarioError(
            f"bodies: {what} is {name!r}, but there is no such {kind}; there are: {', '.join(there) or 'none'}"
        )
