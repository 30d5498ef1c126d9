"""A node of a decision tree as it is drawn, with the line up to its parent."""

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QPainter, QPen
from PySide6.QtWidgets import QGraphicsItem

from ...core.conditions import InArc
from ..diagram.strokes import elided, wrapped
from ..theme import CAPTION, Theme, mixed, text_font
from .shape import HEIGHT, WIDTH, Knot

RADIUS, BAR, ARC = 7.0, 4.0, 20.0
#: Pixels for one of the scene below which nobody can read, so that nothing is written.
LEGIBLE = 0.3


@dataclass(frozen=True, slots=True)
class NodeWords:
    """What stands in a node.

    Attributes:
        title: The test as a question, or the state that a leaf leads to.
        under: How many examples, and how sure.
        bar: Share and color of each label, and whether a prune forbids it.
        arc: For a test of an angle: the arc, and the period.
        tip: What is said under the mouse.
        is_leaf: Whether nothing is tested here.
    """

    title: str
    under: str
    bar: tuple[tuple[float, QColor, bool], ...]
    arc: tuple[InArc, float] | None = None
    tip: str = ""
    is_leaf: bool = False


class NodeItem(QGraphicsItem):
    """Draws one node; its words are found when it is seen first, since of a large tree most are not in sight.

    Attributes:
        knot: What it is, and where.
        box: The box, around (0, 0).
    """

    box = QRectF(-WIDTH / 2, -HEIGHT / 2, WIDTH, HEIGHT)

    def __init__(
        self, knot: Knot, tell: Callable[[], NodeWords], theme: Theme, parent_at: tuple[float, float] | None
    ) -> None:
        super().__init__()
        self.knot, self._tell, self._theme = knot, tell, theme
        self._told: NodeWords | None = None
        self._lit = self._chosen = False
        self._up = None if parent_at is None else QPointF(*parent_at) - QPointF(*knot.at)
        around = self.box.adjusted(-6, -6, 6, 20)
        line = None if self._up is None else QRectF(self._up, self.box.center()).normalized()
        self._around = around if line is None else around.united(line)  # with the line up
        self.setPos(QPointF(*knot.at))

    @property
    def words(self) -> NodeWords:
        """What stands in it."""
        if self._told is None:
            self._told = self._tell()
        return self._told

    def expander(self) -> QRectF:
        """What opens what is hidden below; empty if nothing is."""
        return QRectF(-24, HEIGHT / 2 - 2, 48, 18) if self.knot.hidden else QRectF()

    def show_as(self, *, lit: bool, chosen: bool) -> None:
        """Whether the selected node's decision passes here, and whether it is selected."""
        if (lit, chosen) != (self._lit, self._chosen):
            self._lit, self._chosen = lit, chosen
            self.setZValue(float(lit))
            self.update()

    def boundingRect(self) -> QRectF:
        """The box, and what is drawn around it."""
        return self._around

    # -------------------------------------------------------------------------------------------- painting

    def paint(self, painter: QPainter, _option: object, _widget: object = None) -> None:
        """Draw it; from afar, boxes and lines only."""
        if painter.worldTransform().m11() < LEGIBLE:
            self._paint_from_afar(painter)
            return
        self._paint_line(painter)
        color = "accent" if self._lit else "hairline"
        painter.setPen(QPen(self._theme.color(color), 2.0 if self._lit else 1.2))
        painter.setBrush(self._theme.color("raised"))
        painter.drawRoundedRect(self.box, RADIUS, RADIUS)
        if self._chosen:
            painter.setPen(QPen(self._theme.color("accent"), 1.5))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRoundedRect(self.box.adjusted(-4, -4, 4, 4), RADIUS + 3, RADIUS + 3)
        self._paint_inside(painter)

    def _paint_from_afar(self, painter: QPainter) -> None:
        """In lines of a pixel, however small the box is."""
        color = self._theme.color("accent") if self._lit or self._chosen else self._faint()
        painter.setPen(QPen(color, 0))
        painter.setBrush(color if self._chosen else self._theme.color("raised"))
        if self._up is not None:
            painter.drawLine(*self._line(self._up))
        painter.drawRect(self.box)

    def _paint_inside(self, painter: QPainter) -> None:
        self._paint_words(painter)
        self._paint_bar(painter)
        if self.words.arc is not None:
            self._paint_arc(painter, *self.words.arc)
        if self.knot.hidden:
            self._paint_hidden(painter)

    def _line(self, up: QPointF) -> tuple[QPointF, QPointF]:
        return up + QPointF(0, HEIGHT / 2), QPointF(0, -HEIGHT / 2)

    def _paint_line(self, painter: QPainter) -> None:
        if self._up is None:
            return
        start, end = self._line(self._up)
        painter.setPen(
            QPen(self._theme.color("accent") if self._lit else self._faint(), 2.4 if self._lit else 1.4)
        )
        painter.drawLine(start, end)
        middle = start + (end - start) * 0.55
        around = QRectF(middle.x() - 14, middle.y() - 8, 28, 15)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(self._theme.color("panel"))
        painter.drawRect(around)
        painter.setPen(self._theme.color("text" if self._lit else "dim"))
        painter.setFont(text_font(CAPTION))
        painter.drawText(around, Qt.AlignmentFlag.AlignCenter, "yes" if self.knot.key % 2 else "no")

    def _faint(self) -> QColor:
        return mixed(self._theme.palette.dim, self._theme.palette.panel, 0.55)

    def _paint_words(self, painter: QPainter) -> None:
        room = self.box.adjusted(6, 2, -6, -8)
        if self.words.arc is not None:
            room.setRight(room.right() - ARC)
        lines = wrapped(self.words.title, room.width(), 2, CAPTION, bold=self.words.is_leaf)
        height = room.height() / (len(lines) + 1)
        painter.setFont(text_font(CAPTION, bold=self.words.is_leaf))
        painter.setPen(self._theme.color("text"))
        for number, line in enumerate(lines):
            place = QRectF(room.left(), room.top() + number * height, room.width(), height)
            painter.drawText(place, Qt.AlignmentFlag.AlignCenter, line)
        painter.setFont(text_font(CAPTION))
        painter.setPen(self._theme.color("dim"))
        place = QRectF(room.left(), room.top() + len(lines) * height, room.width(), height)
        under = elided(self.words.under, room.width(), CAPTION)
        painter.drawText(place, Qt.AlignmentFlag.AlignCenter, under)

    def _paint_bar(self, painter: QPainter) -> None:
        room = QRectF(self.box.left() + RADIUS, self.box.bottom() - BAR - 3, WIDTH - 2 * RADIUS, BAR)
        left = room.left()
        for share, color, is_pruned in self.words.bar:
            width = share * room.width()
            pattern = Qt.BrushStyle.Dense6Pattern if is_pruned else Qt.BrushStyle.SolidPattern
            painter.fillRect(QRectF(left, room.top(), max(0.5, width - 1), BAR), QBrush(color, pattern))
            left += width

    def _paint_arc(self, painter: QPainter, arc: InArc, period: float) -> None:
        """A small compass: ahead is up, and the arc of the test is filled."""
        circle = QRectF(self.box.right() - ARC - 5, self.box.center().y() - ARC / 2 - 3, ARC, ARC)
        painter.setPen(QPen(self._theme.color("hairline"), 1.0))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawEllipse(circle)
        turn = 360.0 / period
        start, end = arc.start * turn, arc.end * turn
        sweep = (end - start) % 360.0
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(self._theme.color("accent"))
        painter.drawPie(circle.adjusted(1, 1, -1, -1), round((start + 90.0) * 16), round(sweep * 16))

    def _paint_hidden(self, painter: QPainter) -> None:
        painter.setPen(QPen(self._theme.color("hairline"), 1.0))
        painter.setBrush(self._theme.color("panel"))
        place = self.expander()
        painter.drawRoundedRect(place, 8, 8)
        painter.setPen(self._theme.color("dim"))
        painter.setFont(text_font(CAPTION))
        painter.drawText(place, Qt.AlignmentFlag.AlignCenter, f"+{self.knot.hidden}")
