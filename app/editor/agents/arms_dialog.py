"""Arms, worlds and node types: who acts where, and who may stand under whom."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QVBoxLayout, QWidget

from ..forms.buttons import closing
from ..forms.late_pages import LatePages
from ..room import resize_within
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
    """A window that stays open beside the work; every change is done at once and can be undone."""

    def __init__(self, studio: Studio, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setObjectName("arms-and-worlds")
        self.setWindowTitle("Arms and worlds")
        self.tabs = LatePages()
        self.tabs.offer(
            {
                ARMS: partial(ArmsPage, studio),
                WORLDS: partial(WorldsPage, studio),
                TYPES: partial(TypesPage, studio),
            }
        )
        column = QVBoxLayout(self)
        column.addWidget(self.tabs, 1)
        column.addWidget(closing(self))
        resize_within(self, 720, 520)
        self.finished.connect(lambda _: self._settle())
        studio.opened.connect(self._leave)
        studio.closing.connect(self._leave)

    @property
    def arms(self) -> ArmsPage:
        """Who acts where."""
        return self.tabs.page(ARMS, ArmsPage)

    @property
    def worlds(self) -> WorldsPage:
        """Named sets of parameters."""
        return self.tabs.page(WORLDS, WorldsPage)

    @property
    def types(self) -> TypesPage:
        """Who may stand under whom."""
        return self.tabs.page(TYPES, TypesPage)

    def _settle(self) -> None:
        for page in self.tabs.made(ArmsPage):
            page.settle()

    def _leave(self) -> None:
        """The project is another one: what was meant for the last one is not for this."""
        for page in self.tabs.made(ArmsPage):
            page.table.forget()
        self.close()

    def turn_to(self, page: str) -> None:
        """Show a page by its name."""
        self.tabs.turn_to(page)
