"""The scene of a decision tree: an item for each node that is shown."""

from collections.abc import Collection
from functools import partial

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtWidgets import QGraphicsScene, QGraphicsSceneHelpEvent

from ..theme import Theme
from .node_item import NodeItem
from .shape import ROOT, Key, below, shape
from .subject import Subject


class TreeScene(QGraphicsScene):
    """Shows the tree of a subject.

    Attributes:
        nodes: The items by key.
        chosen: The node that is selected; 0 if none is.
    """

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        self.nodes: dict[Key, NodeItem] = {}
        self.chosen: Key = 0
        self._opened: set[Key] = set()
        self._closed: set[Key] = set()
        self._lit: frozenset[Key] = frozenset()
        self._subject: Subject | None = None

    def forget_opened(self) -> None:
        """Another state is shown: its first levels only."""
        self._opened.clear()
        self._closed.clear()
        self.chosen = 0

    def build(self, subject: Subject | None) -> None:
        """Show the tree of a state; what was open and selected stays so, as far as it is there."""
        self.clear()
        self.nodes = {}
        self._subject = subject
        if subject is None or subject.tree is None:
            return
        knots = shape(subject.tree, self._opened, self._closed)
        for key, knot in knots.items():
            parent = knots[key // 2].at if key != ROOT else None
            item = NodeItem(knot, partial(subject.words, knot), self._theme, parent)
            self.addItem(item)
            self.nodes[key] = item
        self.choose(self.chosen if self.chosen in self.nodes else 0)

    def toggle(self, key: Key) -> None:
        """Show what is below a node, or hide it."""
        if self._subject is None or self._subject.tree is None:
            return
        if 2 * key in self.nodes:
            self._opened = {other for other in self._opened if not _is_below(other, key)}
            self._closed.add(key)
        else:
            self._closed -= below(self._subject.tree, key)
            self._opened |= below(self._subject.tree, key)
        self.build(self._subject)

    def open_to(self, key: Key) -> None:
        """Show a node that may stand below those that are shown."""
        if self._subject is None or self._subject.tree is None or key in self.nodes:
            return
        above = {key >> up for up in range(1, key.bit_length())}
        self._opened |= above
        self._closed -= above
        self.build(self._subject)

    def choose(self, key: Key) -> None:
        """Select a node; 0 selects none."""
        self.chosen = key
        self._show()

    def light(self, keys: Collection[Key]) -> None:
        """Show where the selected node's decision passes."""
        new = frozenset(keys)
        if new != self._lit:
            self._lit = new
            self._show()

    def is_lit(self, key: Key) -> bool:
        """Whether the selected node's decision passes a node."""
        return key in self._lit

    def _show(self) -> None:
        for key, item in self.nodes.items():
            item.show_as(lit=key in self._lit, chosen=key == self.chosen)

    def node_at(self, at: QPointF) -> NodeItem | None:
        """The node at a place of the scene."""
        for item in self.items(at):
            if isinstance(item, NodeItem):
                here = item.mapFromScene(at)
                if item.box.contains(here) or item.expander().contains(here):
                    return item
        return None

    def helpEvent(self, event: QGraphicsSceneHelpEvent) -> None:
        """What is under the mouse says what it is."""
        item = self.node_at(event.scenePos())
        if item is not None:
            item.setToolTip(item.words.tip)
        super().helpEvent(event)

    def contents(self) -> QRectF:
        """The box around all nodes."""
        if not self.nodes:
            return QRectF()
        xs, ys = zip(*(item.knot.at for item in self.nodes.values()), strict=True)
        corner = QPointF(min(xs), min(ys))
        return (
            NodeItem.box.adjusted(-8, -8, 8, 16)
            .translated(corner)
            .united(NodeItem.box.adjusted(-8, -8, 8, 16).translated(QPointF(max(xs), max(ys))))
        )


def _is_below(key: Key, other: Key) -> bool:
    """Whether *key* is *other* or stands below it."""
    up = key.bit_length() - other.bit_length()
    return up >= 0 and key >> up == other
