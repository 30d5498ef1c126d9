"""What can be asked of a session: frozen values, sent with a ticket each."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from ..core.automaton import Content
from ..core.project import Project, Value


class Others(StrEnum):
    """What the nodes that are not taught do meanwhile."""

    IDLE = "idle"
    RUN = "run"


@dataclass(frozen=True, slots=True)
class UseProject:
    """Go on with a newer value of the project; running nodes keep their places in it as far as they still exist.

    The world keeps the forest and the parameters that it began with; `Reset` takes over changes of the arm.

    Attributes:
        applied: How many of the session's edits (`app.engine.snapshots.Edit`) it contains, counted from the session's
            beginning; later ones, which were on their way to the caller, are applied to it. None: all there are.
    """

    project: Project
    applied: int | None = None


@dataclass(frozen=True, slots=True)
class UseArm:
    """Begin again with another arm.

    Attributes:
        settings: As in `app.engine.runs.treatment`.
    """

    arm: str
    settings: Mapping[str, Value] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Reset:
    """Begin the world again, with the arm as it is now in the project; a lesson or test goes on in it from Start.

    Attributes:
        seed: None keeps the seed.
    """

    seed: int | None = None


@dataclass(frozen=True, slots=True)
class RunArm:
    """Let every root run the arm's top behavior; nobody is taught."""


@dataclass(frozen=True, slots=True)
class Teach:
    """Take nodes into training mode for one automaton.

    Attributes:
        nodes: One or several of the automaton's type, taught in turn.
        arguments: Ground targets for the automaton's parameters meanwhile.
        demonstration: What the examples are filed under.
    """

    type: str
    automaton: str
    nodes: tuple[str, ...]
    arguments: Mapping[str, str] = field(default_factory=dict)
    others: Others = Others.IDLE
    demonstration: str = ""


@dataclass(frozen=True, slots=True)
class Pick:
    """The user picks what a node is to do from the next tick on.

    Attributes:
        choice: The id of a state, or what a state is to hold; a state is added where the automaton lacks it.
        hand_back: In a test, let the node decide by itself again after the next tick, as after the answer to a question.
    """

    node: str
    choice: str | Content
    hand_back: bool = False


@dataclass(frozen=True, slots=True)
class ShouldNotHaveLeft:
    """The state that a node left by itself last, it should have stayed in."""

    node: str


@dataclass(frozen=True, slots=True)
class UndoPick:
    """Take back the last pick of this lesson."""


@dataclass(frozen=True, slots=True)
class RedoPick:
    """Do again what `UndoPick` took back last, unless something else was taught since."""


@dataclass(frozen=True, slots=True)
class Test:
    """Learn what was taught, then let all nodes of the type run it."""


@dataclass(frozen=True, slots=True)
class Play:
    """Let time pass.

    Attributes:
        speed: 1 is 60 ticks a second; None goes as fast as it can.
    """

    speed: float | None = 1.0


@dataclass(frozen=True, slots=True)
class Pause:
    """Stop time."""


@dataclass(frozen=True, slots=True)
class StopAt:
    """Stop time before *tick* of this run, or now if that is over, at whatever speed it passes until then.

    None, a `Pause`, `Step`, `GoTo` or another world forgets it.
    """

    tick: int | None


@dataclass(frozen=True, slots=True)
class Step:
    """Pass some ticks, then pause."""

    ticks: int = 1


@dataclass(frozen=True, slots=True)
class MoveEntities:
    """Put agents or other entities somewhere else: one move, all or none of it, which is undone as one.

    Attributes:
        to: Entity -> where it is to be, in world units; in the order in which they are moved.
    """

    to: Mapping[int, tuple[float, float]]


@dataclass(frozen=True, slots=True)
class UndoMove:
    """Put what was moved back to where it was before.

    If no tick has passed since, the whole world is as it was; later, only the places of what was moved.

    Attributes:
        number: Of the move, see `app.engine.snapshots.Moved`.
    """

    number: int


@dataclass(frozen=True, slots=True)
class RedoMove:
    """Move entities again to where they had been moved before that was undone."""

    number: int


@dataclass(frozen=True, slots=True)
class AskMe:
    """While testing, stop before a node does what it is not sure of, and ask, see `app.engine.snapshots.Asked`.

    Attributes:
        nodes: Whose decisions are looked at; none turns asking off.
        below: Ask where the most probable next state has a probability below this; None does not ask for that reason.
        beyond: Ask where what the node sees is farther than this from every example of that state; 1 is as far apart as
            the examples of the automaton are. None does not ask for that reason.
    """

    nodes: tuple[str, ...] = ()
    below: float | None = None
    beyond: float | None = None


@dataclass(frozen=True, slots=True)
class LetGo:
    """The node that was asked about may decide by itself, here and wherever the same decides again in this test."""


@dataclass(frozen=True, slots=True)
class GoTo:
    """Go to the world as it was or will be before *tick* of this run; while no one is taught or tested.

    Any `Play`, `Pause`, `Reset`, `UseArm`, `Teach` or `GoTo` ends the journey where it is.
    """

    tick: int


@dataclass(frozen=True, slots=True)
class Watch:
    """Show in every snapshot what these nodes are about to decide, instead of those of before.

    Nodes that do not exist are left out, until they do in another arm.
    """

    nodes: tuple[str, ...] = ()


Command = (
    UseProject
    | UseArm
    | Reset
    | RunArm
    | Teach
    | Pick
    | ShouldNotHaveLeft
    | UndoPick
    | RedoPick
    | Test
    | Play
    | Pause
    | StopAt
    | Step
    | MoveEntities
    | UndoMove
    | RedoMove
    | AskMe
    | LetGo
    | GoTo
    | Watch
)
