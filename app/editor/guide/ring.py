"""A ring around what the first lesson speaks of; clicks go through it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, QRect, Qt, QTimer
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QMainWindow, QToolBar, QToolButton, QWidget

if TYPE_CHECKING:
    from ..theme import Theme

ROOM, WIDTH, OFTEN = 5, 3, 150


class Ring(QWidget):
    """Follows a control.

    Attributes:
        target: What it is around; None where there is nothing to be seen.
    """

    def __init__(self, window: QMainWindow, theme: Theme) -> None:
        super().__init__(window)
        self._window = window
        self._theme = theme
        self._points_at = ""
        self.target: QWidget | None = None
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_NoSystemBackground)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._timer = QTimer(self, interval=OFTEN)
        self._timer.timeout.connect(self.follow)
        self.hide()

    def point_at(self, points_at: str) -> None:
        """Be around what a step speaks of; nothing for an empty text."""
        self._points_at = points_at
        if points_at:
            self._timer.start()
            self.follow()
        else:
            self._timer.stop()
            self.target = None
            self.hide()

    def follow(self) -> None:
        """Go where the control is now."""
        self.target = found(self._window, self._points_at)
        if self.target is None:
            self.hide()
            return
        corner = self.target.mapTo(self._window, QPoint(0, 0))
        place = QRect(corner, self.target.size()).adjusted(-ROOM, -ROOM, ROOM, ROOM)
        place = place.intersected(self._window.rect())
        if place != self.geometry():
            self.setGeometry(place)
        if not self.isVisible():
            self.show()
        self.raise_()

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002 - it is painted as a whole
        """Only an outline."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(self._theme.color("accent"), WIDTH))
        inset = WIDTH // 2 + 1
        painter.drawRoundedRect(self.rect().adjusted(inset, inset, -inset, -inset), 9, 9)
        painter.end()


def found(window: QMainWindow, points_at: str) -> QWidget | None:
    """The control that a step speaks of, if it can be seen."""
    what, _, name = points_at.partition(":")
    if what == "action":
        return _tool(window, name)
    if what == "pick":
        return _pick(window, name) or _dock(window, "teach")
    if what == "panel":
        return _dock(window, name)
    return window.centralWidget() if what == "canvas" else None


def _tool(window: QMainWindow, action: str) -> QWidget | None:
    for bar in window.findChildren(QToolBar):
        for button in bar.findChildren(QToolButton):
            named = [each.objectName() for each in button.actions()]
            if action in named and button.isVisible():
                return button
    return None


def _pick(window: QMainWindow, name: str) -> QWidget | None:
    panel = _dock(window, "teach")
    if panel is None:
        return None
    for button in panel.findChildren(QAbstractButton):
        words = (button.accessibleName() or button.text()).split()
        if words and words[0].strip(",") == name and button.isVisible():
            return button
    return None


def _dock(window: QMainWindow, panel: str) -> QWidget | None:
    dock = window.findChild(QWidget, panel)
    return dock if dock is not None and dock.isVisible() else None
