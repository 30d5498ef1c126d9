"""The agents and their controllers, as a tree."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

if TYPE_CHECKING:
    from ..studio import Studio


class AgentsPanel(QWidget):
    """The agents and their controllers, as a tree."""

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
