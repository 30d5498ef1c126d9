"""A transition as it is drawn: solid where it was learned, dashed where it was authored, dotted where it is pruned."""

from functools import lru_cache
from html import escape
from math import log2

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPainterPathStroker, QPen
from PySide6.QtWidgets import QGraphicsItem

from ...export.graph import Edge
from ..diagram.strokes import arrow_head, curve, text_width, wrapped
from ..theme import CAPTION, Theme, mixed, text_font
from .arrangement import Run
from .labels import Label
from .state_item import Path

THINNEST, THICKEST = 1.3, 5.0
LABEL_WIDTH, LINE, MOST_LINES = 94.0, 14.0, 3
#: Around the middle of a pruned edge.
CROSS = 4.0


#: Measuring text takes longer than all else; an automaton of 120 edges is measured at every edit.
@lru_cache(maxsize=4096)
@lru_cache(maxsize=4096)
def label_size(label: Label) -> tuple[float, float]:
    """Width and height of what stands at an edge."""
    lines = lines_of(label)
    return max(text_width(line, CAPTION) for line in lines) + 8.0, len(lines) * LINE


@lru_cache(maxsize=4096)
def lines_of(label: Label) -> tuple[str, ...]:
    """What stands at an edge, line by line; the last one says how sure it is."""
    return (*wrapped(label.when, LABEL_WIDTH, MOST_LINES), *wrapped(label.how, LABEL_WIDTH, 1))


class EdgeItem(QGraphicsItem):
    """Draws one edge; whoever owns it says where.

    Attributes:
        level: State ids down to the automaton that it belongs to.
        edge: What it is.
    """

    def __init__(self, level: Path, edge: Edge, label: Label, theme: Theme, *, labeled: bool) -> None:
        super().__init__()
        self.level, self.edge, self._theme = level, edge, theme
        self._labeled = labeled
        self._lines = lines_of(label)
        self._size = label_size(label)
        self._chosen = self._hovered = False
        self.problem = self._tip = ""
        self._run = Run(((0.0, 0.0),) * 4, (0.0, 0.0))
        self._path = QPainterPath()
        self._bounds = QRectF()
        self.setAcceptHoverEvents(True)
        self._lift()

    @property
    def run(self) -> Run:
        """How it runs."""
        return self._run

    def place(self, run: Run) -> None:
        """Let it run like this."""
        self.prepareGeometryChange()
        self._run = run
        self._path = curve(run.points)
        around = self._path.boundingRect().united(self._label_box())
        self._bounds = around.adjusted(-12, -12, 12, 12)

    def say(self, tip: str) -> None:
        """Say in its tool tip what it is, as HTML."""
        self._tip = tip
        self.setToolTip(tip)

    def say_problem(self, words: str) -> None:
        """Say there, too, what is wrong, if anything is."""
        self.setToolTip(f"{self._tip}<br>{escape(words)}" if words else self._tip)

    def choose(self, *, chosen: bool) -> None:
        """Draw it as the one that is selected, or not."""
        if chosen is not self._chosen:
            self._chosen = chosen
            self._lift()
            self.update()

    def boundingRect(self) -> QRectF:
        """With its label."""
        return self._bounds

    def shape(self) -> QPainterPath:
        """Where it can be hit: near the line, and at its label."""
        stroker = QPainterPathStroker()
        stroker.setWidth(12.0)
        hit = stroker.createStroke(self._path)
        hit.setFillRule(Qt.FillRule.WindingFill)
        if self._shows_label:
            hit.addRect(self._label_box())
        return hit

    @property
    def _shows_label(self) -> bool:
        return self._labeled or self._chosen or self._hovered

    def _label_box(self) -> QRectF:
        width, height = self._size
        x, y = self._run.label
        return QRectF(x - width / 2, y - height / 2, width, height)

    def hoverEnterEvent(self, _event: object) -> None:
        """Show what it says, even among many."""
        self._hover(hovered=True)

    def hoverLeaveEvent(self, _event: object) -> None:
        """Quiet again."""
        self._hover(hovered=False)

    def _hover(self, *, hovered: bool) -> None:
        self._hovered = hovered
        self._lift()
        self.update()

    def _lift(self) -> None:
        """What is looked at lies on all else; words of loops, for which there is little room, on other edges."""
        is_loop = self.edge.source == self.edge.target
        self.setZValue(3.0 if self._hovered or self._chosen else 1.5 if is_loop else 1.0)

    # -------------------------------------------------------------------------------------------- painting

    def _color(self) -> QColor:
        palette = self._theme.palette
        if self._chosen or self._hovered:
            return QColor(palette.accent)
        if not self.edge.is_open:
            return mixed(palette.dim, palette.panel, 0.45)
        return QColor(palette.text) if self.edge.rules else QColor(palette.dim)

    def pen(self) -> QPen:
        """Wider the more examples speak for it; dashed for rules, dotted where it is pruned."""
        pen = QPen(self._color(), min(THICKEST, THINNEST + 0.75 * log2(1.0 + self.edge.support)))
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        if self.edge.is_pruned:
            pen.setWidthF(THINNEST)
            pen.setDashPattern([1.5, 3.0])
        elif self.edge.rules:
            pen.setWidthF(1.6)
            pen.setDashPattern([5.0, 3.0])
        return pen

    def paint(self, painter: QPainter, _option: object, _widget: object = None) -> None:
        """Draw it."""
        pen = self.pen()
        painter.setPen(pen)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawPath(self._path)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(pen.color())
        painter.drawPolygon(arrow_head(self._run.points, 8.0 + 0.8 * pen.widthF()))
        if self.edge.is_pruned:
            self._paint_cross(painter)
        if self._shows_label:
            self._paint_label(painter)
        if self.problem:
            self._paint_problem(painter)

    def _paint_cross(self, painter: QPainter) -> None:
        middle = self._path.pointAtPercent(0.5)
        painter.setPen(QPen(self._color(), 1.8))
        for way in (QPointF(CROSS, CROSS), QPointF(CROSS, -CROSS)):
            painter.drawLine(middle - way, middle + way)

    def _paint_label(self, painter: QPainter) -> None:
        box = self._label_box()
        ground = self._theme.color("panel")
        ground.setAlpha(215)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(ground)
        painter.drawRoundedRect(box, 4, 4)
        painter.setFont(text_font(CAPTION))
        for number, text in enumerate(self._lines):
            line = QRectF(box.left(), box.top() + number * LINE, box.width(), LINE)
            is_last = number == len(self._lines) - 1
            painter.setPen(self._theme.color("text" if self.edge.is_open and not is_last else "dim"))
            painter.drawText(line, Qt.AlignmentFlag.AlignCenter, text)

    def _paint_problem(self, painter: QPainter) -> None:
        middle = self._path.pointAtPercent(0.2)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(self._theme.color("teach" if self.problem == "error" else "dim"))
        painter.drawEllipse(middle, 7, 7)
        painter.setPen(self._theme.color("background" if self._theme.is_dark else "raised"))
        painter.setFont(text_font(CAPTION, bold=True))
        around = QRectF(middle.x() - 7, middle.y() - 7, 14, 14)
        painter.drawText(around, Qt.AlignmentFlag.AlignCenter, "!")
