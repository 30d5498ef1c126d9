"""The world as it was painted last: what lies on it, and all that has the window painted, leave it as it is."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QSize
from PySide6.QtGui import QColor, QPainter, QPixmap
from PySide6.QtWidgets import QWidget


class Picture:
    """What a widget shows, painted apart from its paint events."""

    def __init__(self, widget: QWidget, paint: Callable[[QPainter], None]) -> None:
        self._widget = widget
        self._paint = paint
        self._pixmap = QPixmap()

    def paint_anew(self) -> None:
        """Paint what is to be seen now."""
        if self._pixmap.size() != self._wanted():
            self._pixmap = QPixmap(self._wanted())
            self._pixmap.setDevicePixelRatio(self._widget.devicePixelRatioF())
        painter = QPainter(self._pixmap)
        self._paint(painter)
        painter.end()

    def show(self, ground: QColor) -> None:
        """In a paint event: show what was painted; where the widget has grown since, there is but the ground."""
        if self._pixmap.isNull():
            self.paint_anew()
        painter = QPainter(self._widget)
        if self._pixmap.size() != self._wanted():
            painter.fillRect(self._widget.rect(), ground)
        painter.drawPixmap(0, 0, self._pixmap)
        painter.end()

    def forget(self) -> None:
        """What was painted is not to be seen any more."""
        self._pixmap = QPixmap()

    def _wanted(self) -> QSize:
        """The size that the widget has, in pixels of the screen."""
        return self._widget.size() * self._widget.devicePixelRatioF()
