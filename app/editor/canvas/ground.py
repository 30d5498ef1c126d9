"""Painting what does not move: the ground, its grid, walls, and places such as a deposit."""

from __future__ import annotations

from math import ceil, floor, log10

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from ..arrays import draw_lines
from .frame import Frame

#: Pixels between two lines of the grid, at least.
APART = 34.0
#: Pixels: half the cross of a place.
CROSS = 9.0


def grid_step(scale: float) -> float:
    """Units between two lines of the grid: 1, 2 or 5 times a power of ten."""
    least = APART / scale
    power = 10.0 ** floor(log10(least))
    return next(power * k for k in (1.0, 2.0, 5.0, 10.0) if power * k >= least * (1 - 1e-9))


def paint_ground(painter: QPainter, frame: Frame) -> None:
    """Ground, grid, and walls where the world has some."""
    camera = frame.camera
    painter.fillRect(QRectF(0, 0, camera.width, camera.height), QColor(frame.palette.canvas))
    if frame.options.grid:
        _paint_grid(painter, frame)
    look = frame.scene.place.look
    if look.width > 0.0 and look.height > 0.0:
        left, bottom = camera.to_view(0.0, 0.0)
        right, top = camera.to_view(look.width, look.height)
        painter.setPen(QPen(QColor(frame.palette.hairline), 2.0))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(QRectF(QPointF(left, top), QPointF(right, bottom)))


def _paint_grid(painter: QPainter, frame: Frame) -> None:
    camera, shown = frame.camera, frame.camera.shown()
    step = grid_step(camera.scale)
    xs = np.arange(ceil(shown.left / step), floor(shown.right / step) + 1) * step
    ys = np.arange(ceil(shown.bottom / step), floor(shown.top / step) + 1) * step
    across, down = camera.to_view(np.asarray(xs, np.float64), np.asarray(ys, np.float64))
    across, down = np.floor(across) + 0.5, np.floor(down) + 0.5
    upright = np.stack((across, np.zeros_like(across), across, np.full_like(across, camera.height)), axis=1)
    level = np.stack((np.zeros_like(down), down, np.full_like(down, camera.width), down), axis=1)
    painter.setPen(QPen(QColor(frame.palette.grid), 1.0))
    draw_lines(painter, np.concatenate((upright, level)))


def paint_places(painter: QPainter, frame: Frame) -> None:
    """A cross for each place, and a dashed circle as far as it reaches."""
    look = frame.scene.place.look
    x, y = frame.places()
    for kind in look.places:
        reaches = [radius * frame.camera.scale for radius in look.ranges.get(kind, {}).values()]
        for entity in frame.scene.place.spans.get(kind, range(0)):
            _paint_place(painter, frame, QPointF(x[entity], y[entity]), reaches)


def _paint_place(painter: QPainter, frame: Frame, center: QPointF, reaches: list[float]) -> None:
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(QColor(frame.palette.dim), 1.0, Qt.PenStyle.DashLine))
    for radius in reaches:
        painter.drawEllipse(center, radius, radius)
    size = min([CROSS, *(max(radius * 0.5, 4.0) for radius in reaches)])
    painter.setPen(QPen(QColor(frame.palette.text), 2.5, c=Qt.PenCapStyle.RoundCap))
    for slope in (1, -1):
        painter.drawLine(center + QPointF(-size, -size * slope), center + QPointF(size, size * slope))
