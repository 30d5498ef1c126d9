"""How a scenario's world is to be drawn, told by naming its own parameters, columns and kinds."""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import Field, dataclass, field
from typing import Any

from ..core.errors import ScenarioError
from ..core.project import Value
from .columns import AGENT, Column, Kind, Per


@dataclass(frozen=True, slots=True)
class Look:
    """What a world looks like from above, x to the right and y upward. What is left out is not drawn.

    Attributes:
        width, height: Parameters, units: the world reaches from (0, 0) to there. Without them, it is as large as what
            is in it.
        diameters: Kind, agents included -> parameter, units.
        ranges: Kind, agents included -> parameters, units: circles around the selected entity.
        held: Column of whole numbers: the load that an agent is attached to, or `NO_ENTITY`.
        loads: The kind of entity that is held.
        got, needed: Columns of whole numbers: how many hold a load, and how many it needs.
        places: Kinds drawn as a cross instead of a body.
    """

    width: str = ""
    height: str = ""
    diameters: Mapping[str, str] = field(default_factory=dict)
    ranges: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    held: str = ""
    loads: str = ""
    got: str = ""
    needed: str = ""
    places: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class SettledLook:
    """A `Look` with numbers in the place of parameters: units.

    Attributes:
        width, height: 0 where the scenario does not say how large its world is.
        diameters: Of every kind, agents included; 0 where the scenario does not say.
        ranges: Kind -> parameter -> radius, for the kinds that have some.
    """

    width: float = 0.0
    height: float = 0.0
    diameters: Mapping[str, float] = field(default_factory=dict)
    ranges: Mapping[str, Mapping[str, float]] = field(default_factory=dict)
    held: str = ""
    loads: str = ""
    got: str = ""
    needed: str = ""
    places: tuple[str, ...] = ()


def settled(look: Look | None, kinds: Iterable[Kind], parameters: Mapping[str, Value]) -> SettledLook:
    """*look* for these parameters; without one, what the kinds themselves say about how large they are."""
    diameters = {AGENT: 0.0} | {kind.name: 2.0 * _number(kind.radius, parameters) for kind in kinds}
    if look is None:
        return SettledLook(diameters=diameters)
    diameters |= {kind: _number(name, parameters) for kind, name in look.diameters.items()}
    ranges = {
        kind: {name: _number(name, parameters) for name in names} for kind, names in look.ranges.items()
    }
    width, height = (_number(name or 0.0, parameters) for name in (look.width, look.height))
    return SettledLook(
        width, height, diameters, ranges, look.held, look.loads, look.got, look.needed, look.places
    )


def _number(value: str | float, parameters: Mapping[str, Value]) -> float:
    return float(parameters[value]) if isinstance(value, str) else value


def refuse_bad_look(
    look: Look, kinds: Iterable[Kind], columns: Iterable[Column], parameters: Mapping[str, "Field[Any]"]
) -> None:
    """Raise a `ScenarioError` if a look names what the scenario does not have."""
    there = [AGENT, *(kind.name for kind in kinds)]
    numbers = sorted(name for name, declared in parameters.items() if type(declared.default) in (float, int))
    whole = [column.name for column in columns if column.whole and column.per is Per.ENTITY]
    for what, name in (("width", look.width), ("height", look.height)):
        _refuse_missing(what, name, "parameter that is a number", numbers)
    for what, name in (("held", look.held), ("got", look.got), ("needed", look.needed)):
        _refuse_missing(what, name, "column of whole numbers", whole)
    _refuse_missing("loads", look.loads, "kind of entity", there)
    for kind in (*look.diameters, *look.ranges, *look.places):
        _refuse_missing("a key of diameters or ranges, or one of places,", kind, "kind of entity", there)
    for name in (*look.diameters.values(), *(name for names in look.ranges.values() for name in names)):
        _refuse_missing("a diameter or range", name, "parameter that is a number", numbers)


def _refuse_missing(what: str, name: str, kind: str, there: Collection[str]) -> None:
    if name and name not in there:
        raise ScenarioError(
            f"look: {what} is {name!r}, but there is no such {kind}; there are: {', '.join(there) or 'none'}"
        )
