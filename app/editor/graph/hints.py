"""What the graph panel says below the graph, or in its place."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject
from PySide6.QtGui import QFocusEvent
from PySide6.QtWidgets import QLabel

from ..focus_frame import BY_KEYS, FOR_A_WHILE

if TYPE_CHECKING:
    from .view import GraphView

NOTHING = "Choose a behavior in the library to see its states."
HINT = "Drop a behavior here to add a state. Drag from a state's handle to draw a transition. Right-click to prune."
KEYS = (
    "Arrow keys: states; Page Up and Down: transitions. F2 edits, Ctrl+T draws a transition, Delete removes or prunes; "
    "the menu key offers more."
)
LINKING = "Choose where the transition leads: a click, or arrow keys and Enter. Esc gives up."
EMPTY = "No states yet. Teach it, drop a behavior here, or use Add state in the context menu."


def nothing_shown() -> QLabel:
    """What stands in the place of a graph while there is none."""
    words = QLabel(NOTHING)
    words.setProperty("role", "empty")
    words.setWordWrap(True)
    words.setContentsMargins(10, 10, 10, 10)
    return words


class Hint(QLabel):
    """What can be done with a graph now: by keys, for whoever came to it by keys."""

    def __init__(self, view: GraphView) -> None:
        super().__init__(HINT)
        self._view = view
        self._by_keys, self._is_empty = False, False
        self.setProperty("role", "caption")
        self.setWordWrap(True)
        self.setContentsMargins(10, 0, 10, 6)
        for part in (view, view.viewport()):
            part.installEventFilter(self)

    def say(self, *, is_empty: bool | None = None) -> None:
        """Say what fits what is going on; *is_empty* if that has changed."""
        self._is_empty = self._is_empty if is_empty is None else is_empty
        usual = KEYS if self._by_keys else HINT
        self.setText(LINKING if self._view.is_linking else EMPTY if self._is_empty else usual)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """The keys have come to the graph, or gone."""
        if isinstance(event, QFocusEvent) and event.reason() not in FOR_A_WHILE:
            self._by_keys = event.gotFocus() and event.reason() in BY_KEYS
            self.say()
        elif event.type() is QEvent.Type.MouseButtonPress and self._by_keys:
            self._by_keys = False
            self.say()
        return super().eventFilter(watched, event)
