"""The field in the menu bar that opens the command palette."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QWidget

from ..actions import ActionRow

if TYPE_CHECKING:
    from ..studio import Studio
    from .palette import Palette

WIDTH = 330


def palette_rows(palette: Palette) -> tuple[ActionRow, ...]:
    """Opening the palette."""
    return (
        ActionRow(
            "help.palette",
            "Search everything…",
            "Help",
            lambda _: palette.open(),
            "search",
            "Ctrl+K",
            "Find an action, a behavior, an agent, an arm, a parameter or a setting by a few letters",
            "magnify",
        ),
    )


class SearchField(QWidget):
    """Looks like a field; a click opens the palette, where the typing is done."""

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self.button = QPushButton("Search actions, behaviors, agents")
        self.button.setObjectName("search-field")
        self.button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.button.setMinimumSize(QSize(WIDTH, 22))
        self.button.clicked.connect(studio.actions["help.palette"].trigger)
        self._keys = QLabel(self.button)
        self._keys.setProperty("role", "caption")
        self._keys.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        inner = QHBoxLayout(self.button)
        inner.setContentsMargins(8, 0, 8, 0)
        inner.addStretch(1)
        inner.addWidget(self._keys)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 2, 8, 2)
        layout.addWidget(self.button)
        studio.theme.changed.connect(self._dress)
        studio.settings.changed.connect(self._dress)
        self._dress()

    def _dress(self) -> None:
        action = self._studio.actions["help.palette"]
        self.button.setToolTip(action.toolTip())
        keys = action.shortcut()
        self._keys.setText(keys.toString(keys.SequenceFormat.NativeText).replace("+", " "))
        dim = self._studio.theme.palette.dim
        self.button.setStyleSheet(f"text-align: left; padding: 1px 10px; color: {dim};")
