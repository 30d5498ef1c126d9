"""Playing stored demonstrations through the teaching session: the same hand, the same examples, byte for byte."""

from collections.abc import Callable, Collection
from itertools import groupby

from ..core.edits.examples import replace_examples
from ..core.errors import SessionError
from ..core.project import Demonstration, Pick, Project
from ..learner.trainer import apply, learn
from ..sim.scenario import Scenario
from .commands import Command, Others, ShouldNotHaveLeft, Teach, Test, UndoPick, UseArm
from .commands import Pick as PickCommand
from .session import Session
from .snapshots import Refused

#: Told which part of the whole is done, and what comes next.
Progress = Callable[[float, str], None]


def play(project: Project, scenario: Scenario, demonstration: Demonstration) -> Project:
    """The project with the examples that *demonstration* records.

    Raises:
        SessionError: An act of the demonstration cannot be carried out; the message names it.
    """
    session = Session(project, scenario, demonstration.arm, demonstration.seed)
    settings = {f"world.{name}": value for name, value in demonstration.parameters.items()}
    _send(session, UseArm(demonstration.arm, settings), demonstration)
    for tick, command in commands(demonstration):
        _until(session, tick, demonstration)
        _send(session, command, demonstration)
        session.settle()
    _until(session, demonstration.ticks, demonstration)
    session.close()
    return session.project


def commands(demonstration: Demonstration) -> list[tuple[int, Command]]:
    """What to send before which tick.

    Nodes are taken into training mode by acts ``teach``, those of one tick together; a demonstration without any begins
    with all nodes that it picks for.

    Raises:
        SessionError: There is no such act.
    """
    acts = list(demonstration.picks)
    if not any(act.act == "teach" for act in acts):
        nodes = dict.fromkeys(act.node for act in acts if act.node)
        acts = [*(Pick(0, node, act="teach") for node in nodes), *acts]
    found: list[tuple[int, Command]] = []
    for (tick, kind), group in groupby(acts, key=lambda act: (act.tick, act.act)):
        if kind == "teach":
            found.append((tick, _teach(demonstration, tuple(act.node for act in group))))
        else:
            found += [(tick, _command(act)) for act in group]
    return found


def _teach(demonstration: Demonstration, nodes: tuple[str, ...]) -> Teach:
    return Teach(
        demonstration.type,
        demonstration.automaton,
        nodes,
        demonstration.arguments,
        Others(demonstration.others),
        demonstration.id,
    )


def _command(act: Pick) -> Command:
    match act.act:
        case "pick":
            return PickCommand(act.node, act.state)
        case "should not have left":
            return ShouldNotHaveLeft(act.node)
        case "undo":
            return UndoPick()
        case "test":
            return Test()
    raise SessionError(f"{act.act!r} is no act; allowed: pick, should not have left, undo, test, teach")


def recreate(
    project: Project,
    scenario: Scenario,
    only: Collection[tuple[str, str]] | None = None,
    progress: Progress | None = None,
    cancelled: Callable[[], bool] | None = None,
) -> Project:
    """Record all examples anew by playing the demonstrations in their order, learning each behavior on the way.

    What an automaton was taught by other means than a stored demonstration is dropped with its old examples.

    Args:
        only: (type, automaton id) pairs to record anew; all that have demonstrations if None.
    """
    chosen = [d for d in project.demonstrations if only is None or (d.type, d.automaton) in only]
    for type_name, automaton_id in dict.fromkeys((d.type, d.automaton) for d in chosen):
        project = replace_examples(project, type_name, automaton_id, (), {})
    for done, demonstration in enumerate(chosen):
        if cancelled is not None and cancelled():
            raise SessionError("cancelled; nothing was changed")
        if progress is not None:
            progress(done / len(chosen), f"playing {demonstration.id}")
        project = play(project, scenario, demonstration)
        wanted = [(demonstration.type, demonstration.automaton)]
        project = apply(project, learn(project, scenario.vocabulary, wanted))
    if progress is not None:
        progress(1.0, "done")
    return project


def _send(session: Session, command: Command, demonstration: Demonstration) -> None:
    session.send(command)
    for event in session.events():
        if isinstance(event, Refused):
            tick = session.snapshot().tick
            raise SessionError(f"demonstration {demonstration.id!r}, tick {tick}: {event.message}")


def _until(session: Session, tick: int, demonstration: Demonstration) -> None:
    """Let time pass up to *tick*."""
    missing = tick - session.tick
    if missing < 0:
        raise SessionError(f"demonstration {demonstration.id!r}: tick {tick} comes after tick {session.tick}")
    if missing:
        session.advance(missing)
    for event in session.events():
        if isinstance(event, Refused):
            raise SessionError(f"demonstration {demonstration.id!r}, tick {session.tick}: {event.message}")
