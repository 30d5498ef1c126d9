"""What the hand does to a learned tree, as undoable edits of the document: prunes, cuts, pruning confidence."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from ...core.conditions import Test
from ...core.edits import add_prune, describe, move_cut, remove_prune, set_settings
from ...core.project import Project
from .subject import Subject

if TYPE_CHECKING:
    from ..studio import Studio


class Pruning:
    """Edits of the tree of a state."""

    def __init__(self, studio: Studio) -> None:
        self._studio = studio

    def below(self, subject: Subject, key: int) -> None:
        """Forbid all transitions at a leaf or below a node: the state stays there."""
        forbidden = sorted(set(subject.labels_at(key)) - {subject.state})
        if not forbidden:
            self._studio.warn(
                f"there is no transition to prune here: all examples stay in {subject.name(subject.state)}"
            )
            return
        self._add(subject, key, forbidden)

    def label(self, subject: Subject, key: int, label: str) -> None:
        """Forbid one state at a leaf or below a node."""
        self._add(subject, key, [label])

    def _add(self, subject: Subject, key: int, forbidden: list[str]) -> None:
        where = subject.type, subject.automaton.id, subject.state
        guard = subject.path(key)
        there = any(
            p.guard == guard and p.forbidden == set(forbidden) for p in subject.automaton.prunes_of(where[2])
        )
        if there:
            self._studio.warn("this is pruned already; Prunes lists it, and takes it back")
            return
        self._studio.document.attempt(add_prune, *where, forbidden, guard)

    def take_back(self, subject: Subject, key: int) -> None:
        """Take back the prunes that hold at a node, as one step."""
        prunes = subject.prunes_at(key)
        if not prunes:
            return
        document, where = self._studio.document, (subject.type, subject.automaton.id)
        project: Project = document.project
        text = describe(remove_prune, project, *where, prunes[0].id)
        for prune in prunes:
            project = remove_prune(project, *where, prune.id)
        many = f"Take back {len(prunes)} prunes of {subject.automaton.name}"
        document.push(text if len(prunes) == 1 else many, project)

    def cut(self, subject: Subject, key: int, test: Test, gesture: str = "") -> None:
        """Let the test at a node have other numbers."""
        guard = subject.path(key)
        where = subject.type, subject.automaton.id, subject.state
        self._studio.document.attempt(move_cut, *where, guard, test, gesture=gesture)

    def confidence(self, subject: Subject, confidence: float | None, gesture: str = "") -> None:
        """Prune trees with another confidence from now on."""
        settings = subject.automaton.settings
        if settings.pruning_confidence != confidence:
            new = replace(settings, pruning_confidence=confidence)
            where = subject.type, subject.automaton.id
            self._studio.document.attempt(set_settings, *where, new, gesture=gesture)
