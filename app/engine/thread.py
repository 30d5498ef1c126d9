"""The background thread that a session runs in: asleep when paused, paced when playing, never in the caller's way."""

from collections import deque
from collections.abc import Callable
from dataclasses import replace
from threading import Condition, Thread
from time import monotonic

from ..core.errors import SessionError, UnderstudyError
from .commands import Command
from .pace import FRAME, Pace
from .session import Session
from .snapshots import Event, Refused, Snapshot

#: A frame may be shown by so much of its length sooner than due: ticks come at the same pace, but not as evenly, and
#: every second one would be missed.
EARLY = 0.25
#: Snapshots that take long are shown less often, so that ticks get at least so many times what they take.
SHARE = 6
#: Makes the session, given what wakes the thread up.
MakeSession = Callable[[Callable[[], None]], Session]


class EngineThread:
    """Runs a session in the background.

    Commands are queued and answered by tickets; the newest snapshot wins, nothing is emitted per tick. Whatever goes
    wrong in the session ends up as a failure in the snapshot and as an event; the thread lives until it is closed.

    Attributes:
        broken: Why the session could not even be made, in words; then every command is refused.
    """

    def __init__(
        self,
        make: MakeSession,
        clock: Callable[[], float] = monotonic,
        wake: Condition | None = None,
        answered: Callable[[], None] = lambda: None,
    ) -> None:
        """Start the thread, in which the session is made, paused; nobody has to wait for it.

        Args:
            make: Makes the session; it is given a function that wakes the thread.
            clock, wake: Give seconds and let the thread sleep; passed in so that tests can do without real time.
            answered: Called from the thread when there is a snapshot that somebody waits for: a command was obeyed, or the
                first tick after it has passed. It must only wake somebody up.
        """
        self.broken = ""
        self._make = make
        self._wake = wake or Condition()
        self._clock = clock
        self._inbox: deque[Command] = deque()
        self._outbox: list[Event] = []
        self._tickets = 0
        self._stop = False
        self._nudged = False
        self._answered = answered
        self._obeyed = False  # and no tick has been shown since
        self._session: Session | None = None
        self._newest: Snapshot | None = None
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
    def newest(self) -> Snapshot | None:
        """The last snapshot; None until the session has begun."""
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

    def wait_for(self, ready: Callable[[Snapshot], bool], timeout: float = 60.0) -> Snapshot:
        """Wait for a snapshot that is *ready*; the first may still have to come.

        Raises:
            SessionError: None will come, since the engine could not begin, has failed or was closed; the message says why.
            TimeoutError: None came in *timeout* seconds.
        """
        with self._wake:
            self._wake.wait_for(lambda: self._is(ready) or self._ended(), timeout)
            newest = self._newest
            if newest is not None and ready(newest):
                return newest
            if ended := self._ended():
                raise SessionError(ended)
            there = "there is none yet" if newest is None else f"the newest is at tick {newest.tick:,}"
            raise TimeoutError(f"no such snapshot in {timeout} s; {there}")

    def leave(self) -> None:
        """Let the thread end as soon as it can, which may take as long as a tick of a large world; wait for nothing."""
        with self._wake:
            self._stop = True
            self._wake.notify_all()

    def close(self) -> None:
        """Let the thread end, with all that runs beside it, and wait for that."""
        self.leave()
        self._thread.join()

    @property
    def has_ended(self) -> bool:
        """Whether the thread and all that ran beside it are gone."""
        return not self._thread.is_alive()

    def _is(self, ready: Callable[[Snapshot], bool]) -> bool:
        return self._newest is not None and ready(self._newest)

    def _ended(self) -> str:
        """Why no snapshot will come unless another command does; empty if one may."""
        if self._stop:
            return "the engine is closed"
        if self.broken:
            return f"the engine could not begin: {self.broken}"
        newest = self._newest
        answered = newest is not None and newest.acknowledged >= self._tickets
        return f"the engine stands still: {newest.failure}" if newest and answered and newest.failure else ""

    def _nudge(self) -> None:
        with self._wake:
            self._nudged = True
            self._wake.notify_all()

    # -------------------------------------------------------------------------------------- in the thread

    def _work(self) -> None:
        session = self._begin()
        if session is None:
            self._refuse_all()
            return
        self._session = session
        try:
            while self._sleep(session):
                try:
                    self._round(session)
                except BaseException as error:  # noqa: BLE001 - whatever it is, those who wait have to hear of it
                    self._fail(session, error)
        finally:
            session.close()

    def _begin(self) -> Session | None:
        """Make the session; None, with the reason in `broken`, if that is not possible."""
        session = None
        try:
            session = self._make(self._nudge)
            self._post(session.snapshot(), session.events())
        except BaseException as error:  # noqa: BLE001 - as above
            why = str(error) if isinstance(error, UnderstudyError) else f"{type(error).__name__}: {error}"
            if session is not None:
                session.close()
            with self._wake:
                self.broken = why
                self._outbox.append(Refused(0, why))
                self._wake.notify_all()
            return None
        return session

    def _refuse_all(self) -> None:
        """Without a session, answer every command with the reason until the thread is closed."""
        answered = 0
        with self._wake:
            while self._inbox or not self._stop:
                if self._inbox:
                    self._inbox.popleft()
                    answered += 1
                    self._outbox.append(Refused(answered, f"the engine could not begin: {self.broken}"))
                else:
                    self._wake.wait()

    def _sleep(self, session: Session) -> bool:
        """Sleep until there is something to do; False when it is time to end."""
        with self._wake:
            while not (self._stop or self._inbox or self._nudged):
                delay = self._pace.delay(session)
                if delay == 0.0 or not self._wake.wait(delay):
                    break  # ticks are due
            return not self._stop

    def _round(self, session: Session) -> None:
        """Obey commands, take in what was learned, pass the ticks that are due, show what has become of it."""
        answering = self._obey(session)
        session.settle()
        ticks = self._pace.ticks(session)
        if ticks:
            session.pass_ticks(ticks)
            self._pace.passed(ticks)
        awaited = answering or (self._obeyed and ticks > 0)
        self._obeyed = (answering or self._obeyed) and not ticks
        if awaited or not session.playing or self._clock() >= self._show_at:
            self._publish(session)
        if awaited:
            self._answered()

    def _obey(self, session: Session) -> bool:
        """Obey the commands that have come; whether somebody waits for an answer."""
        with self._wake:
            answering, self._nudged = self._nudged, False
        while self._inbox:
            answering = True
            session.send(self._inbox.popleft())
        return answering

    def _publish(self, session: Session) -> None:
        began = self._clock()
        snapshot, events = session.snapshot(), session.events()
        ended = self._clock()
        # A large world is not shown all the time.
        self._show_at = max(began + (1.0 - EARLY) * FRAME, ended + SHARE * (ended - began))
        self._post(snapshot, events)

    def _post(self, snapshot: Snapshot, events: list[Event]) -> None:
        with self._wake:
            self._newest = snapshot
            self._outbox += events
            self._wake.notify_all()

    def _fail(self, session: Session, error: BaseException) -> None:
        """Tell of something that nobody foresaw."""
        why = f"{type(error).__name__}: {error}"
        session.fail(why)
        try:
            snapshot = session.snapshot()
        except BaseException:  # noqa: BLE001 - it cannot be shown either: show the last one that could, stopped
            assert self._newest is not None  # there was one when the session began
            snapshot = replace(self._newest, acknowledged=session.acknowledged, speed=0.0, failure=why)
        self._post(snapshot, session.events())
