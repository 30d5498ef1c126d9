"""What the hand does on the canvas, as small state machines: press, move, release and cancel each give the next state.

They know nothing of Qt and nothing of worlds: whatever they want done they ask of a `Stage`.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Protocol

#: Pixels that the mouse has to go before a press becomes a drag.
SLACK = 4.0


#: Entities that are moved together.
Held = tuple[int, ...]


class Button(Enum):
    """Of the mouse."""

    LEFT = "left"
    MIDDLE = "middle"
    RIGHT = "right"


@dataclass(frozen=True, slots=True)
class Pointer:
    """The mouse: where it is, and what is held meanwhile.

    Attributes:
        x, y: Pixels of the view.
        adds: Shift or Ctrl: to what is selected already.
        pans: Space: any drag moves the view.
    """

    x: float
    y: float
    adds: bool = False
    pans: bool = False

    def far_from(self, other: Pointer) -> bool:
        """Whether this is a drag."""
        return abs(self.x - other.x) > SLACK or abs(self.y - other.y) > SLACK


class Stage(Protocol):
    """What gestures are carried out on."""

    def held_at(self, at: Pointer) -> Held:
        """What is dragged from there, the one that is taken hold of first; of several that are selected, all."""

    def cannot_drag(self) -> str:
        """Why nothing can be dragged now; empty if it can."""

    def click(self, at: Pointer) -> None:
        """Select what is there."""

    def choose(self, at: Pointer) -> bool:
        """Choose what is there, for who has asked; whether it was one of those that can be chosen."""

    def give_up_choosing(self) -> None:
        """Nothing is chosen."""

    def menu(self, at: Pointer) -> None:
        """Show what can be done there."""

    def pan(self, dx: float, dy: float) -> None:
        """Shift the view by pixels."""

    def show_band(self, first: Pointer, last: Pointer) -> None:
        """Show a rectangle between two corners."""

    def take_band(self, first: Pointer, last: Pointer) -> None:
        """Select what is in it; it is not shown any more."""

    def drop_band(self) -> None:
        """It is not shown any more."""

    def preview(self, held: Held, at: Pointer) -> None:
        """Show the first of them there, and the others as far from it as they are."""

    def put(self, held: Held, at: Pointer) -> None:
        """Put them there for good."""

    def drop_preview(self) -> None:
        """Show them where they are."""

    def say(self, why: str) -> None:
        """Tell the user why something does not happen."""


class Gesture:
    """A state: by itself it does nothing and stays."""

    #: Whether Escape means something to it.
    cancelable = False

    def press(self, _stage: Stage, _button: Button, _at: Pointer) -> Gesture:
        """A button goes down."""
        return self

    def move(self, _stage: Stage, _at: Pointer) -> Gesture:
        """The mouse goes elsewhere."""
        return self

    def release(self, _stage: Stage, _at: Pointer) -> Gesture:
        """The button that began this goes up."""
        return self

    def cancel(self, _stage: Stage) -> Gesture:
        """Escape, or the canvas is no longer what it was."""
        return self


@dataclass(frozen=True, slots=True)
class Resting(Gesture):
    """Nothing is going on."""

    def press(self, stage: Stage, button: Button, at: Pointer) -> Gesture:
        """Begin what the button stands for."""
        if at.pans or button is Button.MIDDLE:
            return Panning(self, at)
        if button is Button.RIGHT:
            return Asking(self, at)
        return Pressed(at, stage.held_at(at))


@dataclass(frozen=True, slots=True)
class Choosing(Gesture):
    """A click chooses an entity for who has asked for one; the view can be moved meanwhile."""

    cancelable = True

    def press(self, stage: Stage, button: Button, at: Pointer) -> Gesture:
        """The left button chooses; the others move the view or ask for a menu."""
        if at.pans or button is Button.MIDDLE:
            return Panning(self, at)
        if button is Button.RIGHT:
            return Asking(self, at)
        return Resting() if stage.choose(at) else self

    def cancel(self, stage: Stage) -> Gesture:
        """Choose nothing."""
        stage.give_up_choosing()
        return Resting()


@dataclass(frozen=True, slots=True)
class Panning(Gesture):
    """The world goes where the mouse goes."""

    then: Gesture
    last: Pointer

    def move(self, stage: Stage, at: Pointer) -> Gesture:
        """The world comes along."""
        stage.pan(at.x - self.last.x, at.y - self.last.y)
        return Panning(self.then, at)

    def release(self, _stage: Stage, _at: Pointer) -> Gesture:
        """Go on with what was going on before."""
        return self.then


@dataclass(frozen=True, slots=True)
class Asking(Gesture):
    """The right button: a menu where it is released, unless it becomes a drag."""

    then: Gesture
    first: Pointer

    def move(self, stage: Stage, at: Pointer) -> Gesture:
        """Far enough, it is a drag that moves the view."""
        return Panning(self.then, self.first).move(stage, at) if at.far_from(self.first) else self

    def release(self, stage: Stage, at: Pointer) -> Gesture:
        """Show the menu."""
        stage.menu(at)
        return self.then


@dataclass(frozen=True, slots=True)
class Pressed(Gesture):
    """The left button is down: a click, unless it becomes a drag."""

    first: Pointer
    held: Held

    def move(self, stage: Stage, at: Pointer) -> Gesture:
        """Far enough, it is a drag: of what was pressed, or of a rectangle."""
        if not at.far_from(self.first):
            return self
        if not self.held:
            return Banding(self.first).move(stage, at)
        why = stage.cannot_drag()
        if why:
            stage.say(why)
            return Refused()
        return Dragging(self.held).move(stage, at)

    def release(self, stage: Stage, _at: Pointer) -> Gesture:
        """A click."""
        stage.click(self.first)
        return Resting()

    def cancel(self, _stage: Stage) -> Gesture:
        """No click."""
        return Resting()


@dataclass(frozen=True, slots=True)
class Refused(Gesture):
    """A drag that is not possible; the user was told."""

    def release(self, _stage: Stage, _at: Pointer) -> Gesture:
        """Ready for the next."""
        return Resting()


@dataclass(frozen=True, slots=True)
class Banding(Gesture):
    """A rectangle is pulled open."""

    first: Pointer
    cancelable = True

    def move(self, stage: Stage, at: Pointer) -> Gesture:
        """The other corner goes along."""
        stage.show_band(self.first, at)
        return self

    def release(self, stage: Stage, at: Pointer) -> Gesture:
        """Select what is inside."""
        stage.take_band(self.first, at)
        return Resting()

    def cancel(self, stage: Stage) -> Gesture:
        """Select nothing else; the button may go up at any time."""
        stage.drop_band()
        return Refused()


@dataclass(frozen=True, slots=True)
class Dragging(Gesture):
    """Entities are held; the world hears of it when they are let go."""

    held: Held
    cancelable = True

    def move(self, stage: Stage, at: Pointer) -> Gesture:
        """They are shown there."""
        stage.preview(self.held, at)
        return self

    def release(self, stage: Stage, at: Pointer) -> Gesture:
        """They stay there."""
        stage.put(self.held, at)
        return Resting()

    def cancel(self, stage: Stage) -> Gesture:
        """They are where they were; the button may go up at any time."""
        stage.drop_preview()
        return Refused()


@dataclass(frozen=True, slots=True)
class Carrying(Gesture):
    """Entities are held by keys, which move them and put them down; the mouse lets go of them."""

    held: Held
    cancelable = True

    def press(self, stage: Stage, button: Button, at: Pointer) -> Gesture:
        """Whoever takes the mouse does something else."""
        return self.cancel(stage).press(stage, button, at)

    def cancel(self, stage: Stage) -> Gesture:
        """They are where they were."""
        stage.drop_preview()
        return Resting()
