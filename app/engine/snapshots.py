"""What a session shows of itself: frozen snapshots, and events that its caller turns into edits of the project."""

from collections.abc import Container, Mapping
from dataclasses import dataclass, field, fields
from enum import StrEnum
from functools import cached_property

from ..core.amounts import counted
from ..core.edits.examples import Recorded, record_pick, take_back_pick
from ..core.project import Demonstration, Project
from ..learner.trainer import Learned, LearnedAutomaton, apply, fingerprint
from ..sim.columns import AGENT
from ..sim.doing import BehaviorRef, Doing, StateRef
from ..sim.engine import Columns
from ..sim.world import FrozenWorld
from .commands import Teach
from .place import Place
from .watching import Watched, WatchedLevel

__all__ = [
    "Asked",
    "BehaviorRef",
    "Columns",
    "Demonstrated",
    "Doing",
    "Edit",
    "Event",
    "Failed",
    "Interrupted",
    "LessonView",
    "Mode",
    "Moved",
    "MovedEntity",
    "NodeView",
    "Picked",
    "Place",
    "Refused",
    "Relearned",
    "Snapshot",
    "StateRef",
    "TakenBack",
    "Watched",
    "WatchedLevel",
    "edited",
]


class Mode(StrEnum):
    """What the session is for at the moment."""

    RUNNING = "running"
    TEACHING = "teaching"
    LEARNING = "learning"
    TESTING = "testing"


@dataclass(frozen=True, slots=True)
class NodeView:
    """What a node does.

    Attributes:
        behavior: Name of what it was directed to do or is taught; empty if it idles.
        path: (automaton id, state id) from the outermost automaton inward.
        basic: Name of the basic behavior at the end of the path; empty in Start.
        flags: Flags that are up on it.
        taught: It does just what the user picks.
    """

    behavior: str = ""
    path: tuple[tuple[str, str], ...] = ()
    basic: str = ""
    flags: frozenset[str] = frozenset()
    taught: bool = False


@dataclass(frozen=True, slots=True)
class LessonView:
    """What is being taught or tested.

    Attributes:
        testing: What was learned is being tested.
        taught: The nodes that do just what the user picks.
        acts: How many can be taken back with `UndoPick`.
        waiting: The nodes whose pick no tick has carried out yet.
        obstacle: Why what is done cannot be kept as a demonstration, see `Demonstrated`.
    """

    plan: Teach
    testing: bool
    taught: frozenset[str]
    acts: int
    waiting: frozenset[str]
    obstacle: str = field(default="", compare=False)


@dataclass(frozen=True, slots=True)
class Asked:
    """Time stands still, since a node that is tested is about to do what it is not sure of, see `AskMe`.

    `Pick` answers what it is to do, `LetGo` that it may decide by itself.

    Attributes:
        type, automaton: What is tested.
        state: The node's current state in it.
        values: What it sees, by feature id.
        outcome: The states that can come next, each once with its probability, the most probable first.
        reason: Why it is asked, in words.
        confidence: The probability of the most probable next state.
        distance: How far what it sees is from the nearest example of that state, as in `AskMe`; infinite if it has none.
    """

    node: str
    type: str
    automaton: str
    state: str
    values: Mapping[str, float]
    outcome: tuple[tuple[str, float], ...]
    reason: str
    confidence: float
    distance: float


@dataclass(frozen=True, eq=False)  # no slots: what is derived is kept once it was asked for
class Snapshot:
    """The session between two ticks.

    Two are equal if the same can be read from them, however the ticks were passed.

    Attributes:
        acknowledged: The last ticket that was dealt with.
        tick: The tick that comes next.
        revision: Grows with every change of the session's copy of the project.
        speed: As in `Play`; 0 when paused.
        failure: What stopped the engine, in words; empty if nothing did.
        columns: The world's columns, read-only: entries are entities, agents first, then each kind in its order.
        place: What does not change while this world lives.
        doing: What all nodes do.
        taught: The nodes that do just what the user picks.
        watched: What the nodes of the last `Watch` are about to decide, as far as there are such nodes.
        engine: ``compiled`` or ``reference``: what passes the ticks.
        notice: What is going on with the engine, or why it is not the compiled one; empty if there is nothing to say.
        lesson: What is being taught or tested, if anything is.
        asked: What the user has been asked and has not answered yet.
        going_to: The tick that a `GoTo` is on its way to.
        stops_at: The tick before which time stops, see `StopAt`; None if it just goes on.
        earliest: The first tick of the run that can be gone back to.
    """

    acknowledged: int
    tick: int
    revision: int
    mode: Mode
    speed: float | None
    seed: int
    arm: str
    columns: Columns = field(repr=False, compare=False)
    place: Place = field(compare=False)
    doing: Doing = field(repr=False, compare=False)
    measures: Mapping[str, float]
    taught: frozenset[str] = field(default=frozenset(), repr=False)
    watched: Mapping[str, Watched] = field(default_factory=dict, repr=False)
    engine: str = field(default="", compare=False)
    notice: str = field(default="", compare=False)
    failure: str = ""
    lesson: LessonView | None = None
    asked: Asked | None = None
    going_to: int | None = None
    stops_at: int | None = None
    earliest: int = field(default=0, compare=False)

    __hash__ = None  # type: ignore[assignment]  # arrays have none

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Snapshot):
            return NotImplemented
        compared = [f.name for f in fields(self) if f.compare] + ["world", "nodes"]
        return all(getattr(self, name) == getattr(other, name) for name in compared)

    @cached_property
    def world(self) -> FrozenWorld:
        """The columns as plain numbers; worked out when it is first asked for."""
        return {name: tuple(column.tolist()) for name, column in self.columns.items()}

    @cached_property
    def nodes(self) -> Mapping[str, NodeView]:
        """What every node does, by id; worked out when it is first asked for."""
        return views_of(self.doing, self.taught)

    def node(self, node_id: str) -> NodeView:
        """What one node does; it costs nothing that grows with their number."""
        doing, row = self.doing, self.doing.row(node_id)
        behavior, state, flags = (part[row].tolist() for part in (doing.behavior, doing.state, doing.flags))
        return _view(doing, behavior, state, flags, taught=node_id in self.taught)


@dataclass(frozen=True, slots=True)
class Picked:
    """A pick was recorded."""

    recorded: Recorded


@dataclass(frozen=True, slots=True)
class Demonstrated:
    """What the hand has done in the lesson so far, after it has taught something or taken it back.

    Attributes:
        demonstration: Played, it records the lesson's examples again; None if there are none.
        obstacle: Why it would not; empty if it would.
    """

    demonstration: Demonstration | None
    obstacle: str = ""


@dataclass(frozen=True, slots=True)
class TakenBack:
    """A pick was taken back, or replaced by the one after."""

    recorded: Recorded


@dataclass(frozen=True, slots=True)
class Relearned:
    """Models were learned."""

    learned: Learned


@dataclass(frozen=True, slots=True)
class Refused:
    """A command could not be obeyed, or the engine failed; the message says why and what can be done."""

    ticket: int
    message: str


@dataclass(frozen=True, slots=True)
class Failed(Refused):
    """The world failed, as snapshots say for as long as it is so."""


@dataclass(frozen=True, slots=True)
class Interrupted:
    """Something ended by itself, because an edit took away what it was about; the message says what."""

    message: str


@dataclass(frozen=True, slots=True)
class MovedEntity:
    """One of those that were moved.

    Attributes:
        kind: Of the entity.
        name: What the user calls it.
        before, after: Its places, in world units; *after* is where the scenario let it go.
    """

    entity: int
    kind: str
    name: str
    before: tuple[float, float]
    after: tuple[float, float]


@dataclass(frozen=True, slots=True)
class Moved:
    """The user moved entities, all at once.

    Attributes:
        number: Names the move for `UndoMove` and `RedoMove`.
    """

    entities: tuple[MovedEntity, ...]
    number: int

    @property
    def words(self) -> str:
        """What was moved: its name, or how many there were."""
        if len(self.entities) == 1:
            return self.entities[0].name
        agents = all(moved.kind == AGENT for moved in self.entities)
        return counted(len(self.entities), "agent" if agents else "thing")


#: What changed the session's copy of the project, and is to change the caller's in the same way, see `edited`.
Edit = Picked | TakenBack | Relearned
Event = Edit | Refused | Interrupted | Asked | Moved | Demonstrated


def edited(project: Project, edit: Edit) -> Project:
    """*project* with one of the session's edits.

    Of what was learned, only that is put in which was learned from the examples that *project* has.

    Raises:
        EditError: *project* has changed so much that the edit is not possible.
    """
    match edit:
        case Picked(recorded):
            return record_pick(project, recorded)
        case TakenBack(recorded):
            return take_back_pick(project, recorded)
        case Relearned(learned):
            fitting = {where: new for where, new in learned.automata.items() if _fits(project, where, new)}
            return apply(project, Learned(fitting))


def _fits(project: Project, where: tuple[str, str], new: LearnedAutomaton) -> bool:
    automaton = project.library(where[0]).automata.get(where[1])
    return automaton is not None and fingerprint(automaton, project.examples_of(*where)) == new.fingerprint


def views_of(doing: Doing, taught: Container[str] = ()) -> Mapping[str, NodeView]:
    """What every node does, by id."""
    behavior, state, flags = doing.behavior.tolist(), doing.state.tolist(), doing.flags.tolist()
    return {
        node_id: _view(doing, behavior[row], state[row], flags[row], taught=node_id in taught)
        for node_id, row in doing.rows.items()
    }


def _view(
    doing: Doing, behavior: list[int], state: list[int], flags: list[bool], *, taught: bool
) -> NodeView:
    runs = [doing.behaviors[what] for what in behavior if what >= 0]
    path = tuple((doing.states[where].automaton, doing.states[where].state) for where in state if where >= 0)
    basic = runs[-1].name if runs and not runs[-1].id else ""
    up = frozenset(name for name, is_up in zip(doing.flag_names, flags, strict=True) if is_up)
    return NodeView(runs[0].name if runs else "", path, basic, up, taught)
