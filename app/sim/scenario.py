'''The contract between a scenario and the engines that run it: the manual of scenario authors.

A scenario is one Python module. It declares parameters, kinds of entities, columns and measures, and decorates plain
functions. One that ships with Understudy is a file in ``app/sim/scenarios``; a project brings its own as
``scenario.py`` in its folder, says ``"scenario": "scenario.py"``, and imports all it needs from here; ``understudy new
DIR --scenario FILE.py`` begins such a project. A whole one::

    from dataclasses import dataclass
    from understudy.sim.scenario import FeatureKind, Scenario, World, quantity, uniform

    @dataclass(frozen=True, slots=True)
    class Parameters:
        """What can be set."""

        length: float = quantity(100.0, "units", 1.0, 1e6, doc="the line that agents live on")

    scenario = Scenario("line", "On a line", Parameters, doc="Agents walk up and down a line.")

    @scenario.feature("Place", FeatureKind.CONTINUOUS, unit="units")
    def place(world: World, me: int) -> float:
        """Where on the line the agent is."""
        return world.x[me]

    @scenario.behavior("Up")
    def up(world: World, me: int) -> None:
        """Walk on."""
        world.drive[me] = 1.0

    @scenario.reset
    def reset(world: World) -> None:
        """Put all agents somewhere on the line."""
        for agent in range(world.agents):
            world.x[agent] = uniform(world.clock, agent, 0) * world.params.length

    @scenario.kinematics
    def move(world: World) -> None:
        """Walk, as far as the line goes."""
        for agent in range(world.agents):
            world.x[agent] = min(world.x[agent] + world.drive[agent], world.params.length)

**What can be declared.** Each declaration names its functions' arguments. *me*, *target* and what a target function
returns are entities: agents come first, numbered from 0, then each kind in its order.

=================  =========================================  ==========================================================
``feature``        ``(world, me, *targets) -> float``         what an agent sees; one target for each parameter
``group_feature``  ``(world, first, end) -> float``           what a controller sees of its agents, see ``members``
``behavior``       ``(world, me, *targets)``                  what an agent does in one tick
``target``         ``(world, first, end, me) -> int``         whom a name means: an entity, or `NO_ENTITY`
``reset``          ``(world)``                                how a world begins; every scenario has one
``resolve``        ``(world)``                                who wins where acts conflict
``kinematics``     ``(world)``                                how things move without contact
``after_tick``     ``(world)``                                what happens at the end of a tick; counting
``moved``          ``(world, entity, x, y)``                  what follows when a user drags an entity there
``check``          ``(parameters) -> str``                    what is wrong with the parameters together; empty: nothing
=================  =========================================  ==========================================================

**The world** has, besides the declared columns:

* ``x``, ``y`` (world units) and ``heading`` (radians in [-pi, pi)) of every entity.
* ``drive`` (units per tick) and ``turn`` (radians per tick): what agents want of the physics; zeroed every tick.
* ``group_size``: the agents in the level-1 group that an agent belongs to, itself included; 1 if it is in none.
* ``members``: agents ordered so that every controller's are ``members[k] for k in range(first, end)``.
* ``clock``: (seed, world, tick, key); ``progressed[0]``: the tick of the last progress, set by the scenario.
* ``agents``: how many agents; ``first_KIND`` and ``end_KIND``: the entities of each other kind.
* ``params``: the parameters, by name; a word is its place among the choices.

A column has an entry for every entity (``world.x[me]``), or a single one (``world.boxes[0]``). All that a scenario
remembers is in columns: a world can be stored, gone back to, and stepped by any engine.

**One tick.** All nodes sense and decide; features and targets read the world as it was when the tick began, and write
nothing. Then agents act: a behavior writes entries of the acting agent alone, and reads nothing that another's behavior
writes, so that the order of acting does not matter; what agents want of each other is settled in ``resolve``. Then
``resolve``, physics, ``after_tick``. A behavior with ``one_shot`` or ``raises`` runs once; one with ``raises`` raises
that flag. A target that means nobody gives features their default and makes behaviors idle: no function is called.

**Physics.** ``kinematics`` moves things without contact. A scenario with ``bodies`` (see `Bodies`) can be run with
``physics=rigid`` as well: then bodies with mass are moved instead, by ``drive`` and ``turn``, contact, walls, joints
between agents and what they hold, and friction; the other stages stay the same.

**Drawing.** A scenario with a `Look` says how large its world is, how large its entities are, what circles show how far
they reach, and who holds what; without one, its entities are drawn where they are.

**Values.** A boolean feature is 0.0 or 1.0, a categorical one the place of its category, a toroidal one lies in
[-period/2, period/2). NaN and infinity are errors.

**Chance** is ``uniform(world.clock, who, number)``, in [0, 1): *who* is the agent that draws or `THE_WORLD`; *number*
tells several draws of one drawer in one tick apart. The same three give the same number again, in every engine.

**What functions may use.** Engines call these very functions, as they are or compiled, and have to come to the same
numbers. So they keep to numbers, ``if``, ``for`` over ``range``, ``while``, ``abs``, ``min``, ``max``, ``round``,
``int``, ``float``, the functions of `math`, `uniform`, constants, and functions of the same sort. Not allowed:

* ``hypot``, ``fmod`` and ``**``, which round differently when compiled: write ``sqrt(dx * dx + dy * dy)``;
* negative indices, ``len`` of a column, whole numbers beyond 63 bits, fractions in columns of whole numbers;
* lists, dicts, strings, ``None``, exceptions, classes, nested functions, other modules, other randomness, clocks;
* variables of the module that change: state is in columns, and nowhere else.

Fast: ``heading_cos(world, entity)`` and ``heading_sin``, remembered until the entity turns, and ``square_distance``.

`app.sim.portable` finds most of this by reading, `app.sim.trial` the rest of what is promised here by trying.
'''

from collections.abc import Callable, Mapping
from dataclasses import Field, replace
from math import pi
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
from .bodies import Bodies, refuse_bad_bodies
from .columns import (
    STANDARD_COLUMNS,
    Column,
    Kind,
    Per,
    refuse_bad_columns,
    refuse_bad_kinds,
    refuse_bad_measures,
)
from .declaring import blaming, promise, refuse_bad_function, refuse_twice
from .failure import failed
from .geometry import clamped, distance, heading_cos, heading_sin, square_distance, wrapped
from .look import Look, refuse_bad_look
from .parameters import checked, default, parameter_fields, quantity
from .ranges import refuse_bad_feature

__all__ = [
    "DONE",
    "FAILED",
    "NO_ENTITY",
    "STANDARD_COLUMNS",
    "THE_WORLD",
    "Bodies",
    "Column",
    "FeatureKind",
    "Kind",
    "Look",
    "Per",
    "Phrases",
    "Scenario",
    "World",
    "clamped",
    "distance",
    "heading_cos",
    "heading_sin",
    "quantity",
    "square_distance",
    "uniform",
    "wrapped",
]

Function = TypeVar("Function", bound=Callable[..., Any])
#: A world is a named tuple whose type depends on the scenario, hence Any.
World = Any

NO_PHRASES = Phrases()


class Scenario:
    """What a scenario module declares.

    Attributes:
        parameters: A frozen dataclass whose fields are made by `quantity`.
        features, behaviors, targets: Name -> function; the vocabulary tells what each is.
        stages: ``reset``, ``resolve``, ``kinematics``, ``after_tick``, ``moved`` -> function, as far as declared.
        measures: Name -> the column with a single entry that holds it.
        checks: Rules across parameters.
        bodies: What rigid physics has to know; without it there is kinematic physics only.
        look: How its worlds are drawn; without it, what is there is drawn where it is.
    """

    def __init__(  # noqa: PLR0913, PLR0917 - a scenario is declared in one piece, by keywords
        self,
        name: str,
        title: str,
        parameters: type,
        kinds: tuple[Kind, ...] = (),
        columns: tuple[Column, ...] = (),
        measures: Mapping[str, str] | None = None,
        doc: str = "",
        bodies: Bodies | None = None,
        look: Look | None = None,
    ) -> None:
        self.name = name
        self.title = title
        self.doc = doc
        self.parameters = parameters
        self.kinds = kinds
        self.bodies = bodies
        self.look = look
        self.columns = (*STANDARD_COLUMNS, *columns)
        self.measures = dict(measures or {})
        self.features: dict[str, Callable[..., float]] = {}
        self.behaviors: dict[str, Callable[..., None]] = {}
        self.targets: dict[str, Callable[..., int]] = {}
        self.stages: dict[str, Callable[..., None]] = {}
        self.checks: list[Callable[[Any], str]] = []
        self._features: dict[str, Feature] = {}
        self._behaviors: dict[str, BasicBehavior] = {}
        self._targets: dict[str, Target] = {}
        with blaming(name):
            self._fields = parameter_fields(parameters)
            refuse_bad_kinds(kinds, self._fields)
            refuse_bad_columns(columns, kinds)
            refuse_bad_measures(self.measures, self.columns)
            if bodies is not None:
                refuse_bad_bodies(bodies, kinds, columns, self._fields)
            if look is not None:
                refuse_bad_look(look, kinds, columns, self._fields)

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
        feature = Feature(name, kind, parameters, default, categories, period, unit, phrases)
        return self._feature(feature, 2 + len(parameters))

    def group_feature(
        self,
        name: str,
        kind: FeatureKind,
        default: float = 0.0,
        categories: tuple[str, ...] = (),
        period: float = 2 * pi,
        unit: str = "",
        phrases: Phrases = NO_PHRASES,
    ) -> Callable[[Function], Function]:
        """Declare a controller's feature: ``function(world, first, end) -> float`` over ``world.members``."""
        feature = Feature(name, kind, (), default, categories, period, unit, phrases, whose="group")
        return self._feature(feature, 3)

    def _feature(self, feature: Feature, arguments: int) -> Callable[[Function], Function]:
        def declare(function: Function) -> Function:
            what = f"feature {feature.name!r}"
            with blaming(self.name):
                refuse_twice(what, feature.parameters)
                refuse_bad_feature(feature)
            self._add(what, feature.name, self.features, function, arguments)
            self._features[feature.name] = replace(feature, doc=promise(function))
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
            with blaming(self.name):
                refuse_twice(f"behavior {name!r}", parameters)
            self._add(f"behavior {name!r}", name, self.behaviors, function, 2 + len(parameters))
            doc = promise(function)
            self._behaviors[name] = BasicBehavior(name, parameters, one_shot, raises, finishes, doc=doc)
            return function

        return declare

    def target(self, name: str, level: int = 0) -> Callable[[Function], Function]:
        """Declare a target: ``function(world, first, end, me) -> entity``, or `NO_ENTITY`.

        ``members[first:end]`` are the agents of the node that bound it, *me* is the agent that acts. Nodes of *level*
        and above can bind it; agents are level 0.
        """

        def declare(function: Function) -> Function:
            self._add(f"target {name!r}", name, self.targets, function, 4)
            self._targets[name] = Target(name, level, promise(function))
            return function

        return declare

    def reset(self, function: Function) -> Function:
        """Declare how a world begins: ``function(world)``."""
        return self._add("reset", "reset", self.stages, function, 1)

    def resolve(self, function: Function) -> Function:
        """Declare what happens between acting and physics, such as who wins: ``function(world)``."""
        return self._add("resolve", "resolve", self.stages, function, 1)

    def kinematics(self, function: Function) -> Function:
        """Declare how things move without contact: ``function(world)``."""
        return self._add("kinematics", "kinematics", self.stages, function, 1)

    def after_tick(self, function: Function) -> Function:
        """Declare the rules at the end of a tick: ``function(world)``."""
        return self._add("after_tick", "after_tick", self.stages, function, 1)

    def moved(self, function: Function) -> Function:
        """Declare what follows when a user drags an entity: ``function(world, entity, x, y)``; it sets the position."""
        return self._add("moved", "moved", self.stages, function, 4)

    def check(self, function: Function) -> Function:
        """Declare a rule across parameters: ``function(parameters)`` says what is wrong, or nothing."""
        with blaming(self.name):
            refuse_bad_function("check", function, 1)
        self.checks.append(function)
        return function

    def _add(
        self, what: str, name: str, table: dict[str, Any], function: Function, arguments: int
    ) -> Function:
        with blaming(self.name):
            if not name.strip():
                raise ScenarioError(f"a name is missing: {what}")
            if name in table:
                raise ScenarioError(f"{what} is declared twice")
            refuse_bad_function(what, function, arguments)
        table[name] = function
        return function

    # ----------------------------------------------------------------------------------------- parameters

    def parameter_fields(self) -> Mapping[str, "Field[Any]"]:
        """The parameters with their metadata, by name."""
        return self._fields

    def defaults(self) -> Mapping[str, Value]:
        """Every parameter's default."""
        return {name: default(declared) for name, declared in self._fields.items()}

    def settle(self, given: Mapping[str, Value]) -> Mapping[str, Value]:
        """All parameters: the defaults with *given* put over them.

        Raises:
            ParameterError: A name is unknown, a value has the wrong type or lies outside its range, or the values do
                not go together.
        """
        if unknown := [name for name in given if name not in self._fields]:
            raise ParameterError(
                f"scenario {self.name!r} has no parameter {unknown[0]!r}; there are: {', '.join(sorted(self._fields))}"
            )
        values = dict(self.defaults())
        values.update({name: checked(name, self._fields[name], value) for name, value in given.items()})
        for check in self.checks:
            self._apply(check, values)
        return values

    def _apply(self, check: Callable[[Any], str], values: Mapping[str, Value]) -> None:
        try:
            wrong = check(self.parameters(**values))
        except Exception as error:
            raise failed(self.name, "check", check, error) from error
        if wrong:
            raise ParameterError(wrong)
