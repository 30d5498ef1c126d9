"""The picture of a run: a row of picks, one for all agents, one for each node that is looked at, and what was counted."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QHelpEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget

from ...core.amounts import counted
from ..behavior_colors import luminance
from ..diagram.strokes import elided, text_width
from ..theme import CAPTION, text_font
from .band import Band, band_of
from .past import Doing, Past, Span

if TYPE_CHECKING:
    from collections.abc import Callable

    from ...core.edits.examples import Recorded
    from ...core.examples import Example
    from ..theme import Theme

#: Pixels: of the words beside the rows, at the right, of the axis below, and between two marks of it at least.
LEFT, RIGHT, AXIS, APART = 76, 16, 20, 64
#: Of a row, and of one where there is little room; of a band in it; of the dot of a pick; how near to it the mouse has to be.
ROW, LOW_ROW, BAND, DOT, NEAR = 24, 18, 16.0, 4.0, 6.0
#: From this luminance on, words on a color are dark.
BRIGHT = 0.3


@dataclass(frozen=True, slots=True)
class PickDot:
    """A pick of the user.

    Attributes:
        recorded: At least one example.
        words: What it was: "Agent 1 was to go from Forward to RotateLeft".
    """

    recorded: Recorded
    words: str

    @property
    def tick(self) -> int:
        """When it was."""
        return self.recorded.examples[0].tick

    @property
    def key(self) -> tuple[str, str]:
        """Type and id of what was taught."""
        return self.recorded.type, self.recorded.automaton

    @property
    def examples(self) -> tuple[str, ...]:
        """The ids of what it recorded."""
        return tuple(example.id for example in self.recorded.examples)

    def recorded_it(self, example: Example | None) -> bool:
        """Whether an example with the id of its first one is that: taken back, ids are given to others."""
        first = self.recorded.examples[0]
        return example is not None and (example.tick, example.node) == (first.tick, first.node)


@dataclass(frozen=True, slots=True)
class Shown:
    """What the strip shows.

    Attributes:
        now: The tick that the world is at.
        earliest: The first one that can be gone back to; None where nobody can go back at the moment.
        nodes: Ids and words of the nodes that have a row.
        measure: What is counted in the last row; empty for no such row.
    """

    now: int = 0
    earliest: int | None = None
    nodes: tuple[tuple[str, str], ...] = ()
    picks: tuple[PickDot, ...] = ()
    measure: str = ""


class Strip(QWidget):
    """Draws a `Past`, and says which tick of it the user points at.

    Signals:
        tick_wanted: A tick that the user wants to see the world at.
        pick_chosen: A pick that was clicked.
    """

    tick_wanted = Signal(int)
    pick_chosen = Signal(object)

    def __init__(self, theme: Theme, past: Past, look: Callable[[Doing], tuple[str, QColor]]) -> None:
        """Show *past*; *look* says what is done in words, and its color."""
        super().__init__()
        self._theme, self._past, self._look = theme, past, look
        self.shown = Shown()
        self._spans: dict[str, list[Span]] = {}
        self._band_now = Band()
        self._events: list[int] = []
        self._drags = False  # the mouse was pressed on the line, and moves along it
        self.setAccessibleName("Timeline of the run")
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Maximum)
        theme.changed.connect(self.update)

    def show_now(self, shown: Shown) -> None:
        """Draw it as it is now."""
        before = self.rows()
        self.shown = shown
        self._past.look_at([node for node, _ in shown.nodes])
        self._spans = {node: self._past.spans(node) for node, _ in shown.nodes}
        self._events = self._past.counted(shown.measure) if shown.measure else []
        if before != self.rows():
            self.updateGeometry()
        told = [self.words_at(shown.now), counted(len(shown.picks), "pick")]
        self.setAccessibleDescription("; ".join(told))
        self.update()

    def sizeHint(self) -> QSize:
        """As high as its rows."""
        return QSize(300, ROW * len(self.rows()) + AXIS)

    def minimumSizeHint(self) -> QSize:
        """In a low window rows are lower."""
        return QSize(0, LOW_ROW * len(self.rows()) + AXIS)

    def rows(self) -> list[str]:
        """The words beside the rows, from top to bottom."""
        last = [self.shown.measure] if self.shown.measure else []
        return ["picks", "all agents", *(words for _, words in self.shown.nodes), *last]

    # ------------------------------------------------------------------------------------------------ places

    @property
    def _row(self) -> float:
        """How high a row is."""
        return (self.height() - AXIS) / len(self.rows())

    @property
    def _band(self) -> float:
        """How high what is drawn in a row is."""
        return min(BAND, self._row - 3.0)

    @property
    def _ends(self) -> tuple[int, int]:
        points = self._past.points
        if not points:
            return 0, 1
        return points[0].tick, max(points[0].tick + 1, points[-1].tick, self.shown.now)

    def x_of(self, tick: float) -> float:
        """Where a tick is."""
        first, last = self._ends
        return LEFT + (tick - first) / (last - first) * max(1, self.width() - LEFT - RIGHT)

    def tick_at(self, x: float) -> int:
        """Which tick is at a place, or nearest to it."""
        first, last = self._ends
        share = (x - LEFT) / max(1, self.width() - LEFT - RIGHT)
        return round(first + min(1.0, max(0.0, share)) * (last - first))

    def middle_of(self, row: int) -> float:
        """Where a row has its middle."""
        return self._row * (row + 0.5)

    def _dot_at(self, place: QPointF) -> PickDot | None:
        if abs(place.y() - self.middle_of(0)) > NEAR:
            return None
        near = [dot for dot in self.shown.picks if abs(self.x_of(dot.tick) - place.x()) <= NEAR]
        return min(near, key=lambda dot: abs(self.x_of(dot.tick) - place.x()), default=None)

    def changes(self) -> list[int]:
        """The ticks at which something is drawn to happen, in their order."""
        starts = [span.first for spans in self._spans.values() for span in spans]
        return sorted({self._ends[0], *starts, *self._events, *(dot.tick for dot in self.shown.picks)})

    # ------------------------------------------------------------------------------------------------- words

    def words_at(self, tick: int) -> str:
        """What the nodes that have a row did at a tick."""
        point = self._past.at(tick)
        told = [f"tick {tick:,}"]
        for node, words in self.shown.nodes:
            span = next((s for s in reversed(self._spans.get(node, [])) if s.first <= tick), None)
            if span is not None:
                told.append(f"{words}: {'idle' if span.doing is None else self._look(span.doing)[0]}")
        if self.shown.measure and point is not None:
            told.append(f"{self.shown.measure} {point.measures.get(self.shown.measure, 0.0):,.0f}")
        return ", ".join(told)

    def event(self, event: QEvent) -> bool:
        """Tell what is under the mouse."""
        if event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            dot = self._dot_at(QPointF(event.pos()))
            words = self.words_at(self.tick_at(event.pos().x())) if dot is None else dot.words
            QToolTip.showText(event.globalPos(), words, self)
            return True
        return super().event(event)

    # -------------------------------------------------------------------------------------------------- hand

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Choose a pick, or go to a tick."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        dot = self._dot_at(event.position())
        self._drags = dot is None and event.position().x() >= LEFT - NEAR
        if dot is not None:
            self.pick_chosen.emit(dot)
        elif self._drags:
            self.tick_wanted.emit(self.tick_at(event.position().x()))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Go along with the mouse while its button is down, if it went down on the line."""
        if self._drags and event.buttons() & Qt.MouseButton.LeftButton:
            self.tick_wanted.emit(self.tick_at(event.position().x()))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """The arrows go to where something happened before, or after."""
        now = self.shown.now
        if event.key() == Qt.Key.Key_Left:
            wanted = max((tick for tick in self.changes() if tick < now), default=None)
        elif event.key() == Qt.Key.Key_Right:
            wanted = min((tick for tick in self.changes() if tick > now), default=None)
        else:
            super().keyPressEvent(event)
            return
        if wanted is not None:
            self.tick_wanted.emit(wanted)

    # ---------------------------------------------------------------------------------------------- painting

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the rows, the axis, and where the world is now."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setFont(text_font(CAPTION))
        self._paint_words(painter)
        self._paint_axis(painter)
        self._paint_shares(painter)
        for row, (node, _) in enumerate(self.shown.nodes, start=2):
            for span in self._spans.get(node, ()):
                self._paint_span(painter, row, span)
        self._paint_events(painter)
        self._fade(painter)
        self._paint_now(painter)
        self._paint_picks(painter)
        painter.end()

    def _paint_words(self, painter: QPainter) -> None:
        painter.setPen(self._theme.color("dim"))
        for row, words in enumerate(self.rows()):
            place = QRectF(10, self._row * row, LEFT - 18, self._row)
            painter.drawText(place, Qt.AlignmentFlag.AlignVCenter, elided(words, LEFT - 18))

    def _paint_axis(self, painter: QPainter) -> None:
        bottom = self.height() - AXIS
        first, last = self._ends
        step = step_of(last - first, max(1, (self.width() - LEFT - RIGHT) // APART))
        for tick in range(-(-first // step) * step, last + 1, step):
            x = self.x_of(tick)
            painter.setPen(QPen(self._theme.color("hairline"), 1.0))
            painter.drawLine(QPointF(x, 2), QPointF(x, bottom))
            painter.setPen(self._theme.color("dim"))
            painter.drawText(
                QRectF(x - APART / 2, bottom, APART, AXIS), Qt.AlignmentFlag.AlignCenter, short(tick)
            )

    def _paint_shares(self, painter: QPainter) -> None:
        """All agents in one picture: each of many calls would wait for its turn among the threads."""
        place = QRectF(LEFT, self.middle_of(1) - self._band / 2, self.width() - LEFT - RIGHT, self._band)
        self._band_now = band_of(
            self._past.points, self._ends, round(place.width()), self._look, self._band_now
        )
        if self._band_now.picture is not None:
            painter.drawImage(place, self._band_now.picture)

    def _paint_span(self, painter: QPainter, row: int, span: Span) -> None:
        if span.doing is None:
            return
        words, color = self._look(span.doing)
        left, right = self.x_of(span.first), self.x_of(span.last)
        place = QRectF(left, self.middle_of(row) - self._band / 2, max(1.0, right - left - 1.0), self._band)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(color)
        painter.drawRoundedRect(place, min(3.0, place.width() / 2), 3.0)
        if text_width(words, CAPTION) <= place.width() - 8:
            painter.setPen(QColor("#14161b" if luminance(color) > BRIGHT else "#ffffff"))
            painter.drawText(place, Qt.AlignmentFlag.AlignCenter, words)

    def _paint_events(self, painter: QPainter) -> None:
        middle = self.middle_of(len(self.rows()) - 1)
        painter.setPen(QPen(self._theme.color("good"), 2.0))
        for tick in self._events:
            painter.drawLine(QPointF(self.x_of(tick), middle - 6), QPointF(self.x_of(tick), middle + 6))

    def _fade(self, painter: QPainter) -> None:
        """What cannot be gone back to any more is paler."""
        if self.shown.earliest:
            veil = self._theme.color("panel")
            veil.setAlphaF(0.55)
            right = self.x_of(min(self.shown.earliest, self._ends[1]))
            painter.fillRect(QRectF(LEFT, 0, max(0.0, right - LEFT), self.height() - AXIS), veil)

    def _paint_picks(self, painter: QPainter) -> None:
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(self._theme.color("teach"))
        for dot in self.shown.picks:
            painter.drawEllipse(QPointF(self.x_of(dot.tick), self.middle_of(0)), DOT, DOT)

    def _paint_now(self, painter: QPainter) -> None:
        x, bottom = self.x_of(self.shown.now), self.height() - AXIS
        color = self._theme.color("accent")
        painter.setPen(QPen(color, 1.5))
        painter.drawLine(QPointF(x, 2), QPointF(x, bottom))
        painter.setBrush(color)
        painter.drawEllipse(QPointF(x, bottom), DOT, DOT)


def step_of(length: int, most: int) -> int:
    """A round number of ticks between two marks, so that there are at most so many of them."""
    step = 1
    while length / step > most:
        for factor in (2, 5, 10):
            if length / (step * factor) <= most:
                return step * factor
        step *= 10
    return step


def short(tick: int) -> str:
    """A tick in few letters: "500", "7k", "1.5k", "2M"."""
    for size, letter in ((1_000_000, "M"), (1_000, "k")):
        if tick >= size:
            return f"{tick / size:.2f}".rstrip("0").rstrip(".") + letter
    return str(tick)
