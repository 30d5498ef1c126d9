"""Arrays of numbers as Qt's arrays of points, lines and fragments, without a Python object each."""

from __future__ import annotations

from typing import Any

import numpy as np
import shiboken6
from numpy.typing import NDArray
from PySide6.QtCore import QLineF
from PySide6.QtGui import QPainter, QPixmap, QPolygonF

#: Numbers of a `QPainter.PixmapFragment`: x, y, left, top, width and height in the pixmap, two scales, rotation, opacity.
FRAGMENT = 10

Floats = NDArray[np.float64]


def _first(numbers: Floats, kind: Any) -> Any:
    """The first of an array of Qt's, in the memory of *numbers*, which has to outlive it."""
    return shiboken6.wrapInstance(numbers.ctypes.data, kind)


def draw_fragments(painter: QPainter, fragments: Floats, pixmap: QPixmap) -> None:
    """Draw pieces of a pixmap: fragments x `FRAGMENT` numbers."""
    kept = np.ascontiguousarray(fragments, np.float64)
    if len(kept):
        painter.drawPixmapFragments(_first(kept, QPainter.PixmapFragment), len(kept), pixmap)


def draw_copies(painter: QPainter, pixmap: QPixmap, x: Floats, y: Floats) -> None:
    """Draw a pixmap around each of these places: one call for all, since each has to wait for Python's lock."""
    copies = np.zeros((len(x), FRAGMENT))
    copies[:, 0], copies[:, 1] = x, y
    copies[:, 4], copies[:, 5] = pixmap.width(), pixmap.height()
    copies[:, 6:8], copies[:, 9] = 1.0 / pixmap.devicePixelRatio(), 1.0
    draw_fragments(painter, copies, pixmap)


def draw_lines(painter: QPainter, lines: Floats) -> None:
    """Draw lines: lines x (x, y, x, y)."""
    kept = np.ascontiguousarray(lines, np.float64)
    if len(kept):
        painter.drawLines(_first(kept, QLineF), len(kept))


def draw_points(painter: QPainter, points: Floats) -> None:
    """Draw dots as wide as the pen: points x (x, y)."""
    if len(points):
        painter.drawPoints(_polygon(points))


def draw_polygon(painter: QPainter, points: Floats) -> None:
    """Draw a convex polygon: corners x (x, y)."""
    if len(points) > 2:
        painter.drawConvexPolygon(_polygon(points))


def _polygon(points: Floats) -> QPolygonF:
    polygon = QPolygonF()
    polygon.resize(len(points))
    memory: Any = shiboken6.VoidPtr(polygon.data(), len(points) * 16, True)  # type: ignore[call-arg, arg-type] # as it is
    np.frombuffer(memory, np.float64).reshape(-1, 2)[:] = points
    return polygon
