"""Showing, hiding and walking through panels, by the menu View and its keys."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt

from ..actions import ActionRow, when_open
from .docks import DOCKS, Dock, has_keys, is_in_sight
from .tabs import float_row

if TYPE_CHECKING:
    from ..studio import Studio
    from .main_window import MainWindow


def panel_rows(window: MainWindow) -> tuple[ActionRow, ...]:
    """The actions."""
    return (
        *(_dock_row(window, window.docks[row.id]) for row in DOCKS),
        _way_row(window, "next", "Next panel", 1, "F6", "arrow-right"),
        _way_row(window, "previous", "Previous panel", -1, "Shift+F6", "arrow-left"),
        float_row(window),
        ActionRow(
            "view.standard",
            "Standard layout",
            "View",
            lambda _: window.standard_layout(),
            "panels",
            tip="Put all panels back where they stood at first",
            icon="view-dashboard-outline",
            enabled=when_open,
        ),
    )


def _dock_row(window: MainWindow, dock: Dock) -> ActionRow:
    row = dock.row

    def toggle(studio: Studio) -> None:
        if not is_in_sight(dock):
            window.show_panel(row.id)
        elif has_keys(dock) or not studio.actions.is_by_keys(f"view.{row.id}"):
            window.hide_panel(row.id)
        else:
            window.show_panel(row.id)
            if not has_keys(dock):  # it has nothing that takes keys
                window.hide_panel(row.id)

    return ActionRow(
        f"view.{row.id}",
        row.title,
        "View",
        toggle,
        "panels",
        row.keys,
        f"Show or hide the panel {row.title}; pressed elsewhere, its keys go into it",
        enabled=when_open,
        checked=lambda _: not dock.isHidden(),
    )


def _way_row(window: MainWindow, name: str, text: str, steps: int, keys: str, icon: str) -> ActionRow:
    return ActionRow(
        f"view.{name}",
        text,
        "View",
        lambda _: _go_on(window, steps),
        "panels",
        keys,
        f"Let keys go to the {text.lower()} in sight, to the world, or to a message",
        icon,
        enabled=when_open,
    )


def _go_on(window: MainWindow, steps: int) -> None:
    """Let keys go to the world, a message or a panel in sight, so many places after where they go now."""
    said = [window.messages] if window.messages.isVisible() else []
    panels = [dock.widget() for dock in window.docks.values() if is_in_sight(dock)]
    places = [window.canvas, *said, *panels]
    at = next((k for k, place in enumerate(places) if has_keys(place)), -1 if steps > 0 else 0)
    for further in range(1, len(places) + 1):
        place = places[(at + further * steps) % len(places)]
        place.setFocus(Qt.FocusReason.ShortcutFocusReason)
        if has_keys(place):  # one that says what to do first may have nothing that takes keys
            return
