"""The colors of the states of an automaton, as bars and legends show them."""

from collections.abc import Mapping

from PySide6.QtGui import QColor

from ...core.automaton import Automaton, Basic, Nested
from ..behavior_colors import BehaviorColors
from ..palette import BASIC
from ..theme import Theme, mixed

#: Greys in turn, since all basic behaviors are grey: shares of the ground that is mixed in.
SHADES = (0.0, 0.45, 0.22, 0.6, 0.34, 0.7)


def state_colors(
    automaton: Automaton, type_name: str, colors: BehaviorColors, theme: Theme
) -> Mapping[str, QColor]:
    """A color for each state: its behavior's; those of basic behaviors and flags are greys that can be told apart.

    What a controller directs has the color of the behavior of that name.
    """
    found: dict[str, QColor] = {}
    grey = 0
    for state in automaton.states:
        if isinstance(state.content, Nested):
            found[state.id] = colors.color(type_name, state.content.automaton)
        elif isinstance(state.content, Basic) and colors.of_name(state.content.behavior) != QColor(BASIC):
            found[state.id] = colors.of_name(state.content.behavior)
        else:
            found[state.id] = mixed(BASIC, theme.palette.panel, SHADES[grey % len(SHADES)])
            grey += 1
    return found
