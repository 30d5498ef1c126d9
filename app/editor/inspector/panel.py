"""What the selected node does and why."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

if TYPE_CHECKING:
    from ..studio import Studio


class InspectorPanel(QWidget):
    """What the selected node does and why."""

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
