"""A state as it is drawn: a box in its behavior's color, a pill for Start, an arrow-shaped box for flags."""

from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPen
from PySide6.QtWidgets import QGraphicsItem

from ...export.graph import GraphState, StateKind
from ..diagram.strokes import elided, text_width
from ..theme import CAPTION, Theme, mixed, text_font

#: State ids from the automaton that is shown down to a state.
Path = tuple[str, ...]

HEIGHT, LEAST_WIDTH, MOST_TEXT, RADIUS = 36.0, 84.0, 150.0, 8.0
#: Room for the name of an open state, and around what is inside.
HEADER, PADDING = 30.0, 14.0
EXPANDER, BADGE, BAR, HANDLE = 16.0, 14.0, 3.0, 5.0


@dataclass(frozen=True, slots=True)
class StateLook:
    """What is shown of a state besides what it is.

    Attributes:
        share: Of the nodes in the automaton, how many are in it, 0 to 1; negative where nobody is anywhere.
        count: How many nodes those are.
        active: The selected node is in it.
        problem: The worst that is wrong with it: "error", "warning" or "".
    """

    share: float = -1.0
    count: int = 0
    active: bool = False
    problem: str = ""
    selected: bool = False
    shown: bool = False
    target: bool = False
    handle: bool = False


def closed_size(state: GraphState) -> tuple[float, float]:
    """Width and height of a state that is not open."""
    width = min(MOST_TEXT, text_width(state.name, bold=True)) + 32.0 + (EXPANDER if state.nested else 0.0)
    return max(LEAST_WIDTH, round(width + 0.5)), HEIGHT


class StateItem(QGraphicsItem):
    """Draws one state; whoever owns it says how.

    Attributes:
        path: Where it is.
        state: What it is.
        size: Width and height.
        is_open: Whether its automaton is shown inside.
    """

    def __init__(
        self,
        path: Path,
        state: GraphState,
        size: tuple[float, float],
        color: QColor,
        theme: Theme,
        *,
        is_open: bool,
    ) -> None:
        super().__init__()
        self.path, self.state, self.size, self.is_open = path, state, size, is_open
        self.look = StateLook()
        self._problem = ""
        self._color = color
        self._theme = theme
        self.setZValue(2.0)
        self.setAcceptHoverEvents(True)
        self._tell()

    @property
    def box(self) -> QRectF:
        """The box, around (0, 0)."""
        width, height = self.size
        return QRectF(-width / 2, -height / 2, width, height)

    def dress(self, look: StateLook) -> None:
        """Draw it like this from now on."""
        if look != self.look:
            self.look = look
            self.update()
            self._tell()

    def say_problem(self, words: str) -> None:
        """Say in its tool tip what is wrong."""
        self._problem = words
        self._tell()

    def _tell(self) -> None:
        look = self.look
        there = f"{look.count} here, {look.share:.0%} of those that run it" if look.share >= 0.0 else ""
        self.setToolTip("\n".join(filter(None, (self.state.name, self.state.note, there, self._problem))))

    def boundingRect(self) -> QRectF:
        """With its glow and badges."""
        return self.box.adjusted(-12, -12, 12, 12)

    def shape(self) -> QPainterPath:
        """Where it can be hit."""
        path = QPainterPath()
        path.setFillRule(Qt.FillRule.WindingFill)
        path.addRect(self.box.adjusted(-2, -2, 2, 2))
        if self.look.handle:
            path.addEllipse(self.handle_at(), HANDLE + 5, HANDLE + 5)
        return path

    def expander(self) -> QRectF:
        """What opens and closes it; empty if it holds no automaton."""
        if not self.state.nested:
            return QRectF()
        box = self.box
        return QRectF(box.right() - EXPANDER - 6, box.top() + (HEIGHT - EXPANDER) / 2, EXPANDER, EXPANDER)

    def handle_at(self) -> QPointF:
        """Where a transition is drawn from."""
        return QPointF(self.box.right(), self.box.top() + HEIGHT / 2)

    # -------------------------------------------------------------------------------------------- painting

    def paint(self, painter: QPainter, _option: object, _widget: object = None) -> None:
        """Draw it."""
        outline = self._outline()
        self._paint_around(painter, outline)
        painter.setBrush(self._theme.color("panel" if self.is_open else "raised"))
        painter.setPen(self._border())
        painter.drawPath(outline)
        self._paint_share(painter)
        self._paint_name(painter)
        self._paint_badges(painter)

    def _outline(self) -> QPainterPath:
        path, box = QPainterPath(), self.box
        if self.state.kind is StateKind.FLAG:
            tip = 12.0
            path.moveTo(box.left(), box.top())
            path.lineTo(box.right() - tip, box.top())
            path.lineTo(box.right(), box.center().y())
            path.lineTo(box.right() - tip, box.bottom())
            path.lineTo(box.left(), box.bottom())
            path.closeSubpath()
        else:
            radius = box.height() / 2 if self.state.kind is StateKind.START else RADIUS
            path.addRoundedRect(box, radius, radius)
        return path

    def _border(self) -> QPen:
        plain = self.state.kind in (StateKind.START, StateKind.FLAG)
        color = self._theme.color("dim") if plain else self._color
        return QPen(color, 3.0 if self.look.active else 1.5)

    def _paint_around(self, painter: QPainter, outline: QPainterPath) -> None:
        look = self.look
        painter.setBrush(Qt.BrushStyle.NoBrush)
        if look.active:
            glow = QColor(self._border().color())
            for width, alpha in ((13.0, 40), (8.0, 70)):
                glow.setAlpha(alpha)
                painter.setPen(QPen(glow, width))
                painter.drawPath(outline)
        if look.selected or look.target:
            accent = self._theme.color("good" if look.target else "accent")
            painter.setPen(QPen(accent, 1.5, Qt.PenStyle.SolidLine if look.shown else Qt.PenStyle.DashLine))
            painter.drawRoundedRect(self.box.adjusted(-5, -5, 5, 5), RADIUS + 5, RADIUS + 5)

    def _paint_share(self, painter: QPainter) -> None:
        look, box = self.look, self.box
        if look.share <= 0.0:
            return
        room = box.width() - 2 * RADIUS
        bar = QRectF(box.left() + RADIUS, box.bottom() - BAR - 3, room, BAR)
        color = self._border().color()
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(mixed(color.name(), self._theme.palette.raised, 0.75))
        painter.drawRoundedRect(bar, 1.5, 1.5)
        bar.setWidth(max(2.0, room * min(1.0, look.share)))
        painter.setBrush(color)
        painter.drawRoundedRect(bar, 1.5, 1.5)

    def _paint_name(self, painter: QPainter) -> None:
        box = QRectF(self.box.left(), self.box.top(), self.box.width(), HEIGHT)
        box.adjust(10, 0, -10 - (EXPANDER if self.state.nested else 0.0), 0)
        bold = self.look.active or self.is_open
        painter.setFont(text_font(bold=bold))
        painter.setPen(self._theme.color("text"))
        text = ("⚑ " if self.state.kind is StateKind.FLAG else "") + self.state.name
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, elided(text, box.width(), 13, bold=bold))

    def _paint_badges(self, painter: QPainter) -> None:
        if self.state.nested:
            self._paint_expander(painter)
        if self.state.note:
            corner = self.box.topLeft()
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(self._theme.color("dim"))
            painter.drawPolygon([corner + QPointF(5, 4), corner + QPointF(13, 4), corner + QPointF(5, 12)])
        if self.look.problem:
            self._paint_problem(painter)
        if self.look.handle:
            painter.setPen(QPen(self._theme.color("accent"), 1.5))
            painter.setBrush(self._theme.color("raised"))
            painter.drawEllipse(self.handle_at(), HANDLE, HANDLE)

    def _paint_expander(self, painter: QPainter) -> None:
        middle = self.expander().center()
        painter.setPen(QPen(self._theme.color("dim"), 1.6))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        up = -2.5 if self.is_open else 2.5
        path = QPainterPath(middle + QPointF(-4, -up / 1.2))
        path.lineTo(middle + QPointF(0, up))
        path.lineTo(middle + QPointF(4, -up / 1.2))
        painter.drawPath(path)

    def _paint_problem(self, painter: QPainter) -> None:
        middle = self.box.topRight() + QPointF(-2, 2)
        is_error = self.look.problem == "error"
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(self._theme.color("teach" if is_error else "dim"))
        painter.drawEllipse(middle, BADGE / 2, BADGE / 2)
        painter.setPen(self._theme.color("background" if self._theme.is_dark else "raised"))
        painter.setFont(text_font(CAPTION, bold=True))
        around = QRectF(middle.x() - BADGE / 2, middle.y() - BADGE / 2, BADGE, BADGE)
        painter.drawText(around, Qt.AlignmentFlag.AlignCenter, "!")
