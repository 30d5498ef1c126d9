"""The histogram of the examples at a node, with the cut of its test as a line that can be dragged."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from ...core.conditions import AtMost, InArc
from ...core.phrasing import for_people, number, unit_of
from ...core.vocabulary import Feature
from ..theme import CAPTION, Theme, text_font
from .bins import BINS, Histogram
from .subject import Subject

LEFT, RIGHT, TOP, BOTTOM = 10, 44, 18, 18
#: One press of an arrow key, as a share of what is shown.
STEP = 0.01
EMPTY = "Select a node that tests a number or an angle to see its examples and to drag its cut."
TREELESS = "There is no tree here, so there is no cut to see or to drag."


class CutPage(QWidget):
    """Shows a histogram and drags its cut.

    Attributes:
        empty: What is said where there is no histogram.

    Signals:
        dragged: The cut is on its way: the test as it would be.
        dropped: The cut is to stay there.
        cancelled: It is to be where it was.
        settled: The hand let go of the keys.
    """

    dragged = Signal(object)
    dropped = Signal(object)
    cancelled = Signal()
    settled = Signal()

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self._subject: Subject | None = None
        self._histogram: Histogram | None = None
        self._test: AtMost | InArc | None = None
        self._feature: Feature | None = None
        self._held: int | None = None  # which end is dragged
        self._last = 0
        self.empty = EMPTY
        self.setMinimumHeight(96)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setProperty("framed", True)
        self.setAccessibleName("Histogram of the examples at the node; arrow keys move the cut")
        self.setToolTip(
            "Examples at the node by value and label. Drag the line, or move it by the arrow keys"
        )

    def show_test(
        self,
        subject: Subject | None,
        found: Histogram | None,
        test: AtMost | InArc | None,
        feature: Feature | None,
        *,
        treeless: bool = False,
    ) -> None:
        """Show the histogram of a test; None if what is selected has no cut, or if all of it is *treeless*."""
        if self._held is None:
            self.empty = TREELESS if treeless else EMPTY
            self._subject, self._histogram, self._test, self._feature = subject, found, test, feature
            self.update()

    # ------------------------------------------------------------------------------------------------ places

    @property
    def _room(self) -> QRectF:
        return QRectF(LEFT, TOP, max(1, self.width() - LEFT - RIGHT), max(1, self.height() - TOP - BOTTOM))

    def x_of(self, value: float) -> float:
        """Where a value is, in pixels."""
        assert self._histogram is not None
        return self._room.left() + self._histogram.place(value) * self._room.width()

    @property
    def ends(self) -> tuple[float, ...]:
        """The values at which the test cuts."""
        match self._test:
            case AtMost(_, threshold):
                return (threshold,)
            case InArc(_, start, end):
                return start, end
        return ()

    def _with(self, end: int, value: float) -> AtMost | InArc:
        test = self._test
        if isinstance(test, AtMost):
            return replace(test, threshold=value)
        assert test is not None
        assert self._feature is not None
        half = self._feature.period / 2
        around = -half if value >= half else value
        return replace(test, start=around) if end == 0 else replace(test, end=around)

    # ---------------------------------------------------------------------------------------------- the hand

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take the nearest cut."""
        if event.button() is Qt.MouseButton.LeftButton and self.ends:
            x = event.position().x()
            away = [abs(self.x_of(value) - x) for value in self.ends]
            self._held = self._last = away.index(min(away))
            self._drag(x)
        event.accept()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Move it along."""
        if self._held is not None:
            self._drag(event.position().x())

    def _drag(self, x: float) -> None:
        assert self._histogram is not None
        assert self._held is not None
        self._test = self._with(
            self._held, self._histogram.value((x - self._room.left()) / self._room.width())
        )
        self.dragged.emit(self._test)
        self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Leave it there."""
        if self._held is not None:
            self._held = None
            self.dropped.emit(self._test)
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Move the cut by the arrow keys; Tab-like, Up and Down choose the other end of an arc. Escape gives up."""
        step = {Qt.Key.Key_Left: -STEP, Qt.Key.Key_Right: STEP}.get(Qt.Key(event.key()))
        if event.key() == Qt.Key.Key_Escape and self._held is not None:
            self._held = None
            self.cancelled.emit()
        elif event.key() in (Qt.Key.Key_Up, Qt.Key.Key_Down) and len(self.ends) > 1:
            self._last = 1 - self._last
            self.update()
        elif step is not None and self.ends and self._histogram is not None:
            end = min(self._last, len(self.ends) - 1)
            moved = self._histogram.place(self.ends[end]) + step
            self._test = self._with(end, self._histogram.value(moved))
            self.dropped.emit(self._test)
            self.update()
        else:
            super().keyPressEvent(event)
            return
        event.accept()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """What was moved by keys was one step."""
        self.settled.emit()
        super().focusOutEvent(event)

    # -------------------------------------------------------------------------------------------- painting

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Bars by label, the cut above them."""
        painter = QPainter(self)
        painter.setFont(text_font(CAPTION))
        if self._histogram is None or self._subject is None:
            painter.setPen(self._theme.color("dim"))
            around = QRectF(self.rect()).adjusted(10, 6, -10, -6)
            painter.drawText(around, Qt.AlignmentFlag.AlignTop | Qt.TextFlag.TextWordWrap, self.empty)
            return
        self._paint_bars(painter, self._histogram)
        self._paint_axis(painter, self._histogram)
        for place, value in enumerate(self.ends):
            self._paint_cut(painter, value, strong=place == min(self._last, len(self.ends) - 1))

    def _paint_bars(self, painter: QPainter, shown: Histogram) -> None:
        room = self._room
        width = room.width() / BINS
        for place, counts in enumerate(shown.counts.tolist()):
            self._paint_bar(
                painter, QRectF(room.left() + place * width, room.top(), width, room.height()), counts
            )
        beyond = QRectF(room.right() + 14, room.top(), width, room.height())
        self._paint_bar(painter, beyond, shown.nobody.tolist())

    def _paint_bar(self, painter: QPainter, column: QRectF, counts: list[int]) -> None:
        assert self._histogram is not None
        assert self._subject is not None
        bottom = column.bottom()
        for label, count in zip(self._subject.labels, counts, strict=True):
            height = column.height() * count / self._histogram.most
            bar = QRectF(column.left() + 0.5, bottom - height, max(1.0, column.width() - 1), height)
            painter.fillRect(bar, self._subject.color(label))
            bottom -= height

    def _paint_axis(self, painter: QPainter, shown: Histogram) -> None:
        room = self._room
        painter.setPen(QPen(self._theme.color("hairline"), 1))
        painter.drawLine(room.bottomLeft(), room.bottomRight())
        painter.setPen(self._theme.color("dim"))
        below = QRectF(room.left(), room.bottom() + 1, room.width(), BOTTOM)
        painter.drawText(below, Qt.AlignmentFlag.AlignLeft, self._words(shown.low))
        painter.drawText(below, Qt.AlignmentFlag.AlignRight, self._words(shown.high))
        if shown.nobody.sum():
            beyond = QRectF(room.right() + 4, room.bottom() + 1, RIGHT, BOTTOM)
            painter.drawText(beyond, Qt.AlignmentFlag.AlignLeft, "none")

    def _paint_cut(self, painter: QPainter, value: float, *, strong: bool) -> None:
        room, x = self._room, self.x_of(value)
        painter.setPen(QPen(self._theme.color("accent"), 2.5 if strong else 1.5))
        painter.drawLine(int(x), int(room.top()) - 3, int(x), int(room.bottom()))
        painter.setPen(self._theme.color("text"))
        aside = (-1 if value == self.ends[0] else 1) if len(self.ends) > 1 else 0
        above = QRectF(x - 60 + 62 * aside, 0, 120, TOP - 3)
        above.moveLeft(min(max(0.0, above.left()), self.width() - above.width()))
        ways = {
            -1: Qt.AlignmentFlag.AlignRight,
            0: Qt.AlignmentFlag.AlignHCenter,
            1: Qt.AlignmentFlag.AlignLeft,
        }
        painter.drawText(above, ways[aside] | Qt.AlignmentFlag.AlignVCenter, self._words(value))

    def _words(self, value: float) -> str:
        feature = self._feature
        if feature is None:
            return number(value)
        unit = unit_of(feature)
        return number(for_people(feature, value)) + ("°" if unit == "degrees" else f" {unit}" if unit else "")
