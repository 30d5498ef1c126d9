"""Agents drawn beforehand: every color and shape in 64 headings, in one pixmap from which a frame takes its pieces."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import ceil, pi

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QBrush, QColor, QPainter, QPainterPath, QPen, QPixmap, QPolygonF, QTransform

from ..arrays import FRAGMENT
from ..theme import mixed
from .coloring import BASICS, IDLES, SHAPES

HEADINGS = 64
#: Pixels: below, an agent is a dot; above, it does not grow any more.
DOT, LARGEST = 5.0, 40.0
#: The contrast to the ground from which on a color needs no edge.
CONTRAST = 4.0

#: An arrowhead of length 1 that points along x.
_ARROW = ((0.55, 0.0), (-0.45, 0.36), (-0.22, 0.0), (-0.45, -0.36))
#: A bar in front of the nose of those that are attached.
_BAR = ((0.62, -0.34), (0.62, 0.34))
_IDLE_RADIUS = 0.27


@dataclass(frozen=True, slots=True)
class Look:
    """How one sort of agents is drawn.

    Attributes:
        color: Red, green, blue.
        shape: See `app.editor.canvas.coloring`.
    """

    color: tuple[int, int, int]
    shape: int


@dataclass(frozen=True, slots=True)
class Style:
    """What all agents have in common.

    Attributes:
        size: Length of an arrow, pixels of the view.
        ratio: Pixels of the screen to one of the view.
        ground: Color behind them, as a name.
        text: Color that stands out from the ground.
    """

    size: float
    ratio: float
    ground: str
    text: str


class Atlas:
    """The pixmap for some looks in one style."""

    def __init__(self, looks: Sequence[Look], style: Style) -> None:
        self.style = style
        self.looks = tuple(looks)
        self._cell = 2 * ceil(max(style.size, 3.0) * 0.75 * style.ratio + 1.0)
        self._headings = HEADINGS if style.size >= DOT else 1
        self.pixmap = QPixmap(self._cell * self._headings, self._cell * max(len(looks), 1))
        self.pixmap.fill(Qt.GlobalColor.transparent)
        painter = QPainter(self.pixmap)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        for row, look in enumerate(looks):
            self._paint_row(painter, row, tuple(strokes_of(look, style)))
        painter.end()

    def _paint_row(self, painter: QPainter, row: int, strokes: Sequence[Stroke]) -> None:
        """One look in all headings; pens and shapes are made but once."""
        ratio = self.style.ratio
        turned = []
        for column in range(self._headings):
            turn = QTransform.fromTranslate((column + 0.5) * self._cell, (row + 0.5) * self._cell)
            turned.append(turn.scale(ratio, ratio).rotate(-column * 360.0 / self._headings))
        for stroke in strokes:
            painter.setPen(stroke.pen)
            painter.setBrush(stroke.brush)
            for turn in turned:
                painter.setTransform(turn)
                painter.drawPath(stroke.path)

    def fragments(
        self,
        x: NDArray[np.float64],
        y: NDArray[np.float64],
        heading: NDArray[np.float64],
        row: NDArray[np.int64],
        opacity: NDArray[np.float64],
    ) -> NDArray[np.float64]:
        """The pieces of the pixmap that show agents.

        Args:
            x, y: Pixels of the view.
            heading: Radians.
            row: Place among the looks.
        """
        made = np.empty((len(x), FRAGMENT))
        column = np.rint(heading * (self._headings / (2 * pi))).astype(np.int64) % self._headings
        made[:, 0], made[:, 1] = x, y
        made[:, 2], made[:, 3] = column * self._cell, row * self._cell
        made[:, 4] = made[:, 5] = self._cell
        made[:, 6] = made[:, 7] = 1.0 / self.style.ratio
        made[:, 8] = 0.0
        made[:, 9] = opacity
        return made


@dataclass(frozen=True, slots=True)
class Stroke:
    """A shape with its pen and brush."""

    pen: QPen
    brush: QBrush
    path: QPainterPath


def paint_agent(painter: QPainter, look: Look, style: Style) -> None:
    """An agent around the origin that heads along x."""
    for stroke in strokes_of(look, style):
        painter.setPen(stroke.pen)
        painter.setBrush(stroke.brush)
        painter.drawPath(stroke.path)


def strokes_of(look: Look, style: Style) -> Iterator[Stroke]:
    """What an agent is drawn from: it is filled, outlined, or a ring; a dot if it is very small."""
    color = QColor(*look.color)
    if style.size < DOT:
        radius = max(style.size * 0.38, 1.1)
        yield Stroke(QPen(Qt.PenStyle.NoPen), QBrush(color), _disk(radius))
        return
    shape, attached = look.shape % SHAPES, look.shape >= SHAPES
    width = min(max(style.size * 0.1, 1.1), 2.5)
    outline = QPen(color, width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap, Qt.PenJoinStyle.RoundJoin)
    hollow = shape in (BASICS, IDLES)
    pen = outline if hollow else QPen(_edge(color, style), max(width * 0.5, 0.8))
    yield Stroke(pen, QBrush(QColor(style.ground) if hollow else color), _body(shape, style.size))
    if attached:
        yield Stroke(QPen(color, width * 1.3), QBrush(Qt.BrushStyle.NoBrush), _bar(style.size))


def _edge(color: QColor, style: Style) -> QColor:
    """A color that hardly stands out from the ground needs an edge that does."""
    dark, bright = sorted((_luminance(color), _luminance(QColor(style.ground))))
    faint = (bright + 0.05) / (dark + 0.05) < CONTRAST
    return mixed(color.name(), style.text, 0.45) if faint else color


def _luminance(color: QColor) -> float:
    """As the guidelines for accessible content define it, from 0 to 1; gamma rounded to 2.2."""
    red, green, blue = (part**2.2 for part in (color.redF(), color.greenF(), color.blueF()))
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def _body(shape: int, size: float) -> QPainterPath:
    if shape == IDLES:
        path = _disk(_IDLE_RADIUS * size)
        path.moveTo(_IDLE_RADIUS * size, 0.0)
        path.lineTo(0.5 * size, 0.0)
        return path
    path = QPainterPath()
    path.addPolygon(QPolygonF([QPointF(x, y) * size for x, y in _ARROW]))
    path.closeSubpath()
    return path


def _disk(radius: float) -> QPainterPath:
    path = QPainterPath()
    path.addEllipse(QPointF(0.0, 0.0), radius, radius)
    return path


def _bar(size: float) -> QPainterPath:
    path = QPainterPath()
    path.addPolygon(QPolygonF([QPointF(x, y) * size for x, y in _BAR]))
    return path
