"""The contract between a scenario and the engines that run it.

A scenario is one Python module. It makes a `Scenario`, declares its parameters, kinds of entities, columns and measures,
and decorates plain functions. Every function gets the world first and reads and writes columns by entity:
``world.x[me]``. The reference engine calls the functions as they are; the compiled kernel calls the same functions
compiled, so they keep to numbers, `math`, loops, and `uniform`. What differs between the two is not to be used: hypot,
``**`` with whole powers, fmod, negative indices, whole numbers beyond 63 bits. A project's own scenario imports all it
needs from here: ``from understudy.sim.scenario import Scenario, uniform, ...``.

The world has, besides the declared columns:

* ``x``, ``y`` (world units) and ``heading`` (radians in [-pi, pi)) of every entity; agents come first.
* ``drive`` (units per tick) and ``turn`` (radians per tick): what agents want of the physics; zeroed every tick.
* ``group_size``: the agents in the level-1 group that an agent belongs to, itself included.
* ``members``: agents ordered so that every controller's are ``members[k] for k in range(first, end)``.
* ``clock``: (seed, world, tick, key); ``progressed[0]``: the tick of the last progress, set by the scenario.
* ``agents``: how many agents; ``first_KIND`` and ``end_KIND``: the entities of each other kind.
* ``params``: the parameters, by name.

One tick: sense and decide (features and targets read the world as it was when the tick began), act (behaviors write
only the acting agent's own entries), resolve (conflicting acts), physics, after-tick rules.
"""

from collections.abc import Callable, Mapping
from dataclasses import MISSING, Field, dataclass, field, fields
from enum import StrEnum
from math import isfinite, pi
from typing import Any, TypeVar

from ..core.chance import THE_WORLD, uniform
from ..core.errors import ParameterError, ScenarioError
from ..core.project import Value
from ..core.vocabulary import (
    DONE,
    FAILED,
    NO_ENTITY,
    BasicBehavior,
    Feature,
    FeatureKind,
    Phrases,
    Target,
    Vocabulary,
)

__all__ = [
    "DONE",
    "FAILED",
    "NO_ENTITY",
    "THE_WORLD",
    "Column",
    "FeatureKind",
    "Kind",
    "Per",
    "Phrases",
    "Scenario",
    "World",
    "quantity",
    "uniform",
]

Function = TypeVar("Function", bound=Callable[..., Any])
#: A world is a named tuple whose type depends on the scenario, hence Any.
World = Any

NO_PHRASES = Phrases()


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
        radius: The parameter that says how large one is, or a fixed number; for drawing and for rigid bodies.
    """

    name: str
    count: str | int
    radius: str | float = 0.0
    doc: str = ""


def quantity(
    default: Value,
    unit: str = "",
    low: float | None = None,
    high: float | None = None,
    choices: tuple[str, ...] = (),
    doc: str = "",
) -> Any:
    """A parameter: its default, unit, closed range or choices, and meaning."""
    metadata = {"unit": unit, "low": low, "high": high, "choices": choices, "doc": doc}
    return field(default=default, metadata=metadata)


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


class Scenario:
    """What a scenario module declares.

    Attributes:
        parameters: A frozen dataclass whose fields are made by `quantity`.
        features, behaviors, targets: Name -> function; the vocabulary tells what each is.
        measures: Name -> the column with a single entry that holds it.
    """

    def __init__(
        self,
        name: str,
        title: str,
        parameters: type,
        kinds: tuple[Kind, ...] = (),
        columns: tuple[Column, ...] = (),
        measures: Mapping[str, str] | None = None,
        doc: str = "",
    ) -> None:
        self.name = name
        self.title = title
        self.doc = doc
        self.parameters = parameters
        self.kinds = kinds
        self.columns = (*STANDARD_COLUMNS, *columns)
        self.measures = dict(measures or {})
        self.features: dict[str, Callable[..., float]] = {}
        self.behaviors: dict[str, Callable[..., None]] = {}
        self.targets: dict[str, Callable[..., int]] = {}
        self.stages: dict[str, Callable[[Any], None]] = {}
        self._features: dict[str, Feature] = {}
        self._behaviors: dict[str, BasicBehavior] = {}
        self._targets: dict[str, Target] = {}

    @property
    def vocabulary(self) -> Vocabulary:
        """What agents can do and see, and the group features of controllers."""
        return Vocabulary(0, self._behaviors, self._features, self._targets)

    # ------------------------------------------------------------------------------------------ declaring

    def feature(
        self,
        name: str,
        kind: FeatureKind,
        parameters: tuple[str, ...] = (),
        default: float = 0.0,
        categories: tuple[str, ...] = (),
        period: float = 2 * pi,
        unit: str = "",
        phrases: Phrases = NO_PHRASES,
    ) -> Callable[[Function], Function]:
        """Declare an agent's feature: ``function(world, me, *targets) -> float``."""

        def declare(function: Function) -> Function:
            doc = _doc(function)
            self._features[name] = Feature(
                name, kind, parameters, default, categories, period, unit, phrases, doc
            )
            self.features[name] = function
            return function

        return declare

    def group_feature(
        self,
        name: str,
        kind: FeatureKind,
        default: float = 0.0,
        unit: str = "",
        phrases: Phrases = NO_PHRASES,
    ) -> Callable[[Function], Function]:
        """Declare a controller's feature: ``function(world, first, end) -> float`` over ``world.members``."""

        def declare(function: Function) -> Function:
            doc = _doc(function)
            self._features[name] = Feature(
                name, kind, default=default, unit=unit, phrases=phrases, doc=doc, whose="group"
            )
            self.features[name] = function
            return function

        return declare

    def behavior(
        self,
        name: str,
        parameters: tuple[str, ...] = (),
        *,
        one_shot: bool = False,
        raises: str | None = None,
        finishes: bool = False,
    ) -> Callable[[Function], Function]:
        """Declare a basic behavior: ``function(world, me, *targets)``; it writes only the agent's own entries."""

        def declare(function: Function) -> Function:
            doc = _doc(function)
            self._behaviors[name] = BasicBehavior(name, parameters, one_shot, raises, finishes, doc=doc)
            self.behaviors[name] = function
            return function

        return declare

    def target(self, name: str, level: int = 0) -> Callable[[Function], Function]:
        """Declare a target: ``function(world, first, end, me) -> entity``, or `NO_ENTITY`.

        ``members[first:end]`` are the agents of the node that bound it, *me* is the agent that acts.
        """

        def declare(function: Function) -> Function:
            self._targets[name] = Target(name, level, _doc(function))
            self.targets[name] = function
            return function

        return declare

    def reset(self, function: Function) -> Function:
        """Declare how a world begins: ``function(world)``."""
        return self._stage("reset", function)

    def resolve(self, function: Function) -> Function:
        """Declare what happens between acting and physics, such as who wins: ``function(world)``."""
        return self._stage("resolve", function)

    def kinematics(self, function: Function) -> Function:
        """Declare how things move without contact: ``function(world)``."""
        return self._stage("kinematics", function)

    def after_tick(self, function: Function) -> Function:
        """Declare the rules at the end of a tick: ``function(world)``."""
        return self._stage("after_tick", function)

    def _stage(self, name: str, function: Function) -> Function:
        if name in self.stages:
            raise ScenarioError(f"scenario {self.name!r} declares {name} twice")
        self.stages[name] = function
        return function

    # ----------------------------------------------------------------------------------------- parameters

    def parameter_fields(self) -> Mapping[str, "Field[Any]"]:
        """The parameters with their metadata, by name."""
        return {f.name: f for f in fields(self.parameters)}

    def defaults(self) -> Mapping[str, Value]:
        """Every parameter's default."""
        return {name: f.default for name, f in self.parameter_fields().items() if f.default is not MISSING}

    def settle(self, given: Mapping[str, Value]) -> Mapping[str, Value]:
        """All parameters: the defaults with *given* put over them.

        Raises:
            ParameterError: A name is unknown, or a value has the wrong type or lies outside its range.
        """
        known = self.parameter_fields()
        if unknown := [name for name in given if name not in known]:
            raise ParameterError(
                f"scenario {self.name!r} has no parameter {unknown[0]!r}; there are: {', '.join(sorted(known))}"
            )
        values = dict(self.defaults())
        values.update({name: _checked(name, known[name], value) for name, value in given.items()})
        return values


def _doc(function: Callable[..., Any]) -> str:
    return (function.__doc__ or "").strip().split("\n")[0]


def _checked(name: str, declared: "Field[Any]", value: Value) -> Value:
    """*value* as the type of the parameter's default, within its range."""
    wanted: Any = type(declared.default)
    if wanted is float and isinstance(value, int) and not isinstance(value, bool):
        value = float(value)
    if not isinstance(value, wanted) or isinstance(value, bool) is not (wanted is bool):
        raise ParameterError(f"{name} takes {_TYPE_WORDS[wanted]}, but it is {value!r}")
    if isinstance(value, float) and not isfinite(value):
        raise ParameterError(f"{name} takes a finite number, but it is {value!r}")
    _check_range(name, declared, value)
    settled: Value = value
    return settled


def _check_range(name: str, declared: "Field[Any]", value: Value) -> None:
    low, high, choices = (declared.metadata.get(key) for key in ("low", "high", "choices"))
    if choices and value not in choices:
        raise ParameterError(f"{name} is one of {', '.join(choices)}, but it is {value!r}")
    if isinstance(value, str):
        return
    if low is not None and value < low:
        raise ParameterError(f"{name} must be {low} or more, but it is {value}")
    if high is not None and value > high:
        raise ParameterError(f"{name} must be {high} or less, but it is {value}")


_TYPE_WORDS = {float: "a number", int: "a whole number", bool: "true or false", str: "a word"}
