"""Arms, worlds and node types: who acts where, and who may stand under whom."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QTabWidget, QVBoxLayout, QWidget

from ..forms.buttons import closing
from .arms_page import ArmsPage
from .types_page import TypesPage
from .worlds_page import WorldsPage

if TYPE_CHECKING:
    from ..studio import Studio

ARMS, WORLDS, TYPES = "Arms", "Worlds", "Node types"


def arms_and_worlds(studio: Studio, parent: QWidget, page: str = "") -> ArmsDialog:
    """Open the dialog, or bring it to the front."""
    window = parent.window()
    dialog = window.findChild(ArmsDialog) or ArmsDialog(studio, window)
    dialog.show()
    dialog.raise_()
    dialog.activateWindow()
    dialog.turn_to(page)
    return dialog


class ArmsDialog(QDialog):
    """A window that stays open beside the work; every change is done at once and can be undone.

    Attributes:
        arms, worlds, types: The pages.
    """

    def __init__(self, studio: Studio, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setObjectName("arms-and-worlds")
        self.setWindowTitle("Arms and worlds")
        self.arms = ArmsPage(studio)
        self.worlds = WorldsPage(studio)
        self.types = TypesPage(studio)
        self._pages: dict[str, QWidget] = {ARMS: self.arms, WORLDS: self.worlds, TYPES: self.types}
        self.tabs = QTabWidget()
        self.tabs.setDocumentMode(True)
        for title, page in self._pages.items():
            self.tabs.addTab(page, title)
        column = QVBoxLayout(self)
        column.addWidget(self.tabs, 1)
        column.addWidget(closing(self))
        self.resize(720, 520)
        studio.opened.connect(self.close)
        studio.closing.connect(self.close)

    def turn_to(self, page: str) -> None:
        """Show a page by its name."""
        if page in self._pages:
            self.tabs.setCurrentWidget(self._pages[page])
