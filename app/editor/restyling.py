"""Widgets take on the colors of another palette: those in sight at once, the others in turns, so that the window answers."""

from collections import deque
from collections.abc import Iterable

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QWidget
from shiboken6 import isValid

from .soon import Later

#: Widgets in a row, at most, of those that nobody sees.
SOME = 40


class Restyling:
    """Has the style look up the colors of widgets again.

    A palette is taken on by itself, but not where a style sheet refers to it. Whoever sets the sheet again has all of it
    done in one go, hidden or not, and each widget as often as it lies deep; here each is styled once.
    """

    def __init__(self, parent: QObject) -> None:
        self._hidden: deque[QWidget] = deque()
        self._later = Later(parent, self._go_on)

    @property
    def is_under_way(self) -> bool:
        """Whether some are still to be restyled."""
        return self._later.is_due

    def begin(self, widgets: Iterable[QWidget]) -> None:
        """Restyle these, those in sight before anything else happens."""
        self._hidden.clear()
        for widget in widgets:
            if widget.isVisible():
                _restyle(widget)
            else:
                self._hidden.append(widget)
        self._later.ask()

    def _go_on(self) -> None:
        for _ in range(min(SOME, len(self._hidden))):
            widget = self._hidden.popleft()
            if isValid(widget):  # otherwise it was closed in the meantime
                _restyle(widget)
        if self._hidden:
            self._later.ask()


def _restyle(widget: QWidget) -> None:
    widget.style().polish(widget)
