"""Opening, saving and closing projects."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from ...core.storage import load
from ...engine.scenarios import open_scenario
from ..actions import ActionRow

if TYPE_CHECKING:
    from PySide6.QtWidgets import QWidget

    from ..studio import Studio


class Files:
    """Opens and saves projects for a window."""

    def __init__(self, studio: Studio, window: QWidget) -> None:
        self._studio = studio
        self._window = window

    def open(self, folder: Path) -> None:
        """Open the project in *folder*."""

        def opened() -> None:
            project = load(folder)
            self._studio.open(project, open_scenario(project, folder), folder)

        self._studio.attempt(opened)

    def may_close(self, then: Callable[[], None]) -> None:
        """Do *then* once nothing can be lost by it."""
        then()

    def rows(self) -> tuple[ActionRow, ...]:
        """The actions of the File menu."""
        return ()
