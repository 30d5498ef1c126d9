"""A forest as Qt's tree, made entry by entry as it is looked at, so that ten thousand agents cost nothing unseen."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

from PySide6.QtCore import (
    QAbstractItemModel,
    QItemSelection,
    QItemSelectionRange,
    QMimeData,
    QModelIndex,
    QPersistentModelIndex,
    Qt,
)

from ...core.hierarchy import Hierarchy, Node
from ...core.wording import node_words
from ..row_spans import spans
from ..searching import has_words, words_in

#: Nodes that are dragged: JSON, a list of their ids.
MIME = "application/x-understudy-nodes"
#: The `Node` of an index.
NODE = int(Qt.ItemDataRole.UserRole)
Index = QModelIndex | QPersistentModelIndex
#: Qt asks for these ten thousand times where there are so many agents.
_ANY = (
    Qt.ItemFlag.ItemIsEnabled
    | Qt.ItemFlag.ItemIsSelectable
    | Qt.ItemFlag.ItemIsEditable
    | Qt.ItemFlag.ItemIsDragEnabled
)
_CONTROLLER = _ANY | Qt.ItemFlag.ItemIsDropEnabled
_AGENT = _ANY | Qt.ItemFlag.ItemNeverHasChildren


@dataclass(slots=True)
class _Entry:
    """A node that was looked at: its place, and the numbers of the entries below it once they were needed."""

    node: Node
    parent: int
    row: int
    children: list[int] | None = None
    rows: dict[str, int] = field(default_factory=dict)


class ForestModel(QAbstractItemModel):
    """The nodes of a forest.

    Args:
        move: Puts nodes under a controller, or among the roots if that is empty, at a place or last; whether it could.
        rename: Gives a node another name; whether it could.
        why_not: Why nodes may not stand under a controller; empty if they may.
    """

    def __init__(
        self,
        move: Callable[[Sequence[str], str, int | None], bool],
        rename: Callable[[str, str], bool],
        why_not: Callable[[Sequence[str], str], str],
    ) -> None:
        super().__init__()
        self._move = move
        self._rename = rename
        self._why_not = why_not
        self._entries: list[_Entry] = []
        self._roots: list[int] = []
        self._root_rows: dict[str, int] = {}
        self._parents: dict[str, str] | None = None
        self.forest = Hierarchy(())

    def show(self, forest: Hierarchy) -> None:
        """Show another forest; where only names are others, the tree is not laid out anew."""
        changed: list[int] = []
        if self._matches(self._roots, forest.roots, changed):
            self._rename_in_place(forest, changed)
            return
        self.beginResetModel()
        self.forest = forest
        self._entries, self._parents = [], None
        self._roots, self._root_rows = self._grown(forest.roots, -1)
        self.endResetModel()

    def _matches(self, numbers: Sequence[int], nodes: Sequence[Node], changed: list[int]) -> bool:
        """Whether the same nodes stand in the same places as far as was looked at; collects those that differ at all."""
        if len(numbers) != len(nodes):
            return False
        for number, node in zip(numbers, nodes, strict=True):
            entry = self._entries[number]
            if entry.node is node:
                continue
            if entry.node.id != node.id or len(entry.node.children) != len(node.children):
                return False
            changed.append(number)
            if entry.children is not None and not self._matches(entry.children, node.children, changed):
                return False
        return True

    def _rename_in_place(self, forest: Hierarchy, changed: Sequence[int]) -> None:
        """Show other values of the same nodes, parents first."""
        self.forest, self._parents = forest, None
        for number in changed:
            entry = self._entries[number]
            siblings = forest.roots if entry.parent < 0 else self._entries[entry.parent].node.children
            entry.node = siblings[entry.row]
            index = self._index_of(number)
            self.dataChanged.emit(index, index)

    def _grown(self, nodes: Sequence[Node], parent: int) -> tuple[list[int], dict[str, int]]:
        first = len(self._entries)
        self._entries += [_Entry(node, parent, row) for row, node in enumerate(nodes)]
        return list(range(first, len(self._entries))), {node.id: row for row, node in enumerate(nodes)}

    def _below(self, number: int) -> list[int]:
        """The entries below an entry; of -1, the roots."""
        if number < 0:
            return self._roots
        entry = self._entries[number]
        if entry.children is None:
            entry.children, entry.rows = self._grown(entry.node.children, number)
        return entry.children

    # ------------------------------------------------------------------------------------------ looking

    def find(self, node_id: str) -> QModelIndex:
        """The index of a node; invalid if there is none."""
        number = self._number_of(node_id) if node_id in self._controllers else None
        return QModelIndex() if number is None else self._index_of(number)

    @property
    def _controllers(self) -> dict[str, str]:
        """The controller of each node; none, an empty id, for roots."""
        if self._parents is None:
            self._parents = dict(self.forest.parents())
            self._parents |= {root.id: "" for root in self.forest.roots}
        return self._parents

    def _number_of(self, node_id: str) -> int | None:
        """The entry of a node, -1 for an empty id; None if there is none."""
        way = []
        while node_id:
            way.append(node_id)
            node_id = self._controllers.get(node_id, "")
        number = -1
        for step in reversed(way):
            below, rows = self._below(number), self._rows(number)
            if step not in rows:
                return None
            number = below[rows[step]]
        return number

    def _rows(self, number: int) -> dict[str, int]:
        """The places of those below an entry, which have been looked at, by their ids."""
        return self._root_rows if number < 0 else self._entries[number].rows

    def spans(self, nodes: Iterable[str]) -> QItemSelection:
        """The indexes of nodes, neighbors in one range: selections are slow by the number of ranges."""
        controllers = self._controllers
        together: dict[str, list[str]] = {}
        for node_id in nodes:
            if node_id in controllers:
                together.setdefault(controllers[node_id], []).append(node_id)
        found = QItemSelection()
        for controller, ids in together.items():
            above = self._number_of(controller)
            if above is not None:
                below, rows = self._below(above), self._rows(above)
                for ends in spans(rows[node_id] for node_id in ids):
                    found.append(QItemSelectionRange(*(self._index_of(below[row]) for row in ends)))
        return found

    def nodes(self, selection: QItemSelection) -> Iterator[Node]:
        """The nodes of a selection, which may be ten thousand in one range."""
        for at in range(selection.size()):
            span = selection.at(at)
            parent = span.parent()
            below = self._below(parent.internalId() if parent.isValid() else -1)
            for row in range(span.top(), span.bottom() + 1):
                yield self._entries[below[row]].node

    def _index_of(self, number: int) -> QModelIndex:
        return QModelIndex() if number < 0 else self.createIndex(self._entries[number].row, 0, number)

    def node(self, index: Index) -> Node | None:
        """The node of an index."""
        return self._entries[index.internalId()].node if index.isValid() else None

    # --------------------------------------------------------------------------------------- Qt's model

    def index(self, row: int, column: int, parent: Index = QModelIndex()) -> QModelIndex:  # noqa: B008 - an immutable value
        """An entry by its place."""
        below = self._below(parent.internalId() if parent.isValid() else -1)
        if column or not 0 <= row < len(below):
            return QModelIndex()
        return self.createIndex(row, 0, below[row])

    def parent(self, index: Index) -> QModelIndex:  # type: ignore[override]  # Qt's other parent() is QObject's
        """The controller of a node."""
        above = self._entries[index.internalId()].parent if index.isValid() else -1
        return QModelIndex() if above < 0 else self.createIndex(self._entries[above].row, 0, above)

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - as above
        """How many nodes stand under one."""
        if not parent.isValid():
            return len(self._roots)
        return len(self._entries[parent.internalId()].node.children)

    def hasChildren(self, parent: Index = QModelIndex()) -> bool:  # noqa: B008 - as above
        """Whether somebody stands under a node, without looking at whom."""
        return self.rowCount(parent) > 0

    def columnCount(self, _parent: Index = QModelIndex()) -> int:  # noqa: B008 - as above
        """One: the delegate paints all that there is to say of a node."""
        return 1

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        """A node and its names."""
        node = self.node(index)
        if node is None:
            return None
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return node_words(node)
            case Qt.ItemDataRole.EditRole:
                return node.name
            case Qt.ItemDataRole.ToolTipRole | Qt.ItemDataRole.AccessibleTextRole:
                return facts(node)
        return node if role == NODE else None

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        """Rename a node; an empty name shows its id again."""
        node = self.node(index)
        if node is None or role != Qt.ItemDataRole.EditRole:
            return False
        return str(value).strip() == node.name or self._rename(node.id, str(value).strip())

    def flags(self, index: Index) -> Qt.ItemFlag:
        """Nodes can be renamed and dragged; controllers, and the space below all, take drops."""
        if not index.isValid():
            return Qt.ItemFlag.ItemIsDropEnabled
        return _CONTROLLER if self._entries[index.internalId()].node.children else _AGENT

    # ------------------------------------------------------------------------------------------ dragging

    def mimeTypes(self) -> list[str]:
        """What is dragged."""
        return [MIME]

    def mimeData(self, indexes: Sequence[QModelIndex]) -> QMimeData:
        """The ids of the nodes, without those that come along with a node above them."""
        data = QMimeData()
        nodes = [node for index in indexes if (node := self.node(index)) is not None]
        data.setData(MIME, json.dumps([node.id for node in apart(nodes)]).encode())
        return data

    def supportedDropActions(self) -> Qt.DropAction:
        """Nodes are moved, never copied."""
        return Qt.DropAction.MoveAction

    def canDropMimeData(
        self, data: QMimeData, _action: Qt.DropAction, _row: int, _column: int, parent: Index
    ) -> bool:
        """Nodes can be dropped on controllers that may have them, and beside roots."""
        node = self.node(parent)
        if not data.hasFormat(MIME):
            return False
        return node is None or (bool(node.children) and not self._why_not(_ids(data), node.id))

    def dropMimeData(
        self, data: QMimeData, _action: Qt.DropAction, row: int, _column: int, parent: Index
    ) -> bool:
        """Move the nodes; the edit moves the rows, so the view must not."""
        if not data.hasFormat(MIME):
            return False
        ids = _ids(data)
        under = self.node(parent)
        siblings = self.forest.roots if under is None else under.children
        before = sum(node.id in ids for node in siblings[: max(0, row)])
        self._move(ids, under.id if under else "", None if row < 0 else row - before)
        return False


def _ids(data: QMimeData) -> list[str]:
    return [str(node) for node in json.loads(bytes(data.data(MIME).data()).decode())]


def apart(nodes: Iterable[Node]) -> tuple[Node, ...]:
    """*nodes* without those that stand below another of them."""
    chosen = tuple(nodes)
    below = {inner.id for node in chosen for inner in node.walk() if inner is not node}
    return tuple(node for node in chosen if node.id not in below)


def facts(node: Node) -> str:
    """What a node is, in words."""
    words = [node_words(node), f"{node.type}, id {node.id}"]
    if node.children:
        count = sum(1 for _ in node.agents())
        words.append(f"level {node.level} · {count} agents · {len(node.children)} direct subsidiaries")
    return "\n".join(words)


def filtered(forest: Hierarchy, text: str) -> Hierarchy:
    """The nodes whose name, id and type have all words of *text*, with all below and above them."""
    wanted = words_in(text)
    return Hierarchy(tuple(_kept(forest.roots, wanted))) if wanted else forest


def is_found(node: Node, words: Sequence[str]) -> bool:
    """Whether a node has all of these words in its name, id and type."""
    return has_words(words, node_words(node), node.id, node.type)


def _kept(nodes: Iterable[Node], wanted: Sequence[str]) -> Iterable[Node]:
    for node in nodes:
        if is_found(node, wanted):
            yield node
        elif node.children and (children := tuple(_kept(node.children, wanted))):
            yield Node(node.id, node.type, children, node.name)
