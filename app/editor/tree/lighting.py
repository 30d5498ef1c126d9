"""Which path of the tree is lit: of what was chosen elsewhere, or else that of what the selected node decides now."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING

from ...core.amounts import counted
from ...core.automaton import Refit
from ...core.phrasing import number
from ...core.wording import node_words
from .reaching import passed
from .shape import Key, leading_to, leaves, lit

if TYPE_CHECKING:
    from ...core.examples import Example
    from ...engine.snapshots import WatchedLevel
    from ..studio import Studio
    from .subject import Subject


class Lighting:
    """Finds the nodes of a tree that are to be lit, and says whose path it is.

    Attributes:
        traced: Where the chosen examples pass, or else the ways to where the selected transition leads; empty if nothing was
            chosen, or the examples that reach a node of the tree.
        words: Whose path is lit; empty if none is.
    """

    def __init__(self, studio: Studio) -> None:
        self._studio = studio
        self.traced: frozenset[Key] = frozenset()
        self.words = ""
        self._traced_words = ""
        self._of: tuple[object, ...] = ()
        self._reached: tuple[str, ...] = ()
        self._named: tuple[object, str, str] = (None, "", "")

    def chose(self, examples: tuple[str, ...]) -> None:
        """A node of the tree was chosen, which these examples reach: their paths are not asked for."""
        self._reached = examples

    @property
    def has_examples(self) -> bool:
        """Whether examples are chosen that the tree did not choose itself."""
        chosen = self._studio.selection.examples
        return bool(chosen) and chosen != self._reached

    def trace(self, subject: Subject | None) -> bool:
        """Find where the chosen examples pass, once for each choice; whether it is somewhere else now."""
        selection = self._studio.selection
        of = (subject, selection.examples, selection.goal)
        if len(self._of) == len(of) and all(a is b for a, b in zip(of, self._of, strict=True)):
            return False
        self._of, before = of, self.traced
        self.traced, self._traced_words = frozenset(), ""
        if subject is None or subject.tree is None:
            return self.traced != before
        if examples := self._chosen(subject):
            self.traced = passed(subject.tree, examples)
            named = f"example {examples[0].id}" if len(examples) == 1 else counted(len(examples), "example")
            self._traced_words = f"lit: {named}"
        elif selection.goal and selection.state == subject.state:
            self.traced = leading_to(subject.tree, selection.goal)
            self._traced_words = f"lit: the way to {subject.name(selection.goal)}"
        return self.traced != before

    def _chosen(self, subject: Subject) -> list[Example]:
        if not self.has_examples:
            return []
        chosen, tested = set(self._studio.selection.examples), [use.id for use in subject.automaton.features]
        return [
            example
            for example in self._studio.document.project.examples_of(subject.type, subject.automaton.id)
            if example.id in chosen
            and example.source == subject.state
            and all(feature in example.values for feature in tested)
        ]

    def end(self, subject: Subject | None) -> Key:
        """The leaf in which all that was traced ends; 0 if there is none, or several."""
        ends = [] if subject is None or subject.tree is None else leaves(subject.tree, self.traced)
        return ends[0] if len(ends) == 1 else 0

    def keys(self, subject: Subject, *, follows: bool) -> Collection[Key]:
        """What is to be lit now.

        Args:
            follows: The node is followed, whatever examples are still chosen.
        """
        if self.traced and not follows:
            self.words = self._traced_words
            return self.traced
        level, self.words = self.level(subject), ""
        if level is None or subject.tree is None:
            return ()
        try:
            keys = lit(subject.tree, level.values.__getitem__)
        except KeyError:  # a feature that cannot be told now, or that the world does not know yet
            return ()
        self.words = f"lit: {self._node_words()}, now"
        return keys

    def _node_words(self) -> str:
        """What the selected node is called: found once, since a forest may have thousands."""
        snapshot, node = self._studio.snapshot, self._studio.selection.node
        if snapshot is None:
            return ""
        place, of, _ = self._named
        if place is not snapshot.place or of != node:
            self._named = snapshot.place, node, node_words(snapshot.place.hierarchy.node(node))
        return self._named[2]

    def level(self, subject: Subject | None) -> WatchedLevel | None:
        """The selected node's run of the automaton that is shown, if it is in the state that is shown."""
        snapshot = self._studio.snapshot
        watched = None if snapshot is None else snapshot.watched.get(self._studio.selection.node)
        if watched is None or subject is None:
            return None
        wanted = subject.type, subject.automaton.id, subject.state
        levels = (each for each in watched.levels if (each.type, each.automaton, each.state) == wanted)
        return next(levels, None)

    def outcome_words(self, subject: Subject | None) -> str:
        """What a model without a tree says now; empty where there is a tree, or nothing."""
        if subject is None or not isinstance(subject.model, Refit):
            return ""
        level = self.level(subject)
        if level is None or not level.outcome:
            return "Select an agent that is in this state to see what it says."
        said = ", ".join(f"{subject.name(state)} {number(100 * p)}%" for state, p in level.outcome)
        return f"Now it says: {said}."
