"""The graph under the hand: mouse and keys."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QEvent, QPointF, QRect, QRectF, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QContextMenuEvent,
    QDragEnterEvent,
    QDragMoveEvent,
    QDropEvent,
    QKeyEvent,
    QKeySequence,
    QMouseEvent,
    QPainter,
    QPen,
)

from ..diagram.view import DiagramView
from ..theme import Theme
from .arrangement import Point
from .gestures import Gesture, Idle, Linking, Pressed
from .offers import BEHAVIOR_MIME
from .scene import GraphScene
from .state_item import HANDLE, Path, StateItem
from .walking import next_one

WAYS = {
    Qt.Key.Key_Left: (-1.0, 0.0),
    Qt.Key.Key_Right: (1.0, 0.0),
    Qt.Key.Key_Up: (0.0, -1.0),
    Qt.Key.Key_Down: (0.0, 1.0),
}
#: Page down and up go through the transitions of a state.
TURNS = {Qt.Key.Key_PageDown: 1, Qt.Key.Key_PageUp: -1}
#: How far Ctrl and an arrow key move a state.
NUDGE = 10.0


class GraphView(DiagramView):
    """Shows a scene and tells what the user wants of it.

    Attributes:
        has_form: A form is open that Escape closes.

    Signals:
        pressed: A state was pressed, which may be selected already.
        opened: Show the automaton of a state.
        toggled: Open or close a state in place.
        moved: A state was dragged by so much.
        nudged: The same by keys.
        linked: A transition is to lead from a state to a state.
        edited: What was chosen is to be changed: a state's path or an edge.
        menu_wanted: A context menu, at a place of the screen.
        back: Show what was shown before.
        removed: Remove what is selected.
        clipped: "copy", "paste" or "duplicate" what is selected.
        cancelled: The user gave up what was going on.
        dropped: A behavior, as the library drags it, came down at a place of the scene.
    """

    pressed = Signal(object)
    opened = Signal(object)
    toggled = Signal(object)
    moved = Signal(object, object)
    nudged = Signal(object, object)
    linked = Signal(object, object)
    edited = Signal()
    menu_wanted = Signal(object)
    back = Signal()
    removed = Signal()
    dropped = Signal(object, object)
    clipped = Signal(str)
    cancelled = Signal()

    def __init__(self, scene: GraphScene, theme: Theme) -> None:
        super().__init__(scene, theme)
        self._graph = scene
        self._gesture: Gesture = Idle(self)
        self._link: tuple[QPointF, QPointF] | None = None
        self._linking_from: Path | None = None
        self._hovered: StateItem | None = None
        self.has_form = False
        self.setMouseTracking(True)
        self.setAcceptDrops(True)
        self.setAccessibleName("Automaton graph")

    @property
    def is_linking(self) -> bool:
        """Whether what is chosen next is where a transition leads."""
        return self._linking_from is not None

    def contents(self) -> QRectF:
        """What there is to see."""
        return self._graph.contents()

    # ----------------------------------------------------------------------------------- what gestures act on

    def drag(self, path: Path, by: Point) -> None:
        """Show a state elsewhere."""
        self._graph.drag(path, by)

    def drop(self, path: Path, by: Point) -> None:
        """Leave it there."""
        self.moved.emit(path, by)

    def stretch(self, source: Path, to: Point) -> None:
        """Show a transition on its way to the pointer."""
        item = self._graph.states[source]
        self._link = item.mapToScene(item.handle_at()), QPointF(*to)
        self._aim(self._target(source, to))
        self.viewport().update()

    def link(self, source: Path, to: Point) -> None:
        """Draw a transition to what is under the pointer, if that is a state of the same automaton."""
        target = self._target(source, to)
        if target is not None:
            self.linked.emit(source, target.path)

    def settle(self) -> None:
        """Show everything as the project has it."""
        self._link = None
        self._aim(None)
        self._graph.settle()
        self.viewport().update()

    def _target(self, source: Path, to: Point) -> StateItem | None:
        """The state under the pointer in the automaton of *source*: the one that holds what is pointed at."""
        item = self._graph.state_at(QPointF(*to))
        while item is not None and len(item.path) > len(source):
            item = self._graph.states[item.path[:-1]]
        same = item is not None and item.path[:-1] == source[:-1]
        return item if same else None

    def _aim(self, target: StateItem | None) -> None:
        for item in self._graph.states.values():
            if item.look.target is not (item is target):
                item.dress(replace(item.look, target=item is target))

    def show_selected(self) -> None:
        """Pan until what is selected is seen."""
        edge, current = self._graph.edge, self._graph.current
        if edge is not None and edge in self._graph.edges:
            line = self._graph.edges[edge]
            self.show_item(line.mapRectToScene(line.boundingRect()))
        elif current is not None:
            item = self._graph.states[current]
            self.show_item(item.mapRectToScene(item.box))

    def forget(self) -> None:
        """The scene is about to be another one."""
        self._gesture = Idle(self)
        self._hovered, self._link = None, None
        if self._linking_from not in self._graph.states:
            self._linking_from = None

    # ------------------------------------------------------------------------------------------- the mouse

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Select, hold, link or pan."""
        at = self.mapToScene(event.position().toPoint())
        if event.button() is Qt.MouseButton.MiddleButton:
            self.begin_pan(event)
        elif event.button() is Qt.MouseButton.LeftButton:
            self._pressed(event, at)
        elif event.button() is Qt.MouseButton.RightButton:
            self._select_at(at, keep=True)
        event.accept()

    def _pressed(self, event: QMouseEvent, at: QPointF) -> None:
        item = self._graph.state_at(at)
        if item is not None and self._linking_from is not None:
            source, self._linking_from = self._linking_from, None
            self.link(source, at.toTuple())
            self.settle()
        elif item is None:
            self._select_at(at)
            if self._graph.edge is None:
                self.begin_pan(event)
        elif item.expander().contains(item.mapFromScene(at)):
            self.toggled.emit(item.path)
        elif _near(item.mapFromScene(at), item.handle_at()):
            self._gesture = Linking(self, item.path)
        else:
            self._select(item.path, add=bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier))
            self._gesture = Pressed(self, item.path, at.toTuple())

    def _select_at(self, at: QPointF, *, keep: bool = False) -> None:
        item = self._graph.state_at(at)
        if item is not None:
            if not (keep and item.path in self._graph.selected):
                self._select(item.path)
            return
        self._graph.mark((), self._graph.edge_at(at))

    def _select(self, path: Path, *, add: bool = False) -> None:
        before = [other for other in self._graph.selected if other != path] if add else []
        self._graph.mark([*before, path])
        self.pressed.emit(path)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Go on with what is going on; show where transitions are drawn from."""
        if self.go_on_panning(event):
            return
        at = self.mapToScene(event.position().toPoint())
        self._gesture = self._gesture.move(at.toTuple())
        if self._linking_from is not None:
            self.stretch(self._linking_from, at.toTuple())
        if isinstance(self._gesture, Idle):
            self._hover(self._graph.state_at(at))
            super().mouseMoveEvent(event)

    def _hover(self, item: StateItem | None) -> None:
        if item is self._hovered:
            return
        for other, handle in ((self._hovered, False), (item, True)):
            if other is not None:
                other.prepareGeometryChange()
                other.dress(replace(other.look, handle=handle))
        self._hovered = item

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """End what is going on."""
        if not self.end_pan():
            at = self.mapToScene(event.position().toPoint())
            self._gesture = self._gesture.release(at.toTuple())
        event.accept()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Open the automaton of a state; change anything else."""
        at = self.mapToScene(event.position().toPoint())
        item = self._graph.state_at(at)
        self._gesture = Idle(self)
        if item is not None and item.expander().contains(item.mapFromScene(at)):
            self.toggled.emit(item.path)
        elif item is not None and item.state.nested:
            self.opened.emit(item.path)
        elif item is not None or self._graph.edge_at(at) is not None:
            self.edited.emit()
        event.accept()

    def leaveEvent(self, event: QEvent) -> None:
        """No handle is shown where the pointer is not."""
        self._hover(None)
        super().leaveEvent(event)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        """A behavior from the library is welcome."""
        self._welcome(event)

    def dragMoveEvent(self, event: QDragMoveEvent) -> None:
        """The same all over the graph."""
        self._welcome(event)

    def _welcome(self, event: QDropEvent) -> None:
        if event.mimeData().hasFormat(BEHAVIOR_MIME):
            event.setDropAction(Qt.DropAction.CopyAction)
            event.accept()
        else:
            event.ignore()

    def dropEvent(self, event: QDropEvent) -> None:
        """Add a state where it came down."""
        self._welcome(event)
        if event.isAccepted():
            data = bytes(event.mimeData().data(BEHAVIOR_MIME).data())
            self.dropped.emit(data, self.mapToScene(event.position().toPoint()))

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Offer what can be done here; the menu key asks for what is selected."""
        self.menu_wanted.emit(event.globalPos())
        event.accept()

    # --------------------------------------------------------------------------------------------- the keys

    def event(self, event: QEvent) -> bool:
        """Keep Escape while something is going on that it ends."""
        if event.type() is QEvent.Type.ShortcutOverride and self._takes(event):
            event.accept()
            return True
        return super().event(event)

    def _takes(self, event: QEvent) -> bool:
        if not isinstance(event, QKeyEvent):
            return False
        busy = self._linking_from is not None or not isinstance(self._gesture, Idle)
        return event.key() == Qt.Key.Key_Escape and (busy or self.has_form)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Walk from state to state, open, change, remove, link."""
        key = Qt.Key(event.key())
        if key in WAYS:
            self._walk(WAYS[key], event.modifiers())
        elif key in TURNS:
            self._graph.turn(TURNS[key])
            self.show_selected()
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._enter()
        elif key == Qt.Key.Key_Escape:
            self.cancel()
        elif key == Qt.Key.Key_Backspace:
            self.back.emit()
        elif key == Qt.Key.Key_Delete:
            self.removed.emit()
        elif key == Qt.Key.Key_F2:
            self.edited.emit()
        elif self._copying(event):
            pass
        else:
            super().keyPressEvent(event)
            return
        event.accept()

    def _copying(self, event: QKeyEvent) -> bool:
        """Whether it was a key for copying, which is told."""
        keys = (
            (QKeySequence(QKeySequence.StandardKey.Copy), "copy"),
            (QKeySequence(QKeySequence.StandardKey.Paste), "paste"),
            (QKeySequence("Ctrl+D"), "duplicate"),
        )
        pressed = QKeySequence(event.keyCombination())
        for sequence, what in keys:
            if pressed == sequence:
                self.clipped.emit(what)
                return True
        return False

    def cancel(self) -> None:
        """End what is going on, and leave all as it was."""
        self._linking_from = None
        self._gesture = self._gesture.cancel()
        self.settle()
        self.cancelled.emit()

    def begin_link(self) -> None:
        """From now on, choosing a state draws a transition to it, until Escape."""
        self._linking_from = self._graph.current

    def _enter(self) -> None:
        current = self._graph.current
        if self._linking_from is not None and current is not None:
            source, self._linking_from = self._linking_from, None
            if current[:-1] == source[:-1]:
                self.linked.emit(source, current)
            self.settle()
        elif current is not None and self._graph.states[current].state.nested:
            self.opened.emit(current)
        else:
            self.edited.emit()

    def _walk(self, way: Point, keys: Qt.KeyboardModifier) -> None:
        current = self._graph.current
        if keys & Qt.KeyboardModifier.ControlModifier and current is not None:
            self.nudged.emit(current, (way[0] * NUDGE, way[1] * NUDGE))
            return
        found: Path | None = self._end_of_edge(way) or next(iter(self._graph.states), None)
        if current is not None:
            middles = [
                (path, at.toTuple()) for path, at in self._graph.around() if self._walkable(path, current)
            ]
            found = next_one(self._graph.states[current].scenePos().toTuple(), middles, way)
        if found is not None:
            before = self._graph.selected if keys & Qt.KeyboardModifier.ShiftModifier else ()
            self._graph.mark([*(path for path in before if path != found), found])
            item = self._graph.states[found]
            self.show_item(item.mapRectToScene(item.box))
            if self._linking_from is not None:
                self.stretch(self._linking_from, item.scenePos().toTuple())

    def _end_of_edge(self, way: Point) -> Path | None:
        """From a transition, right and down lead to its target, left and up to its source."""
        edge = self._graph.edge
        return None if edge is None else (*edge[0], edge[2] if sum(way) > 0 else edge[1])

    def _walkable(self, path: Path, current: Path) -> bool:
        if self._linking_from is not None:
            return path[:-1] == self._linking_from[:-1]
        return path != current and path != current[: len(path)]

    # ---------------------------------------------------------------------------------------- a link on its way

    def drawForeground(self, painter: QPainter, _rect: QRectF | QRect) -> None:
        """The transition that is being drawn."""
        if self._link is None:
            return
        painter.setPen(QPen(QColor(self._theme.palette.accent), 2.0, Qt.PenStyle.DashLine))
        painter.drawLine(*self._link)


def _near(at: QPointF, handle: QPointF) -> bool:
    return abs(at.x() - handle.x()) <= HANDLE + 5 and abs(at.y() - handle.y()) <= HANDLE + 5
