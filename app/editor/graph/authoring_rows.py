"""What can be done to the automaton on the graph."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ...core.automaton import START
from ...export.graph import WayKind
from ..actions import ActionRow, When

if TYPE_CHECKING:
    from ..studio import Studio
    from .panel import GraphPanel
    from .state_item import Path


NOT_SHOWN = "choose a behavior in the library, and show the panel Automaton"
NO_STATE = "select a state in the graph first"
NO_OWN = "select a state in the graph first; Start is in every automaton, once"
NO_EDGE = "select a transition in the graph first"


class _Able:
    """What is possible with what is selected."""

    def __init__(self, panel: GraphPanel) -> None:
        self._panel = panel

    def shows(self, _studio: Studio) -> bool:
        return self._panel.root is not None and self._panel.isVisible()

    def has_state(self, _studio: Studio) -> bool:
        return self._panel.scene.current is not None and self._panel.isVisible()

    def has_edge(self, _studio: Studio) -> bool:
        return self._panel.scene.edge is not None and self._panel.isVisible()

    def has_own(self, studio: Studio) -> bool:
        """Whether a state other than Start is selected."""
        return self.has_state(studio) and any(path[-1] != START for path in self._panel.scene.selected)

    def has_any(self, studio: Studio) -> bool:
        return self.has_state(studio) or self.has_edge(studio)

    def has_removable(self, studio: Studio) -> bool:
        return self.has_own(studio) or self.has_edge(studio)

    def has_copied(self, studio: Studio) -> bool:
        return self.shows(studio) and not self._panel.editing.why_no_paste

    def why_no_paste(self, studio: Studio) -> str:
        return self._panel.editing.why_no_paste if self.shows(studio) else NOT_SHOWN

    def has_prunes(self, studio: Studio) -> bool:
        edge = self._panel.scene.edge
        return self.has_edge(studio) and edge is not None and bool(self._panel.editing.prunes_of(edge))

    def has_learned(self, studio: Studio) -> bool:
        """Whether what the selected state learned decides anything: rules may do so before."""
        level, path = self._panel.scene.level_for_new, self._panel.scene.current
        if not self.has_state(studio) or level is None or path is None:
            return False
        edges = [edge for edge in level.graph.edges if edge.source == path[-1]]
        return any(way.is_open and way.kind is not WayKind.RULE for edge in edges for way in edge.ways)

    def has_rules(self, studio: Studio) -> bool:
        level, path = self._panel.scene.level_for_new, self._panel.scene.current
        return (
            self.has_state(studio)
            and level is not None
            and path is not None
            and bool(level.automaton.rules_of(path[-1]))
        )

    def removal_words(self, studio: Studio) -> str:
        """What removing does to what is selected."""
        if not self.has_edge(studio):
            return "Remove the state"
        edge = self._panel.scene.edge
        item = None if edge is None else self._panel.scene.edges.get(edge)
        return "Prune the transition" if item is not None and not item.edge.rules else "Remove the transition"


def authoring_rows(panel: GraphPanel) -> tuple[ActionRow, ...]:
    """Changing the automaton."""
    able = _Able(panel)

    def with_state(act: Callable[[Path], object]) -> Callable[[Studio], object]:
        return lambda _: None if panel.scene.current is None else act(panel.scene.current)

    def add_rule(_studio: Studio) -> None:
        if panel.scene.edge is not None:
            level, source, target = panel.scene.edge
            panel.link((*level, source), (*level, target))

    def take_back(_studio: Studio) -> None:
        if panel.scene.edge is not None:
            panel.editing.take_back(panel.scene.edge)

    def row(name: str, text: str, do: Callable[[Studio], object], tip: str, **more: Any) -> ActionRow:
        return ActionRow(f"graph.{name}", text, "Behavior", do, "states", tip=tip, **more)

    return (
        row(
            "add_state",
            "Add a state…",
            lambda _: panel.add_state_menu(),
            "Choose what a new state holds; a behavior can also be dragged here from the library",
            keys="Ctrl+Shift+A",
            icon="plus-box-outline",
            enabled=When(able.shows, NOT_SHOWN),
        ),
        row(
            "link",
            "Draw a transition",
            lambda _: panel.begin_link(),
            "From the selected state: choose where it leads with the arrow keys and Enter, or by a click",
            keys="Ctrl+T",
            icon="arrow-right-thin",
            enabled=When(able.has_state, NO_STATE),
        ),
        row(
            "edit",
            "Edit the state or transition",
            lambda _: panel.edit(),
            "Open the form of what is selected in the automaton graph; F2 does the same",
            icon="pencil-outline",
            enabled=When(able.has_any, "select a state or a transition in the graph first"),
        ),
        row(
            "add_rule",
            "Add a rule to the transition",
            add_rule,
            "One more rule between the same states",
            icon="source-branch-plus",
            enabled=When(able.has_edge, NO_EDGE),
        ),
        row(
            "author",
            "Turn what the state learned into rules",
            with_state(panel.editing.author),
            "Rules that do what its decision tree does now",
            icon="playlist-edit",
            enabled=When(able.has_learned, "select a state in the graph that has learned to leave"),
        ),
        row(
            "unauthor",
            "Remove the rules of the state",
            with_state(panel.editing.unauthor),
            "What the state learned decides alone again",
            icon="playlist-remove",
            enabled=When(able.has_rules, "select a state in the graph that has rules"),
        ),
        row(
            "copy",
            "Copy the states",
            lambda _: panel.editing.copy(panel.scene.selected),
            "With the transitions among them; Ctrl+C in the graph. Ctrl and a click select several",
            icon="content-copy",
            enabled=When(able.has_own, NO_OWN),
        ),
        row(
            "paste",
            "Paste states",
            lambda _: panel.paste(),
            "Put copied states into the automaton; Ctrl+V in the graph",
            icon="content-paste",
            enabled=When(able.has_copied, able.why_no_paste),
        ),
        row(
            "duplicate",
            "Duplicate the states",
            lambda _: panel.duplicate(),
            "Copies beside the selected states, with their transitions; Ctrl+D in the graph",
            icon="content-duplicate",
            enabled=When(able.has_own, NO_OWN),
        ),
        row(
            "remove",
            "Remove the state or transition",
            lambda _: panel.remove(),
            "Rules are removed, what was learned is pruned; Delete in the graph",
            says=able.removal_words,
            icon="delete-outline",
            enabled=When(able.has_removable, f"{NO_OWN}; or select a transition"),
        ),
        row(
            "unprune",
            "Take back the prunes of the transition",
            take_back,
            "What was learned may lead there again",
            icon="restore",
            enabled=When(able.has_prunes, "select a transition in the graph of which something is pruned"),
        ),
    )
