"""Why a node does what it does, in sentences, and what would have to be different for it to do something else.

Everything is told from a `Watched` of a snapshot and the project: nothing here touches a world, and nothing is drawn.
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from ..core.automaton import START, Refit
from ..core.conditions import Condition, Guard
from ..core.examples import enabled
from ..core.hierarchy import Hierarchy
from ..core.project import Project
from ..core.tree import Forest
from ..core.vocabulary import Vocabulary
from .deciding import Way, deciding_way, ways
from .explained import Case, Part, Reason, agreement, case_of, percent, ranked, reason_of
from .snapshots import Watched

__all__ = ["Part", "Reason", "reasons", "why", "why_not"]

#: Before what a node would do that does what the user picks.
YOURS = Part("You decide now; by itself: ")
#: So many of the states that can come next are told.
MOST_STATES = 3
#: A state that comes next with less than the rest to 1 is not the only one.
CERTAIN = 1.0 - 1e-9


def reasons(
    project: Project,
    vocabulary: Vocabulary,
    watched: Mapping[str, Watched],
    node_id: str,
    forest: Hierarchy,
    taught: Collection[str] = (),
) -> tuple[Reason, ...]:
    """Why a node does what it does, from the top: of its controllers, as far as they are *watched*, then its own.

    Args:
        vocabulary: The scenario's.
        taught: The nodes that do just what the user picks.
    """
    parents = forest.parents()
    line = [node_id]
    while line[0] in parents:
        line.insert(0, parents[line[0]])
    return tuple(
        reason
        for above in line
        if above in watched
        for reason in why(
            project, vocabulary, watched[above], forest, of_its=above != node_id, taught=above in taught
        )
    )


def why(
    project: Project,
    vocabulary: Vocabulary,
    watched: Watched,
    forest: Hierarchy | None = None,
    *,
    of_its: bool = False,
    taught: bool = False,
) -> tuple[Reason, ...]:
    """One reason for each automaton on a node's path, outermost first; none if it runs no automaton.

    Args:
        vocabulary: The scenario's.
        forest: For the names of groups.
        of_its: Whether it is told to somebody below: "Its group's ControlForage stays in ...".
        taught: Whether the user decides for it.
    """
    found: list[Reason] = []
    for level in watched.levels:
        case = case_of(project, vocabulary, watched, level, forest)
        if case is not None:
            reason = _told(case, of_its=of_its)
            yours = taught and level is watched.levels[0]
            found.append(replace(reason, parts=(YOURS, *reason.parts)) if yours else reason)
    return tuple(found)


def why_not(
    project: Project,
    vocabulary: Vocabulary,
    watched: Watched,
    state: str,
    forest: Hierarchy | None = None,
    level: int = 0,
) -> Reason | None:
    """What would have to be different for *state* to come next: the nearest rule or leaf that leads there.

    Args:
        level: Which automaton on the node's path, 0 being the outermost.

    Returns: None if there is no such automaton, or no such state in it.
    """
    if not 0 <= level < len(watched.levels):
        return None
    case = case_of(project, vocabulary, watched, watched.levels[level], forest)
    return None if case is None or not case.automaton.has_state(state) else _told_not(case, state)


# -------------------------------------------------------------------------------------------------- why


def _told(case: Case, *, of_its: bool) -> Reason:
    level = case.level
    order = ranked(case)
    who = f"Its {level.type}'s {case.automaton.name}" if of_its else case.automaton.name
    if not order:
        unknown = Part("; what comes next cannot be told now")
        parts = [Part(f"{who} is in "), case.shown(level.state), unknown]
        return reason_of(case, level.state, 0.0, parts, None)
    goes, probability = order[0]
    examples = case.project.examples_of(level.type, level.automaton)
    way = deciding_way(case.automaton, level.state, level.values, goes, examples)
    parts = [Part(f"{who} "), *_course(case, order), *_because(case, way, goes)]
    return reason_of(case, goes, probability, parts, way)


def _course(case: Case, ranked: Sequence[tuple[str, float]]) -> list[Part]:
    """Where it goes: "stays in Wander", "goes from Start to Wander", "stays in A (99%) or goes to B (1%)"."""
    here = case.level.state
    if ranked[0][1] >= CERTAIN:
        return [*_moves(case, here, ranked[0][0]), case.shown(ranked[0][0])]
    parts: list[Part] = []
    before = ""
    for state, probability in ranked[:MOST_STATES]:
        moves = (
            [] if before not in ("", here) and state != here else _moves(case, here, state, first=not before)
        )
        parts += [Part(" or ")] if before else []
        parts += [*moves, case.shown(state), Part(f" ({percent(probability)})")]
        before = state
    return parts


def _moves(case: Case, here: str, state: str, *, first: bool = True) -> list[Part]:
    if state == here:
        return [Part("stays in ")]
    return [Part("goes from "), case.shown(here), Part(" to ")] if first else [Part("goes to ")]


def _because(case: Case, way: Way | None, goes: str) -> list[Part]:
    if way is None:
        return [Part(_without(case))]
    because = f" because {case.words(way.guard)}" if way.guard else ""
    chance = (" and" if because else ",") + " by chance" if way.by_chance else ""
    if way.rule or not way.examples:
        return [Part(f"{because}{chance}" or ", as its rule always says")]
    agreeing = sum(example.label == goes for example in way.examples)
    agree = agreement(agreeing, len(way.examples))
    return [Part(f"{because}{agree}" if because else f", whatever it sees{agree}")]


def _without(case: Case) -> str:
    """What is told where neither a rule nor a leaf decides."""
    level = case.level
    model = case.automaton.learned.get(level.state)
    if isinstance(model, Refit | Forest):
        what = model.classifier if isinstance(model, Refit) else f"the {len(model.trees)} trees of its forest"
        return f" because {what} say{'s' if isinstance(model, Refit) else ''} so"
    own = enabled(case.project.examples_of(level.type, level.automaton), level.state)
    if own and model is None:
        return ", since what it was taught there has not been learned yet"
    if model is not None:
        return ", since everything else is pruned"
    waits = "it has not been taught how to begin" if level.state == START else "nothing leads out of it"
    return f", since {waits}"


# ---------------------------------------------------------------------------------------------- why not


def _told_not(case: Case, state: str) -> Reason:
    level = case.level
    chance = dict(ranked(case)).get(state, 0.0)
    does = "stay in " if state == level.state else "go to "
    if chance > 0.0:
        certain = chance >= CERTAIN
        parts = [Part(f"{case.automaton.name} {'will' if certain else 'may'} {does}"), case.shown(state)]
        parts += [] if certain else [Part(f", with a probability of {percent(chance)} at this tick")]
        return reason_of(case, state, chance, parts, None)
    examples = case.project.examples_of(level.type, level.automaton)
    leading = [
        way
        for way in ways(case.automaton, level.state, level.values, examples)
        if way.shares.get(state, 0.0) > 0.0
    ]
    if not leading:
        return reason_of(case, state, 0.0, _never(case, state), None)
    nearest = min(leading, key=lambda way: (len(way.failing(level.values)), -len(way.examples)))
    parts = [
        Part(f"{case.automaton.name} would {does}"),
        case.shown(state),
        *_only_where(case, nearest, state),
    ]
    return reason_of(case, state, 0.0, parts, nearest)


def _only_where(case: Case, way: Way, state: str) -> list[Part]:
    failing = way.failing(case.level.values)
    if not failing:
        return [Part(", but something else comes before it")]
    agree = agreement(sum(example.label == state for example in way.examples), len(way.examples))
    return [Part(f" only where {case.words(failing)}{agree}, but {_turned(case, failing)}")]


def _turned(case: Case, failing: Guard) -> str:
    """What is so now, instead of the tests that fail."""
    return case.seen(failing) or case.words(tuple(Condition(c.test, not c.wanted) for c in failing))


def _never(case: Case, state: str) -> list[Part]:
    """What is told where nothing leads to a state."""
    if state == START:
        return [
            Part(f"{case.automaton.name} goes back to "),
            case.shown(START),
            Part(" only when it raises a flag"),
        ]
    pruned = any(state in prune.forbidden for prune in case.automaton.prunes_of(case.level.state))
    end = " any more: that is pruned" if pruned else "; pick it there once to teach that"
    return [
        Part(f"Nothing leads {case.automaton.name} from "),
        case.shown(case.level.state),
        Part(" to "),
        case.shown(state),
        Part(end),
    ]
