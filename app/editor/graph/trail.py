"""What stands above the graph: which automata were entered on the way to the one that is shown, as links, and buttons."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QToolButton, QWidget

from ..letters import plain
from ..selection import BehaviorKey

if TYPE_CHECKING:
    from ..studio import Studio

BUTTONS = ("graph.zoom_in", "graph.zoom_out", "graph.fit", "graph.arrange")


class Trail(QWidget):
    """The way from the automaton that was chosen to the one that is shown.

    Signals:
        chosen: Go back to this one.
    """

    chosen = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self._layout = QHBoxLayout(self)
        self._layout.setContentsMargins(0, 0, 0, 0)
        self._layout.setSpacing(2)

    def show_way(self, way: list[tuple[BehaviorKey, str]]) -> None:
        """Show these, the last being where we are."""
        while (entry := self._layout.takeAt(0)) is not None:
            widget = entry.widget()
            if widget is not None:
                widget.setParent(None)
                widget.deleteLater()
        for number, (key, name) in enumerate(way):
            if number:
                self._layout.addWidget(QLabel("/"))
            self._layout.addWidget(self._link(key, name, is_last=number == len(way) - 1))
        self._layout.addStretch(1)

    def _link(self, key: BehaviorKey, name: str, *, is_last: bool) -> QWidget:
        if is_last:
            label = QLabel(name)
            label.setTextFormat(Qt.TextFormat.PlainText)
            return label
        button = QToolButton()
        button.setText(plain(name))
        button.setProperty("flat", "true")
        button.setToolTip(f"Back to {name} (Backspace)")
        button.setAccessibleName(f"Back to {name}")
        button.clicked.connect(lambda: self.chosen.emit(key))
        return button


def top_bar(studio: Studio, trail: Trail) -> QHBoxLayout:
    """The trail, and buttons for looking at the graph."""
    row = QHBoxLayout()
    row.setContentsMargins(8, 0, 8, 0)
    row.setSpacing(2)
    row.addWidget(trail, 1)
    for action in BUTTONS:
        button = QToolButton()
        button.setProperty("flat", "true")
        button.setDefaultAction(studio.actions[action])
        button.setAccessibleName(studio.actions.rows[action].text)
        row.addWidget(button)
    return row
