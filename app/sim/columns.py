"""What a world consists of: columns of numbers, and kinds of entities."""

from collections.abc import Iterable, Mapping
from dataclasses import Field, dataclass
from enum import StrEnum
from keyword import iskeyword
from math import isfinite
from typing import Any

from ..core.errors import ScenarioError


class Per(StrEnum):
    """How many entries a column has."""

    ENTITY = "entity"
    WORLD = "world"


@dataclass(frozen=True, slots=True)
class Column:
    """One array of the world: float64, or int64 where *whole*."""

    name: str
    whole: bool = False
    initial: float = 0.0
    per: Per = Per.ENTITY
    doc: str = ""


@dataclass(frozen=True, slots=True)
class Kind:
    """A kind of entity besides agents.

    Attributes:
        count: The parameter that says how many there are, or a fixed number.
        radius: The parameter that says how large one is, or a fixed number; for drawing and for rigid bodies. A parameter
            called KIND_diameter says it too, and KIND_range how far a place reaches.
    """

    name: str
    count: str | int
    radius: str | float = 0.0
    doc: str = ""


#: Columns that every world has.
STANDARD_COLUMNS = (
    Column("x", doc="position, world units"),
    Column("y", doc="position, world units"),
    Column("heading", doc="radians in [-pi, pi), 0 along x, counterclockwise"),
    Column("drive", doc="how far an agent wants to move along its heading in this tick, units"),
    Column("turn", doc="how far an agent wants to turn in this tick, radians, counterclockwise"),
    Column("group_size", whole=True, initial=1, doc="agents in this agent's level-1 group"),
    Column("members", whole=True, doc="agents, ordered so that every controller's are consecutive"),
    Column("progressed", whole=True, initial=-1, per=Per.WORLD, doc="tick of the last progress"),
)

#: Names in a world that no column can have, and kinds that every world has.
RESERVED, AGENT = ("clock", "agents", "params"), "agent"


def span_names(kinds: Iterable[Kind]) -> tuple[str, ...]:
    """The names by which a world says where the entities of each kind begin and end."""
    return tuple(f"{edge}_{kind.name}" for kind in kinds for edge in ("first", "end"))


def refuse_bad_columns(columns: Iterable[Column], kinds: tuple[Kind, ...]) -> None:
    """Raise a `ScenarioError` if a declared column cannot stand beside the standard ones."""
    taken = {column.name: "a column that every world has" for column in STANDARD_COLUMNS}
    taken |= dict.fromkeys((*RESERVED, *span_names(kinds)), "something that every world has")
    for column in columns:
        _refuse_bad_name("column", column.name)
        if column.name in taken:
            raise ScenarioError(f"column {column.name!r} has the name of {taken[column.name]}")
        taken[column.name] = "another column"
        if not isfinite(column.initial) or (column.whole and column.initial != int(column.initial)):
            allowed = "a whole number" if column.whole else "a finite number"
            raise ScenarioError(f"column {column.name!r} begins with {column.initial}; allowed: {allowed}")


def refuse_bad_kinds(kinds: Iterable[Kind], parameters: Mapping[str, "Field[Any]"]) -> None:
    """Raise a `ScenarioError` if a kind cannot be, e.g. because there is no parameter that counts its entities."""
    taken = {AGENT}
    for kind in kinds:
        _refuse_bad_name("kind", kind.name)
        if kind.name in taken:
            raise ScenarioError(f"there is more than one kind {kind.name!r}")
        taken.add(kind.name)
        if not _counts(kind.count, parameters):
            raise ScenarioError(
                f"the count of kind {kind.name!r} is {kind.count!r}; allowed: a whole number, 0 or more, or the name of "
                "a parameter that is one and has low=0 or more"
            )
        if isinstance(kind.radius, str) and kind.radius not in parameters:
            raise ScenarioError(
                f"the radius of kind {kind.name!r} is a parameter {kind.radius!r} that there is not"
            )


def _counts(count: str | int, parameters: Mapping[str, "Field[Any]"]) -> bool:
    """Whether *count*, or every value of the parameter that it names, can be a number of entities."""
    if not isinstance(count, str):
        return type(count) is int and count >= 0
    declared = parameters.get(count)
    if declared is None or type(declared.default) is not int:
        return False
    low = declared.metadata["low"]
    return low is not None and bool(low >= 0)


def _refuse_bad_name(what: str, name: str) -> None:
    if not name.isidentifier() or iskeyword(name) or name.startswith("_"):
        raise ScenarioError(
            f"{what} {name!r} needs another name: letters, digits and inner underscores, and no word of Python's own"
        )


def refuse_bad_measures(measures: Mapping[str, str], columns: Iterable[Column]) -> None:
    """Raise a `ScenarioError` if a measure is no column with a single entry."""
    single = [column.name for column in columns if column.per is Per.WORLD]
    for measure, column in measures.items():
        if column not in single:
            raise ScenarioError(
                f"measure {measure!r} names the column {column!r}; columns with a single entry: {', '.join(single)}"
            )
