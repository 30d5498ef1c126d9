"""A frame around a view that the keys go to, as long as they got there by keys."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QRectF, Qt
from PySide6.QtGui import QFocusEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractItemView, QGraphicsView, QWidget

from .theme import Theme

#: Whoever uses the mouse sees where it is; whoever uses keys has to be shown.
BY_KEYS = (
    Qt.FocusReason.TabFocusReason,
    Qt.FocusReason.BacktabFocusReason,
    Qt.FocusReason.ShortcutFocusReason,
)
#: The keys come back to where they were.
FOR_A_WHILE = (
    Qt.FocusReason.ActiveWindowFocusReason,
    Qt.FocusReason.PopupFocusReason,
    Qt.FocusReason.MenuBarFocusReason,
)
RADIUS = 4.0


class FocusFrame(QWidget):
    """Lies on a view and lets everything through."""

    def __init__(self, view: QWidget, theme: Theme) -> None:
        super().__init__(view)
        self._view, self._theme = view, theme
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()
        view.installEventFilter(self)
        theme.changed.connect(self.update)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Come and go with the keys."""
        if event.type() == QEvent.Type.Resize:
            self.setGeometry(self._view.rect())
        elif isinstance(event, QFocusEvent) and event.reason() not in FOR_A_WHILE:
            self.setVisible(event.gotFocus() and event.reason() in BY_KEYS)
            self.setGeometry(self._view.rect())
            self.raise_()
        elif event.type() == QEvent.Type.MouseButtonPress:
            self.hide()
        return super().eventFilter(watched, event)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """A line in the accent color."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(self._theme.color("accent"), 1.0))
        painter.drawRoundedRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5), RADIUS, RADIUS)
        painter.end()


def frame_views(above: QWidget, theme: Theme) -> None:
    """Give a frame to every list, table, tree and diagram in a panel, and to whatever has the property ``framed``."""
    for child in (above, *above.findChildren(QWidget)):
        if isinstance(child, QAbstractItemView | QGraphicsView) or child.property("framed"):
            FocusFrame(child, theme)
