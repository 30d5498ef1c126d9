"""What is wrong with the project, and what can be done about it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

if TYPE_CHECKING:
    from ..studio import Studio


class ProblemsPanel(QWidget):
    """What is wrong with the project, and what can be done about it."""

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
