"""The live picture of the world."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

if TYPE_CHECKING:
    from ..studio import Studio


class WorldCanvas(QWidget):
    """The live picture of the world."""

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
