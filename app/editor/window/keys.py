"""Keys that belong to what has the focus, although actions have them as shortcuts."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QKeyCombination, QObject, Qt
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QApplication,
    QCheckBox,
    QComboBox,
    QDockWidget,
    QLineEdit,
    QRadioButton,
    QTabBar,
    QWidget,
)
from shiboken6 import isValid

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
_TYPED = (QLineEdit, QAbstractSpinBox)
_COMMANDING = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier
_BY_THEMSELVES = (
    Qt.Key.Key_Control,
    Qt.Key.Key_Shift,
    Qt.Key.Key_Alt,
    Qt.Key.Key_AltGr,
    Qt.Key.Key_Meta,
)
_ENTER = (Qt.Key.Key_Return, Qt.Key.Key_Enter)


class OwnKeys(QObject):
    """Lets lists, boxes and sliders have the keys that move through them; the space bar switches, Enter presses buttons.

    Qt asks whoever has the focus before it looks for a shortcut, then all around it; the window answers for them. Before
    that it takes what was typed as finished if the key is a command, and does what was put off by whoever gets the key, so
    that it finds things, and what is possible, as they are by now. Buttons are pressed by Enter, since time goes on and stops by the
    space bar wherever one is. Escape empties a filter and leaves a field: letters are shortcuts only outside of those.
    """

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window
        window.installEventFilter(self)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Take a key from the shortcuts if it belongs to what has the focus; do what that has let through."""
        if not isinstance(event, QKeyEvent):
            return False
        if event.type() is QEvent.Type.KeyPress:
            focus = QApplication.focusWidget()
            return _presses(event, focus) or _leaves(event, focus)
        if event.type() is not QEvent.Type.ShortcutOverride:
            return False
        if _commands(event, self._window):
            finish_typing()
        catch_up(QApplication.focusWidget())
        if belongs(event, QApplication.focusWidget()):
            event.accept()
            return True
        return False


def finish_typing() -> None:
    """Have what is being typed into a field counted: otherwise it is once the keys leave the field."""
    field = QApplication.focusWidget()
    line = field.lineEdit() if isinstance(field, QAbstractSpinBox) else field
    if field is None or not isinstance(line, QLineEdit) or not line.isModified():
        return
    field.clearFocus()
    if isValid(field) and field.isVisible():
        field.setFocus(Qt.FocusReason.OtherFocusReason)


def _commands(event: QKeyEvent, window: QWidget) -> bool:
    """Whether a key that the focus did not want for itself is one of those with which commands are given."""
    if event.key() in _BY_THEMSELVES or belongs(event, QApplication.focusWidget()):
        return False
    return bool(event.modifiers() & _COMMANDING) or _is_shortcut(event, window)


def _is_shortcut(event: QKeyEvent, window: QWidget) -> bool:
    """Whether some action of a window has this key, or of the one that it floats above."""
    pressed = QKeySequence(
        QKeyCombination(event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier, Qt.Key(event.key()))
    )
    above: QWidget | None = window
    while above is not None:
        if any(pressed in action.shortcuts() for action in above.actions()):
            return True
        above = above.parentWidget()
    return False


def _presses(event: QKeyEvent, focus: QWidget | None) -> bool:
    """Press the button that has the focus, if the key does that; whether it did."""
    if event.key() not in _ENTER or event.isAutoRepeat() or not isinstance(focus, QAbstractButton):
        return False
    focus.click()
    return True


def _leaves(event: QKeyEvent, focus: QWidget | None) -> bool:
    """Empty the filter that has the focus, or leave the field, if the key does that; whether it did."""
    if event.key() != Qt.Key.Key_Escape or event.modifiers() or not isinstance(focus, _TYPED):
        return False
    if isinstance(focus, QLineEdit) and focus.isClearButtonEnabled() and focus.text():
        focus.clear()
        return True
    panel = _panel_of(focus)
    if panel is not None:
        panel.setFocus(Qt.FocusReason.ShortcutFocusReason)
    if QApplication.focusWidget() is focus:
        focus.window().setFocus()
    return True


def _panel_of(field: QWidget) -> QWidget | None:
    above: QWidget | None = field
    while above is not None and not isinstance(above, QDockWidget):
        above = above.parentWidget()
    return None if above is None else above.widget()


def belongs(event: QKeyEvent, focus: QWidget | None) -> bool:
    """Whether a key means something to what has the focus, rather than to the window."""
    if event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier:
        return False
    if event.key() == Qt.Key.Key_Escape:
        return isinstance(focus, _TYPED)
    if event.key() == Qt.Key.Key_Space:
        return isinstance(focus, _SWITCHED)
    return event.key() in MOVES and isinstance(focus, _MOVED)
