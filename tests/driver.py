"""Drives a session as a user does: ``driver.teach("agent-1", "Shuttle").pick("up").advance(10).test()``.

The driver is the session's caller: it owns a project of its own, to which it applies the edits that the session reports,
and compares the two all the time. What the session refuses fails the test, unless the test expects it.
"""

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any

from app.core.automaton import Automaton, Basic, Content, Nested, RaiseFlag
from app.core.examples import Example
from app.core.project import Demonstration, Project
from app.engine.commands import (
    Command,
    Others,
    Pick,
    RedoPick,
    Reset,
    RunArm,
    ShouldNotHaveLeft,
    Teach,
    Test,
    UndoPick,
    UseProject,
)
from app.engine.learning import Learner
from app.engine.session import Session
from app.engine.snapshots import (
    Asked,
    Demonstrated,
    Edit,
    Event,
    Interrupted,
    Mode,
    Moved,
    NodeView,
    Refused,
    Snapshot,
    edited,
)
from app.sim.scenario import Scenario
from tests import corridor

#: What a test of teaching needs no kernel for.
UNCOMPILED = {"engine": "reference"}


class Driver:
    """A user at a session.

    Attributes:
        session: The session.
        project: The caller's, kept by applying the session's edits.
        interruptions: What the session told of things that ended by themselves.
        told: What it asked, and what was moved.
        demonstration, obstacle: What the hand has done, as the session told it last, and why that would not do it again.
    """

    def __init__(
        self,
        project: Project | None = None,
        arm: str = "alone",
        seed: int = 1,
        learner: Learner | None = None,
        scenario: Scenario = corridor.corridor,
        **settings: Any,
    ) -> None:
        self.project = project or corridor.project()
        world = {f"world.{name}": value for name, value in settings.items()}
        self.session = Session(self.project, scenario, arm, seed, learner, world | UNCOMPILED)
        self.interruptions: list[str] = []
        self.told: list[Asked | Moved] = []
        self.problems: list[str] = []
        self.demonstration: Demonstration | None = None
        self.obstacle = ""
        self._lesson = ("agent", "Shuttle")
        self._node = "agent-1"

    # -------------------------------------------------------------------------------------------- the hand

    def teach(
        self,
        nodes: str | Iterable[str],
        automaton: str,
        others: Others = Others.IDLE,
        demonstration: str = "",
        **arguments: str,
    ) -> "Driver":
        """Take nodes into training mode; the first is the one picked for from now on."""
        chosen = (nodes,) if isinstance(nodes, str) else tuple(nodes)
        self._node = chosen[0]
        self._lesson = chosen[0].rpartition("-")[0], automaton
        return self.send(Teach(*self._lesson, chosen, arguments, others, demonstration))

    def pick(self, choice: str | Content, node: str = "") -> "Driver":
        """Pick a state by id, a behavior by name, or what a state is to hold."""
        self._node = node or self._node
        return self.send(Pick(self._node, self.meant(choice)))

    def meant(self, choice: str | Content) -> str | Content:
        """A state's id if there is one, or else what a state would hold."""
        if not isinstance(choice, str) or self.automaton.has_state(choice):
            return choice
        held = self.session.project.library(self._lesson[0]).by_name(choice)
        return Nested(held.id) if held else Basic(choice)

    def flag(self, name: str) -> "Driver":
        """Pick a flag to be raised."""
        return self.pick(RaiseFlag(name))

    def should_not_have_left(self, node: str = "") -> "Driver":
        """Say so of the state that the node left last."""
        return self.send(ShouldNotHaveLeft(node or self._node))

    def undo(self) -> "Driver":
        """Take the last pick back."""
        return self.send(UndoPick())

    def redo(self) -> "Driver":
        """Do again the pick that was taken back last."""
        return self.send(RedoPick())

    def test(self) -> "Driver":
        """Learn, and let all run it."""
        self.send(Test())
        self.session.settle()
        return self.listen()

    def run(self) -> "Driver":
        """Let the arm run."""
        return self.send(RunArm())

    def reset(self, seed: int | None = None) -> "Driver":
        """Begin the world again."""
        return self.send(Reset(seed))

    def advance(self, ticks: int = 1) -> "Driver":
        """Let time pass."""
        self.session.advance(ticks)
        return self.listen()

    def edit(self, change: Callable[..., Any], *args: Any, **kwargs: Any) -> "Driver":
        """Make an edit of the caller's own."""
        made = change(self.project, *args, **kwargs)
        self.project = made[0] if isinstance(made, tuple) else made
        return self.send(UseProject(self.project))

    def send(self, command: Command) -> "Driver":
        """Send any command."""
        self.session.send(command)
        return self.listen()

    def refused(self, command: Command) -> str:
        """Send a command that has to be refused without changing anything; its message."""
        before, looked, acts = self.session.project, self.look(), self.acts
        ticket = self.session.send(command)
        self.session.settle()
        (refusal,) = self.session.events()
        assert isinstance(refusal, Refused), f"not refused: {refusal}"
        assert refusal.ticket == ticket
        assert self.session.project is before
        assert (self.look(), self.acts) == (looked, acts)
        return refusal.message

    def listen(self) -> "Driver":
        """Apply what the session reports, and compare."""
        for event in self.session.events():
            self._hear(event)
        assert self.project == self.session.project, "the caller's project differs from the session's"
        return self

    def _hear(self, event: Event) -> None:
        match event:
            case Refused(_, message):
                self.problems.append(message)
                raise AssertionError(f"refused: {message}")
            case Interrupted(message):
                self.interruptions.append(message)
            case Demonstrated(demonstration, obstacle):
                self.demonstration, self.obstacle = demonstration, obstacle
            case Asked() | Moved():
                self.told.append(event)
            case _:
                edit: Edit = event
                self.project = edited(self.project, edit)

    # -------------------------------------------------------------------------------------------- the eyes

    @property
    def snapshot(self) -> Snapshot:
        """What the session shows."""
        return self.session.snapshot()

    def look(self) -> Snapshot:
        """All that a user sees, but the ticket."""
        return replace(self.snapshot, acknowledged=0)

    @property
    def acts(self) -> list[str]:
        """The goals of what can be undone."""
        lesson = self.session._lesson
        return [act.goal for act in lesson.acts] if lesson else []

    @property
    def mode(self) -> Mode:
        """What the session is for now."""
        return self.session.mode

    def view(self, node: str = "") -> NodeView:
        """What a node does."""
        return self.snapshot.nodes[node or self._node]

    def state(self, node: str = "") -> str:
        """The states that a node is in, outermost first: ``signal/up``."""
        return "/".join(state for _, state in self.view(node).path)

    def does(self, ticks: int, node: str = "") -> list[str]:
        """Pass ticks; the basic behavior that a node showed after each."""
        return [self.advance().view(node).basic for _ in range(ticks)]

    def place(self, agent: int = 1) -> float:
        """Where an agent stands, numbered from 1 like its name."""
        return self.snapshot.world["x"][agent - 1]

    @property
    def automaton(self) -> Automaton:
        """What is taught."""
        return self.session.project.library(self._lesson[0]).get(self._lesson[1])

    @property
    def examples(self) -> tuple[Example, ...]:
        """What was recorded for it."""
        return self.project.examples_of(*self._lesson)

    @property
    def taught(self) -> list[str]:
        """The examples in short: ``start>up`` for a transition, ``up>up+`` for a continuation."""
        return [f"{e.source}>{e.label}" + "+" * e.continuation for e in self.examples]
