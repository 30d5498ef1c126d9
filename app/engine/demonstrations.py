"""Playing stored demonstrations through the teaching session: the same hand, the same examples, byte for byte."""

from collections.abc import Callable, Collection, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from itertools import groupby

from ..core.automaton import State
from ..core.edits.examples import replace_examples
from ..core.edits.learned import set_learned
from ..core.edits.moments import with_moments, without_stray_moments
from ..core.edits.place import change, with_examples
from ..core.edits.states import remove_state
from ..core.errors import SessionError, UnderstudyError
from ..core.project import Demonstration, Pick, Project
from ..learner.builder import LearningCancelled
from ..learner.trainer import apply, learn
from ..sim.engines import REFERENCE
from ..sim.scenario import Scenario
from .commands import (
    Command,
    MoveEntities,
    Others,
    RedoPick,
    ShouldNotHaveLeft,
    Teach,
    Test,
    UndoPick,
    UseProject,
)
from .commands import Pick as PickCommand
from .session import Session
from .snapshots import Refused


@dataclass(frozen=True, slots=True)
class Learn:
    """Learn from the examples that there are, in the middle of a test, as the window does in the background."""


#: Told which part of the whole is done, and what comes next.
Progress = Callable[[float, str], None]
Cancelled = Callable[[], bool]
#: Type name and automaton id.
Where = tuple[str, str]

#: How many ticks pass between two questions whether to go on.
SLICE = 20


def play(
    project: Project,
    scenario: Scenario,
    demonstration: Demonstration,
    passed: Callable[[int], None] | None = None,
) -> Project:
    """The project with the examples that *demonstration* records.

    States that were removed since are there while it is played, and are removed once more after it.

    Args:
        passed: Told now and then how many ticks have passed; it may raise to end the play.

    Raises:
        SessionError: An act of the demonstration cannot be carried out; the message names it.
    """
    return _Play(project, scenario, demonstration, passed or (lambda _: None)).project()


def commands(demonstration: Demonstration) -> list[tuple[int, Command | Learn]]:
    """What to send before which tick.

    Nodes are taken into training mode by acts ``teach``, those of one tick together; a demonstration without any begins
    with all nodes that it picks for.

    Raises:
        SessionError: There is no such act, or the acts are not in order.
    """
    acts = list(demonstration.picks)
    if not any(act.act == "teach" for act in acts):
        nodes = dict.fromkeys(act.node for act in acts if act.node)
        acts = [*(Pick(0, node, act="teach") for node in nodes), *acts]
    found: list[tuple[int, Command | Learn]] = []
    for (tick, kind), group in groupby(acts, key=lambda act: (act.tick, act.act)):
        if kind == "teach":
            found.append((tick, _teach(demonstration, tuple(act.node for act in group))))
        else:
            found += [(tick, _command(act, demonstration)) for act in group]
    return found


def _teach(demonstration: Demonstration, nodes: tuple[str, ...]) -> Teach:
    if demonstration.others not in list(Others):
        allowed = ", ".join(Others)
        raise SessionError(
            f"demonstration {demonstration.id!r}: others cannot be {demonstration.others!r}; allowed: {allowed}"
        )
    return Teach(
        demonstration.type,
        demonstration.automaton,
        nodes,
        demonstration.arguments,
        Others(demonstration.others),
        demonstration.id,
    )


def _command(act: Pick, demonstration: Demonstration) -> Command | Learn:
    match act.act:
        case "pick":
            return PickCommand(act.node, act.state)
        case "answer":
            return PickCommand(act.node, act.state, hand_back=True)
        case "should not have left":
            return ShouldNotHaveLeft(act.node)
        case "undo":
            return UndoPick()
        case "redo":
            return RedoPick()
        case "test":
            return Test()
        case "learn":
            return Learn()
        case "move" if act.entity is not None and act.x is not None and act.y is not None:
            return MoveEntities({act.entity: (act.x, act.y)})
        case "move":
            raise SessionError(
                f"demonstration {demonstration.id!r}, tick {act.tick:,}: a move needs an entity, x and y"
            )
    raise SessionError(
        f"demonstration {demonstration.id!r}, tick {act.tick:,}: {act.act!r} is no act; allowed: pick, answer, should not have "
        "left, undo, redo, test, learn, teach, move"
    )


class _Play:
    """One demonstration while it is played."""

    def __init__(
        self,
        project: Project,
        scenario: Scenario,
        demonstration: Demonstration,
        passed: Callable[[int], None],
    ) -> None:
        self._demonstration = demonstration
        self._passed = passed
        self._kept = project.demonstrations
        self._vocabulary = scenario.vocabulary
        settings = {f"world.{name}": value for name, value in demonstration.parameters.items()}
        settings["engine"] = REFERENCE  # it steps lessons in any case, so nothing is compiled first
        with self._blaming():
            arm, seed = demonstration.arm, demonstration.seed
            project, self._revived = _with_removed(project, demonstration)
            self._session = Session(project, scenario, arm, seed, settings=settings)

    def project(self) -> Project:
        """The project with what the demonstration recorded."""
        for tick, command in commands(self._demonstration):
            self._until(tick)
            self._send(self._learned() if isinstance(command, Learn) else command)
        self._until(self._demonstration.ticks)
        self._session.close()
        return self._without_revived(self._session.project)

    def _without_revived(self, project: Project) -> Project:
        where = where_of(self._demonstration)
        for state in self._revived:
            if project.library(where[0]).get(where[1]).has_state(state.id):
                project = remove_state(project, *where, state.id)
        return replace(project, demonstrations=self._kept)

    def _learned(self) -> Command:
        project, where = self._session.project, where_of(self._demonstration)
        return UseProject(apply(project, learn(project, self._vocabulary, [where])))

    def _send(self, command: Command) -> None:
        self._session.send(command)
        self._session.settle()
        self._refuse_refused()

    def _until(self, tick: int) -> None:
        """Let time pass up to *tick*."""
        if tick < self._session.tick:
            raise SessionError(f"{self._name}: tick {tick:,} comes after tick {self._session.tick:,}")
        while self._session.tick < tick:
            self._session.pass_ticks(min(SLICE, tick - self._session.tick))
            self._refuse_refused()
            self._passed(self._session.tick)

    def _refuse_refused(self) -> None:
        for event in self._session.events():
            if isinstance(event, Refused):
                raise SessionError(f"{self._name}, tick {self._session.tick:,}: {event.message}")

    @property
    def _name(self) -> str:
        return f"demonstration {self._demonstration.id!r}"

    @contextmanager
    def _blaming(self) -> Iterator[None]:
        try:
            yield
        except UnderstudyError as error:
            raise SessionError(f"{self._name}: {error}") from error


# ------------------------------------------------------------------------------------------- all of them


def recreate(
    project: Project,
    scenario: Scenario,
    only: Collection[Where] | None = None,
    progress: Progress | None = None,
    cancelled: Cancelled | None = None,
) -> Project:
    """Record all examples anew by playing the demonstrations in their order, learning each behavior on the way.

    A demonstration finds every behavior as it was learned from the demonstrations before it, and only from them, so that
    the result depends on the lists alone. What an automaton was taught by other means than a stored demonstration is
    dropped with its old examples.

    Args:
        only: (type, automaton id) pairs to record anew; all that have demonstrations if None. The stored examples of the
            others stand for their demonstrations.

    Raises:
        SessionError: An act cannot be carried out, or *cancelled* returned true.
    """
    every = [(where_of(d), d) for d in project.demonstrations]
    chosen = {where: None for where, _ in every if only is None or where in only}
    needed = every[: 1 + max((n for n, (where, _) in enumerate(every) if where in chosen), default=-1)]
    tell = _Teller(sum(d.ticks for where, d in needed if where in chosen), progress, cancelled)
    stage = _untaught(project, {where for where, _ in every})
    for number, (where, demonstration) in enumerate(needed):
        if where in chosen:
            stage = play(stage, scenario, demonstration, tell.begin(demonstration))
            stage = _learned(stage, scenario, where, tell)
        elif where in [later for later, _ in every[number + 1 :]]:
            stored = [e for e in project.examples_of(*where) if e.demonstration == demonstration.id]
            stage = with_examples(stage, *where, (*stage.examples_of(*where), *stored))
            stage = _learned(stage, scenario, where, tell)
        else:
            stage = _copied(project, stage, where)
    tell.end()
    for where in chosen:
        project = _copied(stage, project, where)
    return project


def where_of(demonstration: Demonstration) -> Where:
    """What a demonstration teaches."""
    return demonstration.type, demonstration.automaton


def _with_removed(project: Project, demonstration: Demonstration) -> tuple[Project, tuple[State, ...]]:
    """*project* with the states that the demonstration picks and the automaton has no longer, and these."""
    automaton = project.library(demonstration.type).automata.get(demonstration.automaton)
    if automaton is None:
        return project, ()
    lacking = tuple(state for state in demonstration.removed if not automaton.has_state(state.id))
    states = (*automaton.states, *lacking)
    return change(project, *where_of(demonstration), states=states), lacking


def _untaught(project: Project, taught: Collection[Where]) -> Project:
    """*project* as it was before these automata were taught; those that are gone cannot be, which playing will tell."""
    for where in taught:
        if where[1] not in project.library(where[0]).automata:
            continue
        project = replace_examples(project, *where, (), {})
        project = set_learned(project, *where, {}, "")
    return project


def _learned(project: Project, scenario: Scenario, where: Where, tell: "_Teller") -> Project:
    if not project.examples_of(*where):
        return project
    try:
        return apply(project, learn(project, scenario.vocabulary, [where], cancelled=tell.cancelled))
    except LearningCancelled:
        raise _cancelled() from None


def _copied(source: Project, into: Project, where: Where) -> Project:
    """*into* with the examples and models that an automaton has in *source*."""
    automaton, examples = source.library(where[0]).get(where[1]), source.examples_of(*where)
    into = set_learned(into, *where, automaton.learned, automaton.learned_from)
    missing = {e.snapshot for e in examples} & (source.moments.keys() - into.moments.keys())
    moments = {snapshot: source.moments[snapshot] for snapshot in sorted(missing)}
    return without_stray_moments(with_moments(with_examples(into, *where, examples), moments))


class _Teller:
    """Tells how far the whole is, and asks whether to go on."""

    def __init__(self, ticks: int, progress: Progress | None, cancelled: Cancelled | None) -> None:
        self._ticks = max(1, ticks)
        self._progress = progress
        self.cancelled = cancelled or (lambda: False)
        self._done = 0

    def begin(self, demonstration: Demonstration) -> Callable[[int], None]:
        """A demonstration begins; it is to call what this returns with the ticks that have passed in it."""
        before, self._done = self._done, self._done + demonstration.ticks

        def passed(ticks: int) -> None:
            if self.cancelled():
                raise _cancelled()
            self._tell((before + ticks) / self._ticks, f"playing {demonstration.id}")

        passed(0)
        return passed

    def end(self) -> None:
        """All have been played."""
        self._tell(1.0, "done")

    def _tell(self, share: float, what: str) -> None:
        if self._progress is not None:
            self._progress(min(1.0, share), what)


def _cancelled() -> SessionError:
    return SessionError("cancelled; nothing was changed")
