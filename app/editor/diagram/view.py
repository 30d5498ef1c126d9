"""A view of a diagram: the wheel zooms, dragging the ground pans, and it fits itself in until the user takes over."""

from PySide6.QtCore import QPoint, QRectF, QSize, Qt
from PySide6.QtGui import QMouseEvent, QPainter, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import QFrame, QGraphicsScene, QGraphicsView

from ..theme import Theme

LEAST, MOST = 0.08, 4.0
#: One notch of the wheel.
STEP = 1.2
#: A diagram that is fitted in is never drawn larger, and smaller than it can be read only where the user wants all of it.
FITTED, READABLE = 1.0, 0.72
MARGIN = 12.0
#: Pixels of the scene around a diagram, into which it can be dragged.
ROOM = 2000.0


class DiagramView(QGraphicsView):
    """Shows a scene.

    Attributes:
        is_fitted: It keeps itself fitted in, since the user has neither panned nor zoomed.
    """

    def __init__(self, scene: QGraphicsScene, theme: Theme) -> None:
        super().__init__(scene)
        self._theme = theme
        self.is_fitted = True
        self._least = READABLE
        self._shown_whole = QRectF(), QSize()
        self._pan_from: QPoint | None = None
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setRenderHint(QPainter.RenderHint.Antialiasing)
        self.setViewportUpdateMode(QGraphicsView.ViewportUpdateMode.SmartViewportUpdate)
        self.setTransformationAnchor(QGraphicsView.ViewportAnchor.AnchorUnderMouse)
        for bar in (self.horizontalScrollBar(), self.verticalScrollBar()):
            bar.actionTriggered.connect(self._scrolled)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        theme.changed.connect(self._dress)
        self._dress()

    def _dress(self) -> None:
        self.setBackgroundBrush(self._theme.color("panel"))

    # ------------------------------------------------------------------------------------------ looking around

    @property
    def scale_now(self) -> float:
        """Pixels on the screen for one of the scene."""
        return self.transform().m11()

    def zoom(self, factor: float) -> None:
        """Larger or smaller, around the pointer or the middle."""
        self._take_over()
        wanted = min(MOST, max(LEAST, self.scale_now * factor))
        self.scale(wanted / self.scale_now, wanted / self.scale_now)

    def fit(self) -> None:
        """Show the whole diagram, or as much of it as can be read, and scroll bars for the rest."""
        self._least = READABLE
        self._fit_in()

    def fit_whole(self) -> None:
        """Show the whole diagram, however small, and go on with that until the user pans or zooms."""
        self._least = LEAST
        self._fit_in()

    def _fit_in(self) -> None:
        self.is_fitted = True
        whole, seen = self.contents(), self.maximumViewportSize()
        self._shown_whole = whole, seen
        if whole.isEmpty() or seen.isEmpty():
            return
        wide = (seen.width() - 2 * MARGIN) / whole.width()
        high = (seen.height() - 2 * MARGIN) / whole.height()
        scale = max(self._least, min(wide, high, FITTED))
        self.resetTransform()
        self.scale(scale, scale)
        across, down = (
            _room(all_of_it, side * scale) / scale
            for all_of_it, side in ((seen.width(), whole.width()), (seen.height(), whole.height()))
        )
        self._frame(across, down, Qt.ScrollBarPolicy.ScrollBarAsNeeded)
        self.centerOn(self._middle(whole, scale))

    def _frame(self, across: float, down: float, bars: Qt.ScrollBarPolicy) -> None:
        """Leave room beside the diagram, and above and below it."""
        self.setHorizontalScrollBarPolicy(bars)
        self.setVerticalScrollBarPolicy(bars)
        self.setSceneRect(self.contents().adjusted(-across, -down, across, down))

    def _take_over(self) -> None:
        """The user has panned or zoomed: the diagram goes wherever it is put, even out of sight."""
        self.is_fitted = False
        self._least = READABLE
        self._frame(ROOM, ROOM, Qt.ScrollBarPolicy.ScrollBarAlwaysOff)

    def _scrolled(self) -> None:
        """What was scrolled to stays."""
        self.is_fitted = False

    def _middle(self, whole: QRectF, scale: float) -> QPoint:
        """What to put into the middle: all of it, or its upper part where it does not fit in."""
        seen = self.viewport().rect()
        middle = whole.center()
        if whole.height() * scale > seen.height() - 2 * MARGIN:
            middle.setY(whole.top() + (seen.height() / 2 - MARGIN) / scale)
        return middle.toPoint()

    def contents(self) -> QRectF:
        """What there is to see."""
        return self.scene().itemsBoundingRect()

    def show_item(self, where: QRectF) -> None:
        """Pan until a place of the scene is seen."""
        self.ensureVisible(where, 16, 16)

    def changed(self) -> None:
        """Say that the diagram has another extent."""
        if not self.is_fitted:
            self._frame(ROOM, ROOM, Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        elif self._shown_whole != (self.contents(), self.maximumViewportSize()):
            self._fit_in()

    # ---------------------------------------------------------------------------------------------- the hand

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom around the pointer; two fingers on a touch pad pan."""
        pixels = event.pixelDelta()
        if not pixels.isNull() and not event.modifiers():
            self._pan(pixels)
        else:
            self.zoom(STEP ** (event.angleDelta().y() / 120.0))
        event.accept()

    def begin_pan(self, event: QMouseEvent) -> None:
        """Pan with the pointer until the button is released."""
        self._pan_from = event.position().toPoint()
        self.viewport().setCursor(Qt.CursorShape.ClosedHandCursor)

    def go_on_panning(self, event: QMouseEvent) -> bool:
        """Whether the pointer pans at the moment."""
        if self._pan_from is None:
            return False
        at = event.position().toPoint()
        self._pan(at - self._pan_from)
        self._pan_from = at
        return True

    def end_pan(self) -> bool:
        """Whether it was panning."""
        panned, self._pan_from = self._pan_from is not None, None
        if panned:
            self.viewport().unsetCursor()
        return panned

    def _pan(self, by: QPoint) -> None:
        self._take_over()
        horizontal, vertical = self.horizontalScrollBar(), self.verticalScrollBar()
        horizontal.setValue(horizontal.value() - by.x())
        vertical.setValue(vertical.value() - by.y())

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Stay fitted in."""
        super().resizeEvent(event)
        if self.is_fitted and self._shown_whole[1] != self.maximumViewportSize():
            self._fit_in()


def _room(seen: float, filled: float) -> float:
    """The room on either side of what fills so many of the pixels seen: no more than there is, or there would be a bar."""
    return min(MARGIN / 2, max(0.0, (seen - filled - 1.0) / 2))  # a pixel less, since Qt rounds
