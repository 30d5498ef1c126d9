"""One frame, layer by layer."""

from __future__ import annotations

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QPainter, QPen

from .bodies import paint_bodies, paint_counts
from .crowd import paint_agents, paint_ranges, paint_rings, paint_trails
from .frame import Frame
from .ground import paint_ground, paint_places
from .group_painting import paint_band, paint_groups
from .ink import Ink

#: Around what can be chosen: pixels.
CHOICE = 15.0


def paint(painter: QPainter, frame: Frame, ink: Ink, controllers: list[QColor]) -> None:
    """Paint a frame.

    Args:
        controllers: The color of each controller.
    """
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    paint_ground(painter, frame)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    paint_groups(painter, frame, controllers)
    paint_trails(painter, frame)
    paint_places(painter, frame)
    paint_bodies(painter, frame, ink)
    paint_ranges(painter, frame)
    paint_agents(painter, frame, ink)
    paint_counts(painter, frame, ink)
    paint_rings(painter, frame, ink)
    _paint_choices(painter, frame)
    paint_band(painter, frame)


def _paint_choices(painter: QPainter, frame: Frame) -> None:
    """Rings around everything that can be chosen."""
    if not frame.targets:
        return
    x, y = frame.places()
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(QColor(frame.palette.teach), 1.6, Qt.PenStyle.DotLine))
    for entity in frame.targets:
        painter.drawEllipse(QPointF(x[entity], y[entity]), CHOICE, CHOICE)
