"""The behaviors that can be picked, as large buttons with keys."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

if TYPE_CHECKING:
    from ..studio import Studio


class TeachPanel(QWidget):
    """The behaviors that can be picked, as large buttons with keys."""

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
