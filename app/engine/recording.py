"""From a user's pick to examples: <B, f, B'>, and the continuation <B', f, B'> (paper, section 3.1)."""

from collections.abc import Mapping
from dataclasses import dataclass

from ..core.actor import Actor, Run
from ..core.automaton import Automaton, Basic, RaiseFlag, Start, State
from ..core.features import FeatureUse, FlagUp, Statistic, TicksInState, summarize
from ..core.machine import Machine, Senses
from ..core.vocabulary import Vocabulary

Values = Mapping[str, float]


@dataclass(frozen=True, slots=True)
class Triple:
    """What one example says: in *source*, seeing *values*, go to *label*."""

    source: str
    label: str
    values: Values
    continuation: bool = False


def triples(
    automaton: Automaton, vocabulary: Vocabulary, run: Run, picked: State, values: Values, entered: Values
) -> list[Triple]:
    """What picking a state teaches.

    Args:
        run: What the node does now.
        values: What it sees now.
        entered: What it will see on entering the state, see `on_entry`.
    """
    once = runs_once(picked, vocabulary)
    if isinstance(picked.content, Start) or _raises(automaton.state(run.state), vocabulary):
        return []  # no example is recorded to Start, or from a state that raises a flag
    if picked.id == run.state:
        return [] if once else [Triple(run.state, picked.id, values)]
    went = Triple(run.state, picked.id, values)
    return [went] if once else [went, Triple(picked.id, picked.id, entered, continuation=True)]


def runs_once(state: State, vocabulary: Vocabulary) -> bool:
    """Whether a state's behavior is executed only once, so that its pick records no continuation."""
    match state.content:
        case RaiseFlag():
            return True
        case Basic(name):
            return vocabulary.behavior(name).runs_once
    return False


def _raises(state: State, vocabulary: Vocabulary) -> bool:
    match state.content:
        case RaiseFlag():
            return True
        case Basic(name):
            return vocabulary.behavior(name).raises is not None
    return False


def seen(machine: Machine, senses: Senses, actor: Actor, run: Run, automaton: Automaton) -> dict[str, float]:
    """The values of all features of *automaton* for a node that runs it, by feature id."""
    return {use.id: machine.value(actor, run, use, senses) for use in automaton.features}


def on_entry(
    machine: Machine, actor: Actor, automaton: Automaton, picked: State, values: Values
) -> dict[str, float]:
    """The same values as they are when *picked* has just been entered.

    The sub-behavior that starts has no flag up, and no ticks have passed in its state. Where entering it directs the
    subsidiaries, all their flags are down; where it only ends what they had been directed to do, those of that. (With
    the flags of the state before, a state that was left because of a flag would teach its successor to stay only while
    that flag is up.)
    """
    entry = _Entry(
        directs=_directs(picked, machine.types.vocabulary(actor.node.type)),
        leaves=actor.run is not None and actor.run.directs(),
    )
    return {use.id: _entered(machine, actor, use, values[use.id], entry) for use in automaton.features}


@dataclass(frozen=True, slots=True)
class _Entry:
    """What a controller's change of state does to its subsidiaries."""

    directs: bool
    leaves: bool


def _entered(machine: Machine, actor: Actor, use: FeatureUse, value: float, entry: _Entry) -> float:
    match use.source:
        case FlagUp() | TicksInState():
            return 0.0
        case Statistic(operation, FlagUp(flag), _) as statistic if entry.directs or entry.leaves:
            below = machine.below(actor, statistic)
            return summarize(operation, [float(_still_up(flag, node, actor, entry)) for node in below], 0.0)
    return value


def _still_up(flag: str, node: Actor, controller: Actor, entry: _Entry) -> bool:
    if entry.directs:
        return False
    return flag in node.flags if node.parent == controller.node.id else node.shows(flag)


def _directs(state: State, vocabulary: Vocabulary) -> bool:
    return isinstance(state.content, Basic) and vocabulary.behavior(state.content.behavior).derived
