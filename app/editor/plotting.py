"""Plots of pyqtgraph in the looks of the window: quiet axes, a legend, and nothing that pops up.

Importing it takes a tenth of a second or two, so panels do that when they are looked at first.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import pyqtgraph as pg

from .theme import CAPTION, text_font

if TYPE_CHECKING:
    from .theme import Theme


#: Pixels that a number takes from top to bottom, with what keeps it from the next one.
LINE = 15


class _Amounts(pg.AxisItem):  # type: ignore[misc]  # pyqtgraph has no types
    """An axis on which thousands are told apart, as in all words of the window, and numbers do not touch."""

    def tickValues(self, least: float, most: float, size: float) -> list[tuple[float, Sequence[float]]]:
        """Where numbers stand, by their distance: beside a low plot at its ends."""
        levels: list[tuple[float, Sequence[float]]] = super().tickValues(least, most, size)
        lines = max(1, int(size // LINE))
        if self.orientation != "left" or not levels or len(levels[0][1]) <= lines:
            return levels
        distance, values = levels[0]
        return [(distance, [*values[: lines > 1], values[-1]])]

    def tickStrings(self, values: Sequence[float], scale: float, spacing: float) -> list[str]:
        """The words at these places."""
        plain = super().tickStrings(values, scale, spacing)
        return [
            f"{value * scale:,.0f}" if abs(value * scale) >= 1_000 and spacing * scale >= 1 else words
            for value, words in zip(values, plain, strict=True)
        ]


def quiet_plot(name: str) -> Any:
    """A plot over ticks; *name* is for those who cannot see it."""
    plot = pg.PlotWidget(enableMenu=False, axisItems={side: _Amounts(side) for side in ("bottom", "left")})
    plot.hideButtons()
    plot.setMouseEnabled(x=True, y=False)
    plot.setAccessibleName(name)
    plot.getAxis("bottom").setLabel("tick")
    plot.getAxis("bottom").enableAutoSIPrefix(False)
    return plot


def dress(plot: Any, theme: Theme) -> None:
    """Give a plot the colors of the theme."""
    plot.setBackground(theme.color("panel"))
    for side in ("left", "bottom"):
        axis = plot.getAxis(side)
        axis.setPen(theme.color("hairline"))
        axis.setTextPen(theme.color("dim"))
        axis.setTickFont(text_font(CAPTION))
        shown = axis.label.isVisible()
        axis.setLabel(axis.labelText, **{"font-size": f"{CAPTION}px", "color": theme.color("dim").name()})
        axis.showLabel(shown)
    legend = plot.getPlotItem().legend
    if legend is not None:
        legend.setLabelTextColor(theme.color("text"))
        for _, label in legend.items:
            label.setText(label.text, color=theme.color("text"))
