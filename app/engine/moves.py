"""What the user's hand moved in a world, so that each move can be undone and done again."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from ..core.errors import SessionError, UnderstudyError
from ..sim.engine import Engine
from .keyframes import Hand, Keyframe, Timeline
from .place import Place
from .snapshots import Moved, MovedEntity

#: A place in the world, in its units.
Spot = tuple[float, float]


@dataclass(frozen=True, slots=True)
class _Move:
    """A move of one or several at once.

    Attributes:
        hands: When it was, who was moved, and where to.
        before: Where each of them was.
        undone: Whether it is taken back now.
    """

    hands: tuple[Hand, ...]
    before: tuple[Spot, ...]
    undone: bool = False

    @property
    def tick(self) -> int:
        """When it was."""
        return self.hands[0].tick

    def back(self, tick: int) -> tuple[Hand, ...]:
        """How all of them are put back; things before agents, whom they may take along."""
        there = {hand.entity: spot for hand, spot in zip(self.hands, self.before, strict=True)}
        return tuple(Hand(tick, entity, *there[entity]) for entity in sorted(there, reverse=True))


class Moves:
    """The moves in one world, by number."""

    def __init__(self, first: int) -> None:
        """None yet.

        Args:
            first: The number of the first, above those in all worlds before.
        """
        self.next = first
        self._moves: dict[int, _Move] = {}
        self._exact: dict[
            int, Keyframe
        ] = {}  # the worlds before the moves since the last tick, the latest last

    def passed(self) -> None:
        """Ticks have passed."""
        self._exact.clear()

    def move(self, engine: Engine, place: Place, to: Mapping[int, Spot], timeline: Timeline | None) -> Moved:
        """Put entities somewhere else.

        Raises:
            UnderstudyError: One of them does not exist, or the scenario failed; the world is as it was.
        """
        if not to:
            raise SessionError("a move has to name what is moved")
        number, tick = self.next, engine.tick
        hands = tuple(Hand(tick, entity, *spot) for entity, spot in to.items())
        before, after = self._do(engine, hands, timeline, number)
        self.next += 1
        return Moved(
            tuple(
                MovedEntity(entity, place.kind_of(entity), place.entity_called(entity), there, here)
                for entity, there, here in zip(to, before, after, strict=True)
            ),
            number,
        )

    def undo(self, engine: Engine, number: int, timeline: Timeline | None) -> None:
        """Take a move back: exactly if no tick has passed and nothing was moved since, otherwise the places of the moved.

        Raises:
            SessionError: There is no such move in this world, or it is undone.
            UnderstudyError: The scenario failed; the world is as it was.
        """
        move = self._known(number)
        if move.undone:
            raise SessionError(f"move {number} is undone already")
        if self._exact and next(reversed(self._exact)) == number:
            self._exact.pop(number).restore(engine)
            _take_back(timeline, move.hands)
        elif move.tick > engine.tick:
            _take_back(timeline, move.hands)  # the run was gone back in, so it is still to come
        else:
            _carry_out(engine, move.back(engine.tick), timeline)
            self._exact.clear()
        self._moves[number] = replace(move, undone=True)

    def redo(self, engine: Engine, number: int, timeline: Timeline | None) -> None:
        """Move again what was moved, to where it had been put.

        Raises:
            SessionError: There is no such move in this world, or it is not undone.
            UnderstudyError: The scenario failed; the world is as it was.
        """
        move = self._known(number)
        if not move.undone:
            raise SessionError(f"move {number} is not undone, so it cannot be done again")
        tick = engine.tick
        hands = tuple(Hand(tick, *hand.move) for hand in move.hands)
        self._do(engine, hands, timeline, number)

    def _do(
        self, engine: Engine, hands: tuple[Hand, ...], timeline: Timeline | None, number: int
    ) -> tuple[tuple[Spot, ...], tuple[Spot, ...]]:
        """Move; returns where all were, and where they are."""
        before = _carry_out(engine, hands, timeline)
        spots = _spots(before, hands)
        self._moves[number] = _Move(hands, spots)
        self._exact.pop(number, None)
        self._exact[number] = before
        return spots, _spots(_world(engine), hands)

    def _known(self, number: int) -> _Move:
        if number not in self._moves:
            raise SessionError(f"there is no move {number} in this world; it has begun again since")
        return self._moves[number]


def _carry_out(engine: Engine, hands: tuple[Hand, ...], timeline: Timeline | None) -> Keyframe:
    """Move all or none; returns the world before."""
    before = _world(engine)
    try:
        engine.move_all([hand.move for hand in hands])
        engine.columns()  # what cannot be shown is refused
    except UnderstudyError:
        if _differs(engine, before):  # a move that was refused outright has touched nothing
            before.restore(engine)
        raise
    if timeline is not None:
        timeline.moved(hands)
    return before


def _differs(engine: Engine, before: Keyframe) -> bool:
    try:
        now = engine.columns()
    except UnderstudyError:
        return True
    return any(not np.array_equal(column, now[name]) for name, column in before.world.items())


def _take_back(timeline: Timeline | None, hands: tuple[Hand, ...]) -> None:
    if timeline is not None:
        timeline.unmoved(hands)


def _world(engine: Engine) -> Keyframe:
    """The world now, without what the nodes do: a move leaves that as it is."""
    return Keyframe(engine.tick, engine.columns(), {"now": engine.tick, "nodes": {}})


def _spots(frame: Keyframe, hands: tuple[Hand, ...]) -> tuple[Spot, ...]:
    x, y = frame.world["x"], frame.world["y"]
    return tuple((float(x[hand.entity]), float(y[hand.entity])) for hand in hands)
