"""What forms are made of: lines around fields, words beside them, the halves of a page."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QObject, Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QLayout, QListWidget, QPlainTextEdit, QWidget

from ...core.errors import UnderstudyError

if TYPE_CHECKING:
    from ..document import Document
    from ..theme import Theme


class _Frame(QObject):
    """Keeps the line around a field in the colors of the theme, as long as the field lives."""

    def __init__(self, field: QWidget, kind: str, theme: Theme) -> None:
        super().__init__(field)
        self._field, self._kind, self._theme = field, kind, theme
        theme.changed.connect(self._dress)
        self._dress()

    def _dress(self) -> None:
        colors, kind = self._theme.palette, self._kind
        self._field.setStyleSheet(
            f"{kind} {{ background: {colors.raised}; border: 1px solid {colors.hairline}; border-radius: 6px; }}"
            "QPlainTextEdit { padding: 1px 4px; }"  # its words begin where those of other fields do
            f"{kind}:focus {{ border-color: {colors.accent}; }}"
        )


def framed(field: QListWidget | QPlainTextEdit, theme: Theme) -> None:
    """Draw a line around a list or a text, so that an empty one is seen as well."""
    _Frame(field, "QListWidget" if isinstance(field, QListWidget) else "QPlainTextEdit", theme)


class Complaint(QLabel):
    """What is wrong with a field, in words beside it; nothing while nothing is."""

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self.setWordWrap(True)
        self.hide()
        theme.changed.connect(self._dress)
        self._dress()

    def say(self, message: str) -> None:
        """Show a message; an empty one shows nothing."""
        self.setText(message[:1].upper() + message[1:])
        self.setVisible(bool(message))

    def attempt(self, document: Document, edit: Callable[..., Any], *args: Any, gesture: str = "") -> bool:
        """Edit the project; why an edit is refused is said here. Returns whether it was possible."""
        try:
            document.do(edit, *args, gesture=gesture)
        except UnderstudyError as error:
            self.say(str(error))
            return False
        self.say("")
        return True

    def _dress(self) -> None:
        self.setStyleSheet(f"color: {self._theme.palette.teach};")


def caption(text: str) -> QLabel:
    """Dim words that explain what stands near them."""
    label = QLabel(text)
    label.setProperty("role", "caption")
    label.setWordWrap(True)
    label.setAlignment(Qt.AlignmentFlag.AlignTop)  # near what it explains, whatever room there is below
    return label


def side_by_side(left: QLayout, right: QLayout | QWidget, shares: tuple[int, int] = (1, 1)) -> QHBoxLayout:
    """The two halves of a page; *shares* say how wide each is in proportion to the other."""
    both = QHBoxLayout()
    both.setSpacing(16)
    both.addLayout(left, shares[0])
    if isinstance(right, QLayout):
        both.addLayout(right, shares[1])
    else:
        both.addWidget(right, shares[1])
    return both
