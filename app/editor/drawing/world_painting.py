"""A world seen from above, in a figure."""

from dataclasses import dataclass
from math import cos, pi, sin

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPen, QPolygonF

from .brush import Brush, text_width
from .figures import Body, Walker, WorldView

#: What a world's title and caption need above it.
CAPTION = 46.0
#: Agents are drawn larger than they are, or they would not be seen.
AGENT = 5.0
#: The arrowhead: angle off the heading, and distance from the center.
ARROW = ((0.0, AGENT * 1.2), (pi * 0.78, AGENT), (pi, AGENT * 0.35), (-pi * 0.78, AGENT))
CELLS = 10


@dataclass(frozen=True, slots=True)
class View:
    """From a world's coordinates, y upward, to the figure's.

    Attributes:
        ground: Where the world is drawn.
        scale: Units of layout to a unit of the world.
    """

    world: WorldView
    ground: QRectF
    scale: float

    def point(self, x: float, y: float) -> QPointF:
        """Where a place in the world is drawn."""
        left, bottom = self.ground.left(), self.ground.bottom()
        return QPointF(
            left + (x - self.world.left) * self.scale, bottom - (y - self.world.bottom) * self.scale
        )


def paint_world(brush: Brush, world: WorldView, room: QRectF) -> None:
    """A title, then the world as large as the width and height of *room*, which begins above the title, allow."""
    brush.swatch(room.left(), room.top() + 8, world.color)
    brush.text(room.left() + 17, room.top() + 13, world.title, size=14, bold=True, room=room.width() - 17)
    caption = world.caption
    brush.text(room.left() + 17, room.top() + 31, caption, color=brush.colors.dim, room=room.width() - 17)
    scale = min(room.width() / world.width, room.height() / world.height)
    ground = QRectF(room.left(), room.top() + CAPTION, world.width * scale, world.height * scale)
    paint_ground(brush, world, ground)


def paint_ground(brush: Brush, world: WorldView, ground: QRectF) -> None:
    """The world alone, so that it fills *ground*, which has its proportions."""
    _paint_grid(brush, ground)
    with brush.clipped(ground):
        _paint_things(brush, View(world, ground, ground.width() / world.width))


def _paint_things(brush: Brush, view: View) -> None:
    """Bodies, agents over them, and counts over all."""
    for body in view.world.bodies:
        paint_body(brush, body, view.point(body.x, body.y), max(body.radius * view.scale, 3.0))
    for walker in sorted(view.world.walkers, key=lambda w: w.busy):
        paint_walker(brush, walker, view.point(walker.x, walker.y))
    for body in view.world.bodies:
        _paint_count(brush, body, view)


def _paint_grid(brush: Brush, ground: QRectF) -> None:
    brush.fill(brush.colors.canvas)
    brush.painter.drawRect(ground)
    brush.pen(brush.colors.grid)
    for k in range(1, CELLS):
        x, y = ground.left() + k * ground.width() / CELLS, ground.top() + k * ground.height() / CELLS
        brush.painter.drawLine(QLineF(x, ground.top(), x, ground.bottom()))
        brush.painter.drawLine(QLineF(ground.left(), y, ground.right(), y))
    brush.pen(brush.colors.hairline)
    brush.painter.drawRect(ground)


def paint_body(brush: Brush, body: Body, center: QPointF, radius: float) -> None:
    """A ring, green and thicker if as many hold it as it needs; a place is a cross within its range."""
    if body.place:
        brush.pen(brush.colors.dim, 1.0, Qt.PenStyle.DashLine)
        brush.painter.drawEllipse(center, radius, radius)
        paint_cross(brush, center, 5.0)
        return
    full = _full(body)
    brush.painter.setBrush(QColor(brush.colors.raised))
    brush.painter.setPen(QPen(QColor(brush.colors.good if full else brush.colors.text), 2.0 if full else 1.2))
    brush.painter.drawEllipse(center, radius, radius)


def _full(body: Body) -> bool:
    return 0 < body.needed <= body.got


def paint_cross(brush: Brush, center: QPointF, size: float) -> None:
    """The mark of a place."""
    brush.pen(brush.colors.text, 2.0)
    for slope in (1, -1):
        brush.painter.drawLine(center + QPointF(-size, -size * slope), center + QPointF(size, size * slope))


def paint_walker(brush: Brush, walker: Walker, center: QPointF) -> None:
    """An arrowhead: filled if the agent holds something."""
    angle = walker.heading
    points = [center + QPointF(r * cos(angle + a), -r * sin(angle + a)) for a, r in ARROW]
    color = brush.colors.accent if walker.busy else brush.colors.dim
    brush.pen(color)
    if walker.busy:
        brush.painter.setBrush(QColor(color))
    brush.painter.drawPolygon(QPolygonF(points))


def _paint_count(brush: Brush, body: Body, view: View) -> None:
    """How many hold it of how many it needs, beside it, where anyone does."""
    if body.got == 0:
        return
    words = f"{body.got}/{body.needed}"
    center, radius = view.point(body.x, body.y), body.radius * view.scale
    leftward = center.x() + radius + 5 + text_width(words, 11) > view.ground.right()
    x = center.x() + (-radius - 5 if leftward else radius + 5)
    y = max(center.y() - radius, view.ground.top() + 12)
    color = brush.colors.good if _full(body) else brush.colors.text
    brush.text(x, y, words, size=11, color=color, align="right" if leftward else "left")
