"""Lines over ticks, one for each key, in any color and dash."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, Any

import pyqtgraph as pg
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QVBoxLayout, QWidget

from ..plotting import dress, quiet_plot

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from ..theme import Theme
    from .series import LineKey


class LinesView(QWidget):
    """A plot of lines.

    Attributes:
        curves: Those that are drawn, by key.
    """

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self._plot = quiet_plot("plot over time")
        self._legend = self._plot.addLegend(offset=(-8, 8), labelTextSize="8pt")
        self.curves: dict[LineKey, Any] = {}
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._plot)
        theme.changed.connect(self._dress)
        self._dress()

    def keep(self, keys: Collection[LineKey]) -> None:
        """Draw no lines but these any more."""
        for key in [key for key in self.curves if key not in keys]:
            self._plot.removeItem(self.curves.pop(key))

    def clear(self) -> None:
        """Draw nothing."""
        self.keep(())
        self._legend.clear()

    def begin(self, key: LineKey, name: str, color: QColor, style: Qt.PenStyle) -> None:
        """Draw one more line, empty at first."""
        self.curves[key] = self._plot.plot(pen=pg.mkPen(color, width=2, style=style), name=name)

    def draw(self, key: LineKey, ticks: NDArray[np.float64], values: NDArray[np.float64]) -> None:
        """Give a line its points."""
        self.curves[key].setData(ticks, values)

    def scale(self, label: str, *, share: bool) -> None:
        """Say what is drawn; shares go from 0 to 1."""
        if share:
            self._plot.setYRange(0.0, 1.0)
        else:
            self._plot.enableAutoRange("y")
        self._plot.getAxis("left").setLabel(label)

    def _dress(self) -> None:
        dress(self._plot, self._theme)
