"""The user's hand on the canvas: carries out what gestures ask for, on the selection, the camera, and the engine."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, Signal

from ...engine.commands import MoveEntities
from ...engine.snapshots import Snapshot
from .frame import Frame, Preview
from .gestures import Button, Carrying, Choosing, Gesture, Held, Pointer, Resting
from .hits import agents_in, controller_at, entity_at, taken_at

if TYPE_CHECKING:
    from ..studio import Studio
    from .looking import Looking


@dataclass(frozen=True, slots=True)
class Choice:
    """Somebody waits for an entity to be chosen.

    Attributes:
        prompt: What the user is asked.
        accept: Whether an entity can be chosen.
        targets: The entities that are marked as such.
    """

    prompt: str
    accept: Callable[[int], bool]
    targets: Callable[[], frozenset[int]]


class Hand(QObject):
    """What is pressed, pulled open, dragged or chosen at the moment. It is a `Stage`.

    Attributes:
        gesture: The state that the mouse is in.
        band: Left, top, right and bottom of the rectangle that is being pulled open.
        dragged: What is being dragged, or was just let go, and where to.
        choice: What is being asked for.

    Signals:
        changed: One of them is another.
        chosen: An entity was chosen.
        gave_up: Choosing was canceled.
        menu_wanted: At these pixels.
    """

    changed = Signal()
    chosen = Signal(int)
    gave_up = Signal()
    menu_wanted = Signal(float, float)

    def __init__(self, studio: Studio, looking: Looking, frame: Callable[[], Frame | None]) -> None:
        super().__init__()
        self._studio = studio
        self._looking = looking
        self._frame = frame
        self._ticket = 0
        self.is_live = True
        self.gesture: Gesture = Resting()
        self.band: tuple[float, float, float, float] | None = None
        self.dragged: Preview | None = None
        self.choice: Choice | None = None

    # ---------------------------------------------------------------------------------------- the mouse

    def press(self, button: Button, at: Pointer) -> None:
        """A button goes down."""
        self._go(self.gesture.press(self, button, at))

    def move(self, at: Pointer) -> None:
        """The mouse goes elsewhere."""
        self._go(self.gesture.move(self, at))

    def release(self, at: Pointer) -> None:
        """The button goes up."""
        self._go(self.gesture.release(self, at))

    def cancel(self) -> None:
        """Escape."""
        self._go(self.gesture.cancel(self))

    # ----------------------------------------------------------------------------------------- the keys

    @property
    def carried(self) -> Held:
        """The entities that are held by keys."""
        return self.gesture.held if isinstance(self.gesture, Carrying) else ()

    def carry(self, held: Held, dx: float = 0.0, dy: float = 0.0) -> None:
        """Hold entities so many pixels from where they are shown; the world hears of it when they are put down."""
        frame, why = self._frame(), self.cannot_drag()
        if frame is None or self.choice is not None:
            return
        if why:
            self.say(why)
            return
        if held != self.carried:
            self.cancel()
            frame = self._frame() or frame
        x, y = frame.places()
        self.preview(held, Pointer(float(x[held[0]]) + dx, float(y[held[0]]) + dy))
        self._go(Carrying(held))

    def put_down(self) -> None:
        """Leave what is held by keys where it is shown."""
        why = self.cannot_drag()
        if not self.carried:
            return
        if why:
            self.say(why)
            return
        self._move()
        self._go(Resting())

    # ------------------------------------------------------------------------------------ other worlds

    def let_go(self) -> None:
        """The world is another one: nothing of it can be held any more."""
        self.drop_band()
        self.drop_preview()
        self._go(Choosing() if self.choice is not None else Resting())

    def ask(self, choice: Choice) -> None:
        """Ask for an entity."""
        self.choice = choice
        self._go(Choosing())

    def stop_asking(self) -> None:
        """No one waits for an entity any more."""
        self.choice = None
        self._go(Resting())

    def settle(self, snapshot: Snapshot) -> None:
        """What was let go is where the world has it, once the world knows."""
        if self._ticket and snapshot.acknowledged >= self._ticket:
            self._ticket, self.dragged = 0, None

    def _go(self, gesture: Gesture) -> None:
        self.gesture = gesture
        self.changed.emit()

    # --------------------------------------------------------------------------------- what gestures ask for

    def entity_at(self, at: Pointer) -> int:
        """The entity there, -1 if there is none."""
        frame = self._frame()
        return -1 if frame is None else entity_at(frame, at.x, at.y)

    def sought(self) -> frozenset[int]:
        """The entities that are marked as what can be chosen; an agent that stands upon one does not hide it."""
        return frozenset() if self.choice is None else self.choice.targets()

    def marked(self) -> frozenset[int]:
        """The entities around which there is a mark: those that can be chosen, or what keys hold.

        Of several that keys hold, all of which are selected and look like that, only the first.
        """
        return frozenset(self.carried[:1]) or self.sought()

    def cannot_drag(self) -> str:
        """Why nothing can be dragged now; empty if it can."""
        snapshot = self._studio.snapshot
        if not self.is_live:
            return "this is a stored moment: go back to now before you move something"
        if snapshot is None or snapshot.failure:
            return "the world stands still after a failure: reset it before you move something"
        if snapshot.speed != 0.0:
            return "pause before you move something: it can be dragged only while time stands still"
        return ""

    def click(self, at: Pointer) -> None:
        """Select the agent there, or the controller whose link or hull is there; nothing there selects none."""
        frame = self._frame()
        if frame is None:
            return
        entity, selection = self.entity_at(at), self._studio.selection
        node = frame.scene.node(entity) if entity >= 0 else controller_at(frame, at.x, at.y)
        if node and not self._lives(node):
            return
        if not node:
            if not at.adds and entity < 0:
                selection.select_nodes(())
        elif at.adds:
            selection.toggle_node(node)
        else:
            selection.select_nodes((node,))

    def choose(self, at: Pointer) -> bool:
        """Choose what is there, for who has asked; whether it was one of those that can be chosen."""
        frame, choice = self._frame(), self.choice
        if choice is None:
            return True
        entity = -1 if frame is None else entity_at(frame, at.x, at.y, self.sought())
        if entity < 0:
            self.say(f"nothing is at that place; {choice.prompt}")
            return False
        if not choice.accept(entity):
            self.say(f"this cannot be chosen; {choice.prompt}")
            return False
        self.choice = None
        self.chosen.emit(entity)
        return self.choice is None  # who has asked may ask again at once

    def give_up_choosing(self) -> None:
        """Nothing is chosen."""
        self.choice = None
        self.gave_up.emit()

    def menu(self, at: Pointer) -> None:
        """Show what can be done there."""
        self.menu_wanted.emit(at.x, at.y)

    def pan(self, dx: float, dy: float) -> None:
        """Shift the view by pixels."""
        self._looking.pan(dx, dy)

    def show_band(self, first: Pointer, last: Pointer) -> None:
        """Show a rectangle between two corners."""
        self.band = min(first.x, last.x), min(first.y, last.y), max(first.x, last.x), max(first.y, last.y)

    def take_band(self, first: Pointer, last: Pointer) -> None:
        """Select the agents in it; it is not shown any more."""
        self.show_band(first, last)
        frame, band, selection = self._frame(), self.band, self._studio.selection
        self.band = None
        if frame is None or band is None:
            return
        inside = tuple(node for node in agents_in(frame, *band) if self._lives(node))
        adds = first.adds or last.adds
        selection.select_nodes((*selection.nodes, *inside) if adds else inside)

    def drop_band(self) -> None:
        """It is not shown any more."""
        self.band = None

    def selected(self) -> Held:
        """The agents that are shown as selected, the one that panels show first."""
        frame = self._frame()
        if frame is None:
            return ()
        agents = frame.selected().tolist()
        shown = frame.scene.entity(self._studio.selection.node)
        return tuple(sorted(agents, key=lambda agent: agent != shown))

    def held_at(self, at: Pointer) -> Held:
        """What is dragged from there, the one that is taken hold of first; of several that are selected, all."""
        frame, selected = self._frame(), self.selected()
        entity = -1 if frame is None else taken_at(frame, at.x, at.y, selected)
        if entity < 0:
            return ()
        return entity, *(other for other in selected if other != entity and entity in selected)

    def preview(self, held: Held, at: Pointer) -> None:
        """Show the first of them there, and the others as far from it as they are."""
        frame = self._frame()
        if frame is not None:
            x, y = self._looking.camera.to_world(at.x, at.y)
            chosen = np.array(held, np.int64)
            there, across = frame.scene.x[chosen], frame.scene.y[chosen]
            self.dragged = Preview(chosen, there - there[0] + x, across - across[0] + y)
            self._ticket = 0  # it is not what was let go before

    def put(self, held: Held, at: Pointer) -> None:
        """Put them there for good; until the world has them there, they are shown there."""
        self.preview(held, at)
        self._move()

    def _move(self) -> None:
        """Have the world move what is shown elsewhere."""
        dragged = self.dragged
        if dragged is not None:
            places = zip(dragged.x.tolist(), dragged.y.tolist(), strict=True)
            to = dict(zip(dragged.held.tolist(), places, strict=True))
            self._ticket = self._studio.bridge.send(MoveEntities(to))

    def drop_preview(self) -> None:
        """Show them where they are."""
        self.dragged, self._ticket = None, 0

    def say(self, why: str) -> None:
        """Tell the user why something does not happen."""
        self._studio.warn(why)

    def _lives(self, node: str) -> bool:
        """Whether a node is one of the world's own, and not only of a stored moment."""
        snapshot = self._studio.snapshot
        return snapshot is not None and node in snapshot.place.rows
