"""Tab goes through all controls that are in sight, one after the other.

Qt takes a panel as such for a control, and gives the keys to the list or the diagram that the panel passes them on to: past the
fields that stand before that, which Tab never gets to, and nowhere at all while it is hidden.
"""

from collections.abc import Iterator

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QDockWidget, QWidget


def go_on(window: QWidget, *, forward: bool) -> bool:
    """Give the keys to the next control of *window* in sight, or to the one before; whether there is one."""
    reason = Qt.FocusReason.TabFocusReason if forward else Qt.FocusReason.BacktabFocusReason
    now = QApplication.focusWidget()
    for widget in _from(now if isinstance(now, QWidget) else window, forward=forward):
        if widget.window() is window and _takes_keys(widget) and _is_in_sight(widget, window):
            widget.setFocus(reason)
            return True
    return False


def _from(start: QWidget, *, forward: bool) -> Iterator[QWidget]:
    """All others of its window in their order, beginning with the one beside it."""
    beside = QWidget.nextInFocusChain if forward else QWidget.previousInFocusChain
    widget = beside(start)
    while widget is not None and widget is not start:
        yield widget
        widget = beside(widget)


def _takes_keys(widget: QWidget) -> bool:
    tabbed = bool(widget.focusPolicy() & Qt.FocusPolicy.TabFocus)
    return tabbed and widget.focusProxy() is None and widget.isEnabled()


def _is_in_sight(widget: QWidget, window: QWidget) -> bool:
    """Whether it is shown, and not in a dock behind others, which lies beside the window."""
    if not widget.isVisibleTo(window):
        return False
    above: QWidget | None = widget
    while above is not None and not isinstance(above, QDockWidget):
        above = above.parentWidget()
    return above is None or above.isWindow() or window.rect().intersects(above.geometry())
