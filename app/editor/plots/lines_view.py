"""Lines over ticks, one for each key, in any color and dash."""

from __future__ import annotations

from collections.abc import Collection
from html import escape
from typing import TYPE_CHECKING, Any

import pyqtgraph as pg
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QResizeEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QVBoxLayout, QWidget

from ..plotting import dress, quiet_plot

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ..theme import Theme
    from .series import LineKey


#: Pixels below which the axis of ticks has no word, nor the other one, and those that it takes at least: no more than other
#: tabs at its place, or the world would become lower as soon as there is something to plot.
LOW, LOWER, LEAST = 140, 70, 40
#: How a line looks in the legend.
_STROKES = {
    Qt.PenStyle.SolidLine: "━━",
    Qt.PenStyle.DashLine: "╍╍",
    Qt.PenStyle.DotLine: "┅┅",
    Qt.PenStyle.DashDotLine: "━╍",
    Qt.PenStyle.DashDotDotLine: "━┅",
}


class LinesView(QWidget):
    """A plot of lines.

    Attributes:
        curves: Those that are drawn, by key.
        legend: What the lines are; above the plot rather than in it, where it would hide them.
    """

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self._plot = quiet_plot("plot over time")
        self.curves: dict[LineKey, Any] = {}
        self._entries: dict[LineKey, str] = {}
        self.legend = QLabel()
        self.legend.setProperty("role", "caption")
        self.legend.setTextFormat(Qt.TextFormat.RichText)
        self.legend.setAccessibleName("legend")
        self.legend.setContentsMargins(10, 0, 8, 2)
        self.legend.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._plot)
        self.setMinimumHeight(LEAST)
        theme.changed.connect(self._dress)
        self._dress()

    def keep(self, keys: Collection[LineKey]) -> None:
        """Draw no lines but these any more."""
        for key in [key for key in self.curves if key not in keys]:
            self._plot.removeItem(self.curves.pop(key))
            self._entries.pop(key, None)
        self._show_legend()

    def clear(self) -> None:
        """Draw nothing."""
        self.keep(())

    def begin(self, key: LineKey, name: str, color: QColor, style: Qt.PenStyle) -> None:
        """Draw one more line, empty at first."""
        self.curves[key] = pg.PlotCurveItem(pen=pg.mkPen(color, width=2, style=style))
        self._plot.addItem(self.curves[key])
        stroke = f'<span style="color: {color.name()}">{_STROKES[style]}</span>'
        self._entries[key] = f"{stroke}&nbsp;{escape(name).replace(' ', '&nbsp;')}"
        self._show_legend()

    def _show_legend(self) -> None:
        words = " &nbsp; ".join(self._entries.values())
        if words != self.legend.text():
            self.legend.setText(words)
            self.legend.setToolTip(words)

    def draw(self, key: LineKey, ticks: NDArray[np.float64], values: NDArray[np.float64]) -> None:
        """Give a line its points."""
        self.curves[key].setData(ticks, values)

    def scale(self, label: str, *, share: bool) -> None:
        """Say what is drawn; shares go from 0 to 1."""
        if share:
            self._plot.setYRange(0.0, 1.0)
        else:
            self._plot.enableAutoRange("y")
        left = self._plot.getAxis("left")
        left.setLabel(label)
        left.showLabel(self.height() >= LOWER)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """In a low panel the lines get the room of the words beside them."""
        super().resizeEvent(event)
        self._plot.getAxis("bottom").showLabel(self.height() >= LOW)
        self._plot.getAxis("left").showLabel(self.height() >= LOWER)

    def _dress(self) -> None:
        dress(self._plot, self._theme)
