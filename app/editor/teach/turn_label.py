"""Whose turn it is, with the number that it has in the world."""

from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QLabel

from ..theme import Theme
from ..turn_mark import mark_width, paint_mark

TIP = (
    "Who is taught now. In the world it has a thick ring; the others of the lesson have dashed ones, numbered in the order of "
    "their turns. A click on one of them there makes it its turn."
)


class TurnLabel(QLabel):
    """The name of the node that picks are for; of several, with its number as it stands beside its ring."""

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self._number = 0
        theme.changed.connect(self.update)

    def tell(self, name: str, number: int, of: int) -> None:
        """It is this one's turn: the *number* th of so many; 0 for one that has no turn."""
        several = number > 0 and of > 1
        self._number = number if several else 0
        room = round(mark_width(number)) + 5 if several else 0
        if self.contentsMargins().left() != room:
            self.setContentsMargins(room, 0, 0, 0)
        self.setText(f"of {of}: {name}" if several else name)
        self.setAccessibleName(f"{number} of {of}: {name}" if several else name)
        self.setToolTip(TIP if several else "")
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """The number in its mark, then the words."""
        super().paintEvent(event)
        if self._number:
            painter = QPainter(self)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.translate(mark_width(self._number) / 2, self.height() / 2)
            paint_mark(painter, self._number, self._theme.palette, its_turn=True)
            painter.end()
