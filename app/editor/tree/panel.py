"""The decision tree of the state that is shown."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

if TYPE_CHECKING:
    from ..studio import Studio


class TreePanel(QWidget):
    """The decision tree of the state that is shown."""

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
