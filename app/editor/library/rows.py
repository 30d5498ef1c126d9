"""What can be done with behaviors, as actions of the window."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..actions import ActionRow, needs, when_open
from .new_automaton import new_automaton
from .settings_dialog import behavior_settings

if TYPE_CHECKING:
    from ..studio import Studio
    from .panel import LibraryPanel


@needs("choose a behavior in the library first; basic behaviors are the program's own")
def has_behavior(studio: Studio) -> bool:
    """Whether an automaton is shown."""
    return studio.is_open and studio.selection.behavior is not None


def library_rows(panel: LibraryPanel) -> tuple[ActionRow, ...]:
    """The actions of the Behavior menu that concern behaviors as wholes."""
    return (
        ActionRow(
            "behavior.new",
            "New automaton…",
            "Behavior",
            lambda studio: new_automaton(studio, panel),
            "library",
            "Ctrl+Shift+N",
            "Make a new behavior to teach or to write by hand",
            "plus",
            when_open,
        ),
        ActionRow(
            "behavior.settings",
            "Behavior settings…",
            "Behavior",
            lambda studio: behavior_settings(studio, panel),
            "library",
            "Ctrl+I",
            "Name, parameters, states, features and learner of the behavior that is shown",
            "tune-variant",
            has_behavior,
        ),
        ActionRow(
            "behavior.note",
            "Note…",
            "Behavior",
            lambda studio: behavior_settings(studio, panel, field="note"),
            "library",
            tip="Write a note on the behavior that is shown",
            icon="note-edit-outline",
            enabled=has_behavior,
        ),
        ActionRow(
            "behavior.open",
            "Open in the graph",
            "Behavior",
            lambda studio: studio.show_panel.emit("graph"),
            "library",
            tip="Show the behavior's automaton (Enter in the library)",
            icon="graph-outline",
            enabled=has_behavior,
        ),
        ActionRow(
            "behavior.learn",
            "Learn what has changed",
            "Behavior",
            lambda studio: studio.relearning.ask(),
            "library",
            tip="Learn all behaviors that have changed since they were learned (a click on the badge stale)",
            icon="school-outline",
            enabled=when_open,
        ),
        ActionRow(
            "behavior.rename",
            "Rename",
            "Behavior",
            lambda _: panel.rename(),
            "change",
            tip="Give the behavior that is shown another name (F2 in the library)",
            icon="rename-box",
            enabled=has_behavior,
        ),
        ActionRow(
            "behavior.duplicate",
            "Duplicate",
            "Behavior",
            lambda _: panel.duplicate(),
            "change",
            tip="Copy the behavior that is shown, examples included (Ctrl+D in the library)",
            icon="content-copy",
            enabled=has_behavior,
        ),
        ActionRow(
            "behavior.delete",
            "Delete behavior…",
            "Behavior",
            lambda _: panel.delete(),
            "change",
            tip="Delete the behavior that is shown; its users can get a replacement (Delete in the library)",
            icon="delete-outline",
            enabled=has_behavior,
        ),
        ActionRow(
            "behavior.filter",
            "Filter behaviors",
            "Behavior",
            lambda _: panel.focus_filter(),
            "find",
            "Ctrl+L",
            "Find behaviors by name, feature or state",
            "magnify",
            when_open,
        ),
    )
