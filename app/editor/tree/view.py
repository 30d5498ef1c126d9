"""The decision tree under the hand: mouse and keys."""

from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QContextMenuEvent, QKeyEvent, QMouseEvent, QPalette, QResizeEvent

from ..cut_line import CutLine
from ..diagram.view import DiagramView
from ..theme import Theme
from .scene import TreeScene
from .shape import ROOT, Key

#: Pixels between what is said and the edges, and around its words.
EDGE, AROUND = 8, 4


class TreeView(DiagramView):
    """Shows a scene and tells what the user wants of it.

    Attributes:
        told: Says in its corner whose path is lit.

    Signals:
        chosen: A node was selected, by its key.
        toggled: What is below a node is to be shown or hidden.
        menu_wanted: A context menu, at a place of the screen.
        removed: Prune what is selected.
    """

    chosen = Signal(object)
    toggled = Signal(object)
    menu_wanted = Signal(object)
    removed = Signal()

    def __init__(self, scene: TreeScene, theme: Theme) -> None:
        super().__init__(scene, theme)
        self._tree = scene
        self.setAccessibleName("Decision tree")
        self.told = CutLine()
        self.told.setParent(self)
        self.told.setProperty("role", "caption")
        self.told.setContentsMargins(AROUND, 0, AROUND, 0)
        self.told.setBackgroundRole(QPalette.ColorRole.Window)
        self.told.setAutoFillBackground(True)
        self.told.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.told.hide()

    def tell(self, words: str) -> None:
        """Say whose path is lit, or what is missing for one to be."""
        if words != self.told.text():
            self.told.setText(words)
            self.told.setVisible(bool(words))
            self.setAccessibleDescription(words)
            self._place_told()

    def _place_told(self) -> None:
        wanted, height = self.told.sizeHint().width(), self.told.sizeHint().height()
        seen = self.maximumViewportSize()
        width = min(wanted, seen.width() - 2 * EDGE)
        self.told.setGeometry(EDGE, seen.height() - height - EDGE // 2, width, height)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """What is said stays in its corner."""
        super().resizeEvent(event)
        self._place_told()

    def contents(self) -> QRectF:
        """What there is to see."""
        return self._tree.contents()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Select a node, open one, or pan."""
        at = self.mapToScene(event.position().toPoint())
        item = self._tree.node_at(at)
        if item is None:
            if event.button() is not Qt.MouseButton.RightButton:
                self.begin_pan(event)
        elif item.expander().contains(item.mapFromScene(at)):
            self.toggled.emit(item.knot.key)
        else:
            self.chosen.emit(item.knot.key)
        event.accept()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Pan."""
        if not self.go_on_panning(event):
            super().mouseMoveEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Stop panning."""
        self.end_pan()
        event.accept()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Show or hide what is below a node."""
        item = self._tree.node_at(self.mapToScene(event.position().toPoint()))
        if item is not None:
            self.toggled.emit(item.knot.key)
        event.accept()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Offer what can be done here."""
        self.menu_wanted.emit(event.globalPos())
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Walk from node to node, open and close, prune."""
        chosen = self._tree.chosen
        steps: dict[int, Key] = {
            Qt.Key.Key_Up: max(ROOT, chosen // 2),
            Qt.Key.Key_Down: self._best_below(chosen),
            Qt.Key.Key_Left: self._beside(chosen, -1),
            Qt.Key.Key_Right: self._beside(chosen, 1),
        }
        if event.key() in steps:
            self._go(steps[event.key()])
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and chosen:
            self.toggled.emit(chosen)
        elif event.key() == Qt.Key.Key_Delete:
            self.removed.emit()
        else:
            super().keyPressEvent(event)
            return
        event.accept()

    def _go(self, key: Key) -> None:
        if key in self._tree.nodes:
            self.chosen.emit(key)
            item = self._tree.nodes[key]
            self.show_item(item.mapRectToScene(item.box))

    def _best_below(self, key: Key) -> Key:
        """The child that more examples reach; the root where nothing is selected."""
        children = [child for child in (2 * key, 2 * key + 1) if child in self._tree.nodes and key]
        sizes = {child: sum(self._tree.nodes[child].knot.node.counts) for child in children}
        return max(sizes, key=lambda child: sizes[child]) if sizes else key or ROOT

    def _beside(self, key: Key, way: int) -> Key:
        """The next node to the left or right on the same level."""
        if key not in self._tree.nodes:
            return ROOT
        x, y = self._tree.nodes[key].knot.at
        level = [(k, item.knot.at[0]) for k, item in self._tree.nodes.items() if item.knot.at[1] == y]
        ahead = [(abs(at - x), k) for k, at in level if (at - x) * way > 0]
        return min(ahead)[1] if ahead else key
