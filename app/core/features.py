"""How an automaton uses features: which ones, of whom, with which targets.

Targets are bound either to a ground target or to a parameter of the automaton itself (paper, section 3).
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from .vocabulary import Feature, FeatureKind, Vocabulary


@dataclass(frozen=True, slots=True)
class Ground:
    """A slot bound to a target of the scenario, e.g. "deposit"."""

    target: str


@dataclass(frozen=True, slots=True)
class Parameter:
    """A slot bound to a parameter of the automaton that holds it."""

    name: str


Binding = Ground | Parameter
#: Slot name -> binding. A slot that is missing is open, which is an error wherever it would run.
Bindings = Mapping[str, Binding]


@dataclass(frozen=True, slots=True)
class Sense:
    """A feature that the scenario declares, with its target slots bound."""

    feature: str
    bindings: Bindings = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class FlagUp:
    """Built in: whether the current sub-behavior has this flag up."""

    flag: str


@dataclass(frozen=True, slots=True)
class TicksInState:
    """Built in: ticks since the current state was entered (0 on entry, 1 at the next evaluation)."""


class Operation(StrEnum):
    """How a controller sums up its subsidiaries."""

    ANY = "any"
    ALL = "all"
    COUNT = "count"
    MEAN = "mean"
    MIN = "min"
    MAX = "max"


class Over(StrEnum):
    """Whom a statistic ranges over."""

    SUBSIDIARIES = "subsidiaries"
    AGENTS = "agents"


@dataclass(frozen=True, slots=True)
class Statistic:
    """A controller's feature: an agent feature or a flag, summed up over nodes below (paper, section 3.2).

    `Over.AGENTS` takes all agents below, however deep. `Over.SUBSIDIARIES` takes the direct ones: for a flag all of
    them, for an agent feature those that are agents. Over nobody, `any` and `count` are 0, `all` is 1, and the others
    are the feature's default. The mean of angles is that of their numbers.
    """

    operation: Operation
    of: Sense | FlagUp
    over: Over = Over.AGENTS


Source = Sense | FlagUp | TicksInState | Statistic


@dataclass(frozen=True, slots=True)
class FeatureUse:
    """One feature of one automaton.

    Attributes:
        id: Stable within the automaton; tests, prunes and examples refer to it.
        name: What the user calls it; empty shows a name made from the source.
    """

    id: str
    source: Source
    name: str = ""

    @property
    def shown(self) -> str:
        """The name that the user reads."""
        return self.name or describe(self.source)


def describe(source: Source) -> str:
    """A name for *source*, e.g. ``DistanceTo(deposit)`` or ``any finished``."""
    match source:
        case Sense(feature, bindings):
            return feature + slots(bindings)
        case FlagUp(flag):
            return flag
        case TicksInState():
            return "TicksInState"
        case Statistic(operation, of, over):
            direct = " (direct)" if over is Over.SUBSIDIARIES else ""
            return f"{operation.value} {describe(of)}{direct}"


def slots(bindings: Bindings) -> str:
    """Bindings as the user reads them: ``(deposit)``, or nothing where there are none."""
    if not bindings:
        return ""
    return "(" + ", ".join(b.target if isinstance(b, Ground) else b.name for b in bindings.values()) + ")"


_KINDS = {Operation.ANY: FeatureKind.BOOLEAN, Operation.ALL: FeatureKind.BOOLEAN}
#: The others give numbers in the unit of what they sum up.
_UNITLESS = (Operation.ANY, Operation.ALL, Operation.COUNT)


def declaration(source: Source, vocabulary: Vocabulary) -> Feature:
    """The kind, default, period and so on of *source*'s values.

    Raises:
        ScenarioError: The vocabulary has no such feature.
    """
    match source:
        case Sense(feature, _):
            return vocabulary.feature(feature)
        case FlagUp(flag):
            return Feature(flag, FeatureKind.BOOLEAN)
        case TicksInState():
            return Feature("TicksInState", FeatureKind.CONTINUOUS, unit="ticks")
        case Statistic(operation, of, _):
            inner = declaration(of, vocabulary)
            kind = _KINDS.get(operation, FeatureKind.CONTINUOUS)
            unit = "" if operation in _UNITLESS else inner.unit
            return Feature(
                describe(source), kind, default=empty_statistic(operation, inner.default), unit=unit
            )


def empty_statistic(operation: Operation, default: float) -> float:
    """The value of a statistic over nobody."""
    return {Operation.ANY: 0.0, Operation.ALL: 1.0, Operation.COUNT: 0.0}.get(operation, default)


def summarize(operation: Operation, values: list[float], default: float) -> float:
    """The statistic *operation* of *values*; of none, see `Statistic`. Sums run left to right."""
    if not values:
        return empty_statistic(operation, default)
    match operation:
        case Operation.ANY:
            return float(any(value != 0.0 for value in values))
        case Operation.ALL:
            return float(all(value != 0.0 for value in values))
        case Operation.COUNT:
            return float(sum(value != 0.0 for value in values))
        case Operation.MEAN:
            return _sum(values) / len(values)
        case Operation.MIN:
            return min(values)
        case Operation.MAX:
            return max(values)


def _sum(values: list[float]) -> float:
    total = 0.0  # built-in sum() compensates rounding from Python 3.12 on, which no kernel would repeat
    for value in values:
        total += value
    return total
