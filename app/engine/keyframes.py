"""How a run went: moments of it that are kept, and what a user's hand did, so that it can be gone through again.

Between two keyframes a run is repeated tick by tick: chance depends on nothing but where and when, so the same comes of
it. What the user moved is moved again when its tick comes.
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field

from ..core.errors import SessionError
from ..core.machine_state import MachineState
from ..sim.engine import Columns, Engine

#: A moment is kept every so many ticks, for each so many nodes: keeping one takes time.
SPACING, NODES = 600, 500
#: So many times as many where ticks are compiled, and gone through again in no time.
COMPILED = 10
#: The most moments that are kept, and the most bytes that they take altogether.
MOST, BUDGET = 120, 256 * 1024 * 1024
#: About what a node takes.
NODE_BYTES = 2_000


@dataclass(frozen=True, slots=True, eq=False)
class Keyframe:
    """A world and what all nodes did, before *tick* passed."""

    tick: int
    world: Columns
    machine: MachineState = field(repr=False)

    def restore(self, engine: Engine) -> None:
        """Let all be as it was."""
        engine.restore({name: column.tolist() for name, column in self.world.items()}, self.machine)


def keep(engine: Engine) -> Keyframe:
    """The moment that is now.

    Raises:
        ScenarioError: The scenario has put something into a column that does not belong there.
    """
    nodes = engine.frozen_nodes()  # first: then the columns of a compiled run are taken as they are
    return Keyframe(engine.tick, engine.columns(), nodes)


@dataclass(frozen=True, slots=True)
class Hand:
    """What the user moved, before *tick* passed."""

    tick: int
    entity: int
    x: float
    y: float

    @property
    def move(self) -> tuple[int, float, float]:
        """Who was moved, and where to."""
        return self.entity, self.x, self.y


class Timeline:
    """The moments and the moves of one run, from the one that it began with."""

    def __init__(self, engine: Engine) -> None:
        """Begin with what is now."""
        nodes = len(engine.shown.actors)
        self._spacing = SPACING * max(1, nodes // NODES)
        self._rigid = engine.start.physics != "kinematic"
        self._frames = [keep(engine)]
        self._hands: list[Hand] = []
        size = sum(column.nbytes for column in self._frames[0].world.values()) + NODE_BYTES * nodes
        self._most = min(MOST, max(3, BUDGET // max(1, size)))

    @property
    def beginning(self) -> int:
        """The first tick that can be gone back to."""
        return self._frames[0].tick

    @property
    def ticks(self) -> Sequence[int]:
        """The ticks of the moments that are kept."""
        return [frame.tick for frame in self._frames]

    # ------------------------------------------------------------------------------------------ as it goes

    def next_stop(self, engine: Engine) -> int:
        """The next tick at which `arrive` has to be called."""
        tick, spacing = engine.tick, self._spacing_of(engine)
        mark = (tick // spacing + 1) * spacing
        return min([mark, *(hand.tick for hand in self._hands if hand.tick > tick)])

    def arrive(self, engine: Engine) -> None:
        """Keep the moment if it is time to, and move what the user moved here."""
        if engine.tick % self._spacing_of(engine) == 0:
            self._mark(engine)
        self._repeat(engine)

    def _spacing_of(self, engine: Engine) -> int:
        """Bodies are put up anew at the same ticks always, whatever passes them."""
        return self._spacing * (COMPILED if engine.compiled and not self._rigid else 1)

    def _mark(self, engine: Engine) -> None:
        known = next((frame for frame in self._frames if frame.tick == engine.tick), None)
        if known is None:
            known = keep(engine)
            self._frames = sorted([*self._frames, known], key=lambda frame: frame.tick)
            if len(self._frames) > self._most:
                self._frames = [self._frames[0], *self._frames[2::2]]
        if self._rigid:
            known.restore(engine)  # bodies are put up anew here, now as whenever this is gone through again

    def _repeat(self, engine: Engine) -> None:
        if here := [hand.move for hand in self._hands if hand.tick == engine.tick]:
            engine.move_all(here)

    # ------------------------------------------------------------------------------------- what a hand did

    def moved(self, hands: Sequence[Hand]) -> None:
        """The user has moved something: what came after this tick may come in another way now.

        Args:
            hands: All of one tick.
        """
        tick = hands[0].tick
        self._frames = [frame for frame in self._frames if frame.tick <= tick]
        self._hands = [*(known for known in self._hands if known.tick <= tick), *hands]

    def unmoved(self, hands: Sequence[Hand]) -> None:
        """The user has taken a move back, now or before it came again.

        Args:
            hands: All of one tick.
        """
        self._frames = [frame for frame in self._frames if frame.tick <= hands[0].tick]
        gone, kept = Counter(hands), []
        for hand in reversed(self._hands):  # of several that are alike, the last is the one
            if gone[hand]:
                gone[hand] -= 1
            else:
                kept.append(hand)
        self._hands = kept[::-1]

    # ------------------------------------------------------------------------------------------- going back

    def go_near(self, engine: Engine, tick: int, *, broken: bool = False) -> None:
        """Let it be as at the last moment kept up to *tick*, unless it already is between the two.

        Args:
            broken: What is now is of no use.

        Raises:
            SessionError: The run cannot be gone back in that far.
        """
        if tick < self.beginning:
            raise SessionError(
                f"this run can be gone back in to tick {self.beginning:,}, not to {tick:,}: what came before ran with other "
                f"behaviors, or someone was taught; a reset begins at tick 0"
            )
        nearest = [frame for frame in self._frames if frame.tick <= tick][-1]
        if broken or engine.tick > tick or nearest.tick > engine.tick:
            nearest.restore(engine)
            self._repeat(engine)
