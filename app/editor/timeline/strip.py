"""The picture of a run: a row of picks, one for all agents, one for each node that is looked at, and what was counted."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QPointF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QHelpEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget

from ...core.amounts import counted
from .band import Band, band_of, line_of
from .past import Doing, Past, Span
from .strip_painting import AXIS, LEFT, RIGHT, Drawn, DrawnLine, Places, StripPainter

if TYPE_CHECKING:
    from collections.abc import Callable

    from ...core.edits.examples import Recorded
    from ...core.examples import Example
    from ..theme import Theme

#: Pixels: of a row, and of one where there is little room; how near to the dot of a pick the mouse has to be.
ROW, LOW_ROW, NEAR = 24, 18, 6.0


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
        self._band = Band()
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
    def places(self) -> Places:
        """Where ticks and rows are."""
        first, last = self._ends
        width = max(1, self.width() - LEFT - RIGHT)
        return Places(first, last, LEFT, width, self.height() - AXIS, len(self.rows()))

    @property
    def _ends(self) -> tuple[int, int]:
        points = self._past.points
        if not points:
            return 0, 1
        return points[0].tick, max(points[0].tick + 1, points[-1].tick, self.shown.now)

    def _dot_at(self, place: QPointF) -> PickDot | None:
        places = self.places
        if abs(place.y() - places.middle_of(0)) > NEAR:
            return None
        apart = [(abs(places.x_of(dot.tick) - place.x()), dot) for dot in self.shown.picks]
        distance, dot = min(apart, key=lambda pair: pair[0], default=(NEAR + 1.0, None))
        return dot if distance <= NEAR else None

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
            words = self.words_at(self.places.tick_at(event.pos().x())) if dot is None else dot.words
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
            self.tick_wanted.emit(self.places.tick_at(event.position().x()))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Go along with the mouse while its button is down, if it went down on the line."""
        if self._drags and event.buttons() & Qt.MouseButton.LeftButton:
            self.tick_wanted.emit(self.places.tick_at(event.position().x()))

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
        places = self.places
        painter = QPainter(self)
        StripPainter(painter, self._theme, places).paint(self._drawn(places))
        painter.end()

    def _drawn(self, places: Places) -> Drawn:
        ends, width = (places.first, places.last), round(places.width)
        self._band = band_of(self._past.points, ends, width, self._look, self._band)
        return Drawn(
            self.rows(),
            self._band.picture,
            [self._line(node, ends, width) for node, _ in self.shown.nodes],
            self._events,
            [dot.tick for dot in self.shown.picks],
            self.shown.now,
            self.shown.earliest,
        )

    def _line(self, node: str, ends: tuple[int, int], width: int) -> DrawnLine:
        """What a node does; Start, in which it idles, is not drawn."""
        codes, all_done = self._past.codes(node)
        looks = [None if doing is None else self._look(doing) for doing in all_done]
        colors = [0 if look is None else look[1].rgb() for look in looks]
        line = line_of(self._past.points, codes, ends, width, colors)
        long = ((left, right, looks[code]) for left, right, code in line.wide)
        return DrawnLine(line.picture, [(left, right, *look) for left, right, look in long if look])
