"""The canvas as a widget that is touched: events of mouse, wheel and keys become gestures, looks and selections."""

from __future__ import annotations

from math import exp2
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, Qt
from PySide6.QtGui import (
    QContextMenuEvent,
    QFocusEvent,
    QKeyEvent,
    QMouseEvent,
    QNativeGestureEvent,
    QSinglePointEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QApplication, QMenu, QWidget

from ...sim.columns import AGENT
from .frame import Frame
from .gestures import Button, Dragging, Panning, Pointer, Resting
from .hand import Hand
from .hits import controller_at, entity_at
from .hovering import Hovering
from .looking import Looking
from .menus import fill_menu
from .overlays import Card

if TYPE_CHECKING:
    from ..studio import Studio

#: Pixels that an arrow key moves the world.
NUDGE = 60.0
#: What part of that an arrow key with Ctrl moves something that is held.
STEP = 0.1
NOTHING_HELD = "select agents, or take a thing by Ctrl and Page Down: then Ctrl and the arrow keys move them"
#: Eighths of a degree that the wheel has to turn to double the scale.
DOUBLES = 360.0
_BUTTONS = {
    Qt.MouseButton.LeftButton: Button.LEFT,
    Qt.MouseButton.MiddleButton: Button.MIDDLE,
    Qt.MouseButton.RightButton: Button.RIGHT,
}
_ARROWS = {
    Qt.Key.Key_Left: (NUDGE, 0.0),
    Qt.Key.Key_Right: (-NUDGE, 0.0),
    Qt.Key.Key_Up: (0.0, NUDGE),
    Qt.Key.Key_Down: (0.0, -NUDGE),
}


class Surface(QWidget):
    """A widget that is touched.

    Attributes:
        looking: Where the camera is, and what is shown.
        hand: What the mouse is doing.
        hovering: What is under the mouse.
    """

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self.looking = Looking(studio.settings)
        self.hand = Hand(studio, self.looking, self.frame)
        self.card = Card(studio, self)
        self.hovering = Hovering(studio, self.card, self.frame)
        self.hovering.changed.connect(self._hovers)
        self.hand.menu_wanted.connect(self.show_menu)
        self._mouse: QPointF | None = None  # where it was last, None if elsewhere
        self._space: bool | None = None  # held; whether the view was moved meanwhile
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    @property
    def is_live(self) -> bool:
        """Whether the world is shown as it is now, rather than a stored moment."""
        return self.hand.is_live

    def frame(self) -> Frame | None:
        """What is to be painted now; None if there is no world."""
        raise NotImplementedError

    def touch(self) -> None:
        """Something that is shown has changed."""
        raise NotImplementedError

    def back_to_now(self) -> None:
        """Show the world as it is now."""
        raise NotImplementedError

    # -------------------------------------------------------------------------------------------- the mouse

    def _pointer(self, event: QSinglePointEvent) -> Pointer:
        both = Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.ControlModifier
        at = event.position()
        return Pointer(at.x(), at.y(), bool(event.modifiers() & both), self._space is not None)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Begin a gesture."""
        button = _BUTTONS.get(event.button())
        if button is not None and self.frame() is not None:
            self.hand.press(button, self._pointer(event))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Go on with the gesture, or look at what is under the mouse."""
        self.hand.move(self._pointer(event))
        if isinstance(self.hand.gesture, Panning) and self._space is not None:
            self._space = True
        self.hover(event.position())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """End the gesture."""
        if event.button() in _BUTTONS:
            self.hand.release(self._pointer(event))
            self.hover(event.position())

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Follow the agent there."""
        frame = self.frame()
        at = event.position()
        node = "" if frame is None else frame.scene.node(entity_at(frame, at.x(), at.y()))
        if event.button() is Qt.MouseButton.LeftButton and node and self.is_live:
            self.follow(node)
        else:
            self.mousePressEvent(event)

    def follow(self, node: str) -> None:
        """Select a node and keep it in the middle."""
        self._studio.selection.select_nodes((node,))
        self.looking.follow(on=True)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Zoom around the mouse."""
        at, turned = event.position(), event.angleDelta().y()
        if turned and self.frame() is not None:
            self.looking.zoom(exp2(turned / DOUBLES), at.x(), at.y())
            self.hover(at)
        event.accept()

    def leaveEvent(self, event: QEvent) -> None:
        """Nothing is under the mouse any more."""
        self.forget_mouse()
        super().leaveEvent(event)

    def forget_mouse(self) -> None:
        """The mouse is not over the world."""
        self._mouse = None
        self.hovering.nothing()

    # ------------------------------------------------------------------------------------------ under the mouse

    def hover(self, at: QPointF | None = None) -> None:
        """Look at what is under the mouse now: it may have moved, or the world."""
        self._mouse = at if at is not None else self._mouse
        if self._mouse is None:
            return
        at = self._mouse
        busy = not isinstance(self.hand.gesture, Resting) and self.hand.choice is None
        if busy or not self.rect().contains(at.toPoint()):
            self.hovering.nothing()
        else:
            self.hovering.look(at.x(), at.y(), is_live=self.is_live, first=self.hand.sought())

    def _hovers(self) -> None:
        self._set_cursor()
        self.touch()

    def _set_cursor(self) -> None:
        shape = Qt.CursorShape.ArrowCursor
        if isinstance(self.hand.gesture, Panning | Dragging):
            shape = Qt.CursorShape.ClosedHandCursor
        elif self._space is not None:
            shape = Qt.CursorShape.OpenHandCursor
        elif self.hand.choice is not None:
            shape = Qt.CursorShape.CrossCursor
        elif self.hovering.entity >= 0 or self.hovering.node:
            shape = Qt.CursorShape.PointingHandCursor
        if self.cursor().shape() is not shape:
            self.setCursor(shape)

    # --------------------------------------------------------------------------------------------- the menu

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """The key for it shows the menu of the selected agent; the mouse has its own way."""
        if event.reason() == QContextMenuEvent.Reason.Keyboard:
            at = self._selected_at()
            self.show_menu(at.x(), at.y())
        event.accept()

    def _selected_at(self) -> QPointF:
        """The pixel of the selected agent, or the middle."""
        frame, node = self.frame(), self._studio.selection.node
        entity = -1 if frame is None or not node else frame.scene.entity(node)
        if frame is None or entity < 0:
            return QPointF(self.width() / 2, self.height() / 2)
        x, y = frame.places()
        return QPointF(x[entity], y[entity])

    def show_menu(self, x: float, y: float) -> QMenu | None:
        """Show what can be done at a pixel."""
        frame = self.frame()
        if frame is None:
            return None
        entity = entity_at(frame, x, y)
        controller = controller_at(frame, x, y) if entity < 0 else ""
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        fill_menu(menu, self._studio, frame, entity, controller)
        menu.popup(self.mapToGlobal(QPoint(int(x), int(y))))
        return menu

    # ------------------------------------------------------------------------------------------------- keys

    def event(self, event: QEvent) -> bool:
        """Space is the canvas's own while it has the focus; a pinch zooms."""
        if (
            event.type() == QEvent.Type.ShortcutOverride
            and isinstance(event, QKeyEvent)
            and event.key() == Qt.Key.Key_Space
            and not event.modifiers()
        ):
            event.accept()
            return True
        zooms = Qt.NativeGestureType.ZoomNativeGesture
        if isinstance(event, QNativeGestureEvent) and event.gestureType() == zooms:
            at = event.position()
            self.looking.zoom(1.0 + event.value(), at.x(), at.y())
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Arrows move the view, Page Up and Down go through the agents, Space held lets any drag move the view.

        With Ctrl, arrows move what is held, or the selected agents, and Page Up and Down take other things; Enter puts them
        down.
        """
        key = event.key()
        if event.modifiers() == Qt.KeyboardModifier.ControlModifier and self._carries(Qt.Key(key)):
            return
        if key == Qt.Key.Key_Space and not event.modifiers():
            if not event.isAutoRepeat() and self._space is None:
                self._space = False
                self._set_cursor()
        elif key in _ARROWS and not event.modifiers():
            self.looking.pan(*_ARROWS[Qt.Key(key)])
        elif key in (Qt.Key.Key_PageUp, Qt.Key.Key_PageDown):
            self._step_through(1 if key == Qt.Key.Key_PageDown else -1)
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter) and self.hand.carried:
            self.hand.put_down()
        elif key == Qt.Key.Key_A and event.modifiers() == Qt.KeyboardModifier.ControlModifier:
            self._select_all()
        else:
            super().keyPressEvent(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """Space that moved nothing plays or pauses, as everywhere."""
        if event.key() != Qt.Key.Key_Space or event.isAutoRepeat() or self._space is None:
            super().keyReleaseEvent(event)
            return
        moved, self._space = self._space, None
        self._set_cursor()
        if not moved:
            self._studio.actions["run.play"].trigger()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Whatever key was held is not known any more."""
        self._space = None
        super().focusOutEvent(event)

    def _carries(self, key: Qt.Key) -> bool:
        """Take or move an entity, if a key together with Ctrl does that; whether it does."""
        if key in _ARROWS:
            dx, dy = _ARROWS[key]
            held = self.hand.carried or self.hand.selected()
            if held:
                self.hand.carry(held, -dx * STEP, -dy * STEP)
            else:
                self.hand.say(NOTHING_HELD)
        elif key in (Qt.Key.Key_PageUp, Qt.Key.Key_PageDown):
            self._take(1 if key == Qt.Key.Key_PageDown else -1)
        else:
            return False
        return True

    def _take(self, way: int) -> None:
        """Hold the thing after or before the one that is held; agents are selected instead."""
        snapshot = self._studio.snapshot
        if snapshot is None:
            return
        spans = snapshot.place.spans
        things = [entity for kind, span in spans.items() if kind != AGENT for entity in span]
        if things:
            held = next(iter(self.hand.carried), -1)
            at = things.index(held) + way if held in things else (0 if way > 0 else -1)
            self.hand.carry((things[at % len(things)],))

    def _select_all(self) -> None:
        snapshot = self._studio.snapshot
        if snapshot is not None:
            self._studio.selection.select_nodes(snapshot.place.agents)

    def _step_through(self, way: int) -> None:
        """Select the agent after or before the one that is selected."""
        snapshot = self._studio.snapshot
        if snapshot is None or not snapshot.place.agents:
            return
        agents, node = snapshot.place.agents, self._studio.selection.node
        at = agents.index(node) + way if node in agents else (0 if way > 0 else -1)
        self._studio.selection.select_nodes((agents[at % len(agents)],))

    def heed_escape(self) -> None:
        """While there is something to cancel, Escape is for that, wherever the focus is."""
        application = QApplication.instance()
        if application is not None:
            application.removeEventFilter(self)
            if self.hand.gesture.cancelable or not self.is_live:
                application.installEventFilter(self)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Take Escape from all others, unless a menu or a dialog is open."""
        keys = (QEvent.Type.ShortcutOverride, QEvent.Type.KeyPress)
        if event.type() not in keys or not isinstance(event, QKeyEvent) or event.key() != Qt.Key.Key_Escape:
            return False
        if not self.isVisible() or QApplication.activePopupWidget() or QApplication.activeModalWidget():
            return False
        if event.type() == QEvent.Type.KeyPress:
            self.escape()
        event.accept()
        return True

    def escape(self) -> None:
        """Cancel what is going on; if nothing is, go back to now."""
        if self.hand.gesture.cancelable:
            self.hand.cancel()
        else:
            self.back_to_now()
