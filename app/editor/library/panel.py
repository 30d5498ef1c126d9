"""The behaviors, by type and kind."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QItemSelectionModel, QModelIndex, QObject, QPoint, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QLineEdit, QMenu, QToolButton, QVBoxLayout, QWidget

from ...core.edits import duplicate_automaton, rename_automaton
from ..forms.nothing import NothingFound
from ..selection import BehaviorKey
from ..soon import Soon
from .delegate import CONFLICTS, STALE, USES, BehaviorDelegate
from .deleting import delete_behavior
from .filtering import KnownWords, LibraryFilter
from .fits import Fits
from .menus import context_menu, uses_menu
from .model import LibraryModel
from .rows import library_rows
from .survey import Group, Kind, Row, RowKey, Surveyor, Use
from .tree import LibraryTree

if TYPE_CHECKING:
    from ..studio import Studio

#: Pixels below which names and facts have no room.
NARROWEST = 210
NOTHING_FOUND = "No behavior here has these words in its name, features or states."


class LibraryPanel(QWidget):
    """The behaviors, by type and kind.

    Attributes:
        filter: Words that a behavior has to have.
        tree: The behaviors.
        model, shown: All of them, and those that the filter leaves.
        fits: How well what was learned of them fits.
    """

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self._surveyor = Surveyor()
        self.fits = Fits(studio.document.freshness, self)
        self._arm = ""
        self._kept_in_sight: RowKey | None = None
        self.model = LibraryModel(self.fits, self._renamed)
        self.shown = LibraryFilter(self.model, KnownWords(studio.document))
        self.tree = LibraryTree()
        self.delegate = BehaviorDelegate(studio, self.tree)
        self.filter = QLineEdit()
        self.empty = QLabel("No behaviors have been made yet.\nNew automaton (Ctrl+Shift+N) makes the first.")
        self._selecting = False
        self._soon = Soon(self, self.follow)
        studio.actions.add(library_rows(self))
        self._lay_out()
        NothingFound(self.tree, NOTHING_FOUND, lambda: bool(self.shown.words))
        self._connect()
        self.follow()

    def _lay_out(self) -> None:
        self.tree.setModel(self.shown)
        self.tree.setItemDelegate(self.delegate)
        self.filter.setPlaceholderText("Filter behaviors")
        self.filter.setClearButtonEnabled(True)
        self.filter.setAccessibleName("Filter behaviors")
        self.filter.setToolTip(
            "Names, features and states; feature:box or state:goto look only there (Ctrl+L)"
        )
        self.new = QToolButton()
        self.new.setDefaultAction(self._studio.actions["behavior.new"])
        self.new.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonIconOnly)
        self.new.setProperty("flat", "true")
        self.new.setAccessibleName("New automaton")
        self.empty.setProperty("role", "empty")
        self.empty.setWordWrap(True)
        self.empty.setContentsMargins(10, 4, 10, 8)
        top = QHBoxLayout()
        top.setContentsMargins(8, 4, 6, 6)
        top.setSpacing(4)
        top.addWidget(self.filter, 1)
        top.addWidget(self.new)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addLayout(top)
        column.addWidget(self.empty)
        column.addWidget(self.tree, 1)
        self.setMinimumWidth(NARROWEST)
        self.setFocusProxy(self.tree)

    def _connect(self) -> None:
        studio = self._studio
        studio.opened.connect(self._opened)
        studio.document.project_changed.connect(self._soon.ask)
        studio.bridge.place_changed.connect(self._soon.ask)
        studio.changed.connect(self._arm_changed)
        studio.selection.behavior_changed.connect(self._show_selected)
        studio.colors.changed.connect(self.tree.viewport().update)
        studio.theme.changed.connect(self.tree.viewport().update)
        studio.closing.connect(self.fits.close)
        self.filter.textChanged.connect(self._filtered)
        self.filter.returnPressed.connect(self._enter_tree)
        self.filter.installEventFilter(self)
        self.tree.asked.connect(self._asked)
        self.tree.released.connect(lambda: self._current_changed(self.tree.currentIndex()))
        self.tree.dragged.connect(self._show_selected)
        self.tree.menu_wanted.connect(self._show_menu)
        self.tree.activated.connect(self._activated)
        self.tree.clicked.connect(self._fold_or_unfold)
        self.tree.selectionModel().currentChanged.connect(self._current_changed)
        self.delegate.linked.connect(self._show_links)

    # ----------------------------------------------------------------------------------------- following

    def _opened(self) -> None:
        self._arm = ""
        self.filter.clear()  # what was looked for in another project may be nowhere in this one
        self.follow()

    def _arm_changed(self) -> None:
        arm = self._studio.arm
        if (arm.name if arm is not None else "") != self._arm:
            self._soon.ask()

    def follow(self) -> None:
        """Show the project as it is now."""
        studio = self._studio
        project, arm = studio.document.project, studio.arm
        groups = self._surveyor.survey(project, studio.document.types, arm)
        before = {(g.type, g.kind) for g in self._groups()}
        self._selecting = True
        self.model.follow(groups)
        self._selecting = False
        name = arm.name if arm is not None else ""
        self._fold(set() if name != self._arm else before)
        self._arm = name
        taught = any(row.is_automaton for row in self.model.rows)
        self.empty.setVisible(studio.is_open and not taught)
        if studio.is_open:
            self.fits.follow(project, studio.document.scenario.vocabulary)
        if self.filter.text():
            self._filtered()
        self._show_selected()
        self._keep_in_sight()

    def _keep_in_sight(self) -> None:
        """What was just named otherwise, or made, may not be what the filter looks for; it is not hidden all the same."""
        key, self._kept_in_sight = self._kept_in_sight, None
        if key is not None and not self.shown.mapFromSource(self.model.find(key)).isValid():
            self.filter.clear()

    def _groups(self) -> Iterator[Group]:
        for at in range(self.model.rowCount()):
            group = self.model.group(self.model.index(at, 0))
            if group is not None:
                yield group

    def _fold(self, known: set[tuple[str, Kind]]) -> None:
        """Unfold what the arm is about, except for the groups that are *known* already: these are the user's."""
        for at in range(self.model.rowCount()):
            index = self.model.index(at, 0)
            group = self.model.group(index)
            if group is not None and (group.type, group.kind) not in known:
                unfolded = group.current and group.kind is not Kind.DERIVED
                self.tree.setExpanded(self.shown.mapFromSource(index), unfolded)

    # ---------------------------------------------------------------------------------------- selecting

    def _show_selected(self) -> None:
        behavior = self._studio.selection.behavior
        if behavior is None:
            return
        index = self.shown.mapFromSource(self.model.find(RowKey(behavior.type, behavior.id)))
        if index.isValid() and index != self.tree.currentIndex():
            self._make_current(index)

    def _make_current(self, index: QModelIndex) -> None:
        self.tree.setExpanded(index.parent(), True)
        flags = QItemSelectionModel.SelectionFlag.ClearAndSelect
        self.tree.selectionModel().setCurrentIndex(index, flags)
        self.tree.scrollTo(index)

    def _current_changed(self, index: QModelIndex) -> None:
        row = self._row(index)
        if row is None or not row.is_automaton or self._selecting or self.tree.pressing:
            return
        key = BehaviorKey(row.key.type, row.key.id)
        if key != self._studio.selection.behavior:  # otherwise the state that is shown stays
            self._studio.selection.select_behavior(key)

    def _row(self, index: QModelIndex) -> Row | None:
        return self.model.row(self.shown.mapToSource(index))

    def jump(self, use: Use) -> None:
        """Show a behavior that uses another, or that is used."""
        key = use.key
        if key is None:
            self._studio.show_panel.emit("agents")
            return
        self.filter.clear()
        if key.id:
            state = {"state": use.state} if use.state else {}
            self._studio.selection.select_behavior(BehaviorKey(key.type, key.id), **state)
        index = self.shown.mapFromSource(self.model.find(key))
        if index.isValid():
            self._make_current(index)

    # ----------------------------------------------------------------------------------------- changing

    def rename(self) -> None:
        """Let the user type another name in place."""
        self._studio.show_panel.emit("library")
        self._show_selected()
        self.tree.edit(self.tree.currentIndex())

    def _renamed(self, key: RowKey, name: str) -> bool:
        self._kept_in_sight = key
        return bool(self._studio.document.attempt(rename_automaton, key.type, key.id, name))

    def duplicate(self) -> None:
        """Copy the behavior that is shown, and show the copy."""
        behavior = self._studio.selection.behavior
        if behavior is None:
            return
        made = self._studio.document.attempt(duplicate_automaton, behavior.type, behavior.id)
        if made:
            self._kept_in_sight = RowKey(behavior.type, str(made))
            self._studio.selection.select_behavior(BehaviorKey(behavior.type, str(made)))

    def delete(self) -> None:
        """Delete the behavior that is shown; the one beside it is shown then."""
        behavior = self._studio.selection.behavior
        if behavior is not None:
            delete_behavior(self._studio, self, self.neighbor(behavior))

    def neighbor(self, behavior: BehaviorKey) -> BehaviorKey | None:
        """The behavior below another one in the list, or else the one above it."""
        index = self.shown.mapFromSource(self.model.find(RowKey(behavior.type, behavior.id)))
        for row in (self._row(index.siblingAtRow(index.row() + step)) for step in (1, -1)):
            if row is not None and row.is_automaton:
                return BehaviorKey(row.key.type, row.key.id)
        return None

    def _asked(self, action: str) -> None:
        row = self._row(self.tree.currentIndex())
        if row is None:
            index = self.tree.currentIndex()
            if action == "behavior.open":
                self.tree.setExpanded(index, not self.tree.isExpanded(index))
        elif row.is_automaton:
            self._current_changed(self.tree.currentIndex())  # what the cursor is on is what is meant
            self._studio.actions[action].trigger()

    def _fold_or_unfold(self, index: QModelIndex) -> None:
        if self._row(index) is None:
            self.tree.setExpanded(index, not self.tree.isExpanded(index))

    def _activated(self, index: QModelIndex) -> None:
        row = self._row(index)
        if row is not None and row.is_automaton:
            self._studio.actions["behavior.open"].trigger()

    # ------------------------------------------------------------------------------------------- menus

    def _show_menu(self, spot: QPoint) -> None:
        self.menu(self._row(self.tree.currentIndex())).popup(spot)

    def menu(self, row: Row | None) -> QMenu:
        """The context menu of a behavior."""
        return context_menu(self, self._studio, row, self.jump)

    def _show_links(self, row: Row, part: str, spot: QPoint) -> None:
        if part == STALE:
            self._studio.actions["behavior.learn"].trigger()
            return
        if part == CONFLICTS:
            self._studio.selection.select_behavior(BehaviorKey(row.key.type, row.key.id))
            self._studio.actions["examples.conflicts"].trigger()
            return
        uses_menu(self, row.uses if part == USES else row.used_by, self.jump).popup(spot)

    # ------------------------------------------------------------------------------------------- filter

    def focus_filter(self) -> None:
        """Let the user type into the filter."""
        self._studio.show_panel.emit("library")
        self.filter.setFocus()
        self.filter.selectAll()

    def _filtered(self) -> None:
        """Typing looks for something and chooses nothing: what is shown elsewhere stays."""
        was_filtered = bool(self.shown.words)
        self._selecting = True
        self.shown.use(self.filter.text())
        self._selecting = False
        if self.shown.words:
            self.tree.expandAll()
            self._show_found()
        elif was_filtered:
            self._fold(set())
            self._show_selected()

    def _show_found(self) -> None:
        """From the top, unless the behavior that is shown is among what was found."""
        behavior = self._studio.selection.behavior
        key = None if behavior is None else RowKey(behavior.type, behavior.id)
        if key is None or not self.shown.mapFromSource(self.model.find(key)).isValid():
            self.tree.selectionModel().clear()
            self.tree.scrollToTop()
        else:
            self._show_selected()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """The down arrow goes from the filter to what was found, as Enter does."""
        down = QEvent.Type.KeyPress, Qt.Key.Key_Down
        if watched is self.filter and isinstance(event, QKeyEvent) and (event.type(), event.key()) == down:
            self._enter_tree()
            return True
        return super().eventFilter(watched, event)

    def _enter_tree(self) -> None:
        """Enter in the filter goes to the first behavior that is called so, or else to the first that is left."""
        nearest = self.shown.nearest()
        if nearest is not None:
            self._make_current(nearest)
            self.tree.setFocus(Qt.FocusReason.ShortcutFocusReason)
