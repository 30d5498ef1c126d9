"""Windows that are no larger at first than the screen has room for."""

from __future__ import annotations

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QWidget

#: Pixels around a window that its title and frame may take.
FRAME = QSize(16, 48)


def resize_within(window: QWidget, width: int, height: int) -> None:
    """Give a window this size, or as much of it as its screen has room for: nobody may be there who would see to that."""
    window.resize(QSize(width, height).boundedTo(window.screen().availableSize() - FRAME))
