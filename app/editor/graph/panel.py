"""The automaton that is shown, as a graph."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, QPointF, Qt, QTimer, Signal
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QMenu, QStackedLayout, QVBoxLayout, QWidget

from ...core.automaton import Content
from ...core.project import Position
from ..selection import BehaviorKey
from ..soon import Later, Soon
from . import offers
from .arrangement import Point
from .badges import Badges
from .drafts import Drafts
from .editing import GraphEditing
from .form_strip import FormStrip
from .hints import Hint, nothing_shown
from .laying_out import LayingOut
from .live import path_of
from .menus import add_menu, context_menu
from .rows import graph_rows
from .scene import GraphScene
from .scoping import Scoping
from .state_item import Path
from .trail import Trail, top_bar
from .view import GraphView

if TYPE_CHECKING:
    from ..studio import Studio

#: Milliseconds between two looks at what the nodes do.
LIVE = 33


class GraphPanel(QWidget):
    """The automaton that is shown, as a graph.

    Attributes:
        root: The automaton that is drawn; automata inside may be open in place.
        scene: Its states and edges.
        view: What they are seen through.
        menu: The context menu that was opened last.

    Signals:
        title_changed: The dock is to be called otherwise.
        refreshed: What is shown is up to date.
    """

    title_changed = Signal(str)
    refreshed = Signal()

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self.studio = studio
        self.scoping = Scoping(studio.document)
        self.root: BehaviorKey | None = None
        self._way: list[BehaviorKey] = []
        self._open: set[Path] = set()
        self.menu: QMenu | None = None
        self._selecting = self._entering = self._reveals = False
        self.laying_out = LayingOut()
        self._drafts = Drafts(studio.document, self.laying_out)
        self.scene = GraphScene(studio.theme, studio.colors)
        self.view = GraphView(self.scene, studio.theme)
        self.editing = GraphEditing(studio, self.scene)
        self.form = FormStrip(studio, self.scoping)
        self.badges = Badges(studio.document, self.scoping, self.scene)
        self._soon = Soon(self, self.refresh)
        self._live = Later(self, self._follow, LIVE)
        studio.actions.add(graph_rows(self))
        self._build()
        self._connect()
        self._behavior_changed()

    def _build(self) -> None:
        self._trail = Trail()
        top = top_bar(self.studio, self._trail)
        self._hint = Hint(self.view)
        self._empty = nothing_shown()
        shown = QWidget()
        column = QVBoxLayout(shown)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        column.addLayout(top)
        column.addWidget(self.view, 1)
        column.addWidget(self._hint)
        column.addWidget(self.form)
        self._pages = QStackedLayout(self)
        self._pages.addWidget(self._empty)
        self._pages.addWidget(shown)
        self.setFocusProxy(self.view)

    def _connect(self) -> None:
        studio = self.studio
        studio.opened.connect(self._opened)
        studio.closing.connect(self._rest)
        studio.document.project_changed.connect(lambda *_: self.touch())
        for changed in (studio.colors.changed, studio.theme.changed):
            changed.connect(self.scene.undress)
            changed.connect(self.touch)
        studio.selection.behavior_changed.connect(self._behavior_changed)
        studio.selection.state_changed.connect(self._chosen_elsewhere)
        studio.selection.nodes_changed.connect(self._live_soon)
        studio.bridge.snapshot_changed.connect(self._live_soon)
        self.laying_out.arranged.connect(self.touch)
        self.laying_out.told.connect(studio.warn)
        self.scene.marked.connect(self._marked)
        self.view.pressed.connect(self._pressed)
        self.view.opened.connect(self.open_state)
        self.view.toggled.connect(self.toggle)
        self.view.back.connect(self.go_back)
        self.view.linked.connect(self.link)
        self.view.edited.connect(self.edit)
        self.view.removed.connect(self.remove)
        self.view.dropped.connect(self._dropped)
        self.view.menu_wanted.connect(self._menu)
        self.form.closed.connect(self.close_form)
        self.view.clipped.connect(self._clip)
        self.editing.held.changed.connect(self._copied)
        self.view.cancelled.connect(self._cancelled)
        self.view.moved.connect(self.move_state)
        self.view.nudged.connect(lambda path, by: self.move_state(path, by, gesture="nudge"))
        self._trail.chosen.connect(self.go_back)

    # ------------------------------------------------------------------------------------------- what is shown

    def touch(self, _what: object = None) -> None:
        """Something that is shown has changed."""
        if self.isVisible():
            self._soon.ask()

    @property
    def is_pending(self) -> bool:
        """Whether something that has changed is not shown yet."""
        return self._soon.is_due

    def refresh(self) -> None:
        """Show everything as it is now."""
        drawn = None if self.root is None else self._drafts.drawn(self.root, self._open)
        if not self.scene.goes_on_as(drawn):
            self.view.forget()
            self.scene.build(drawn)
        self._pages.setCurrentIndex(0 if drawn is None else 1)
        self._hint.say(is_empty=drawn is not None and len(drawn.graph.states) < 2)
        self._show_trail()
        self._state_changed()
        self.badges.show()
        self._show_form()
        self._follow()
        self.view.changed()
        if self._reveals:
            self.view.show_selected()
            self._reveals = not self.scene.is_settled
        self.studio.touch()
        self.refreshed.emit()

    def _show_trail(self) -> None:
        keys = [*self._way, *([self.root] if self.root else [])]
        found = [(key, self.studio.document.automaton(key.type, key.id)) for key in keys]
        way = [(key, automaton.name) for key, automaton in found if automaton is not None]
        self._trail.show_way(way if len(way) > 1 else [])  # one by itself stands in the title
        self.title_changed.emit(f"Automaton · {found[-1][1].name}" if found and found[-1][1] else "Automaton")

    def showEvent(self, event: QShowEvent) -> None:
        """Catch up with what happened meanwhile."""
        super().showEvent(event)
        if self.root is not None:
            self.laying_out.warm_up()
        self._soon.ask()

    def hideEvent(self, event: QHideEvent) -> None:
        """Nobody looks: Graphviz is not needed."""
        super().hideEvent(event)
        self._rest()
        self.studio.touch()

    def _rest(self) -> None:
        self._soon.forget()
        self._live.forget()
        self.laying_out.close()

    def _opened(self) -> None:
        self._drafts.forget()
        self._open.clear()
        self._way.clear()
        self.scene.selected = ()
        self._behavior_changed()

    # ---------------------------------------------------------------------------------------------- selection

    def _behavior_changed(self) -> None:
        key = self.studio.selection.behavior
        if self._selecting or key == self.root:
            return
        if key in self._way:
            del self._way[self._way.index(key) :]
        elif self.root is not None and not self._entering:
            self._way.clear()
        self.root = key
        self._open.clear()
        self.view.is_fitted = True
        self.touch()

    def _state_changed(self) -> None:
        selection = self.studio.selection
        if self._selecting or selection.behavior is None:
            return
        key, shown = selection.behavior, self.scene.deciding
        if shown is not None and self.scene.key_of(shown) == (key, selection.state):
            return
        found = self.scene.find(key.type, key.id, selection.state)
        self.scene.mark([found] if found is not None else [])

    def _chosen_elsewhere(self) -> None:
        """Another state was chosen in another panel: it is brought in sight, once it is drawn."""
        if self._selecting:
            return
        self._state_changed()
        self._reveals = self._soon.is_due or not self.isVisible()
        if not self._reveals:
            self.view.show_selected()

    def _marked(self) -> None:
        """What was selected here is what all panels show."""
        path, selection = self.scene.deciding, self.studio.selection
        if path is None:
            selection.select_goal("")
            self.close_form()
            return
        key, state = self.scene.key_of(path)
        if (key, state) != (selection.behavior, selection.state):
            self._selecting = True
            try:
                selection.select_behavior(key, state)
            finally:
                self._selecting = False
        selection.select_goal(self.scene.edge[2] if self.scene.edge is not None else "")
        self._show_form()
        self.studio.touch()

    def _pressed(self, path: Path) -> None:
        key, state = self.scene.key_of(path)
        if key == self.studio.selection.behavior:
            self.studio.selection.select_state(state)

    # ----------------------------------------------------------------------------------------------- going in

    def open_state(self, path: Path) -> None:
        """Show the automaton that a state holds, with the way back."""
        item = self.scene.states.get(path)
        if item is None or not item.state.nested or self.root is None:
            return
        way = [*self._way, self.root]
        self._entering = True
        try:
            self.studio.selection.select_behavior(BehaviorKey(self.root.type, item.state.nested))
            self._way = way
        finally:
            self._entering = False
        self.refresh()

    def go_back(self, key: BehaviorKey | None = None) -> None:
        """Show again what was shown before, or a certain one on the way here."""
        if self._way:
            self.studio.selection.select_behavior(key or self._way[-1])

    def toggle(self, path: Path | None = None) -> None:
        """Open or close a state in place."""
        path = path or self.scene.current
        if path is None or path not in self.scene.states or not self.scene.states[path].state.nested:
            return
        if path in self._open:
            self._open = {other for other in self._open if other[: len(path)] != path}
        else:
            self._open.add(path)
        self.refresh()

    # ----------------------------------------------------------------------------------------------- editing

    def move_state(self, path: Path, by: Point, gesture: str = "") -> None:
        """Let a state stand elsewhere; the others of its automaton stay where they are from now on."""
        self.view.is_fitted = False  # what was moved stays under the pointer
        self.editing.move_state(path, by, gesture)

    def add_state(self, content: Content, at: Position | None = None) -> None:
        """Add a state, and ask for what it leaves open."""
        level = self.scene.level_for_new if at is None else self.scene.levels.get(())
        if level is not None:
            self._added(self.editing.add_state(level, content, at))

    def _dropped(self, data: bytes, at: QPointF) -> None:
        level, place = self.scene.level_at(at)
        if level is not None:
            self.view.is_fitted = False  # what was dropped stays under the pointer
            self._added(self.editing.dropped(level, data, place))

    def _added(self, path: Path | None) -> None:
        if path is None:
            return
        self._select([path])
        scope = self.scoping.scope(self.scene.levels[path[:-1]].type)
        if scope is not None and offers.slots_of(self.scene.states[path].state.content, scope):
            self.edit()

    def link(self, source: Path, target: Path) -> None:
        """A new rule from a state to a state, to be said when."""
        edge = self.editing.link(source, target)
        if edge is not None:
            self.refresh()
            self.scene.mark((), edge)
            self.edit()

    def _cancelled(self) -> None:
        self._hint.say()
        self.close_form()

    def edit(self) -> None:
        """Open the form of what is selected."""
        if self.scene.current is not None or self.scene.edge is not None:
            self.form.show()
            self.view.has_form = True
            self._hint.hide()
            self._show_form()
            self.form.focus_first()
            QTimer.singleShot(0, self.view.show_selected)  # once the form has taken its room

    def close_form(self, reason: Qt.FocusReason = Qt.FocusReason.OtherFocusReason) -> None:
        """No form."""
        if self.form.isVisible():
            self.form.hide()
            self.view.has_form = False
            self._hint.show()
            self.view.setFocus(reason)

    def _show_form(self) -> None:
        if self.form.isVisibleTo(self) and not self.form.show_selected(self.scene):
            self.close_form()

    def begin_link(self) -> None:
        """From the selected state, choosing another one draws a transition to it."""
        self.view.begin_link()
        self.view.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self._hint.say()

    def remove(self) -> None:
        """Remove what is selected."""
        self.editing.remove(self.scene.selected, self.scene.edge)

    def _copied(self) -> None:
        self.studio.actions.refresh_some(["graph.paste"])

    def _clip(self, what: str) -> None:
        """Do what a key for copying asks for; to paste is to look into the clipboard, whoever has filled it."""
        if what == "paste":
            self.paste()
        else:
            self.studio.actions.do(f"graph.{what}")

    def paste(self) -> None:
        """Put in copies of the states in the clipboard."""
        level = self.scene.level_for_new
        if level is not None:
            self._select(self.editing.paste(level))

    def duplicate(self) -> None:
        """Copy the selected states to beside them."""
        self._select(self.editing.duplicate(self.scene.selected))

    def _select(self, paths: list[Path]) -> None:
        if paths:
            self.refresh()
            self.scene.mark(paths)
            self.view.show_selected()
            self._reveals = not self.scene.is_settled

    def add_state_menu(self) -> None:
        """Offer all that a new state can hold."""
        self.menu = add_menu(self)
        self.menu.popup(self.view.mapToGlobal(self.view.rect().center()))

    def _menu(self, at: QPoint) -> None:
        self.studio.touch()
        place = self.view.mapToScene(self.view.viewport().mapFromGlobal(at)).toTuple()
        self.menu = context_menu(self, place)
        self.menu.popup(at)

    # -------------------------------------------------------------------------------------------------- live

    def _live_soon(self, _snapshot: object = None) -> None:
        if self.isVisible():
            self._live.ask()

    def _follow(self) -> None:
        snapshot = self.studio.snapshot
        self.scene.follow(snapshot, path_of(snapshot, self.studio.selection.node))
