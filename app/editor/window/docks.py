"""The panels of the window as a table, and the docks that they stand in."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPalette, QShowEvent
from PySide6.QtWidgets import (
    QApplication,
    QDockWidget,
    QHBoxLayout,
    QMainWindow,
    QTabWidget,
    QWidget,
)

from ..agents.panel import AgentsPanel
from ..cut_line import CutLine
from ..examples.panel import ExamplesPanel
from ..graph.panel import GraphPanel
from ..inspector.panel import InspectorPanel
from ..letters import plain
from ..library.panel import LibraryPanel
from ..plots.panel import PlotsPanel
from ..problems.panel import ProblemsPanel
from ..teach.panel import TeachPanel
from ..timeline.panel import TimelinePanel
from ..tree.panel import TreePanel
from .tabbing import go_on

if TYPE_CHECKING:
    from ..studio import Studio

Area = Qt.DockWidgetArea
#: Pixels that the left and right columns get at first, and more of a window wider than so many.
LEFT, RIGHT, WIDTH = 252, 372, 1440
#: Pixels of the words on a tab at most.
TAB = 230
#: In a window lower than so many pixels, some panels share a place or are lower, so that each still shows something; the
#: right column gets what the world, which is as high as wide, has no use for.
LOW, LOW_RIGHT = 860, 404


@dataclass(frozen=True, slots=True)
class DockRow:
    """One panel.

    Attributes:
        id: Stable: the window's state is kept by it.
        make: Makes the panel for a studio.
        under: The panel that it stands below in the same area; empty for the first.
        tab_of: The panel that it shares a place with, as a tab.
        keys: Shortcut that brings it to the front.
        height: Pixels that it gets at first, where several stand below each other.
        low_tab_of: The panel that it shares a place with, as a tab, in a low window.
        low: Pixels that it gets at first in a low window; as many as elsewhere if it is 0.
    """

    id: str
    title: str
    make: Callable[[Studio], QWidget]
    area: Area
    under: str = ""
    tab_of: str = ""
    keys: str = ""
    height: int = 0
    low_tab_of: str = ""
    low: int = 0


DOCKS: tuple[DockRow, ...] = (
    DockRow("library", "Library", LibraryPanel, Area.LeftDockWidgetArea, keys="Alt+1", height=430),
    DockRow(
        "agents", "Agents", AgentsPanel, Area.LeftDockWidgetArea, under="library", keys="Alt+2", height=270
    ),
    DockRow("graph", "Automaton", GraphPanel, Area.RightDockWidgetArea, keys="Alt+3", height=300, low=490),
    DockRow(
        "tree",
        "Decision tree",
        TreePanel,
        Area.RightDockWidgetArea,
        under="graph",
        keys="Alt+4",
        height=250,
        low_tab_of="graph",
    ),
    DockRow(
        "inspector",
        "Why",
        InspectorPanel,
        Area.RightDockWidgetArea,
        under="tree",
        keys="Alt+5",
        height=160,
        low=210,
    ),
    DockRow("teach", "Teach", TeachPanel, Area.BottomDockWidgetArea, keys="Alt+6", height=112),
    DockRow(
        "examples",
        "Examples",
        ExamplesPanel,
        Area.BottomDockWidgetArea,
        under="teach",
        keys="Alt+7",
        height=190,
        low=172,
    ),
    DockRow(
        "timeline", "Timeline", TimelinePanel, Area.BottomDockWidgetArea, tab_of="examples", keys="Alt+0"
    ),
    DockRow("plots", "Plots", PlotsPanel, Area.BottomDockWidgetArea, tab_of="examples", keys="Alt+9"),
    DockRow(
        "problems", "Problems", ProblemsPanel, Area.BottomDockWidgetArea, tab_of="examples", keys="Alt+8"
    ),
)


class Dock(QDockWidget):
    """A dock with a quiet title."""

    def __init__(self, row: DockRow, panel: QWidget) -> None:
        super().__init__(row.title)
        self.setObjectName(row.id)
        self.row = row
        self.setWidget(panel)
        self.title = _Title(row.title)
        self._no_title = QWidget(self)
        self._told = row.title
        self.setTitleBarWidget(self.title)
        self.topLevelChanged.connect(self._edge)
        for part in (panel, self.title):
            # The style sheet paints the ground of panels.
            part.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        if hasattr(panel, "title_changed"):
            panel.title_changed.connect(self._tell)

    def _edge(self, floating: bool) -> None:  # noqa: FBT001 - as Qt calls it
        """Leave room for an edge: what floats has no frame of the system's, and lies on panels of the same color."""
        edge = 1 if floating else 0
        self.setContentsMargins(edge, edge, edge, edge)

    def showEvent(self, event: QShowEvent) -> None:
        """What floated the last time floats again without being told."""
        self._edge(self.isFloating())
        super().showEvent(event)

    def focusNextPrevChild(self, forward: bool) -> bool:  # noqa: FBT001 - as Qt calls it
        """Tab in a dock that floats stays in it."""
        return go_on(self, forward=forward) if self.isFloating() else super().focusNextPrevChild(forward)

    def paintEvent(self, event: QPaintEvent) -> None:
        """See above."""
        super().paintEvent(event)
        if self.isFloating():
            painter = QPainter(self)
            painter.setPen(self.palette().color(QPalette.ColorRole.PlaceholderText))
            painter.drawRect(self.rect().adjusted(0, 0, -1, -1))
            painter.end()

    def _tell(self, title: str) -> None:
        """Show what the panel is called now: all of it in the title, what there is room for on a tab."""
        self._told = title
        self.title.label.setText(title)
        folded = self.titleBarWidget() is not self.title
        self.setWindowTitle(self._on_tab(title) if folded else title)

    def _on_tab(self, title: str) -> str:
        """A tab that always stands beside another one says no more than what it is."""
        if self.row.low_tab_of:
            return self.row.title
        return plain(self.fontMetrics().elidedText(title, Qt.TextElideMode.ElideRight, TAB))

    def fold_title(self, *, folded: bool) -> None:
        """Show no title, or show it: where docks are tabs, the tab says it already."""
        wanted = self._no_title if folded else self.title
        if self.titleBarWidget() is not wanted:
            self.titleBarWidget().hide()
            self.setTitleBarWidget(wanted)
            wanted.show()
            self._tell(self._told)


class _Title(QWidget):
    """Only words; it can be dragged as any title bar can."""

    def __init__(self, title: str) -> None:
        super().__init__()
        self.label = CutLine(title)
        self.label.setProperty("role", "title")
        layout = QHBoxLayout(self)
        layout.setContentsMargins(10, 6, 8, 5)
        layout.addWidget(self.label)


def place_docks(window: QMainWindow, studio: Studio) -> Iterator[Dock | None]:
    """Make all panels and put their docks where they stand at first, one after another; None where one is but half done."""
    docks: dict[str, Dock] = {}
    window.setTabPosition(Area.AllDockWidgetAreas, QTabWidget.TabPosition.North)
    for row in DOCKS:
        panel = row.make(studio)
        yield None
        dock = docks[row.id] = Dock(row, panel)
        window.addDockWidget(row.area, dock)
        if row.under:
            way = Qt.Orientation.Vertical
            window.splitDockWidget(docks[row.under], dock, way)
        if row.tab_of:
            window.tabifyDockWidget(docks[row.tab_of], dock)
            docks[row.tab_of].raise_()
        yield dock


def share_places(window: QMainWindow, docks: Mapping[str, Dock]) -> None:
    """In a low window, let panels that would be too low to show anything be tabs of others."""
    for row in DOCKS:
        if row.low_tab_of and is_low(window):
            window.tabifyDockWidget(docks[row.low_tab_of], docks[row.id])
            docks[row.low_tab_of].raise_()


def size_docks(window: QMainWindow, docks: Mapping[str, Dock]) -> None:
    """Give docks the sizes that they have at first; only a window on the screen can."""
    sized = [row for row in DOCKS if row.height and not (row.low_tab_of and is_low(window))]
    heights = [(row.low or row.height) if is_low(window) else row.height for row in sized]
    window.resizeDocks([docks[row.id] for row in sized], heights, Qt.Orientation.Vertical)
    more = max(0, window.width() - WIDTH)
    columns = [LEFT + more // 10, (LOW_RIGHT if is_low(window) else RIGHT) + more // 4]
    window.resizeDocks([docks["library"], docks["graph"]], columns, Qt.Orientation.Horizontal)


def is_low(window: QMainWindow) -> bool:
    """Whether all panels below each other would leave too little of each."""
    return window.height() < LOW


def is_in_sight(dock: Dock) -> bool:
    """Whether anything of a dock is seen: it is not hidden, nor behind another tab."""
    return dock.isVisible() and not dock.visibleRegion().isEmpty()


def has_keys(place: QWidget) -> bool:
    """Whether keys go to a place of the window, or to something in it."""
    focus = QApplication.focusWidget()
    return focus is not None and (focus is place or place.isAncestorOf(focus))
