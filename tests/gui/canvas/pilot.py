"""A user's mouse and keys on the canvas: each act as Qt would deliver it."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QImage, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.editor.canvas.frame import Frame
from app.editor.canvas.view import WorldCanvas
from app.editor.studio import Studio
from app.editor.window.main_window import MainWindow
from app.engine.commands import Command, Step
from app.engine.snapshots import Snapshot
from tests.gui.conftest import PATIENCE

LEFT, MIDDLE, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton, Qt.MouseButton.RightButton
NONE, SHIFT = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier
CONTROL = Qt.KeyboardModifier.ControlModifier


class Pilot:
    """Looks at the canvas of a window and uses it."""

    def __init__(self, window: MainWindow, qtbot: QtBot) -> None:
        self.window = window
        self.qtbot = qtbot
        self.said: list[str] = []
        self.studio.said.connect(lambda message: self.said.append(message.text))

    # ------------------------------------------------------------------------------------------------ eyes

    @property
    def studio(self) -> Studio:
        """What the window shows."""
        return self.window.studio

    @property
    def canvas(self) -> WorldCanvas:
        """The canvas."""
        return self.window.canvas

    @property
    def snapshot(self) -> Snapshot:
        """The newest."""
        assert self.studio.snapshot is not None
        return self.studio.snapshot

    @property
    def frame(self) -> Frame:
        """What is painted."""
        frame = self.canvas.frame()
        assert frame is not None
        return frame

    @property
    def selected(self) -> list[str]:
        """The nodes that are selected."""
        return list(self.studio.selection.nodes)

    def is_live(self) -> bool:
        """Whether the world is shown as it is now."""
        return self.canvas.is_live

    def has_band(self) -> bool:
        """Whether a rectangle is being pulled open."""
        return self.canvas.hand.band is not None

    def is_lit(self) -> bool:
        """Whether the legend lights some up."""
        return self.frame.lit is not None

    def picture(self) -> QImage:
        """What is to be seen once all that has changed is shown."""
        self.wait(lambda: not self.canvas.is_pending)
        return self.canvas.grab().toImage()

    def at(self, entity: int) -> QPoint:
        """The pixel of an entity."""
        x, y = self.frame.places()
        return QPoint(round(x[entity]), round(y[entity]))

    def entity(self, node: str) -> int:
        """The entity of an agent."""
        return self.frame.scene.entity(node)

    def alone(self) -> int:
        """An agent with nothing near it, so that a click can only mean it."""
        x, y = self.frame.places()
        for agent in range(self.frame.scene.agents):
            near = (abs(x - x[agent]) < 30) & (abs(y - y[agent]) < 30)
            if near.sum() == 1 and 60 < x[agent] < self.canvas.width() - 80 and 60 < y[agent] < 440:
                return agent
        raise AssertionError("every agent has neighbors")

    def nowhere(self) -> QPoint:
        """A pixel in the world with nothing near it."""
        x, y = self.frame.places()
        west, south = self.frame.camera.to_view(20.0, 20.0)
        east, north = self.frame.camera.to_view(180.0, 180.0)
        for left in range(round(west), round(east), 20):
            for top in range(round(north), round(south), 20):
                if ((abs(x - left) > 40) | (abs(y - top) > 40)).all():
                    return QPoint(left, top)
        raise AssertionError("there is something everywhere")

    def wait(self, ready: Callable[[], object]) -> None:
        """Wait until something is so."""
        self.qtbot.waitUntil(lambda: bool(ready()), timeout=PATIENCE)

    def send(self, command: Command) -> None:
        """Send a command and wait for its answer; after a step in a world that stands still, until it has passed."""
        before = self.snapshot
        ticket = self.studio.bridge.send(command)
        self.wait(lambda: self.snapshot.acknowledged >= ticket)
        if isinstance(command, Step) and before.speed == 0.0:
            self.wait(lambda: self.snapshot.tick >= before.tick + command.ticks)

    def choose(self, action: str) -> None:
        """Choose an action, once it is possible."""
        self.wait(self.studio.actions[action].isEnabled)
        self.studio.actions[action].trigger()

    def use_arm(self, name: str) -> None:
        """Begin another arm."""
        self.studio.use_arm(name)
        self.wait(lambda: self.snapshot.arm == name and self.frame.scene.place is self.snapshot.place)

    # ------------------------------------------------------------------------------------------------ hands

    def down(self, at: QPoint, button: Qt.MouseButton = LEFT, keys: Qt.KeyboardModifier = NONE) -> Pilot:
        """Press a button."""
        self.qtbot.mousePress(self.canvas, button, keys, at)
        return self

    def move(self, at: QPoint, button: Qt.MouseButton = LEFT, keys: Qt.KeyboardModifier = NONE) -> Pilot:
        """Move with a button held."""
        self._send_move(at, button, keys)
        return self

    def up(self, at: QPoint, button: Qt.MouseButton = LEFT, keys: Qt.KeyboardModifier = NONE) -> Pilot:
        """Let the button go."""
        self.qtbot.mouseRelease(self.canvas, button, keys, at)
        return self

    def click(self, at: QPoint, keys: Qt.KeyboardModifier = NONE) -> None:
        """Click."""
        self.down(at, keys=keys).up(at, keys=keys)

    def drag(
        self,
        start: QPoint,
        end: QPoint,
        button: Qt.MouseButton = LEFT,
        keys: Qt.KeyboardModifier = NONE,
    ) -> None:
        """Press, move in two steps, let go."""
        self.down(start, button, keys).move((start + end) / 2, button, keys).move(end, button, keys)
        self.up(end, button, keys)

    def hover(self, at: QPoint) -> None:
        """Move with no button held."""
        self._send_move(at, Qt.MouseButton.NoButton, NONE)

    def wheel(self, at: QPoint, notches: int) -> None:
        """Turn the wheel, away from the user if positive."""
        event = QWheelEvent(
            QPointF(at),
            QPointF(self.canvas.mapToGlobal(at)),
            QPoint(),
            QPoint(0, 120 * notches),
            Qt.MouseButton.NoButton,
            NONE,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QApplication.sendEvent(self.canvas, event)

    def key(self, key: Qt.Key, keys: Qt.KeyboardModifier = NONE) -> None:
        """Press and release a key with the focus on the canvas."""
        self.canvas.setFocus()
        self.qtbot.keyClick(self.canvas, key, keys)

    def _send_move(self, at: QPoint, buttons: Qt.MouseButton, keys: Qt.KeyboardModifier) -> None:
        # QTest moves the mouse with no button held.
        where = QPointF(at), QPointF(self.canvas.mapToGlobal(at))
        event = QMouseEvent(QEvent.Type.MouseMove, *where, Qt.MouseButton.NoButton, buttons, keys)
        QApplication.sendEvent(self.canvas, event)
