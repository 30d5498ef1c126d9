"""What the hand does on the graph, each gesture a small state machine: press, move, release, cancel."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot
from typing import Protocol

from .arrangement import Point
from .state_item import Path

#: Pixels of the scene that a pressed state is moved before it is dragged.
THRESHOLD = 4.0


class Board(Protocol):
    """What gestures act on. Points are the scene's."""

    def drag(self, path: Path, by: Point) -> None:
        """Show a state elsewhere."""

    def drop(self, path: Path, by: Point) -> None:
        """Leave it there."""

    def stretch(self, source: Path, to: Point) -> None:
        """Show a transition on its way to the pointer."""

    def link(self, source: Path, to: Point) -> None:
        """Draw a transition to what is under the pointer, if that is a state."""

    def settle(self) -> None:
        """Show everything as the project has it."""


@dataclass(frozen=True, slots=True)
class Idle:
    """Nothing is going on."""

    board: Board

    def move(self, _at: Point) -> Gesture:
        """Nothing happens."""
        return self

    def release(self, _at: Point) -> Gesture:
        """Nothing happens."""
        return self

    def cancel(self) -> Gesture:
        """Nothing happens."""
        return self


@dataclass(frozen=True, slots=True)
class Pressed:
    """A state is held, and may be dragged."""

    board: Board
    path: Path
    start: Point

    def move(self, at: Point) -> Gesture:
        """Drag it once the pointer is far enough."""
        if hypot(at[0] - self.start[0], at[1] - self.start[1]) < THRESHOLD:
            return self
        return Dragging(self.board, self.path, self.start).move(at)

    def release(self, _at: Point) -> Gesture:
        """It was a click."""
        return Idle(self.board)

    def cancel(self) -> Gesture:
        """Let go of it."""
        return Idle(self.board)


@dataclass(frozen=True, slots=True)
class Dragging:
    """A state follows the pointer."""

    board: Board
    path: Path
    start: Point

    def move(self, at: Point) -> Gesture:
        """Follow the pointer."""
        self.board.drag(self.path, (at[0] - self.start[0], at[1] - self.start[1]))
        return self

    def release(self, at: Point) -> Gesture:
        """Leave it where it is."""
        self.board.drop(self.path, (at[0] - self.start[0], at[1] - self.start[1]))
        return Idle(self.board)

    def cancel(self) -> Gesture:
        """Back to where it was."""
        self.board.settle()
        return Idle(self.board)


@dataclass(frozen=True, slots=True)
class Linking:
    """A transition follows the pointer."""

    board: Board
    source: Path

    def move(self, at: Point) -> Gesture:
        """Follow the pointer."""
        self.board.stretch(self.source, at)
        return self

    def release(self, at: Point) -> Gesture:
        """Let it end where the pointer is."""
        self.board.settle()
        self.board.link(self.source, at)
        return Idle(self.board)

    def cancel(self) -> Gesture:
        """No transition."""
        self.board.settle()
        return Idle(self.board)


Gesture = Idle | Pressed | Dragging | Linking
