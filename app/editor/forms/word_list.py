"""A box to choose from whose list can be read, however little room the box itself has."""

from PySide6.QtCore import QRect
from PySide6.QtWidgets import QComboBox, QWidget

#: Pixels beside the words of a list: its frame, and what stands around each row.
AROUND = 12


class WordList(QComboBox):
    """Its list is as wide as the longest words in it, and lies on the screen as a whole."""

    def showPopup(self) -> None:
        """Open the list."""
        view = self.view()
        scrolls = self.count() > self.maxVisibleItems()
        bar = view.verticalScrollBar().sizeHint().width() if scrolls else 0
        view.setMinimumWidth(
            min(view.sizeHintForColumn(0) + AROUND + bar, self.screen().availableSize().width())
        )
        super().showPopup()
        _move_onto(view.window(), self.screen().availableGeometry())


def _move_onto(window: QWidget, screen: QRect) -> None:
    """A box at the edge would have a list that goes on beyond it."""
    beyond = window.frameGeometry().right() - screen.right()
    if beyond > 0:
        window.move(window.x() - beyond, window.y())
