"""Keys that belong to what has the focus, although actions have them as shortcuts."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QApplication,
    QCheckBox,
    QComboBox,
    QRadioButton,
    QTabBar,
    QWidget,
)

from ..soon import catch_up

#: What moves through lists, boxes and sliders.
MOVES = (
    Qt.Key.Key_Home,
    Qt.Key.Key_End,
    Qt.Key.Key_PageUp,
    Qt.Key.Key_PageDown,
)
_MOVED = (QAbstractItemView, QAbstractSlider, QAbstractSpinBox, QComboBox, QTabBar)
_SWITCHED = (QCheckBox, QRadioButton)


class OwnKeys(QObject):
    """Lets lists, boxes and sliders have the keys that move through them, and switches the space bar.

    Qt asks whoever has the focus before it looks for a shortcut, then all around it; the window answers for them. Before
    that it does what it has put off, so that the key finds things, and what is possible, as they are by now.
    """

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        window.installEventFilter(self)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Take a key from the shortcuts if it belongs to what has the focus."""
        if event.type() is not QEvent.Type.ShortcutOverride or not isinstance(event, QKeyEvent):
            return False
        catch_up()
        if belongs(event, QApplication.focusWidget()):
            event.accept()
            return True
        return False


def belongs(event: QKeyEvent, focus: QWidget | None) -> bool:
    """Whether a key means something to what has the focus, rather than to the window."""
    if event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier:
        return False
    if event.key() == Qt.Key.Key_Space:
        return isinstance(focus, _SWITCHED)
    return event.key() in MOVES and isinstance(focus, _MOVED)
