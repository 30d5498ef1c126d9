"""A list to choose from that changes only when something is chosen: keys and the wheel do not step through it."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent, QWheelEvent

from .word_list import WordList

STEPS = (
    Qt.Key.Key_Up,
    Qt.Key.Key_Down,
    Qt.Key.Key_PageUp,
    Qt.Key.Key_PageDown,
    Qt.Key.Key_Return,
    Qt.Key.Key_Enter,
)


class ListChoice(WordList):
    """Opens on the keys that would otherwise choose one thing after the other, each a step to undo."""

    def __init__(self) -> None:
        super().__init__()
        self.setMaxVisibleItems(18)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Open the list; letters are for finding something in it."""
        letter = event.text().strip()
        if event.key() in STEPS or (letter and letter.isprintable()):
            self.showPopup()
            event.accept()
        else:
            super().keyPressEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """The wheel scrolls the form."""
        event.ignore()
