"""What every engine offers, so that one can replace another without a change elsewhere."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

from numpy.typing import NDArray

from ..core.actor import Actor
from ..core.hierarchy import Hierarchy
from ..core.library import Types
from ..core.machine import Arguments, Machine, Senses
from ..core.machine_state import MachineState
from ..core.project import Value
from .doing import Doing
from .scenario import Scenario
from .world import FrozenWorld

#: The world's columns by name, read-only.
Columns = Mapping[str, NDArray[Any]]


@dataclass(frozen=True, slots=True)
class Start:
    """Everything that a run begins with.

    Attributes:
        parameters: All of the scenario's parameters, as `Scenario.settle` returns them.
        top: Name of the behavior that every root starts with; empty leaves all idle.
    """

    scenario: Scenario
    parameters: Mapping[str, Value]
    hierarchy: Hierarchy
    types: Types
    seed: int
    world: int = 0
    top: str = ""
    arguments: Arguments = field(default_factory=dict)
    physics: str = "kinematic"


@dataclass(frozen=True, slots=True)
class Control:
    """Who decides in a tick.

    Attributes:
        picks: Node id -> state that the user picked.
        taught: Nodes that change state by picks only.
        still: Nodes that do not tick.
        listen: Whether the engine's observer has to be told who leaves a state; nobody listening is faster.
    """

    picks: Mapping[str, str] = field(default_factory=dict)
    taught: frozenset[str] = frozenset()
    still: frozenset[str] = frozenset()
    listen: bool = True


FREE = Control()


class Past(Protocol):
    """A tick that has passed, to be looked back on.

    Attributes:
        tick: Its number.
        left: The nodes that left a state other than Start at their top, with the automata that they run; only nodes
            without a controller that ticked, since who has one may have been directed.
    """

    tick: int
    left: tuple[tuple[str, str], ...]

    def watch(self, nodes: Iterable[str]) -> tuple[Machine, Senses]:
        """What these nodes and all below them did and sensed when the tick began; until something else is looked at."""

    def replay(self, leaving: Callable[[Machine, Actor], None]) -> None:
        """Let all nodes decide once more as they did, and tell who leaves a state at its top, before it happens."""

    def frozen_world(self) -> FrozenWorld:
        """The world when the tick began."""


#: Told of ticks in which somebody left a state.
Departed = Callable[[Past], None]


class Engine(Protocol):
    """A world with its nodes, stepped tick by tick.

    Attributes:
        start: What the run began with.
        obstacle: Why free ticks cannot be compiled; empty if they are, or if that was not asked for.
        departed: Told after each compiled tick with a control that listens; without it, such ticks are not compiled. Of
            ticks that are not, the observer is told while they pass.
    """

    start: Start
    obstacle: str
    departed: Departed | None

    @property
    def compiled(self) -> bool:
        """Whether free ticks are compiled."""

    @property
    def tick(self) -> int:
        """The tick that comes next; as many have passed."""

    @property
    def machine(self) -> Machine:
        """What all nodes do now."""

    @property
    def shown(self) -> Machine:
        """The same, only to be looked at, which may be faster."""

    @property
    def senses(self) -> Senses:
        """What can be sensed now."""

    def step(self, ticks: int = 1, control: Control = FREE) -> None:
        """Pass ticks; picks take effect in the first of them.

        Raises:
            ScenarioError: A function of the scenario failed; the message names it, with file and line.
            SessionError: A pick names a node or state that is not there; no tick has passed then.
        """

    def frozen_world(self) -> FrozenWorld:
        """A copy of the world."""

    def columns(self) -> Columns:
        """The same as arrays, much faster.

        Raises:
            ScenarioError: The scenario has put something into a column that does not belong there.
        """

    def frozen_nodes(self) -> MachineState:
        """A copy of what all nodes do now; it may be worked out later, since of many that are kept few are looked at."""

    def doing(self) -> Doing:
        """What all nodes do now, as arrays."""

    def watch(self, nodes: Iterable[str]) -> tuple[Machine, Senses]:
        """What these nodes and all below them do and can sense now, only to be looked at until time passes.

        Other nodes of that machine may not be up to date.
        """

    def spans(self) -> Mapping[str, range]:
        """The entities of each kind, agents included."""

    def restore(
        self, world: Mapping[str, Sequence[float] | Sequence[int]], machine: Mapping[str, object]
    ) -> None:
        """Go back to a copied world, and to what all nodes did then."""

    def move(self, entity: int, x: float, y: float) -> None:
        """Put an entity somewhere else, in world units, as far as the scenario allows.

        Raises:
            ScenarioError: There is no such entity, the place is not finite, or the scenario's own function failed.
        """

    def move_all(self, moves: Sequence[tuple[int, float, float]]) -> None:
        """Put entities, each given with where to, somewhere else, as `move` does one after the other.

        Raises:
            ScenarioError: As above; those before it have been moved.
        """

    def measures(self) -> Mapping[str, float]:
        """The scenario's measures now."""

    @property
    def progressed(self) -> int:
        """The tick of the last progress, -1 if there was none."""
