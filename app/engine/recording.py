"""From a user's pick to examples: <B, f, B'>, and the continuation <B', f, B'> (paper, section 3.1)."""

from collections.abc import Mapping
from dataclasses import dataclass

from ..core.actor import Actor, Run
from ..core.automaton import Automaton, Basic, Content, RaiseFlag, Start, State
from ..core.edits.states import add_state
from ..core.errors import SessionError
from ..core.features import FeatureUse, FlagUp, Over, Statistic, TicksInState, declaration, summarize
from ..core.library import statistic_vocabulary
from ..core.machine import Machine, Senses
from ..core.naming import named
from ..core.project import Project
from ..core.vocabulary import Vocabulary

Values = Mapping[str, float]


@dataclass(frozen=True, slots=True)
class Triple:
    """What one example says: in *source*, seeing *values*, go to *label*."""

    source: str
    label: str
    values: Values
    continuation: bool = False


def state_for(
    project: Project, type_name: str, automaton_id: str, choice: str | Content
) -> tuple[State, State | None]:
    """The state that a choice means, and the same again if it is one that the automaton lacks and must be added.

    Args:
        choice: The id of a state, or what a state is to hold.

    Raises:
        SessionError: There is no state with that id.
        EditError: The automaton cannot hold that.
    """
    library = project.library(type_name)
    automaton = library.get(automaton_id)
    for state in automaton.states:
        if choice in (state.id, state.content):
            return state, None
    if isinstance(choice, str):
        raise SessionError(
            f"{automaton.name!r} has no state {choice!r}; there are: {named(automaton.states, library)}"
        )
    changed, state_id = add_state(project, type_name, automaton_id, choice)
    added = changed.library(type_name).get(automaton_id).state(state_id)
    return added, added


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

    The sub-behavior that starts has no flag up, no ticks have passed in its state, and where entering it directs the
    subsidiaries, theirs are down as well. (With the flags of the state before, a state that was left because of a flag
    would teach its successor to stay only while that flag is up.)
    """
    directs = _directs(picked, machine.types.vocabulary(actor.node.type))
    return {
        use.id: _entered(machine, actor, use, values[use.id], directs=directs) for use in automaton.features
    }


def _entered(machine: Machine, actor: Actor, use: FeatureUse, value: float, *, directs: bool) -> float:
    match use.source:
        case FlagUp() | TicksInState():
            return 0.0
        case Statistic(operation, FlagUp() as flag, _) as statistic if directs:
            below = actor.agents if statistic.over is Over.AGENTS else actor.children
            default = declaration(flag, statistic_vocabulary(machine.types)).default
            return summarize(operation, [0.0] * len(below), default)
    return value


def _directs(state: State, vocabulary: Vocabulary) -> bool:
    return isinstance(state.content, Basic) and vocabulary.behavior(state.content.behavior).derived
