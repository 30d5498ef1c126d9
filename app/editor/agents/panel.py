"""The agents and their controllers, as a tree."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QItemSelectionModel, Qt
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QMenu,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ...core.hierarchy import Hierarchy, Node, problems
from ...core.project import Arm, Value
from ...core.remembered import Remembered
from ...engine.commands import Reset
from ...engine.snapshots import Doing
from ..forms.nothing import NothingFound
from ..forms.parts import Complaint, caption
from ..searching import words_in
from ..soon import Later, Soon
from .delegate import NodeDelegate
from .forest_hand import ForestHand, forest_of
from .forest_model import ForestModel, filtered, is_found
from .rows import agent_rows
from .tree import AgentTree

if TYPE_CHECKING:
    from ..studio import Studio

#: Milliseconds between two looks at what the nodes do now.
LIVE = 100
#: Pixels below which names and facts have no room.
NARROWEST = 210
#: Actions of the context menu; an empty one is a line.
MENU = ("node.rename", "node.group", "node.dissolve", "node.remove", "", "arm.settings")
NOTHING_FOUND = "No agent or controller is called so."
HELD = "The world keeps the forest and parameters it began with until Reset."


class AgentsPanel(QWidget):
    """The agents and their controllers, as a tree.

    Attributes:
        filter: What a node's name, id or type has to contain.
        model, tree: The nodes.
        hand: Changes the forest.
        held: Says that the world is of before an edit; `reset` begins it again.
    """

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self._shown: tuple[object, ...] = ()
        self._differs: Remembered[str, bool] = Remembered()  # by the arm that is shown
        self._doing: Doing | None = None
        self._selecting = False
        self._parameters_before = self._parameters(studio.arm)
        self.hand = ForestHand(studio, self)
        self.model = ForestModel(self._drop, self.hand.rename, self.hand.why_not)
        self.tree = AgentTree()
        self.delegate = NodeDelegate(studio, self.tree)
        self.filter = QLineEdit()
        self.trouble = Complaint(studio.theme)
        self.empty = QLabel("There is no arm yet. Arms and worlds (Ctrl+Shift+I) makes the first.")
        self.held = QFrame()
        self.reset = QPushButton("Reset")
        self._live = Later(self, self._show_doing, LIVE)
        self._soon = Soon(self, self.follow)
        # Apart from following, as laying out many rows takes a while.
        self._reselect = Soon(self, self._show_selected)
        studio.actions.add(agent_rows(self))
        self._lay_out()
        NothingFound(self.tree, NOTHING_FOUND, lambda: bool(self.filter.text()))
        self._connect()
        self.follow()

    def _lay_out(self) -> None:
        self.tree.setModel(self.model)
        self.tree.setItemDelegate(self.delegate)
        self.filter.setPlaceholderText("Find agents")
        self.filter.setClearButtonEnabled(True)
        self.filter.setAccessibleName("Find agents and controllers")
        self.filter.setToolTip("Names, ids and types; Enter selects all that are found")
        settings, add = QToolButton(), QToolButton()
        for button, action in ((add, "node.add"), (settings, "arm.settings")):
            button.setDefaultAction(self._studio.actions[action])
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonIconOnly)
            button.setProperty("flat", "true")
            button.setAccessibleName(self._studio.actions.rows[action].text)
        self.empty.setProperty("role", "empty")
        self.empty.setWordWrap(True)
        self.empty.setContentsMargins(10, 4, 10, 8)
        words = caption(HELD)
        self.reset.setToolTip("Begin the world again, with the arm as it is now (Ctrl+R)")
        bar = QHBoxLayout(self.held)
        bar.setContentsMargins(10, 6, 8, 6)
        bar.addWidget(words, 1)
        bar.addWidget(self.reset)
        self.trouble.setContentsMargins(10, 4, 10, 6)
        top = QHBoxLayout()
        top.setContentsMargins(8, 4, 6, 6)
        top.setSpacing(4)
        top.addWidget(self.filter, 1)
        top.addWidget(add)
        top.addWidget(settings)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addLayout(top)
        for part in (self.empty, self.tree, self.trouble, self.held):
            column.addWidget(part, 1 if part is self.tree else 0)
        self.setMinimumWidth(NARROWEST)
        self.setFocusProxy(self.tree)

    def _connect(self) -> None:
        studio = self._studio
        studio.opened.connect(self.filter.clear)  # what was looked for elsewhere may be nowhere here
        studio.opened.connect(self.follow)
        studio.document.project_changed.connect(self._soon.ask)
        studio.bridge.place_changed.connect(lambda _: self._began())
        studio.changed.connect(self._soon.ask)
        studio.bridge.snapshot_changed.connect(self._snapshot_changed)
        studio.selection.nodes_changed.connect(self._show_selected)
        studio.colors.changed.connect(self.tree.viewport().update)
        studio.theme.changed.connect(self.tree.viewport().update)
        self.filter.textChanged.connect(self.follow)
        self.filter.returnPressed.connect(self._select_found)
        self.reset.clicked.connect(lambda: studio.bridge.send(Reset()))
        self.tree.asked.connect(self._asked)
        self.tree.menu_wanted.connect(lambda spot: self.menu().popup(spot))
        self.tree.selectionModel().selectionChanged.connect(self._selection_changed)

    # ----------------------------------------------------------------------------------------- following

    def follow(self) -> None:
        """Show the arm's forest as it is now."""
        arm = self._studio.arm
        types = self._studio.document.project.types
        self.empty.setVisible(self._studio.is_open and arm is None)
        self._show_held(arm)
        text = self.filter.text()
        shown = (None if arm is None else arm.hierarchy, types, text)
        if len(self._shown) == len(shown) and all(
            a is b or a == b for a, b in zip(shown, self._shown, strict=True)
        ):
            return
        self._shown = shown
        forest, trouble = forest_of(arm)
        if not trouble and arm is not None:
            found = problems(forest, {node_type.name: node_type for node_type in types})
            self.delegate.troubled = frozenset(node for node, _ in found)
            trouble = f"{found[0][0]}: {found[0][1]}".removeprefix(": ") if found else ""
            trouble += f" (and {len(found) - 1} more)" if len(found) > 1 else ""
        self.trouble.say(trouble)
        self._show(filtered(forest, text), unfold=bool(text))

    def _show(self, forest: Hierarchy, *, unfold: bool) -> None:
        """Show a forest; what was unfolded stays so."""
        unfolded = [node.id for node in self.model.forest.walk() if node.children and self._is_unfolded(node)]
        self._selecting = True
        self.delegate.forget()
        self.model.show(forest)
        self._selecting = False
        if unfold:
            unfolded = [node.id for node in forest.walk() if node.children][:200]
        for node_id in unfolded:
            self.tree.setExpanded(self.model.find(node_id), True)
        self._reselect.ask()

    def _is_unfolded(self, node: Node) -> bool:
        return self.tree.isExpanded(self.model.find(node.id))

    def _show_held(self, arm: Arm | None) -> None:
        """Say so if the world is of before an edit."""
        snapshot = self._studio.snapshot
        if snapshot is None or arm is None:
            self.held.hide()
            return
        before = snapshot.place.hierarchy
        self._differs.keep({arm.name})
        changed = self._differs.of(  # ten thousand nodes take a while to compare
            arm.name, (arm.hierarchy, before), lambda: forest_of(arm)[0] != before
        )
        self.held.setVisible(changed or self._parameters(arm) != self._parameters_before)

    def _parameters(self, arm: Arm | None) -> Mapping[str, Value]:
        if arm is None or not self._has_world(arm):
            return {}
        return self._studio.document.project.parameters_of(arm)

    def _began(self) -> None:
        """Remember what the world began with."""
        self._parameters_before = self._parameters(self._studio.arm)
        self._soon.ask()

    def _has_world(self, arm: Arm) -> bool:
        return not arm.world or arm.world in self._studio.document.project.worlds

    def _snapshot_changed(self, _snapshot: object) -> None:
        if self.isVisible():
            self._live.ask()

    def _show_doing(self) -> None:
        """Paint again what nodes do, if that has changed."""
        snapshot = self._studio.snapshot
        if snapshot is not None and snapshot.doing is not self._doing and self.isVisible():
            self._doing = snapshot.doing
            self.tree.viewport().update()

    def showEvent(self, event: QShowEvent) -> None:
        """Catch up with what happened meanwhile."""
        super().showEvent(event)
        self._live.ask()

    # ----------------------------------------------------------------------------------------- selecting

    def _show_selected(self) -> None:
        if self._selecting:
            return
        chosen = self.model.spans(self._studio.selection.nodes)
        self._selecting = True
        self.tree.selectionModel().select(chosen, QItemSelectionModel.SelectionFlag.ClearAndSelect)
        last = self.model.find(self._studio.selection.node)
        if last.isValid():
            self.tree.scrollTo(last)
            self.tree.selectionModel().setCurrentIndex(last, QItemSelectionModel.SelectionFlag.NoUpdate)
        self._selecting = False

    def _selection_changed(self, *_: object) -> None:
        if not self._selecting:
            self._selecting = True
            self._studio.selection.select_nodes(self.selected_ids)
            self._selecting = False

    @property
    def selected(self) -> tuple[Node, ...]:
        """The nodes that are selected in the tree; the current one last."""
        current = self.model.node(self.tree.currentIndex())
        nodes = self.model.nodes(self.tree.selectionModel().selection())
        return tuple(sorted(nodes, key=lambda node: node is current))

    @property
    def selected_ids(self) -> tuple[str, ...]:
        """Their ids."""
        return tuple(node.id for node in self.selected)

    def _select_found(self) -> None:
        """Enter in the filter selects what it found."""
        words = words_in(self.filter.text())
        if words:
            found = [node.id for node in self.model.forest.walk() if is_found(node, words)]
            self._studio.selection.select_nodes(found)
            self.tree.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def _drop(self, nodes: Sequence[str], under: str, to: int | None) -> bool:
        known = not self.filter.text()  # places among what is hidden are unknown
        return self.hand.move(nodes, under, to if known else None)

    def rename(self) -> None:
        """Let the user type a name for the current node."""
        self._studio.show_panel.emit("agents")
        self.tree.edit(self.tree.currentIndex())

    # --------------------------------------------------------------------------------------------- menus

    def menu(self) -> QMenu:
        """The context menu."""
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.addAction(self._studio.actions["node.add"])
        for action in MENU:
            if action:
                menu.addAction(self._studio.actions[action])
            else:
                menu.addSeparator()
        return menu

    def _asked(self, action: str) -> None:
        self.follow()  # two keys may come before the tree has followed the first
        self._studio.actions.refresh()
        self._studio.actions[action].trigger()
