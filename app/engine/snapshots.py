"""What a session shows of itself: frozen snapshots, and events that its caller turns into edits of the project."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from ..core.actor import Actor, Run
from ..core.automaton import Automaton
from ..core.edits.examples import Recorded
from ..learner.trainer import Learned
from ..sim.world import FrozenWorld


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
class Snapshot:
    """The session between two ticks.

    Attributes:
        acknowledged: The last ticket that was dealt with.
        tick: The tick that comes next.
        revision: Grows with every change of the session's copy of the project.
        speed: As in `Play`; 0 when paused.
        failure: What stopped the engine, in words; empty if nothing did.
    """

    acknowledged: int
    tick: int
    revision: int
    mode: Mode
    speed: float | None
    seed: int
    arm: str
    world: FrozenWorld = field(repr=False)
    nodes: Mapping[str, NodeView] = field(repr=False)
    measures: Mapping[str, float]
    failure: str = ""


@dataclass(frozen=True, slots=True)
class Picked:
    """A pick was recorded: apply `record` with it."""

    recorded: Recorded


@dataclass(frozen=True, slots=True)
class TakenBack:
    """A pick was taken back: apply `take_back` with it."""

    recorded: Recorded


@dataclass(frozen=True, slots=True)
class Relearned:
    """Models were learned: apply `app.learner.trainer.apply` with them."""

    learned: Learned


@dataclass(frozen=True, slots=True)
class Refused:
    """A command could not be obeyed, or the engine failed; the message says why and what can be done."""

    ticket: int
    message: str


Event = Picked | TakenBack | Relearned | Refused


def view(actor: Actor, *, taught: bool) -> NodeView:
    """What *actor* does."""
    path, basic, run = [], "", actor.run
    while run is not None:
        if isinstance(run.behavior, Automaton):
            path.append((run.behavior.id, run.state))
        else:
            basic = run.behavior.name
        run = run.child
    flags = actor.flags | (actor.run.flags if actor.run else set())
    return NodeView(_name(actor.run), tuple(path), basic, frozenset(flags), taught)


def _name(run: Run | None) -> str:
    return "" if run is None else run.behavior.name
