"""What the user does to an arm's forest: adding, removing, grouping and moving the nodes that are selected."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QMenu

from ...core.edits import add_node, dissolve_node, group_nodes, move_nodes, remove_node, rename_node
from ...core.errors import HierarchyError
from ...core.hierarchy import Hierarchy, Node
from ...core.project import Arm
from ..letters import plain
from .forest_model import apart
from .moving import Move, moved

if TYPE_CHECKING:
    from ..studio import Studio
    from .panel import AgentsPanel

#: Why nodes stay where they are.
_NO_WAY = {
    Move.UP: "what is selected stands first already, or not all under the same controller",
    Move.DOWN: "what is selected stands last already, or not all under the same controller",
    Move.OUT: "what is selected stands under no controller, or not all under the same one",
    Move.IN: "there is no controller right above what is selected, or it stands not all under the same one",
}


class ForestHand:
    """Changes the forest of the arm that is shown."""

    def __init__(self, studio: Studio, panel: AgentsPanel) -> None:
        self._studio = studio
        self._panel = panel

    @property
    def arm(self) -> str:
        """The name of the arm that is shown; empty if there is none."""
        arm = self._studio.arm
        return "" if arm is None else arm.name

    def why_not(self, nodes: Iterable[str], under: str) -> str:
        """Why nodes may not stand under a controller, by their types; empty if they may."""
        if not under:
            return ""
        model = self._panel.model
        controller = model.node(model.find(under))
        types = {t.name: t.subsidiaries for t in self._studio.document.project.types}
        kinds = {node.type for n in nodes if (node := model.node(model.find(n))) is not None}
        if controller is None or kinds <= set(types.get(controller.type, ())):
            return ""
        wrong = sorted(kinds - set(types.get(controller.type, ())))
        allowed = ", ".join(types.get(controller.type, ())) or "none"
        return f"{wrong[0]!r} may not stand under {controller.type!r}; allowed: {allowed}"

    def move(self, nodes: Sequence[str], under: str, to: int | None) -> bool:
        """Put nodes under a controller, or among the roots if that is empty; whether that was possible."""
        if problem := self.why_not(nodes, under):
            self._studio.warn(problem)
            return False
        return bool(self._studio.document.attempt(move_nodes, self.arm, nodes, under, to))

    def rename(self, node: str, name: str) -> bool:
        """Give a node another name; whether that was possible."""
        return bool(self._studio.document.attempt(rename_node, self.arm, node, name))

    def remove(self) -> None:
        """Remove the selected nodes, with all below them."""
        for node in apart(self._panel.selected):
            self._studio.document.attempt(remove_node, self.arm, node.id)

    def add(self) -> None:
        """Add a node under the selected controller, beside a selected agent, or among the roots."""
        selected = self._panel.selected
        parent = self._controller_of(selected[-1]) if selected else None
        types = self._studio.document.project.types
        names = [t.name for t in types]
        if parent is not None:
            names = list(next((t.subsidiaries for t in types if t.name == parent.type), ()))
        self._offer(names, lambda name: self._add_of(name, parent.id if parent is not None else ""))

    def _controller_of(self, node: Node) -> Node | None:
        model = self._panel.model
        return node if node.children else model.node(model.find(node.id).parent())

    def _add_of(self, type_name: str, under: str) -> None:
        self._select_made(self._studio.document.attempt(add_node, self.arm, type_name, under))

    def group(self) -> None:
        """Put the selected nodes under a new controller."""
        nodes = apart(self._panel.selected)
        wanted = {node.type for node in nodes}
        types = self._studio.document.project.types
        fitting = [t.name for t in types if t.level and wanted <= set(t.subsidiaries)]
        if not nodes:
            self._studio.warn("select the agents or controllers that are to be a group")
        elif not fitting:
            self._studio.warn(
                f"no node type may control {' and '.join(sorted(wanted))}; add one in Arms and worlds, Node types"
            )
        else:
            ids = [node.id for node in nodes]
            self._offer(fitting, lambda name: self._group_as(ids, name))

    def _group_as(self, nodes: Sequence[str], type_name: str) -> None:
        self._select_made(self._studio.document.attempt(group_nodes, self.arm, nodes, type_name))

    def dissolve(self) -> None:
        """Put the subsidiaries of the selected controllers in their own place."""
        controllers = [node for node in apart(self._panel.selected) if node.children]
        if not controllers:
            self._studio.warn("select the controller of the group that is to be dissolved")
        for node in controllers:
            self._studio.document.attempt(dissolve_node, self.arm, node.id)

    def shift(self, way: Move) -> None:
        """Move the selected nodes up, down, out of their controller, or into the one before them."""
        ids = [node.id for node in apart(self._panel.selected)]
        plan = moved(forest_of(self._studio.arm)[0], ids, way)
        if plan is not None:
            self.move(ids, *plan)
        else:
            self._studio.say(_NO_WAY[way])

    def _select_made(self, made: object) -> None:
        if isinstance(made, str):
            self._panel.follow()
            self._studio.selection.select_nodes([made])

    def _offer(self, names: Sequence[str], do: Callable[[str], None]) -> None:
        """Do it with the only type there is, or let the user choose one."""
        if len(names) == 1:
            do(names[0])
            return
        menu = QMenu(self._panel)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        for name in names:
            menu.addAction(plain(name)).triggered.connect(lambda _=False, name=name: do(name))
        menu.popup(self._panel.tree.viewport().mapToGlobal(QPoint(24, 24)))


def forest_of(arm: Arm | None) -> tuple[Hierarchy, str]:
    """An arm's forest, and why it has none."""
    if arm is None:
        return Hierarchy(()), ""
    try:
        return arm.forest(), ""
    except HierarchyError as error:
        return Hierarchy(()), str(error)
