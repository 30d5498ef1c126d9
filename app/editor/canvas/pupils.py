"""Who is taught, and whose turn it is: told apart by how rings are drawn and by numbers, not by colors."""

from collections.abc import Set as AbstractSet

from PySide6.QtCore import QPointF, QSizeF, Qt
from PySide6.QtGui import QColor, QPainter, QPen, QPixmap

from ..turn_mark import HEIGHT, mark_width, paint_mark
from .frame import Frame, agents_of
from .ink import Ink
from .stamp import stamp

#: Pixels of rings: of one that is taught alone, of the one whose turn it is, of one that waits for its own.
ALONE, ITS_TURN, WAITS = 2.0, 3.6, 1.6
#: Up to so many agents have wide rings, and numbers.
MOST_WIDE = 60


def paint_pupils(painter: QPainter, frame: Frame, ink: Ink, radius: float, *, crowded: bool) -> None:
    """A ring around each that is taught: of several, a thick one where it is its turn, and dashed ones where it is not.

    Args:
        radius: Of the rings, pixels.
        crowded: They are too many for wide rings, but for the one whose turn it is.
    """
    color = QColor(frame.palette.teach)
    if len(frame.taught) < 2 or frame.turn not in frame.taught:
        if not crowded:
            _paint_rings(painter, frame, frame.taught, radius, QPen(color, ALONE))
        return
    waiting = QPen(color, WAITS, Qt.PenStyle.CustomDashLine)
    waiting.setDashPattern([4.0, 2.6])
    shown = frozenset({frame.turn}) if crowded else frozenset(frame.taught)
    _paint_rings(painter, frame, shown - {frame.turn}, radius, waiting)
    _paint_rings(painter, frame, {frame.turn}, radius + 0.5, QPen(color, ITS_TURN))
    if len(frame.pupils) <= MOST_WIDE:
        _paint_numbers(painter, frame, ink, radius)


def _paint_rings(painter: QPainter, frame: Frame, nodes: AbstractSet[str], radius: float, pen: QPen) -> None:
    """Around agents, and around those under controllers, if they are not too many."""
    x, y = frame.places()
    painter.setPen(pen)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for entity in agents_of(frame.scene, nodes)[:MOST_WIDE].tolist():
        painter.drawEllipse(QPointF(x[entity], y[entity]), radius, radius)


def _paint_numbers(painter: QPainter, frame: Frame, ink: Ink, radius: float) -> None:
    """Above agents, to the left, where labels are not; a controller's agents share its turn."""
    x, y = frame.places()
    aside = (radius + 3.0) * 0.7071
    for number, node in enumerate(frame.pupils, 1):
        entity = frame.scene.entity(node)
        if entity < 0 or node not in frame.taught:
            continue
        mark = _mark(frame, ink, number, its_turn=node == frame.turn)
        size = mark.deviceIndependentSize()
        left, top = x[entity] - aside - size.width() / 2, y[entity] - aside - size.height() / 2
        painter.drawPixmap(QPointF(left, top), mark)


def _mark(frame: Frame, ink: Ink, number: int, *, its_turn: bool) -> QPixmap:
    """A number, drawn once for each."""
    size = QSizeF(mark_width(number) + 1.0, HEIGHT + 1.0)

    def draw(onto: QPainter) -> None:
        paint_mark(onto, number, frame.palette, its_turn=its_turn)

    key = "turn", number, its_turn, frame.palette.teach, frame.ratio
    return ink.pixmap(key, lambda: stamp(size, frame.ratio, draw))
