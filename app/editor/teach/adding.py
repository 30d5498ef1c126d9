"""The list of all that could become a state, with a search: opened by "+ add behavior"."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, QPoint, QSize, Qt, Signal
from PySide6.QtGui import QColor, QHideEvent, QIcon, QKeyEvent, QPainter, QPixmap
from PySide6.QtWidgets import QFrame, QLineEdit, QListWidget, QListWidgetItem, QVBoxLayout, QWidget

from ...core.automaton import RaiseFlag
from ...core.naming import lowered
from ..searching import has_words, words_in
from .choices import Choice

WIDTH, HEIGHT = 300, 320
_STEPS = {
    Qt.Key.Key_Down: 1,
    Qt.Key.Key_Up: -1,
    Qt.Key.Key_PageDown: 8,
    Qt.Key.Key_PageUp: -8,
}


class AddList(QFrame):
    """A list that is open until something was chosen; arrow keys move in it while the search has the focus.

    Signals:
        chosen: A `Choice`.
    """

    chosen = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent, Qt.WindowType.Popup)
        self.setObjectName("add-behavior")
        self.setFixedWidth(WIDTH)
        self.search = QLineEdit(placeholderText="Find a behavior, or name a flag")
        self.search.setAccessibleName("Find a behavior to add")
        self.search.textChanged.connect(self._filter)
        self.search.installEventFilter(self)
        self.list = QListWidget()
        self.list.setAccessibleName("Behaviors that can be added")
        self.list.setUniformItemSizes(True)
        self.list.itemClicked.connect(self._choose)
        self.list.itemActivated.connect(self._choose)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 8, 8, 8)
        layout.addWidget(self.search)
        layout.addWidget(self.list)
        self._choices: tuple[tuple[Choice, QColor], ...] = ()

    def open(self, choices: Sequence[tuple[Choice, QColor]], below: QPoint) -> None:
        """Offer these, each with its color, near *below*, in global coordinates."""
        self._choices = tuple(choices)
        self.search.clear()
        self._filter("")
        height = min(HEIGHT, 60 + 26 * (len(choices) + 1))
        self.setFixedHeight(height)
        screen = self.screen().availableGeometry()
        left = max(screen.left(), min(below.x(), screen.right() - WIDTH))
        top = below.y() if below.y() + height <= screen.bottom() else below.y() - height - 48
        self.move(left, max(screen.top(), top))
        self.show()
        self.search.setFocus()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Arrow keys and Enter in the search are for the list."""
        if watched is self.search and isinstance(event, QKeyEvent) and event.type() is QEvent.Type.KeyPress:
            key = Qt.Key(event.key())
            if key in _STEPS:
                row = self.list.currentRow() + _STEPS[key]
                self.list.setCurrentRow(max(0, min(row, self.list.count() - 1)))
                return True
            if key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
                item = self.list.currentItem()
                if item is not None:
                    self._choose(item)
                return True
        return super().eventFilter(watched, event)

    def _filter(self, text: str) -> None:
        wanted, name = words_in(text), lowered(text.strip())
        found = [(choice, color) for choice, color in self._choices if has_words(wanted, choice.name)]
        self.list.clear()
        for choice, color in found:
            self.list.addItem(_item(choice, color))
        if wanted and all(lowered(choice.name) != name for choice, _ in found):
            flag = Choice(
                f"new flag “{text.strip()}”",
                RaiseFlag(text.strip()),
                raises=text.strip(),
                doc="Raises a flag that you name; whoever runs this behavior can take it as a feature.",
            )
            self.list.addItem(_item(flag, None))
        self.list.setCurrentRow(0)

    def _choose(self, item: QListWidgetItem) -> None:
        choice = item.data(Qt.ItemDataRole.UserRole)
        self.hide()
        self.chosen.emit(choice)

    def hideEvent(self, event: QHideEvent) -> None:
        """Keys are for the window again."""
        super().hideEvent(event)
        parent = self.parentWidget()
        if parent is not None:
            parent.window().activateWindow()


def _item(choice: Choice, color: QColor | None) -> QListWidgetItem:
    name = choice.name + (f"({', '.join(choice.slots)})" if choice.slots else "")
    told = [choice.kind] + ([f"raises {choice.raises}"] if choice.raises and choice.kind == "basic" else [])
    key = f"  [{choice.key}]" if choice.key else ""
    item = QListWidgetItem(f"{name}{key}   {' · '.join(told)}")
    item.setData(Qt.ItemDataRole.UserRole, choice)
    item.setToolTip(f"{name}\n{choice.doc}".strip())  # the list may have no room for the name
    item.setSizeHint(QSize(0, 26))
    if color is not None:
        item.setIcon(swatch(color))
    return item


def swatch(color: QColor, side: int = 11) -> QIcon:
    """A small square of a color."""
    pixmap = QPixmap(side, side)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(color)
    painter.drawRoundedRect(0, 0, side, side, 3, 3)
    painter.end()
    return QIcon(pixmap)
