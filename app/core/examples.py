"""Examples: what a user's picks recorded (paper, section 3.1), with the moment they were recorded in."""

from collections import deque
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from itertools import repeat
from operator import attrgetter


@dataclass(frozen=True, slots=True)
class Example:
    """A triple <B, f, B'>: in state *source*, where the features were *values*, go to (or stay in) *label*.

    Examples are never thrown away by an edit, only disabled.

    Attributes:
        id: Stable within the automaton, counting up.
        values: Feature id -> value, finite.
        continuation: It says "keep doing *label*": recorded right after a pick, of the state picked.
        demonstration, tick, node: Where it came from.
        snapshot: Hash of the moment it was recorded in; empty if that was not kept.
        pick: Number of the user's act that recorded it; examples of one act share it and are undone together.
    """

    id: str
    source: str
    label: str
    values: Mapping[str, float]
    continuation: bool = False
    enabled: bool = True
    weight: float = 1.0
    demonstration: str = ""
    tick: int = 0
    node: str = ""
    snapshot: str = ""
    pick: int = 0


@dataclass(frozen=True, slots=True)
class Moment:
    """A world and what every node was doing, kept so that features can be computed later.

    Attributes:
        world: Column name -> numbers, as the scenario declares them (float64 or int64).
        parameters: The scenario's parameters, by name.
        hierarchy: The name of the arm whose forest it is.
        machine: See `app.core.machine_state`.
    """

    scenario: str
    parameters: Mapping[str, float | int | str | bool]
    arm: str
    world: Mapping[str, Sequence[float] | Sequence[int]]
    machine: Mapping[str, object] = field(default_factory=dict)


def enabled(examples: Sequence[Example], source: str | None = None) -> tuple[Example, ...]:
    """The examples that are learned from, of one state or of all."""
    return tuple(e for e in examples if e.enabled and (source is None or e.source == source))


def changed(examples: Sequence[Example], **others: Iterable[object]) -> tuple[Example, ...]:
    """Copies of *examples* with other values of some fields, given one for each example.

    Thousands are changed at once by hand, while somebody waits: field by field, this takes a third of the time of
    `dataclasses.replace` one by one, most of which goes into guarding values that do not change.
    """
    copies: tuple[Example, ...] = tuple(map(object.__new__, repeat(Example, len(examples))))
    for name in _FIELDS:
        values = others.get(name, map(attrgetter(name), examples))
        deque(map(getattr(Example, name).__set__, copies, values), maxlen=0)
    return copies


_FIELDS = tuple(each.name for each in fields(Example))
