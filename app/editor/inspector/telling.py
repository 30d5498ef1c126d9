"""What the inspector says of a node, as sentences and rows: values that are easy to test, painted elsewhere."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ...core.wording import node_words, reading_words, state_words, value_words
from ...engine.explain import Reason, reasons, why_not

if TYPE_CHECKING:
    from ...core.project import Project
    from ...core.vocabulary import Vocabulary
    from ...engine.snapshots import Snapshot, Watched, WatchedLevel

#: Whom a target means that means nobody.
NOBODY = "nobody"


@dataclass(frozen=True, slots=True)
class Reading:
    """A feature and what it says now."""

    name: str
    value: str
    words: str


@dataclass(frozen=True, slots=True)
class LevelTold:
    """One automaton on a node's path.

    Attributes:
        title: "Forage: Wander, for 12 ticks".
        others: States that it might go to instead: id and name, for "why not".
    """

    type: str
    automaton: str
    state: str
    title: str
    readings: tuple[Reading, ...]
    bindings: tuple[Reading, ...]
    others: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class Told:
    """What is said of a node."""

    node: str
    title: str
    reasons: tuple[Reason, ...]
    levels: tuple[LevelTold, ...]
    basic: str = ""
    flags: tuple[str, ...] = ()


def tell(project: Project, vocabulary: Vocabulary, snapshot: Snapshot, node: str) -> Told | None:
    """All there is to say of *node*; None if it is not watched, or gone.

    Args:
        vocabulary: The scenario's.
    """
    watched = snapshot.watched.get(node)
    if watched is None:
        return None
    hierarchy = snapshot.place.hierarchy
    view = snapshot.node(node)
    found = reasons(project, vocabulary, snapshot.watched, node, hierarchy, snapshot.taught)
    comes = {(one.type, one.automaton): one.goes for one in found if one.probability == 1.0}
    name = node_words(hierarchy.node(node))
    return Told(
        node,
        _title(name, project, watched, view.behavior),
        found,
        tuple(
            _level(project, vocabulary, snapshot, level, comes.get((level.type, level.automaton), ""))
            for level in watched.levels
        ),
        view.basic,
        tuple(sorted(view.flags)),
    )


def tell_why_not(project: Project, vocabulary: Vocabulary, snapshot: Snapshot, node: str, state: str) -> str:
    """What would have to be different for *state* of the outermost automaton to come next; empty if nobody can tell."""
    watched = snapshot.watched.get(node)
    if watched is None:
        return ""
    reason = why_not(project, vocabulary, watched, state, snapshot.place.hierarchy)
    return "" if reason is None else reason.sentence


def _title(name: str, project: Project, watched: Watched, behavior: str) -> str:
    if not watched.levels:
        return f"{name} does {behavior}" if behavior else f"{name} idles"
    first = watched.levels[0]
    automaton = project.library(first.type).automata.get(first.automaton)
    if automaton is None or not automaton.has_state(first.state):
        return name
    return f"Why is {_lower(name)} in {state_words(automaton, first.state, project.library(first.type))}?"


def _lower(name: str) -> str:
    """A name in the middle of a sentence: "agent 17"; names that a user gave stay as they are."""
    first, _, rest = name.partition(" ")
    return f"{first.lower()} {rest}" if rest.isdecimal() else name


def _level(
    project: Project, vocabulary: Vocabulary, snapshot: Snapshot, level: WatchedLevel, comes: str
) -> LevelTold:
    """What is said of one automaton, whose next state is certainly *comes*; empty if none is certain."""
    library = project.library(level.type)
    automaton = library.automata.get(level.automaton)
    if automaton is None or not automaton.has_state(level.state):
        return LevelTold(level.type, level.automaton, level.state, level.automaton, (), (), ())
    state = state_words(automaton, level.state, library)
    readings = tuple(
        Reading(
            use.shown,
            value_words(use, level.values[use.id], vocabulary),
            reading_words(use, level.values[use.id], vocabulary),
        )
        for use in automaton.features
        if use.id in level.values
    )
    ticks = "1 tick" if level.ticks == 1 else f"{level.ticks:,} ticks"
    others = tuple(
        (other.id, state_words(automaton, other.id, library))
        for other in automaton.states[1:]
        if other.id not in (level.state, comes)
    )
    return LevelTold(
        level.type,
        level.automaton,
        level.state,
        f"{automaton.name}: {state}, for {ticks}",
        readings,
        tuple(_binding(snapshot, slot, level.arguments) for slot in level.arguments),
        others,
    )


def _binding(snapshot: Snapshot, slot: str, arguments: Mapping[str, tuple[str, str, int]]) -> Reading:
    target, _owner, entity = arguments[slot]
    who = snapshot.place.entity_called(entity) if entity >= 0 else NOBODY
    return Reading(slot, target, "" if who == target else who)
