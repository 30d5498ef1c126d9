"""Picking a state on the graph while its automaton is taught."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...core.wording import state_words
from ..actions import ActionRow, When
from ..selection import BehaviorKey

if TYPE_CHECKING:
    from ..studio import Studio
    from .panel import GraphPanel


def picking_row(panel: GraphPanel) -> ActionRow:
    """What a button of the teach panel does, where the states are seen."""

    def state(studio: Studio) -> str:
        """The selected state, if it is one of what is taught; empty otherwise."""
        path, level, key = panel.scene.current, panel.scene.level_for_new, studio.teaching.key
        if path is None or level is None or studio.teaching.lesson is None or not panel.isVisible():
            return ""
        of_it = BehaviorKey(level.type, level.automaton.id) == key
        return path[-1] if of_it and path[-1] != level.automaton.states[0].id else ""

    def says(studio: Studio) -> str:
        chosen, automaton, key = state(studio), studio.teaching.automaton, studio.teaching.key
        if not chosen or automaton is None or key is None or not automaton.has_state(chosen):
            return "Pick the state"
        return f"Pick {state_words(automaton, chosen, studio.document.project.library(key.type))}"

    def pick(studio: Studio) -> None:
        if chosen := state(studio):
            studio.teaching.pick(chosen)

    return ActionRow(
        "graph.pick",
        "Pick the state",
        "Teach",
        pick,
        "lesson",
        tip="Let the node that is taught do what the selected state of the graph holds, from the next tick on",
        icon="gesture-tap",
        enabled=When(
            lambda studio: state(studio) != "",
            "teach the behavior that is shown, and select one of its states in the graph",
        ),
        says=says,
    )
