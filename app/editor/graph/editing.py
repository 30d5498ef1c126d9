"""What the hand does to the automaton on the graph, as undoable edits of the document."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any
from uuid import uuid4

from ...core.automaton import START, Automaton, Basic, Content, Nested
from ...core.check.problem import Problem
from ...core.edits import (
    add_prune,
    add_rule,
    add_state,
    author_learned,
    carry_states,
    describe,
    give_back,
    left_behind,
    lend,
    move_states,
    remove_prune,
    remove_rule,
    remove_rules_of,
    remove_state,
)
from ...core.errors import UnderstudyError
from ...core.project import Position, Project
from ...export.graph import Edge
from . import clipboard
from .arrangement import Point
from .lacking import need
from .level import Drawn
from .scene import EdgeKey, GraphScene
from .state_item import Path

if TYPE_CHECKING:
    from ..studio import Studio

#: How far copies stand from all that was there.
ASIDE = 40.0
NOTHING_COPIED = "there are no states in the clipboard: select some and copy them first"
ELSEWHERE = "the states in the clipboard were copied from another project: export the behavior there, and import it here"
LEARNED_COPIED = "what the states learned came along as rules; the examples stay where they were taught"
#: What one step does: project in, project and more out.
Step = Callable[[Project], tuple[Project, Any]]


class GraphEditing:
    """Edits of the automata that are shown.

    Attributes:
        held: What was copied.
    """

    def __init__(self, studio: Studio, scene: GraphScene) -> None:
        self._studio = studio
        self._scene = scene
        self._copied: tuple[clipboard.CopiedStates, Automaton] | None = None
        self._project = uuid4().hex
        self.held = clipboard.Held(scene)
        studio.opened.connect(self._opened)

    def _opened(self) -> None:
        self._copied, self._project = None, uuid4().hex

    def _push(self, text: str, step: Step) -> Any:
        """Do several edits as one step; what is refused is told, and nothing is done."""
        document = self._studio.document
        try:
            project, made = step(document.project)
        except UnderstudyError as error:
            self._studio.warn(str(error))
            return None
        document.push(text, project)
        return made

    # ---------------------------------------------------------------------------------------------- states

    def move_state(self, path: Path, by: Point, gesture: str = "") -> None:
        """Let a state stand elsewhere; the others of its automaton stay where they are from now on."""
        level, state = self._scene.levels[path[:-1]], path[-1]
        x, y = level.base[state]
        places = {**level.base, state: (x + by[0], y + by[1])}
        where = level.type, level.automaton.id
        self._studio.document.attempt(move_states, *where, places, gesture=gesture and f"{gesture} {path}")

    def add_state(self, level: Drawn, content: Content, at: Position | None = None) -> Path | None:
        """Add a state, where it was dropped or where there is room; returns where it is."""
        where = level.type, level.automaton.id

        def step(project: Project) -> tuple[Project, str]:
            project, state = add_state(project, *where, content)
            if at is not None:
                project = move_states(project, *where, {**level.base, state: at})
            return project, state

        text = describe(add_state, self._studio.document.project, *where, content)
        made = self._push(text, step)
        return None if made is None else (*level.path, made)

    def dropped(self, level: Drawn, data: bytes, at: Position) -> Path | None:
        """Add a state for what was dragged from the library."""
        content = self._content(level, data)
        return None if content is None else self.add_state(level, content, at)

    def _content(self, level: Drawn, data: bytes) -> Content | None:
        try:
            dragged = json.loads(data)
            kind, automaton = str(dragged["type"]), str(dragged.get("id", ""))
            basic = str(dragged.get("basic") or dragged.get("name") or "")
        except (ValueError, KeyError, TypeError, AttributeError):
            return None
        if kind != level.type and automaton:
            held = self._studio.document.automaton(kind, automaton)
            basic, automaton = (held.name if held is not None else basic), ""
        if automaton:
            return Nested(automaton)
        known = self._studio.document.vocabulary(level.type).behaviors
        if basic in known:
            return Basic(basic)
        self._studio.warn(
            f"{level.automaton.name} is of type {level.type!r}, whose states cannot hold {basic!r} of type {kind!r}; "
            f"they hold behaviors of their own type, or of what all their subsidiaries share"
        )
        return None

    def remove(self, states: Sequence[Path], edge: EdgeKey | None) -> None:
        """Remove states with their transitions, or what makes up an edge: its rules go, what was learned is pruned."""
        if edge is not None:
            self.remove_edge(edge)
            return
        doomed = [path for path in states if path[-1] != START]
        if not doomed:
            if states:
                self._studio.warn("Start cannot be removed; every automaton begins in it")
            return
        project = self._studio.document.project
        first = self._where(doomed[0])
        text = describe(remove_state, project, *first, doomed[0][-1])

        def step(project: Project) -> tuple[Project, None]:
            for path in doomed:
                project = remove_state(project, *self._where(path), path[-1])
            return project, None

        self._push(text if len(doomed) == 1 else f"Remove {len(doomed)} states", step)

    def _where(self, path: Path) -> tuple[str, str]:
        level = self._scene.levels[path[:-1]]
        return level.type, level.automaton.id

    # ----------------------------------------------------------------------------------------- transitions

    def link(self, source: Path, target: Path) -> EdgeKey | None:
        """A new rule from a state to a state; returns its edge."""
        if source[:-1] != target[:-1]:
            return None
        if not self._studio.document.attempt(add_rule, *self._where(source), source[-1], target[-1]):
            return None
        return source[:-1], source[-1], target[-1]

    def remove_edge(self, key: EdgeKey) -> None:
        """Remove the rules of an edge and prune what was learned, in one step."""
        level, edge = self._scene.levels[key[0]], self._edge(key)
        if edge is None:
            return
        where = level.type, level.automaton.id

        def step(project: Project) -> tuple[Project, None]:
            for way in edge.rules:
                project = remove_rule(project, *where, way.id)
            if self._is_learned(edge):
                project, _ = add_prune(project, *where, edge.source, [edge.target])
            return project, None

        names = [self._name(level, state) for state in (edge.source, edge.target)]
        verb = "Prune" if self._is_learned(edge) and not edge.rules else "Remove"
        self._push(f"{verb} the transition {names[0]} → {names[1]} of {level.automaton.name}", step)

    def _edge(self, key: EdgeKey) -> Edge | None:
        return self._scene.levels[key[0]].edges.get(key[1:]) if key[0] in self._scene.levels else None

    def _is_learned(self, edge: Edge) -> bool:
        return edge.support > 0.0 and not edge.is_pruned

    def _name(self, level: Drawn, state: str) -> str:
        return next((found.name for found in level.graph.states if found.id == state), state)

    def prunes_of(self, key: EdgeKey) -> tuple[str, ...]:
        """Ids of the prunes that forbid something of an edge."""
        edge = self._edge(key)
        ways = edge.ways if edge is not None else ()
        return tuple(dict.fromkeys(prune for way in ways for prune in way.prunes))

    def take_back(self, key: EdgeKey) -> None:
        """Take back the prunes of an edge."""
        level, ids = self._scene.levels[key[0]], self.prunes_of(key)

        def step(project: Project) -> tuple[Project, None]:
            for prune in ids:
                project = remove_prune(project, level.type, level.automaton.id, prune)
            return project, None

        if ids:
            names = [self._name(level, state) for state in key[1:]]
            self._push(f"Take back the prunes of {names[0]} → {names[1]} of {level.automaton.name}", step)

    # ----------------------------------------------------------------------------------- learned and authored

    def author(self, path: Path) -> None:
        """Turn what a state learned into rules."""
        self._studio.document.attempt(author_learned, *self._where(path), path[-1])

    def unauthor(self, path: Path) -> None:
        """Let what a state learned decide alone again."""
        self._studio.document.attempt(remove_rules_of, *self._where(path), path[-1])

    def mend(self, problem: Problem) -> None:
        """Do what mends a problem."""
        mend = problem.mend
        if mend is not None:
            text = problem.fix or "Mend a problem"
            self._push(text[:1].upper() + text[1:], lambda project: (mend(project), None))

    # ---------------------------------------------------------------------------------------------- copying

    def copy(self, states: Sequence[Path]) -> bool:
        """Put states into the clipboard: those of one automaton."""
        if not states:
            return False
        level = self._scene.levels[states[-1][:-1]]
        ids = tuple(path[-1] for path in states if path[:-1] == level.path)
        names = ", ".join(self._name(level, state) for state in ids)
        copied = clipboard.CopiedStates(self._project, level.type, level.automaton.id, ids)
        self._copied = copied, level.automaton
        self.held.put(copied, names)
        return True

    @property
    def why_no_paste(self) -> str:
        """Why there is nothing to paste; empty if there is."""
        copied = self.held.copied
        if copied is None:
            return NOTHING_COPIED
        return "" if copied.project == self._project else ELSEWHERE

    def paste(self, level: Drawn) -> list[Path]:
        """Copies of the states in the clipboard, with the transitions among them; returns where they are.

        States that were removed since are copied as they were.
        """
        copied = clipboard.there()
        if copied is None:
            self._studio.warn(NOTHING_COPIED)
            return []
        if copied.project != self._project:
            self._studio.warn(ELSEWHERE)
            return []
        now = self._studio.document.automaton(copied.type, copied.automaton)
        gone = now is None or not all(map(now.has_state, copied.states))
        if gone and self._copied is not None and self._copied[0] == copied:
            return self._copies((copied.type, copied.automaton), copied.states, level, self._copied[1])
        return self._copies((copied.type, copied.automaton), copied.states, level)

    def duplicate(self, states: Sequence[Path]) -> list[Path]:
        """Copies of states beside them, with their transitions."""
        if not states:
            return []
        level = self._scene.levels[states[-1][:-1]]
        ids = [path[-1] for path in states if path[:-1] == level.path and path[-1] != START]
        return self._copies((level.type, level.automaton.id), ids, level)

    def _copies(
        self, source: tuple[str, str], ids: Sequence[str], level: Drawn, once: Automaton | None = None
    ) -> list[Path]:
        """Make copies; *once* is the automaton as it was, where what is to be copied is gone."""
        where = level.type, level.automaton.id
        before, lent = self._studio.document.project, ""
        if once is not None:
            before, lent = lend(before, source[0], once)
            source = source[0], lent

        def step(_project: Project) -> tuple[Project, Mapping[str, str]]:
            vocabulary = self._studio.document.scenario.vocabulary
            project, made = carry_states(before, vocabulary, source, ids, where)
            project = give_back(project, source[0], lent) if lent else project
            if source == where and project.layout_of(*where):
                project = move_states(project, *where, {**level.base, **_beside(level, made)})
            return project, made

        if not ids:
            self._studio.warn("Start cannot be copied; there is one in every automaton")
            return []
        many = "a state" if len(ids) == 1 else f"{len(ids)} states"
        made = self._push(f"Copy {many} into {level.automaton.name}", step)
        if made:
            self._tell_of_copies(before, source, ids, where, made.values())
        return [(*level.path, new) for new in made.values()] if made else []

    def _tell_of_copies(
        self,
        before: Project,
        source: tuple[str, str],
        ids: Sequence[str],
        where: tuple[str, str],
        copies: Iterable[str],
    ) -> None:
        """Say what came along with copies, what did not, and what they need now."""
        document, said, into = self._studio.document, [], where[0]
        if any(state in before.library(source[0]).get(source[1]).learned for state in ids):
            said.append(LEARNED_COPIED)
        known, now = before.library(into).automata, document.project.library(into).automata
        if came := [automaton.name for key, automaton in now.items() if key not in known]:
            said.append(f"{', '.join(came)} came along to {into}, since the states hold it")
        if left := left_behind(before, document.scenario.vocabulary, source, ids, where):
            name = before.library(into).get(where[1]).name
            said.append(f"transitions that look at {' or '.join(left)} did not: {name} cannot see that")
        message = need(self._studio, where, copies, said)
        if message is not None:
            self._studio.said.emit(message)
        elif said:
            self._studio.say("; ".join(said))


def _beside(level: Drawn, made: Mapping[str, str]) -> dict[str, Position]:
    """Where copies stand, by their ids: as their originals do, but to the right of all that is there."""
    copied = {new: (level.base[old], level.sizes[old][0]) for old, new in made.items() if old in level.base}
    left = min((at[0] - width / 2 for at, width in copied.values()), default=0.0)
    right = level.corners[1][0] + ASIDE
    return {new: (at[0] + right - left, at[1]) for new, (at, _) in copied.items()}
