"""Passing the ticks of a run that nobody looks at, so that whoever ends it need not wait, however slow its world is."""

import time
from collections.abc import Callable

from ..sim.engine import Engine

#: Seconds that a spell of ticks takes at most, as far as the one before it tells.
SPELL = 0.2
#: Ticks of the first spell and of the longest; each has at most so many times those of the one before.
FIRST, MOST, GROWTH = 16, 1_000, 4


class Spells:
    """Passes ticks in spells, and asks before each whether to go on."""

    def __init__(
        self, engine: Engine, going: Callable[[], bool], clock: Callable[[], float] = time.perf_counter
    ) -> None:
        self._engine = engine
        self._going = going
        self._clock = clock
        self._ticks = FIRST

    def until(self, goal: int) -> bool:
        """Pass all ticks up to *goal*; false if it is to end before."""
        while self._engine.tick < goal:
            if not self._going():
                return False
            self._pass(min(self._ticks, goal - self._engine.tick))
        return True

    def _pass(self, ticks: int) -> None:
        began = self._clock()
        self._engine.step(ticks)
        seconds = self._clock() - began
        fitting = MOST if seconds <= 0.0 else int(ticks * SPELL / seconds)
        self._ticks = max(1, min(fitting, GROWTH * self._ticks, MOST))
