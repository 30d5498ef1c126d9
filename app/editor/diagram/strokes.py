"""Paths, arrow heads and texts of diagrams."""

from collections.abc import Sequence
from functools import lru_cache
from math import atan2, cos, hypot, pi, sin

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QFontMetricsF, QPainterPath, QPolygonF

from ..theme import CAPTION, TEXT, text_font

Point = tuple[float, float]
#: Length and half the width of an arrow head.
HEAD, HALF = 9.0, 4.0


def curve(points: Sequence[Point]) -> QPainterPath:
    """A run of cubic pieces."""
    path = QPainterPath(QPointF(*points[0]))
    for first in range(1, len(points) - 2, 3):
        path.cubicTo(*(QPointF(*point) for point in points[first : first + 3]))
    return path


def arrow_head(points: Sequence[Point], length: float = HEAD) -> QPolygonF:
    """The arrow head at the end of a run."""
    end = points[-1]
    before = next((p for p in reversed(points[:-1]) if hypot(p[0] - end[0], p[1] - end[1]) > 1.0), end)
    way = atan2(end[1] - before[1], end[0] - before[0])
    half = length * HALF / HEAD
    back = end[0] - length * cos(way), end[1] - length * sin(way)
    aside = half * cos(way + pi / 2), half * sin(way + pi / 2)
    corners = (end, (back[0] + aside[0], back[1] + aside[1]), (back[0] - aside[0], back[1] - aside[1]))
    return QPolygonF([QPointF(*corner) for corner in corners])


@lru_cache(maxsize=16)
def _metrics(pixels: int, bold: bool) -> QFontMetricsF:  # noqa: FBT001 - a key of the cache
    return QFontMetricsF(text_font(pixels, bold=bold))


def text_width(text: str, pixels: int = TEXT, *, bold: bool = False) -> float:
    """How wide a line of text is."""
    return _metrics(pixels, bold).horizontalAdvance(text)


def wrapped(text: str, width: float, lines: int, pixels: int = CAPTION, *, bold: bool = False) -> list[str]:
    """*text* in at most so many lines of a width, with dots where it is cut off."""
    found: list[str] = []
    line = ""
    words = text.split(" ")
    for number, word in enumerate(words):
        longer = f"{line} {word}" if line else word
        if not line or text_width(longer, pixels, bold=bold) <= width:
            line = longer
        elif len(found) == lines - 1:
            line = " ".join([line, *words[number:]])
            break
        else:
            found.append(line)
            line = word
    return [elided(text, width, pixels, bold=bold) for text in (*found, line)]


def elided(text: str, width: float, pixels: int = CAPTION, *, bold: bool = False) -> str:
    """*text*, with dots at its end where it is wider than *width*."""
    return _metrics(pixels, bold).elidedText(text, Qt.TextElideMode.ElideRight, width)
