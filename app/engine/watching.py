"""What a few nodes are about to decide, and why: looked up for every snapshot, so that the window can explain it."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from ..core.actor import Actor, Argument, Run
from ..core.automaton import Automaton
from ..core.errors import UnderstudyError
from ..core.machine import Machine, Senses
from ..core.transition import Outcome
from ..core.vocabulary import NO_ENTITY
from ..sim.engine import Engine
from ..sim.sensing import KeptSenses

#: A controller's target is shown if it means the same to the first so many of its agents.
MOST_PERFORMERS = 8


@dataclass(frozen=True, slots=True)
class WatchedLevel:
    """One automaton on a node's path, as it would be evaluated now.

    Attributes:
        ticks: Since the state was entered.
        values: What it sees, by feature id; a feature that cannot be told now, such as one with an open target, is left
            out.
        outcome: The states that can come next, each once with its probability, in the order in which they are drawn;
            empty if that cannot be told now.
        arguments: Parameter -> the target that it stands for, the node that bound it, and the entity that this is to
            the node now, or -1.
    """

    type: str
    automaton: str
    state: str
    ticks: int
    values: Mapping[str, float]
    outcome: tuple[tuple[str, float], ...]
    arguments: Mapping[str, tuple[str, str, int]]


@dataclass(frozen=True, slots=True)
class Watched:
    """What a node is about to decide.

    Attributes:
        levels: The automata on its path, outermost first.
        targets: All targets that its type can bind -> the entity that each is to it now, or -1. To a controller, one is
            nobody unless it is the same to its agents.
    """

    node: str
    levels: tuple[WatchedLevel, ...]
    targets: Mapping[str, int]


def watched(engine: Engine, nodes: Iterable[str]) -> Mapping[str, Watched]:
    """What these nodes, all of which there are, are about to decide."""
    machine, sensed = engine.watch(nodes)
    senses = KeptSenses(sensed)
    return {node_id: _watched(machine, senses, machine.actors[node_id]) for node_id in nodes}


def _watched(machine: Machine, senses: Senses, actor: Actor) -> Watched:
    levels, run = [], actor.run
    while run is not None:
        if isinstance(run.behavior, Automaton):
            levels.append(_level(machine, senses, actor, run, run.behavior))
        run = run.child
    names = machine.types.vocabulary(actor.node.type).targets
    targets = {name: _entity(machine, senses, actor, Argument(name, actor.node.id)) for name in names}
    return Watched(actor.node.id, tuple(levels), targets)


def _level(machine: Machine, senses: Senses, actor: Actor, run: Run, automaton: Automaton) -> WatchedLevel:
    values = {}
    for use in automaton.features:
        try:
            values[use.id] = machine.value(actor, run, use, senses)
        except UnderstudyError:
            continue  # the tick that needs it will say what is wrong
    try:
        outcome = totals(machine.outcome(actor, run, senses))
    except UnderstudyError:
        outcome = ()
    arguments = {
        slot: (bound.target, bound.owner, _entity(machine, senses, actor, bound))
        for slot, bound in run.arguments.items()
    }
    ticks = machine.now - run.entered
    return WatchedLevel(actor.node.type, automaton.id, run.state, ticks, values, outcome, arguments)


def totals(outcome: Outcome) -> tuple[tuple[str, float], ...]:
    """The states that can come next, each once with its probability."""
    found: dict[str, float] = {}
    for state, probability in zip(outcome.states, outcome.probabilities, strict=True):
        if probability > 0.0:
            found[state] = found.get(state, 0.0) + probability
    return tuple(found.items())


def _entity(machine: Machine, senses: Senses, actor: Actor, bound: Argument) -> int:
    """What a target means to a node now; `NO_ENTITY` if it means nobody, or somebody else to each agent."""
    members = machine.actors[bound.owner].members
    try:
        found = {senses.target(bound.target, members, agent) for agent in actor.members[:MOST_PERFORMERS]}
    except UnderstudyError:
        return NO_ENTITY
    return found.pop() if len(found) == 1 else NO_ENTITY
