"""How the strip of a run is painted: in few calls, since each of Qt's waits for its turn among the threads."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPen

from ..arrays import draw_lines
from ..behavior_colors import luminance
from ..diagram.strokes import elided, text_width
from ..theme import CAPTION, text_font

if TYPE_CHECKING:
    from ..theme import Theme

#: Pixels: of the words beside the rows, at the right, of the axis below, and between two marks of it at least.
LEFT, RIGHT, AXIS, APART = 76, 16, 20, 64
#: How high what is drawn in a row is at most; the dot of a pick; half as high as a mark of what was counted.
BAND, DOT, MARK = 16.0, 4.0, 6.0
#: From this luminance on, words on a color are dark.
BRIGHT = 0.3


@dataclass(frozen=True, slots=True)
class Places:
    """Where ticks and rows are.

    Attributes:
        first, last: The ticks at both ends.
        left, width: Where the first tick is, and how far the last is from it.
        height: Of all rows together.
        rows: How many there are.
    """

    first: int
    last: int
    left: float
    width: float
    height: float
    rows: int

    @property
    def row(self) -> float:
        """How high a row is."""
        return self.height / self.rows

    @property
    def band(self) -> float:
        """How high what is drawn in a row is."""
        return min(BAND, self.row - 3.0)

    def x_of(self, tick: float) -> float:
        """Where a tick is."""
        return self.left + (tick - self.first) / (self.last - self.first) * self.width

    def tick_at(self, x: float) -> int:
        """Which tick is at a place, or nearest to it."""
        share = min(1.0, max(0.0, (x - self.left) / self.width))
        return round(self.first + share * (self.last - self.first))

    def middle_of(self, row: int) -> float:
        """Where a row has its middle."""
        return self.row * (row + 0.5)

    def band_of(self, row: int) -> QRectF:
        """Where what happens is drawn in a row."""
        return QRectF(self.left, self.middle_of(row) - self.band / 2, self.width, self.band)


@dataclass(frozen=True, slots=True)
class DrawnLine:
    """What one node does: all that is short, and what has room for words by the pixels from the left where it begins and ends."""

    picture: QImage
    long: Sequence[tuple[int, int, str, QColor]]


@dataclass(frozen=True, slots=True)
class Drawn:
    """What is drawn.

    Attributes:
        rows: The words beside the rows: picks, all agents, each of *lines*, and perhaps what is counted.
        shares: What all agents do, if anything is known of it.
        counted: The ticks at which what is counted grew.
        earliest: What was before is paler.
    """

    rows: Sequence[str]
    shares: QImage | None
    lines: Sequence[DrawnLine]
    counted: Sequence[int]
    picks: Sequence[int]
    now: int
    earliest: int | None


class StripPainter:
    """Paints on one painter."""

    def __init__(self, painter: QPainter, theme: Theme, places: Places) -> None:
        self._painter, self._theme, self._places = painter, theme, places

    def paint(self, drawn: Drawn) -> None:
        """Draw the rows, the axis, and where the world is now."""
        self._painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._painter.setFont(text_font(CAPTION))
        self._paint_words(drawn.rows)
        self._paint_axis()
        if drawn.shares is not None:
            self._painter.drawImage(self._places.band_of(1), drawn.shares)
        for row, line in enumerate(drawn.lines, start=2):
            self._paint_line(row, line)
        self._paint_counted(drawn.counted)
        self._fade(drawn.earliest)
        self._paint_now(drawn.now)
        self._paint_picks(drawn.picks)

    def _paint_words(self, rows: Sequence[str]) -> None:
        height = self._places.row
        self._painter.setPen(self._theme.color("dim"))
        for row, words in enumerate(rows):
            place = QRectF(10, height * row, LEFT - 18, height)
            self._painter.drawText(place, Qt.AlignmentFlag.AlignVCenter, elided(words, LEFT - 18))

    def _paint_axis(self) -> None:
        places, bottom = self._places, self._places.height
        step = step_of(places.last - places.first, max(1, int(places.width // APART)))
        ticks = range(-(-places.first // step) * step, places.last + 1, step)
        self._painter.setPen(QPen(self._theme.color("hairline"), 1.0))
        self._draw_upright(ticks, 2.0, bottom)
        self._painter.setPen(self._theme.color("dim"))
        for tick in ticks:
            place = QRectF(places.x_of(tick) - APART / 2, bottom, APART, AXIS)
            self._painter.drawText(place, Qt.AlignmentFlag.AlignCenter, short(tick))

    def _draw_upright(self, ticks: Sequence[int], top: float, bottom: float) -> None:
        lines = np.empty((len(ticks), 4))
        lines[:, 0] = lines[:, 2] = [self._places.x_of(tick) for tick in ticks]
        lines[:, 1], lines[:, 3] = top, bottom
        draw_lines(self._painter, lines)

    def _paint_line(self, row: int, line: DrawnLine) -> None:
        band = self._places.band_of(row)
        self._painter.drawImage(band, line.picture)
        for left, right, words, color in line.long:
            place = QRectF(band.left() + left, band.top(), right - left - 1.0, band.height())
            self._painter.setPen(Qt.PenStyle.NoPen)
            self._painter.setBrush(color)
            self._painter.drawRoundedRect(place, 3.0, 3.0)
            if text_width(words, CAPTION) <= place.width() - 8:
                self._painter.setPen(QColor("#14161b" if luminance(color) > BRIGHT else "#ffffff"))
                self._painter.drawText(place, Qt.AlignmentFlag.AlignCenter, words)

    def _paint_counted(self, ticks: Sequence[int]) -> None:
        middle = self._places.middle_of(self._places.rows - 1)
        self._painter.setPen(QPen(self._theme.color("good"), 2.0))
        self._draw_upright(ticks, middle - MARK, middle + MARK)

    def _fade(self, earliest: int | None) -> None:
        """What cannot be gone back to any more is paler."""
        if earliest:
            veil = self._theme.color("panel")
            veil.setAlphaF(0.55)
            right = self._places.x_of(min(earliest, self._places.last))
            self._painter.fillRect(QRectF(LEFT, 0, max(0.0, right - LEFT), self._places.height), veil)

    def _paint_picks(self, ticks: Sequence[int]) -> None:
        self._painter.setPen(Qt.PenStyle.NoPen)
        self._painter.setBrush(self._theme.color("teach"))
        for tick in ticks:
            self._painter.drawEllipse(QPointF(self._places.x_of(tick), self._places.middle_of(0)), DOT, DOT)

    def _paint_now(self, now: int) -> None:
        x, bottom = self._places.x_of(now), self._places.height
        color = self._theme.color("accent")
        self._painter.setPen(QPen(color, 1.5))
        self._painter.drawLine(QPointF(x, 2), QPointF(x, bottom))
        self._painter.setBrush(color)
        self._painter.drawEllipse(QPointF(x, bottom), DOT, DOT)


def step_of(length: int, most: int) -> int:
    """A round number of ticks between two marks, so that there are at most so many of them."""
    step = 1
    while length / step > most:
        for factor in (2, 5, 10):
            if length / (step * factor) <= most:
                return step * factor
        step *= 10
    return step


def short(tick: int) -> str:
    """A tick in few letters: "500", "7k", "1.5k", "2M"."""
    for size, letter in ((1_000_000, "M"), (1_000, "k")):
        if tick >= size:
            return f"{tick / size:.2f}".rstrip("0").rstrip(".") + letter
    return str(tick)
