"""Where the card of the first lesson can stand, so that it lies upon nobody who is looked at."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, QRect, QSize

if TYPE_CHECKING:
    from ..canvas.view import WorldCanvas

#: Pixels between the card and the edge of the canvas, or what lies there; and around somebody who is to be seen.
AWAY, AROUND = 16, 24


def corners(canvas: WorldCanvas, size: QSize) -> tuple[QRect, QRect]:
    """The lower one at the right, above the legend where that reaches there; and the upper one, beside the buttons."""
    return _lower(canvas, size), _upper(canvas, size)


def _lower(canvas: WorldCanvas, size: QSize) -> QRect:
    left, on_top = canvas.width() - size.width() - AWAY, canvas.on_top
    legend_reaches = on_top.legend.geometry().right() >= left - AWAY
    below = round(on_top.below) if legend_reaches else AWAY
    return QRect(QPoint(left, canvas.height() - size.height() - below), size)


def _upper(canvas: WorldCanvas, size: QSize) -> QRect:
    left, badge = canvas.width() - size.width() - round(canvas.on_top.beside), canvas.on_top.badge
    badge_reaches = badge.isVisibleTo(canvas) and badge.geometry().right() >= left - AWAY
    top = badge.geometry().bottom() if badge_reaches else 0
    return QRect(QPoint(left, top + AWAY), size)


def lies_upon(corner: QRect, canvas: WorldCanvas, node: str) -> bool:
    """Whether a card there hides a node, or some of the ring around it."""
    scene = canvas.scene
    entity = -1 if scene is None else scene.entity(node)
    if scene is None or entity < 0:
        return False
    x, y = canvas.looking.camera.to_view(float(scene.x[entity]), float(scene.y[entity]))
    return corner.adjusted(-AROUND, -AROUND, AROUND, AROUND).contains(round(x), round(y))
