"""Curves with their bands of confidence, which grow while an experiment runs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QLabel, QStackedLayout, QVBoxLayout, QWidget

from ..forms.parts import caption
from ..plotting import dress, quiet_plot
from .reach import reach

if TYPE_CHECKING:
    from ...engine.experiments.findings import Findings, Summary
    from ..theme import Theme

EMPTY = "Nothing has been run yet. Run (F5) draws the curves while the runs go on."
BAND_ALPHA = 46
DASHES = (Qt.PenStyle.SolidLine, Qt.PenStyle.DashLine, Qt.PenStyle.DotLine, Qt.PenStyle.DashDotLine)
#: More cells than this cannot be told apart in one plot; the first are drawn.
MOST = 12
CUT = "Bands of few runs go on beyond what is shown; they shrink with every run."


class CurvesView(QWidget):
    """The mean of a measure over time, a line a cell, each with its 95% band.

    Attributes:
        names: Of the lines that are drawn.
        cut: Says so where bands are higher than what is shown.
    """

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self.plot = quiet_plot("curves")
        self._legend = self.plot.addLegend(offset=(10, 8), labelTextSize="9pt")
        self._items: list[tuple[Any, Any]] = []  # line and band
        self._reach = pg.PlotCurveItem(pen=None)  # all that is to be seen, which nothing else says
        self.names: list[str] = []
        empty = QLabel(EMPTY)
        empty.setProperty("role", "empty")
        empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        empty.setWordWrap(True)
        self.cut = caption(CUT)
        self.cut.hide()
        full = QWidget()
        column = QVBoxLayout(full)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        column.addWidget(self.plot, 1)
        column.addWidget(self.cut)
        self._pages = QStackedLayout(self)
        self._pages.addWidget(empty)
        self._pages.addWidget(full)
        theme.changed.connect(self._dress)
        self._dress()

    def show_findings(self, found: Findings | None, measure: str) -> None:
        """Draw what was found so far of *measure*."""
        drawn = [s for s in found.summaries if s.runs][:MOST] if found is not None else []
        names = [summary.cell.name for summary in drawn]
        if names != self.names:
            self._begin(names)
        self._pages.setCurrentIndex(1 if names else 0)
        if found is None or measure not in found.curves:
            self._begin([])
            return
        row = found.curves.index(measure)
        for summary, items in zip(drawn, self._items, strict=True):
            _draw(summary, row, found.experiment.ticks, items)
        if drawn:
            shown, beyond = reach([s.curve[row] for s in drawn], [s.band[row] for s in drawn])
            self._reach.setData([0.0, float(found.experiment.ticks)], list(shown))
            self.cut.setVisible(beyond)
        if self.plot.getAxis("left").labelText != measure:
            self.plot.getAxis("left").setLabel(measure)

    def _begin(self, names: list[str]) -> None:
        self.plot.clear()
        self._legend.clear()
        self.names = names
        self.plot.addItem(self._reach)
        self._items = [self._line(number, name) for number, name in enumerate(names)]

    def _line(self, number: int, name: str) -> tuple[Any, Any]:
        lines = self._theme.palette.lines
        color = QColor(lines[number % len(lines)])
        shade = QColor(color)
        shade.setAlpha(BAND_ALPHA)
        style = DASHES[(number // len(lines)) % len(DASHES)]
        band = pg.PlotCurveItem(pen=None, brush=pg.mkBrush(shade), fillLevel="enclosed")
        line = pg.PlotCurveItem(pen=pg.mkPen(color, width=2, style=style), name=name)
        self.plot.addItem(band, ignoreBounds=True)
        self.plot.addItem(line, ignoreBounds=True)
        return line, band

    def _dress(self) -> None:
        dress(self.plot, self._theme)
        self.names = []  # lines take their colors anew when they are drawn next


def _draw(summary: Summary, row: int, ticks: int, items: tuple[Any, Any]) -> None:
    mean = summary.curve[row]
    x = np.linspace(0.0, ticks, len(mean))
    line, band = items
    line.setData(x, mean)
    # A single run has no band: its half width is not a number.
    half = np.nan_to_num(summary.band[row])
    around = np.concatenate((x, x[::-1]))  # along the lower edge and back along the upper one
    band.setData(around, np.concatenate((mean - half, (mean + half)[::-1])))
