"""A project: everything the user made, as one frozen value."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from .automaton import State
from .errors import EditError
from .examples import Example, Moment
from .hierarchy import Hierarchy, from_table
from .library import Library, NodeType, Types
from .vocabulary import Vocabulary

#: A value of a scenario's parameter.
Value = float | int | str | bool
#: Where a state stands when its automaton is drawn: its center, in pixels, y downward.
Position = tuple[float, float]
#: State id -> where the user put it; the program places the others.
Positions = Mapping[str, Position]


@dataclass(frozen=True)  # no slots: what is derived is kept once it was asked for
class LevelTable:
    """The quick way to make a forest: sizes and types from the roots down."""

    sizes: tuple[int, ...]
    types: tuple[str, ...]

    @cached_property
    def forest(self) -> Hierarchy:
        """The forest in full."""
        return from_table(self.sizes, self.types)


@dataclass(frozen=True, slots=True)
class Arm:
    """One treatment: a forest, what its roots do, and where.

    Attributes:
        top: Name of the behavior that every root starts with; a name, since roots may be of different types.
        world: The name of one of the project's parameter sets.
        parameters: Scenario parameters that differ from that set, by name.
    """

    name: str
    hierarchy: Hierarchy | LevelTable
    top: str
    world: str = ""
    parameters: Mapping[str, Value] = field(default_factory=dict)
    note: str = ""

    def forest(self) -> Hierarchy:
        """The forest in full."""
        if isinstance(self.hierarchy, LevelTable):
            return self.hierarchy.forest
        return self.hierarchy


@dataclass(frozen=True, slots=True)
class Pick:
    """One act of a demonstrator's hand: before *tick*, on *node*.

    Attributes:
        act: ``pick`` a state; ``answer`` with one, after which the node decides by itself again; ``should not have left``
            the state just left; ``undo`` the last pick; ``redo`` it; ``test``; ``learn`` in the middle of a test; ``teach`` the node
            from this tick on (those of one tick together; the arm runs until then); or ``move`` an entity.
        state: For ``pick`` and ``answer``: the id of the state. Empty otherwise.
        entity, x, y: For ``move``: the number of the entity in its world, and where it is put. None otherwise.
    """

    tick: int
    node: str
    state: str = ""
    act: str = "pick"
    entity: int | None = None
    x: float | None = None
    y: float | None = None


@dataclass(frozen=True, slots=True)
class Demonstration:
    """A literal list of what a person's hand did; playing it records the examples again.

    Attributes:
        type, automaton: What was taught.
        arm: Whose forest and world it took place in.
        seed: The world's seed.
        parameters: Scenario parameters that differ from the arm's, by name.
        arguments: Ground targets for the automaton's parameters while it was taught.
        others: What the nodes that are not taught do meanwhile: ``idle`` or ``run``.
        ticks: How long it went on.
        removed: States that were picked and that the automaton has no longer, as they were.
    """

    id: str
    type: str
    automaton: str
    arm: str
    seed: int
    picks: tuple[Pick, ...]
    ticks: int
    parameters: Mapping[str, Value] = field(default_factory=dict)
    arguments: Mapping[str, str] = field(default_factory=dict)
    others: str = "idle"
    note: str = ""
    removed: tuple[State, ...] = ()

    def mentions(self, state_id: str) -> bool:
        """Whether a state is picked in it."""
        return any(pick.state == state_id for pick in self.picks)


@dataclass(frozen=True, slots=True)
class Project:
    """What a user made.

    Attributes:
        scenario: Name of a scenario that ships with Understudy, or ``scenario.py`` for the project's own.
        worlds: Named sets of scenario parameters; the one called ``""`` holds those of the project as a whole.
        libraries: By type name.
        examples: By type name, then automaton id, in the order in which they were recorded.
        moments: By hash.
        arms, demonstrations: By name and id, in the order in which they are shown.
        layouts: By type name, then automaton id: where the user put states, apart from what they do.
    """

    name: str
    scenario: str
    types: tuple[NodeType, ...] = (NodeType("agent"),)
    worlds: Mapping[str, Mapping[str, Value]] = field(default_factory=dict)
    libraries: Mapping[str, Library] = field(default_factory=dict)
    examples: Mapping[str, Mapping[str, tuple[Example, ...]]] = field(default_factory=dict)
    moments: Mapping[str, Moment] = field(default_factory=dict)
    arms: tuple[Arm, ...] = ()
    demonstrations: tuple[Demonstration, ...] = ()
    note: str = ""
    layouts: Mapping[str, Mapping[str, Positions]] = field(default_factory=dict)

    def library(self, type_name: str) -> Library:
        """The library of a type; empty if it has none yet."""
        return self.libraries.get(type_name, Library())

    def examples_of(self, type_name: str, automaton_id: str) -> tuple[Example, ...]:
        """The examples of one automaton, disabled ones included."""
        return self.examples.get(type_name, {}).get(automaton_id, ())

    def layout_of(self, type_name: str, automaton_id: str) -> Positions:
        """Where the user put states of one automaton."""
        return self.layouts.get(type_name, {}).get(automaton_id, {})

    def arm(self, name: str) -> Arm:
        """The arm called *name*.

        Raises:
            EditError: There is none; the message names those there are.
        """
        for arm in self.arms:
            if arm.name == name:
                return arm
        there = ", ".join(repr(arm.name) for arm in self.arms) or "none"
        raise EditError(f"there is no arm {name!r}; there are: {there}")

    def types_with(self, scenario: Vocabulary) -> Types:
        """The node types with what they can use, given the scenario's vocabulary."""
        return Types(self.types, self.libraries, scenario)

    def parameters_of(self, arm: Arm) -> Mapping[str, Value]:
        """The scenario parameters of an arm, as far as the project sets them: its own over its world's over the project's.

        Raises:
            EditError: The arm names a world that is not there.
        """
        if arm.world and arm.world not in self.worlds:
            there = ", ".join(repr(name) for name in self.worlds) or "none"
            raise EditError(f"arm {arm.name!r} names the world {arm.world!r}; there are: {there}")
        return {**self.worlds.get("", {}), **self.worlds.get(arm.world, {}), **arm.parameters}
