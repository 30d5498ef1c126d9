"""What the user's hand moved in a world, so that each move can be undone and done again."""

from dataclasses import dataclass, replace

import numpy as np

from ..core.errors import SessionError, UnderstudyError
from ..sim.engine import Engine
from .keyframes import Hand, Keyframe, Timeline
from .place import Place
from .snapshots import Moved


@dataclass(frozen=True, slots=True)
class _Move:
    """A move.

    Attributes:
        hand: When it was, and where to.
        before: Where the entity was.
        undone: Whether it is taken back now.
    """

    hand: Hand
    before: tuple[float, float]
    undone: bool = False


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

    def move(
        self, engine: Engine, place: Place, entity: int, to: tuple[float, float], timeline: Timeline | None
    ) -> Moved:
        """Put an entity somewhere else.

        Raises:
            UnderstudyError: There is no such entity, or the scenario failed; the world is as it was.
        """
        number = self.next
        before, after = self._do(engine, Hand(engine.tick, entity, *to), timeline, number)
        self.next += 1
        return Moved(entity, _name(place, entity), before, after, number)

    def undo(self, engine: Engine, number: int, timeline: Timeline | None) -> None:
        """Take a move back: exactly if no tick has passed and nothing was moved since, otherwise the entity's place.

        Raises:
            SessionError: There is no such move in this world, or it is undone.
            UnderstudyError: The scenario failed; the world is as it was.
        """
        move = self._known(number)
        if move.undone:
            raise SessionError(f"move {number} is undone already")
        if self._exact and next(reversed(self._exact)) == number:
            self._exact.pop(number).restore(engine)
            _take_back(timeline, move.hand)
        elif move.hand.tick > engine.tick:
            _take_back(timeline, move.hand)  # the run was gone back in, so it is still to come
        else:
            _carry_out(engine, Hand(engine.tick, move.hand.entity, *move.before), timeline)
            self._exact.clear()
        self._moves[number] = replace(move, undone=True)

    def redo(self, engine: Engine, number: int, timeline: Timeline | None) -> None:
        """Move an entity again to where it had been moved.

        Raises:
            SessionError: There is no such move in this world, or it is not undone.
            UnderstudyError: The scenario failed; the world is as it was.
        """
        move = self._known(number)
        if not move.undone:
            raise SessionError(f"move {number} is not undone, so it cannot be done again")
        self._do(engine, replace(move.hand, tick=engine.tick), timeline, number)

    def _do(
        self, engine: Engine, hand: Hand, timeline: Timeline | None, number: int
    ) -> tuple[tuple[float, float], tuple[float, float]]:
        before = _carry_out(engine, hand, timeline)
        at = _at(before, hand.entity)
        self._moves[number] = _Move(hand, at)
        self._exact.pop(number, None)
        self._exact[number] = before
        return at, _at(_world(engine), hand.entity)

    def _known(self, number: int) -> _Move:
        if number not in self._moves:
            raise SessionError(f"there is no move {number} in this world; it has begun again since")
        return self._moves[number]


def _carry_out(engine: Engine, hand: Hand, timeline: Timeline | None) -> Keyframe:
    """Move; returns the world before it."""
    before = _world(engine)
    try:
        engine.move(hand.entity, hand.x, hand.y)
        engine.columns()  # what cannot be shown is refused
    except UnderstudyError:
        if _differs(engine, before):  # a move that was refused outright has touched nothing
            before.restore(engine)
        raise
    if timeline is not None:
        timeline.moved(hand)
    return before


def _differs(engine: Engine, before: Keyframe) -> bool:
    try:
        now = engine.columns()
    except UnderstudyError:
        return True
    return any(not np.array_equal(column, now[name]) for name, column in before.world.items())


def _take_back(timeline: Timeline | None, hand: Hand) -> None:
    if timeline is not None:
        timeline.unmoved(hand)


def _world(engine: Engine) -> Keyframe:
    """The world now, without what the nodes do: a move leaves that as it is."""
    return Keyframe(engine.tick, engine.columns(), {"now": engine.shown.now, "nodes": {}})


def _at(frame: Keyframe, entity: int) -> tuple[float, float]:
    return float(frame.world["x"][entity]), float(frame.world["y"][entity])


def _name(place: Place, entity: int) -> str:
    if entity < len(place.agents):
        return place.agents[entity]
    return next(kind for kind, span in place.spans.items() if entity in span)
