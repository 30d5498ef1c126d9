"""What the canvas says: who is under the mouse, what it does, and what the session is for."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from ...core.amounts import counted
from ...core.telling import Speech
from ...core.wording import reading_words, state_words
from ...engine.snapshots import LessonView, Mode, Snapshot, Watched, WatchedLevel
from .scene import Scene

if TYPE_CHECKING:
    from ..studio import Studio

#: So many features of an automaton are told under the mouse.
MOST_FEATURES = 5
#: Letters of a name on the badge at most: it is not to cover the world.
LONGEST = 32


def badge_words(studio: Studio) -> str:
    """What the session is for, in few words; empty where nobody is taught."""
    snapshot = studio.snapshot
    lesson = None if snapshot is None else snapshot.lesson
    if snapshot is None or lesson is None:
        return ""
    behavior = studio.document.automaton(lesson.plan.type, lesson.plan.automaton)
    name = _short(behavior.name if behavior is not None else lesson.plan.automaton)
    if snapshot.mode is Mode.LEARNING:
        return f"Learning {name}…"
    if not lesson.testing:
        return f"Teaching {_pupils(snapshot, lesson, studio)}"
    if snapshot.taught:
        return f"Testing {name} · {_several(snapshot, sorted(snapshot.taught))} in training"
    return f"Testing {name}"


def _short(name: str) -> str:
    return name if len(name) <= LONGEST else f"{name[: LONGEST - 1].rstrip()}…"


def _pupils(snapshot: Snapshot, lesson: LessonView, studio: Studio) -> str:
    """The one whose turn it is, of how many."""
    turn = studio.teaching.node or lesson.plan.nodes[0]
    more = len(lesson.plan.nodes) - 1
    return _within(snapshot, turn) + (f" and {more} more" if more > 0 else "")


def _several(snapshot: Snapshot, nodes: list[str]) -> str:
    return _within(snapshot, nodes[0]) if len(nodes) == 1 else f"{len(nodes)} nodes"


def _within(snapshot: Snapshot, node: str) -> str:
    """What a node is called within a sentence: one that has no name of its own is not written large."""
    name = _short(snapshot.place.called(node))
    return name[:1].lower() + name[1:] if name.lower() == node.lower().replace("-", " ") else name


# -------------------------------------------------------------------------------------------- under the mouse


def entity_words(studio: Studio, scene: Scene, entity: int, watched: Watched | None) -> tuple[str, ...]:
    """Lines about an entity, the first one its name."""
    node = scene.node(entity)
    if node:
        return node_words(studio, scene, node, watched)
    return scene.called(entity), *_about_thing(scene, entity)


def node_words(studio: Studio, scene: Scene, node: str, watched: Watched | None) -> tuple[str, ...]:
    """Lines about a node: its name, what runs on it from outside inward, and what it sees."""
    lines = [scene.place.called(node), path_words(scene, node) or "idles"]
    entity = scene.entity(node)
    if entity >= 0 and (held := int(scene.held[entity])) >= 0:
        lines.append(f"attached to {scene.called(held)}")
    for level in () if watched is None else watched.levels:
        lines += _level_words(studio, level)
    return tuple(lines)


def path_words(scene: Scene, node: str) -> str:
    """What runs on a node: "Forage → Wander → Forward"; empty if it idles."""
    doing = scene.doing
    return " → ".join(
        doing.behaviors[what].name for what in doing.behavior[doing.row(node)].tolist() if what >= 0
    )


def _level_words(studio: Studio, level: WatchedLevel) -> Iterator[str]:
    """In which state an automaton is, for how long, and what its features are."""
    document = studio.document
    automaton = document.automaton(level.type, level.automaton)
    if automaton is None:
        return
    library = document.project.library(level.type)
    state = state_words(automaton, level.state, library)
    yield f"{automaton.name}: {state} for {counted(level.ticks, 'tick')}"
    speech = Speech(targets={slot: target for slot, (target, _, _) in level.arguments.items()})
    told = [
        reading_words(use, level.values[use.id], document.scenario.vocabulary, speech)
        for use in automaton.features
        if use.id in level.values
    ]
    for words in dict.fromkeys(told[:MOST_FEATURES]):
        yield f"    {words}"
    if len(told) > MOST_FEATURES:
        yield f"    and {len(told) - MOST_FEATURES} more"


def _about_thing(scene: Scene, entity: int) -> Iterator[str]:
    """What can be said of an entity that is no agent."""
    look, kind = scene.place.look, scene.kind(entity)
    if kind == look.loads and look.got and look.needed:
        got, needed = (int(scene.columns[name][entity]) for name in (look.got, look.needed))
        yield f"{got} of the {counted(needed, 'agent')} that it needs"
    for name, radius in look.ranges.get(kind, {}).items():
        yield f"{name.replace('_', ' ')}: {radius:g} units"
    yield f"at {scene.x[entity]:.1f}, {scene.y[entity]:.1f}"
