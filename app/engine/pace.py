"""How many ticks to pass when, so that time in the world keeps pace with time outside."""

from collections.abc import Callable
from typing import Protocol

#: Ticks a second at speed 1.
TICKS_PER_SECOND = 60
#: How long the thread works before it looks for commands again, and rests at least when it has time, in seconds.
SLICE = 0.01
#: How often it shows a snapshot, in seconds.
FRAME = 1 / 60
#: A world that cannot keep up with the speed asked for is not chased further than this, in seconds.
MOST_BEHIND = 0.1
#: A slice has at most so many times the ticks of the slice before: what a tick costs may have been a bad guess.
GROWTH = 4
#: Over how long the rate is measured, in seconds.
WINDOW = 0.5
#: A tick that is due within rounding is due.
ROUNDING = 1e-6


class Timed(Protocol):
    """What ticks are dealt out to: a session."""

    revision: int

    @property
    def speed(self) -> float | None:
        """As in `Play`; 0 when paused."""

    @property
    def due(self) -> int:
        """Ticks that were asked for and that have not passed yet."""

    @property
    def playing(self) -> bool:
        """Whether time is to pass."""

    @property
    def acknowledged(self) -> int:
        """The last ticket that was dealt with."""

    @property
    def mode(self) -> object:
        """What it is for at the moment."""


class Pace:
    """Deals out ticks: *speed* x 60 of them a second, in slices short enough to answer commands in between.

    Attributes:
        rate: Ticks per second, measured over the last window; 0 when paused.
    """

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock = clock
        self._last = clock()  # when ticks were dealt out last
        self._going = False
        self._owed = 0.0
        self._cost = SLICE  # seconds a tick, measured as it goes
        self._seen: object = None
        self._window, self._count = self._last, 0
        self.rate = 0.0

    def delay(self, session: Timed) -> float | None:
        """Seconds until ticks are due, not sooner than a slice after the last; None if none are before a command."""
        if not session.playing:
            self._stop()  # nobody may ask for ticks again, where those that were due have passed
            return None
        if session.due or session.speed is None:
            return 0.0
        since, rate = self._clock() - self._last, session.speed * TICKS_PER_SECOND
        next_tick = (1.0 - self._owed) / rate - since if self._going else 0.0
        return max(0.0, next_tick, SLICE - since)

    def ticks(self, session: Timed) -> int:
        """How many ticks to pass now."""
        now = self._clock()
        elapsed, self._last = now - self._last, now
        if not session.playing:
            self._stop()
            return 0
        if not self._going:
            self._going, self._owed, elapsed = True, 0.0, 0.0
            self._window, self._count = now, 0
        self._measure(now)
        return self._dealt(session, elapsed)

    def _dealt(self, session: Timed, elapsed: float) -> int:
        most = self._most(session)
        if session.due:
            return min(session.due, most)
        if session.speed is None:
            return most
        rate = session.speed * TICKS_PER_SECOND
        behind = max(2.0, min(MOST_BEHIND * rate, most + 1.0))
        self._owed = min(self._owed + elapsed * rate, behind)
        ticks = min(int(self._owed + ROUNDING), most)
        self._owed -= ticks
        return ticks

    def passed(self, ticks: int) -> None:
        """The ticks dealt out last have passed."""
        seconds = self._clock() - self._last
        self._cost = max(seconds / ticks, self._cost / GROWTH, 1e-7)
        self._count += ticks

    def _most(self, session: Timed) -> int:
        """How many ticks fit a slice; after anything that may change what they cost, one, then more."""
        seen = session.acknowledged, session.revision, session.mode
        if seen != self._seen:
            self._seen, self._cost = seen, SLICE
        return max(1, int(SLICE / self._cost))

    def _measure(self, now: float) -> None:
        if now - self._window >= WINDOW:
            self.rate = self._count / (now - self._window)
            self._window, self._count = now, 0

    def _stop(self) -> None:
        self._going, self.rate = False, 0.0
