"""What can be done with the graph."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...core.edits import forget_layout
from ..actions import ActionRow, needs
from .authoring_rows import authoring_rows
from .picking import picking_row

if TYPE_CHECKING:
    from ..studio import Studio
    from .panel import GraphPanel

STEP = 1.25


def graph_rows(panel: GraphPanel) -> tuple[ActionRow, ...]:
    """Looking at the graph, and where states stand."""

    @needs("choose a behavior in the library first, and show the panel Automaton")
    def shows(_studio: Studio) -> bool:
        return panel.root is not None and panel.isVisible()

    @needs("select a state that holds an automaton in the graph first")
    def has_nested(_studio: Studio) -> bool:
        current = panel.scene.current
        return panel.isVisible() and current is not None and bool(panel.scene.states[current].state.nested)

    @needs("nothing was moved by hand in the graph that is shown")
    def has_layout(studio: Studio) -> bool:
        key = panel.root
        return (
            panel.isVisible()
            and key is not None
            and bool(studio.document.project.layout_of(key.type, key.id))
        )

    def arrange(studio: Studio) -> None:
        if panel.root is not None:
            studio.document.attempt(forget_layout, panel.root.type, panel.root.id)
        panel.view.fit()

    return (
        ActionRow(
            "graph.zoom_in",
            "Zoom the automaton in",
            "",
            lambda _: panel.view.zoom(STEP),
            icon="magnify-plus-outline",
            tip="Larger; the wheel does the same",
            enabled=shows,
        ),
        ActionRow(
            "graph.zoom_out",
            "Zoom the automaton out",
            "",
            lambda _: panel.view.zoom(1 / STEP),
            icon="magnify-minus-outline",
            tip="Smaller; the wheel does the same",
            enabled=shows,
        ),
        ActionRow(
            "graph.fit",
            "Fit the automaton in",
            "",
            lambda _: panel.view.fit_whole(),
            icon="fit-to-page-outline",
            tip="Show the whole automaton",
            enabled=shows,
        ),
        ActionRow(
            "graph.arrange",
            "Arrange the automaton anew",
            "Behavior",
            arrange,
            "graph",
            icon="auto-fix",
            tip="Forget where states were moved by hand",
            enabled=has_layout,
        ),
        ActionRow(
            "graph.expand",
            "Open the state in place",
            "Behavior",
            lambda _: panel.toggle(),
            "graph",
            "Ctrl+Shift+E",
            "Show the automaton of the selected state inside it, or close it again",
            "arrow-expand-vertical",
            has_nested,
        ),
        ActionRow(
            "graph.enter",
            "Go into the state's automaton",
            "Behavior",
            lambda _: panel.open_state(panel.scene.current or ()),
            "graph",
            tip="Show the automaton of the selected state by itself; Enter does the same",
            icon="arrow-down-right",
            enabled=has_nested,
        ),
        picking_row(panel),
        *authoring_rows(panel),
    )
