"""What can be done on the canvas, as rows of the table of actions."""

from __future__ import annotations

from collections.abc import Callable

from ..actions import ActionRow, When, when_there
from .coloring import COLOR_WORDS, ColorBy
from .looking import STEP, Looking

#: Name among the options, text, tip, keys.
_SHOWN = (
    (
        "hulls",
        "Group hulls",
        "Outline the agents of every controller; of hundreds, of the highest levels and of who is selected",
        "Ctrl+Shift+H",
    ),
    (
        "links",
        "Controller links",
        "Draw lines from every controller to who is under it; of hundreds, from the highest and the selected",
        "Ctrl+Shift+L",
    ),
    ("ranges", "Ranges of the selected", "Show how far the selected agents see and reach", ""),
    (
        "trails",
        "Trails of the selected",
        "Show where the selected agents have been, if they are 40 or fewer",
        "",
    ),
    ("all_trails", "Trails of all", "Show where all agents have been, if they are 500 or fewer", ""),
    ("grid", "Grid", "Show lines every so many units", ""),
)


def camera_rows(looking: Looking) -> tuple[ActionRow, ...]:
    """Zooming, fitting, following."""

    def row(name: str, text: str, do: Callable[[], object], keys: str, tip: str, icon: str) -> ActionRow:
        return ActionRow(
            f"canvas.{name}", text, "View", lambda _: do(), "camera", keys, tip, icon, when_there
        )

    return (
        row(
            "zoom_in",
            "Zoom in",
            lambda: looking.zoom(STEP),
            "Ctrl+=",
            "Show less of the world, larger",
            "plus",
        ),
        row(
            "zoom_out",
            "Zoom out",
            lambda: looking.zoom(1 / STEP),
            "Ctrl+-",
            "Show more of the world, smaller",
            "minus",
        ),
        row("fit", "Fit the world", looking.fit, "Ctrl+0", "Show all of the world", "fit-to-screen-outline"),
        ActionRow(
            "canvas.follow",
            "Follow the selected",
            "View",
            lambda _: looking.follow(on=not looking.follows),
            "camera",
            "Ctrl+Shift+F",
            "Keep the selected agent, or the agents of the selected controller, in the middle",
            "crosshairs-gps",
            When(
                lambda studio: when_there(studio) and bool(studio.selection.nodes),
                "select an agent or a controller first",
            ),
            lambda _: looking.follows,
        ),
    )


def shown_rows(looking: Looking) -> tuple[ActionRow, ...]:
    """What is shown besides the agents."""

    def row(name: str, text: str, tip: str, keys: str) -> ActionRow:
        return ActionRow(
            f"canvas.{name}",
            text,
            "View",
            lambda _: looking.show(name, on=not getattr(looking.options, name)),
            "world",
            keys,
            tip,
            enabled=when_there,
            checked=lambda _: getattr(looking.options, name),
        )

    return tuple(row(*shown) for shown in _SHOWN)


def color_rows(looking: Looking) -> tuple[ActionRow, ...]:
    """What colors tell."""

    def row(by: ColorBy) -> ActionRow:
        words = COLOR_WORDS[by]
        return ActionRow(
            f"canvas.color_{by}",
            f"Color by {words[0].lower()}{words[1:]}",
            "View",
            lambda _: looking.color(by),
            "colors",
            tip=_TIPS[by],
            enabled=when_there,
            checked=lambda _: looking.color_by is by,
        )

    return tuple(row(by) for by in ColorBy)


_TIPS = {
    ColorBy.CURRENT: "An agent has the color of what the state of its outermost automaton holds",
    ColorBy.OUTERMOST: "An agent has the color of what it was directed to do, or of what is taught",
    ColorBy.INNERMOST: "An agent has the color of the last automaton on its path",
    ColorBy.BASIC: "An agent has the color of the basic behavior that it carries out",
    ColorBy.GROUP: "An agent has the color of its own controller",
}
