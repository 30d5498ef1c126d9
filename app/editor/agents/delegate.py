"""How a node looks in the tree: its name, and on the right what it does now."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRect, QSize, Qt
from PySide6.QtGui import QColor, QFontMetrics, QPainter
from PySide6.QtWidgets import (
    QLineEdit,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTreeView,
    QWidget,
)

from ...core.hierarchy import Node
from ...engine.snapshots import BehaviorRef
from ..theme import CAPTION, chosen_ground, hovered_ground, text_font
from .forest_model import NODE

if TYPE_CHECKING:
    from ..studio import Studio

Index = QModelIndex | QPersistentModelIndex
HEIGHT, SWATCH, GAP = 25, 8, 8


class NodeDelegate(QStyledItemDelegate):
    """Paints nodes; what they do is looked up while painting, so only for those that can be seen."""

    def __init__(self, studio: Studio, view: QTreeView) -> None:
        super().__init__(view)
        self._studio = studio
        self._view = view
        self.troubled: frozenset[str] = frozenset()
        self._sizes: dict[str, str] = {}

    def forget(self) -> None:
        """The forest is another one."""
        self._sizes = {}

    def sizeHint(self, _option: QStyleOptionViewItem, _index: Index) -> QSize:
        """All rows are of one height."""
        return QSize(120, HEIGHT)

    def doing(self, node_id: str) -> BehaviorRef | None:
        """What a node does now; None if it idles or is in no world yet."""
        snapshot = self._studio.snapshot
        if snapshot is None or node_id not in snapshot.doing.rows:
            return None
        shown = int(snapshot.doing.shown[snapshot.doing.row(node_id)])
        return snapshot.doing.behaviors[shown] if shown >= 0 else None

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        """One node."""
        node: Node = index.data(NODE)
        colors = self._studio.theme.palette
        selected = bool(option.state & QStyle.StateFlag.State_Selected)
        hovered = bool(option.state & QStyle.StateFlag.State_MouseOver)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        rect = option.rect
        if selected or hovered:
            whole = QRect(0, rect.top(), self._view.viewport().width(), rect.height())
            painter.fillRect(whole, chosen_ground(colors) if selected else hovered_ground(colors))
            left = QRect(0, rect.top(), rect.left(), rect.height())
            self._view.drawBranches(painter, left, index)  # the arrow that unfolds lies under what was filled
        metrics = QFontMetrics(text_font())
        wanted = metrics.horizontalAdvance(str(index.data()))
        right = self._paint_doing(painter, rect, node, rect.width() - wanted - 3 * GAP - SWATCH)
        painter.setFont(text_font())
        painter.setPen(QColor(colors.teach if node.id in self.troubled else colors.text))
        name = metrics.elidedText(str(index.data()), Qt.TextElideMode.ElideRight, right - rect.left() - GAP)
        painter.drawText(rect.adjusted(4, 0, 0, 0), Qt.AlignmentFlag.AlignVCenter, name)
        if node.children:
            self._paint_size(painter, rect, node, wanted, right)
        painter.restore()

    def _paint_doing(self, painter: QPainter, rect: QRect, node: Node, room: int) -> int:
        """What it does, at the right, in the *room* that the name leaves; gives the place where that begins."""
        doing, edge = self.doing(node.id), rect.right() - GAP
        if doing is None:
            return edge
        painter.setFont(text_font(CAPTION))
        words = painter.fontMetrics().elidedText(doing.name, Qt.TextElideMode.ElideRight, max(0, room))
        width = painter.fontMetrics().horizontalAdvance(words)
        painter.setPen(self._studio.theme.color("dim"))
        painter.drawText(
            rect.adjusted(0, 0, -GAP, 0), Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignRight, words
        )
        left = edge - width - SWATCH - 6
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(
            self._studio.colors.color(doing.type, doing.id)
            if doing.id
            else self._studio.colors.of_name(doing.name)
        )
        painter.drawRoundedRect(QRect(left, rect.center().y() - SWATCH // 2 + 1, SWATCH, SWATCH), 2, 2)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        return left

    def _paint_size(self, painter: QPainter, rect: QRect, node: Node, name: int, right: int) -> None:
        """How many agents a controller has, if there is room."""
        painter.setFont(text_font(CAPTION))
        words = self._size_words(node)
        left = rect.left() + 4 + name + GAP
        if left + painter.fontMetrics().horizontalAdvance(words) < right - 4:
            painter.setPen(self._studio.theme.color("dim"))
            painter.drawText(
                QRect(left, rect.top(), right - left, rect.height()), Qt.AlignmentFlag.AlignVCenter, words
            )

    def _size_words(self, node: Node) -> str:
        if node.id not in self._sizes:  # counting ten thousand agents at every look would take too long
            count = sum(1 for _ in node.agents())
            agents = f"{count} agent{'s' * (count != 1)}"
            self._sizes[node.id] = f"level {node.level} · {agents}" if node.level > 1 else agents
        return self._sizes[node.id]

    def createEditor(self, parent: QWidget, _option: QStyleOptionViewItem, index: Index) -> QWidget:
        """A field for the name."""
        editor = QLineEdit(parent)
        editor.setAccessibleName("Name of the node")
        editor.setPlaceholderText(str(index.data()))
        return editor
