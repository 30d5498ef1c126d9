"""The background thread that a session runs in: asleep when paused, paced when playing, never in the caller's way."""

from collections import deque
from collections.abc import Callable
from dataclasses import replace
from threading import Condition, Thread
from time import monotonic

from ..core.errors import SessionError
from .commands import Command
from .pace import FRAME, Pace
from .session import Session
from .snapshots import Event, Snapshot

#: Makes the session, given what wakes the thread up.
MakeSession = Callable[[Callable[[], None]], Session]


class EngineThread:
    """Runs a session in the background.

    Commands are queued and answered by tickets; the newest snapshot wins, nothing is emitted per tick. Whatever goes
    wrong in the session ends up as a failure in the snapshot and as an event; the thread lives until it is closed.
    """

    def __init__(
        self, make: MakeSession, clock: Callable[[], float] = monotonic, wake: Condition | None = None
    ) -> None:
        """Start the thread, paused.

        Args:
            make: Makes the session; it is given a function that wakes the thread.
            clock, wake: Give seconds and let the thread sleep; passed in so that tests can do without real time.

        Raises:
            UnderstudyError: The session cannot be made.
        """
        self._wake = wake or Condition()
        self._clock = clock
        self._inbox: deque[Command] = deque()
        self._outbox: list[Event] = []
        self._tickets = 0
        self._stop = False
        self._nudged = False
        self._session = make(self._nudge)
        self._newest = self._session.snapshot()
        self._pace = Pace(clock)
        self._show_at = clock()
        self._thread = Thread(target=self._work, name="engine", daemon=True)
        self._thread.start()

    # ---------------------------------------------------------------------------- from any other thread

    def send(self, command: Command) -> int:
        """Queue a command; its ticket comes back in a snapshot once it was dealt with.

        Raises:
            SessionError: The thread was closed.
        """
        with self._wake:
            if self._stop:
                raise SessionError("the engine is closed; it takes no commands any more")
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
        """Ticks per second over the last half second or so; 0 when paused."""
        return self._pace.rate

    def events(self) -> list[Event]:
        """What happened since the last call, in order."""
        with self._wake:
            events, self._outbox = self._outbox, []
            return events

    def wait_for(self, ready: Callable[[Snapshot], bool], timeout: float = 10.0) -> Snapshot:
        """Wait for a snapshot that is *ready*.

        Raises:
            SessionError: None will come, since the engine has failed or was closed; the message says why.
            TimeoutError: None came in *timeout* seconds.
        """
        with self._wake:
            if not self._wake.wait_for(lambda: ready(self._newest) or self._ended(), timeout):
                raise TimeoutError(
                    f"no such snapshot in {timeout} s; the newest is at tick {self._newest.tick}"
                )
            if not ready(self._newest):
                raise SessionError(self._ended())
            return self._newest

    def close(self) -> None:
        """Stop the thread and wait for its end."""
        with self._wake:
            self._stop = True
            self._wake.notify_all()
        self._thread.join()
        self._session.close()

    def _ended(self) -> str:
        """Why no snapshot will come unless another command does; empty if one may."""
        if self._stop:
            return "the engine is closed"
        answered = self._newest.acknowledged >= self._tickets
        return f"the engine stands still: {self._newest.failure}" if answered and self._newest.failure else ""

    def _nudge(self) -> None:
        with self._wake:
            self._nudged = True
            self._wake.notify_all()

    # -------------------------------------------------------------------------------------- in the thread

    def _work(self) -> None:
        while self._sleep():
            try:
                self._round()
            except BaseException as error:  # noqa: BLE001 - whatever it is, those who wait have to hear of it
                self._fail(error)

    def _sleep(self) -> bool:
        """Sleep until there is something to do; False when it is time to end."""
        with self._wake:
            while not (self._stop or self._inbox or self._nudged):
                delay = self._pace.delay(self._session)
                if delay == 0.0 or not self._wake.wait(delay):
                    break  # ticks are due
            return not self._stop

    def _round(self) -> None:
        """Obey commands, take in what was learned, pass the ticks that are due, show what has become of it."""
        answering = self._obey()
        self._session.settle()
        ticks = self._pace.ticks(self._session)
        if ticks:
            self._session.pass_ticks(ticks)
            self._pace.passed(ticks)
        if answering or not self._session.playing or self._clock() >= self._show_at:
            self._publish()

    def _obey(self) -> bool:
        """Obey the commands that have come; whether somebody waits for an answer."""
        with self._wake:
            answering, self._nudged = self._nudged, False
        while self._inbox:
            answering = True
            self._session.send(self._inbox.popleft())
        return answering

    def _publish(self) -> None:
        began = self._clock()
        snapshot, events = self._session.snapshot(), self._session.events()
        ended = self._clock()
        self._show_at = ended + max(FRAME, 3 * (ended - began))  # a large world is not shown all the time
        self._post(snapshot, events)

    def _post(self, snapshot: Snapshot, events: list[Event]) -> None:
        with self._wake:
            self._newest = snapshot
            self._outbox += events
            self._wake.notify_all()

    def _fail(self, error: BaseException) -> None:
        """Tell of something that nobody foresaw."""
        why = f"{type(error).__name__}: {error}"
        self._session.fail(why)
        try:
            snapshot = self._session.snapshot()
        except BaseException:  # noqa: BLE001 - it cannot be shown either: show the last one that could, stopped
            ticket = self._session.acknowledged
            snapshot = replace(self._newest, acknowledged=ticket, speed=0.0, failure=why)
        self._post(snapshot, self._session.events())
