"""Panels that share a place as tabs: each can be taken out of it, and then be dragged anywhere by its title."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, QPoint, Qt
from PySide6.QtGui import QContextMenuEvent, QMouseEvent
from PySide6.QtWidgets import QMenu, QTabBar

from ..actions import ActionRow, when_open
from .docks import has_keys

if TYPE_CHECKING:
    from ..studio import Studio
    from .docks import Dock
    from .main_window import MainWindow

#: Pixels by which a panel that floats stands off its place: it is seen to be out of it.
OFF = QPoint(-24, -36)
FIRST = "click into a panel and press {keys}, or double-click its tab or title"


class Tabs(QObject):
    """Listens to the tabs of a window's panels: a double click lets a panel float, the right button asks what to do."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window = window

    def watch(self) -> None:
        """Listen to all tab bars that there are now: they come and go as panels are moved."""
        for bar in self._window.findChildren(QTabBar, options=Qt.FindChildOption.FindDirectChildrenOnly):
            bar.removeEventFilter(self)
            bar.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """See above."""
        if isinstance(watched, QTabBar):
            if event.type() == QEvent.Type.MouseButtonDblClick and isinstance(event, QMouseEvent):
                dock = self._dock_at(watched, event.position().toPoint())
                if dock is not None:
                    let_float(self._window, dock)
                    return True
            elif event.type() == QEvent.Type.ContextMenu and isinstance(event, QContextMenuEvent):
                dock = self._dock_at(watched, event.pos())
                if dock is not None:
                    self._ask(dock, event.globalPos())
                    return True
        return super().eventFilter(watched, event)

    def _dock_at(self, bar: QTabBar, at: QPoint) -> Dock | None:
        tab = bar.tabAt(at)
        title = bar.tabText(tab) if tab >= 0 else ""
        docks = self._window.docks.values()
        return next(
            (dock for dock in docks if title and not dock.isFloating() and dock.windowTitle() == title), None
        )

    def _ask(self, dock: Dock, at: QPoint) -> None:
        menu = QMenu(self._window)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.addAction("Let it float", partial(let_float, self._window, dock))
        menu.addAction("Hide it", partial(self._window.hide_panel, dock.row.id))
        menu.popup(at)


def let_float(window: MainWindow, dock: Dock) -> None:
    """Take a panel out of its place; by its title it is dragged, and a double click there puts it back."""
    place = dock.geometry()
    corner, screen = window.mapToGlobal(place.topLeft()) + OFF, window.screen().availableGeometry()
    dock.setFloating(True)
    dock.resize(place.size())
    dock.move(max(corner.x(), screen.left()), max(corner.y(), screen.top()))
    dock.raise_()
    dock.activateWindow()  # the keys stay with it


def float_row(window: MainWindow) -> ActionRow:
    """The same by keys, and back."""

    def toggle(studio: Studio) -> None:
        dock = next((dock for dock in window.docks.values() if has_keys(dock)), None)
        if dock is None:
            studio.say(FIRST.format(keys=studio.actions.keys_of("view.float") or "the key for this"))
        elif dock.isFloating():
            dock.setFloating(False)
        else:
            let_float(window, dock)

    return ActionRow(
        "view.float",
        "Let the panel float",
        "View",
        toggle,
        "panels",
        "Ctrl+F6",
        "Take the panel with the keys out of its place, or put it back; a double click on its tab or title does, too",
        icon="dock-window",
        enabled=when_open,
    )
