"""The background thread that a session runs in: asleep when paused, paced when playing, never in the caller's way."""

from collections import deque
from collections.abc import Callable
from threading import Condition, Thread
from time import monotonic

from .commands import Command
from .session import MakeSession, Session
from .snapshots import Event, Snapshot

#: Ticks a second at speed 1.
TICKS_PER_SECOND = 60
#: How long the thread works before it looks for commands and shows a snapshot again, in seconds.
SLICE = 0.01
#: A world that cannot keep up with the speed asked for is not chased further than this, in seconds.
MOST_BEHIND = 0.1


class EngineThread:
    """Runs a session in the background.

    Commands are queued and answered by tickets; the newest snapshot wins, nothing is emitted per tick.
    """

    def __init__(self, make: MakeSession, clock: Callable[[], float] = monotonic) -> None:
        """Start the thread, paused.

        Args:
            make: Makes the session; it is given a function that wakes the thread.
            clock: Gives seconds; passed in so that tests can do without real time.
        """
        self._wake = Condition()
        self._clock = clock
        self._inbox: deque[Command] = deque()
        self._outbox: list[Event] = []
        self._tickets = 0
        self._stop = False
        self._nudged = False
        self._session = make(self._nudge)
        self._newest = self._session.snapshot()
        self._rate = 0.0
        self._thread = Thread(target=self._work, name="engine", daemon=True)
        self._thread.start()

    # ---------------------------------------------------------------------------- from any other thread

    def send(self, command: Command) -> int:
        """Queue a command; its ticket comes back in a snapshot once it was dealt with."""
        with self._wake:
            self._inbox.append(command)
            self._tickets += 1
            self._wake.notify_all()
            return self._tickets

    @property
    def newest(self) -> Snapshot:
        """The last snapshot."""
        return self._newest

    @property
    def rate(self) -> float:
        """Ticks per second over the last slice; 0 when paused."""
        return self._rate

    def events(self) -> list[Event]:
        """What happened since the last call, in order."""
        with self._wake:
            events, self._outbox = self._outbox, []
            return events

    def wait_for(self, ready: Callable[[Snapshot], bool], timeout: float = 10.0) -> Snapshot:
        """Wait for a snapshot that is *ready*.

        Raises:
            TimeoutError: None came in *timeout* seconds.
        """
        with self._wake:
            if not self._wake.wait_for(lambda: ready(self._newest), timeout):
                raise TimeoutError(
                    f"no such snapshot in {timeout} s; the newest is at tick {self._newest.tick}"
                )
            return self._newest

    def close(self) -> None:
        """Stop the thread and wait for its end."""
        with self._wake:
            self._stop = True
            self._wake.notify_all()
        self._thread.join()
        self._session.close()

    def _nudge(self) -> None:
        with self._wake:
            self._nudged = True
            self._wake.notify_all()

    # -------------------------------------------------------------------------------------- in the thread

    def _work(self) -> None:
        pace = Pace(self._clock)
        while self._wait():
            self._obey()
            self._session.settle()
            started, ticks = self._clock(), pace.ticks(self._session)
            if ticks:
                self._session.advance(ticks)
                pace.passed(ticks, self._clock() - started)
            self._rate = pace.rate if self._session.playing else 0.0
            self._publish()

    def _wait(self) -> bool:
        """Sleep until there is something to do; False when it is time to end."""
        with self._wake:
            while not (self._stop or self._inbox or self._nudged or self._session.playing):
                self._wake.wait()
            if (
                self._session.playing
                and not (self._inbox or self._nudged or self._stop)
                and self._session.speed
            ):
                self._wake.wait(1 / TICKS_PER_SECOND / max(1.0, self._session.speed))
            self._nudged = False
            return not self._stop

    def _obey(self) -> None:
        with self._wake:
            commands = list(self._inbox)
            self._inbox.clear()
        for command in commands:
            self._session.send(command)

    def _publish(self) -> None:
        snapshot, events = self._session.snapshot(), self._session.events()
        with self._wake:
            self._newest = snapshot
            self._outbox += events
            self._wake.notify_all()


class Pace:
    """How many ticks to pass now, so that *speed* x 60 of them pass a second."""

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock = clock
        self._last = clock()
        self._owed = 0.0
        self._cost = 1e-4  # seconds a tick, measured as it goes
        self.rate = 0.0

    def ticks(self, session: Session) -> int:
        """How many ticks to pass in the coming slice."""
        now = self._clock()
        elapsed, self._last = min(now - self._last, MOST_BEHIND), now
        most = max(1, int(SLICE / self._cost))
        if not session.playing:
            self._owed = 0.0
            return 0
        if session.due:
            return min(session.due, most)
        if session.speed is None:
            return most
        self._owed = min(self._owed + elapsed * session.speed * TICKS_PER_SECOND, most + 1.0)
        ticks = int(self._owed)
        self._owed -= ticks
        return ticks

    def passed(self, ticks: int, seconds: float) -> None:
        """Take in how long *ticks* took."""
        self._cost = max(seconds / ticks, 1e-7)
        self.rate = ticks / max(seconds, SLICE if ticks * self._cost < SLICE else seconds)
