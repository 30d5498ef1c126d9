"""The main window: the canvas in the middle, docks around it, menus and bars from the table of actions."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QByteArray, QEvent, QObject, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QCloseEvent, QShowEvent
from PySide6.QtWidgets import QMainWindow, QStackedWidget

from ..canvas.view import WorldCanvas
from ..command_palette.catalog import Catalog, Entry, catalog_of
from ..command_palette.field import SearchField, palette_rows
from ..command_palette.palette import Palette
from ..documents.busy import BusyPage
from ..documents.files import Files
from ..documents.recent_menu import RecentMenu
from ..documents.welcome import WelcomePage
from ..experiments.rows import Experiments
from ..exporting.dialog import export_rows
from ..exporting.import_dialog import import_rows
from ..focus_frame import frame_views
from ..guide.card import Guide, guide_rows
from ..library.panel import LibraryPanel
from ..preferences.dialog import SETTINGS, open_preferences, preference_rows
from ..teach.ask_control import AskControl
from .docks import DOCKS, Dock, has_keys, place_docks, share_places, size_docks
from .help_rows import help_rows
from .keys import OwnKeys, finish_typing
from .menu_bar import fill_menu_bar, letter_menus, menu_bar_rows
from .messages import MessageBar
from .panel_rows import panel_rows
from .physics import physics_rows
from .rows import Speed, edit_rows, teach_rows, time_rows, view_rows
from .status_bar import StatusBar
from .tabbing import go_on
from .tabs import Tabs
from .toolbar import Toolbar

if TYPE_CHECKING:
    from ..studio import Studio

SIZE = QSize(1440, 900)
MESSAGE_WIDTH = 620


class MainWindow(QMainWindow):
    """The window.

    Attributes:
        canvas: The live picture of the world.
        docks: The docks by the ids of their panels.
        files: Opens and saves projects.
        messages: Tells the user what happened.

    Signals:
        closed: The user is done.
    """

    closed = Signal()

    def __init__(self, studio: Studio, *, at_once: bool = True) -> None:
        """Build the window.

        Args:
            at_once: Otherwise only its frame: whoever asks for it calls `build_more` until it is whole.
        """
        super().__init__()
        self.studio = studio
        self.setObjectName("studio")
        studio.theme.dress(self)
        self.setDockOptions(
            QMainWindow.DockOption.AllowNestedDocks
            | QMainWindow.DockOption.AllowTabbedDocks
            | QMainWindow.DockOption.AnimatedDocks
        )
        self.setCorner(Qt.Corner.BottomLeftCorner, Qt.DockWidgetArea.LeftDockWidgetArea)
        self.setCorner(Qt.Corner.BottomRightCorner, Qt.DockWidgetArea.RightDockWidgetArea)
        self.speed = Speed()
        self.files = Files(studio, self)
        self.experiments = Experiments(studio, self)
        self.files.what_ends = self.experiments.what_ends
        self._may_close = self._docks_shown = False
        self.docks: dict[str, Dock] = {}
        self._parts = self._building()
        while at_once and self.build_more():
            pass

    def build_more(self) -> bool:
        """Build the next part; whether there is another. All of it takes longer than another window could wait."""
        return next(self._parts, self) is not self

    def _building(self) -> Iterator[None]:
        self._add_actions()
        yield
        self._add_pages()
        yield
        yield from self._place_docks()
        self._add_bars()
        yield
        self._add_menus()
        yield
        self._standard = self.saveState(len(DOCKS))
        self._connect()
        self._opened()
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setFocus()  # rather than a field, which would take keys that are shortcuts
        OwnKeys(self)

    def _add_actions(self) -> None:
        studio = self.studio
        self.palette_search = Palette(studio, self, self._catalog)
        studio.actions.add(
            (
                *self.files.rows(),
                *import_rows(self, self.files.background),
                *export_rows(self),
                *self.files.leaving_rows(),
                *edit_rows(),
                *view_rows(),
                *teach_rows(),
                *time_rows(self.speed),
                *physics_rows(),
                *self.experiments.rows(),
            )
        )
        studio.actions.add((*preference_rows(self), *palette_rows(self.palette_search)))

    def _add_pages(self) -> None:
        studio = self.studio
        self.canvas = WorldCanvas(studio)
        self.welcome = WelcomePage(studio)
        self.welcome.chosen.connect(self.files.open)
        self.busy = BusyPage(self.files)
        self._pages = QStackedWidget()
        self._pages.addWidget(self.welcome)
        self._pages.addWidget(self.busy)
        self._pages.addWidget(self.canvas)
        self.setCentralWidget(self._pages)
        # Without room for a frame: none is around a window all over the screen.
        self.resize(SIZE.boundedTo(self.screen().availableSize()))
        frame_views(self.canvas, studio.theme)

    def _add_bars(self) -> None:
        studio = self.studio
        self.toolbar = Toolbar(studio, self.speed)
        self.toolbar.insertWidget(self.toolbar.before_arm, AskControl(studio))
        self.addToolBar(self.toolbar)
        status = StatusBar(studio)
        self.setStatusBar(status)
        library = self.docks["library"].widget()
        assert isinstance(library, LibraryPanel)
        status.tell_of(library.fits)
        self.messages = MessageBar(studio, self._pages)
        self._pages.installEventFilter(self)
        self.guide = Guide(self, self._pages)

    def _add_menus(self) -> None:
        studio = self.studio
        studio.actions.add((*guide_rows(self.guide), *help_rows(self), *menu_bar_rows(self.menuBar())))
        self._build_menus()
        self.search_field = SearchField(studio)
        self.menuBar().setCornerWidget(self.search_field)
        self.search_field.show()  # the bar alone would leave it hidden

    def _place_docks(self) -> Iterator[None]:
        for dock in place_docks(self, self.studio):
            if dock is not None:
                self.docks[dock.row.id] = dock
                frame_views(dock.widget(), self.studio.theme)
            yield
        self._tabs = Tabs(self)
        for dock in self.docks.values():
            for signal in (dock.topLevelChanged, dock.dockLocationChanged, dock.visibilityChanged):
                signal.connect(self._fold_titles)
            dock.topLevelChanged.connect(partial(self._settle, dock))
            OwnKeys(dock)  # where it floats, it is a window by itself
        self.studio.actions.add(panel_rows(self))

    def _connect(self) -> None:
        studio = self.studio
        studio.opened.connect(self._opened)
        studio.document.history_changed.connect(self._titled)
        studio.show_panel.connect(self.show_panel)
        self.destroyed.connect(studio.actions.clear)
        studio.world_wanted.connect(self.come_to_front)
        self.files.waiting.connect(self._waiting)
        self._pages.currentChanged.connect(self._lift)

    # ----------------------------------------------------------------------------------------- docks, menus

    def show_panel(self, panel: str) -> None:
        """Bring a panel to the front."""
        dock = self.docks[panel]
        dock.show()
        dock.raise_()
        if dock.isFloating():
            dock.activateWindow()
        dock.widget().setFocus(Qt.FocusReason.ShortcutFocusReason)

    def hide_panel(self, panel: str) -> None:
        """Put a panel away; keys that went to it go to the window, not to the next field, which would take shortcuts."""
        dock = self.docks[panel]
        had_keys = has_keys(dock)
        dock.hide()
        if had_keys:
            self.setFocus()

    def _catalog(self) -> Catalog:
        """All that the command palette finds now."""
        settings = [
            Entry("setting", text, about, do=partial(open_preferences, self.studio, self, name))
            for name, text, about in SETTINGS
        ]
        recent = [
            Entry("project", folder.name, str(folder), do=partial(self.files.open, folder))
            for folder in self.studio.settings.recent
        ]
        return catalog_of(self.studio, settings, recent)

    def come_to_front(self) -> None:
        """Show the world, whatever window is in front of it."""
        self.raise_()
        self.activateWindow()

    def standard_layout(self) -> None:
        """Put all docks back where they stood at first."""
        self._put_back(self._standard)
        for dock in self.docks.values():
            dock.setVisible(self.studio.is_open)
        share_places(self, self.docks)
        self._size_docks_soon()

    def _put_back(self, state: QByteArray) -> bool:
        """Let docks stand as they stood, unless there were other ones then: a new one would be nowhere.

        Tabs go first, since Qt leaves the old ones beside the new ones otherwise.
        """
        for dock in self.docks.values():
            self.removeDockWidget(dock)
        return self.restoreState(state, len(DOCKS))

    def _size_docks_soon(self) -> None:
        """Docks that have just been shown take sizes only once they have been laid out."""
        QTimer.singleShot(0, self, lambda: size_docks(self, self.docks))

    def _fold_titles(self) -> None:
        """Titles only where no tab says the same."""
        self._tabs.watch()
        for dock in self.docks.values():
            dock.fold_title(folded=not dock.isFloating() and bool(self.tabifiedDockWidgets(dock)))

    def _settle(self, dock: Dock, floating: bool) -> None:  # noqa: FBT001 - as Qt calls it
        """Lay all docks out anew once one that floated is back: Qt leaves it where it floated if its place is the same.

        It stands in front of the tabs there: whoever puts a panel back looks at it.
        """

        def lay_out() -> None:
            dock.raise_()
            self.setContentsMargins(0, 0, 1, 1)
            QTimer.singleShot(0, self, lambda: self.setContentsMargins(0, 0, 0, 0))

        if not floating:
            QTimer.singleShot(0, self, lay_out)

    def _build_menus(self) -> None:
        bar, actions = self.menuBar(), self.studio.actions
        fill_menu_bar(bar, actions)
        self.recent = RecentMenu(self.files, bar)
        letter_menus(bar, actions)
        self.studio.settings.changed.connect(self._setting_changed)
        for action_id in self.studio.actions.rows:
            self.addAction(self.studio.actions[action_id])  # shortcuts of actions in no menu work as well

    def _setting_changed(self, name: str) -> None:
        if name == "keys":
            letter_menus(self.menuBar(), self.studio.actions)

    # ------------------------------------------------------------------------------------------ the project

    def _waiting(self, text: str) -> None:
        standard = self.canvas if self.studio.is_open else self.welcome
        self._pages.setCurrentWidget(self.busy if text else standard)
        if text:
            self.busy.cancel.setFocus()

    def _lift(self) -> None:
        """What lies on the pages stays above the one that is shown now."""
        for above in (self.guide, self.messages):
            above.raise_()

    def _opened(self) -> None:
        is_open = self.studio.is_open
        self._pages.setCurrentWidget(self.canvas if is_open else self.welcome)
        if is_open:
            self._restore()
        else:
            self._keep_docks()
            for dock in self.docks.values():
                dock.hide()
        # After the docks, since what was kept of them may say that the tool bar was hidden.
        self.toolbar.setVisible(is_open)
        self.statusBar().setVisible(is_open)
        self._titled()

    def _titled(self) -> None:
        document = self.studio.document
        name = document.project.name
        only = " (read-only)" if document.read_only else ""
        self.setWindowTitle(f"{name}[*]{only} – Understudy" if name else "Understudy")
        self.setWindowModified(self.studio.is_open and not document.is_saved)

    # ------------------------------------------------------------------------------------------- the window

    def take_place(self) -> None:
        """Stand where the window stood last; at first, at a size that the screen has room for, or all over it."""
        kept = self.studio.settings.bytes_of("geometry")
        room = self.screen().availableSize()
        if not kept.isEmpty() and self.restoreGeometry(kept):
            return
        if SIZE.width() >= room.width() or SIZE.height() >= room.height():
            self.setWindowState(Qt.WindowState.WindowMaximized)

    def _restore(self) -> None:
        if self._docks_shown:
            return  # they stand where the user has put them since
        self._docks_shown = True
        state = self.studio.settings.bytes_of("state")
        if state.isEmpty() or not self._put_back(state):
            self.standard_layout()

    def _keep_docks(self) -> None:
        """Remember where the docks stand, if they are there at all."""
        if self._docks_shown:
            self.studio.settings.keep("state", self.saveState(len(DOCKS)))
        self._docks_shown = False

    def focusNextPrevChild(self, forward: bool) -> bool:  # noqa: FBT001 - as Qt calls it
        """Tab goes on to the next control in sight."""
        return go_on(self, forward=forward)

    def showEvent(self, event: QShowEvent) -> None:
        """Docks get their first sizes once they are on the screen."""
        super().showEvent(event)
        if self.studio.settings.bytes_of("state").isEmpty():
            self._size_docks_soon()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Close once nothing can be lost by it."""
        finish_typing()
        if not self._may_close:
            event.ignore()
            self.files.may_close(self._close)
            return
        settings = self.studio.settings
        settings.keep("geometry", self.saveGeometry())
        self._keep_docks()
        self.studio.shut_down()
        event.accept()
        self.closed.emit()

    def _close(self) -> None:
        self._may_close = True
        QTimer.singleShot(0, self.close)  # Qt ignores a close within a close event

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Keep messages at the top of the canvas, in the middle."""
        if watched is self._pages and event.type() in (QEvent.Type.Resize, QEvent.Type.LayoutRequest):
            self._place_messages()
        return super().eventFilter(watched, event)

    def _place_messages(self) -> None:
        width = min(MESSAGE_WIDTH, self._pages.width() - 32)
        height = max(40, self.messages.heightForWidth(width))
        # Above the legend: the badge at the top, which tells the mode, stays in sight.
        top = max(8, self._pages.height() - height - 60)
        self.messages.setGeometry((self._pages.width() - width) // 2, top, width, height)
