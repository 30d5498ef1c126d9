"""How fast time is to pass in a session, and how far."""

from math import isfinite

from ..core.errors import SessionError


class Clock:
    """Says how much time is wanted; it knows no seconds.

    Attributes:
        speed: As in `Play`; 0 when paused.
        due: Ticks that were asked for and that have not passed yet.
        going_to: The tick that a `GoTo` is on its way to.
        stops_in: Ticks after which time stops although it runs; None if it just runs.
    """

    def __init__(self) -> None:
        self.speed: float | None = 0.0
        self.due = 0
        self.going_to: int | None = None
        self.stops_in: int | None = None
        self._held: tuple[float | None, int] | None = None

    @property
    def running(self) -> bool:
        """Whether time is to pass."""
        return self.speed != 0.0 or self.due > 0

    @property
    def shown(self) -> float | None:
        """The speed that the user reads: stepping is as fast as 1 to them.

        A single step is over before anybody could stop it: the key that plays or stops must not find time passing then.
        """
        return self.speed if self.due <= 1 else 1.0

    @property
    def most(self) -> int | None:
        """How many ticks may pass before something else is to happen; None if as many as there is time for."""
        if self.going_to is None:
            return self.stops_in
        return self.due if self.stops_in is None else min(self.due, self.stops_in)

    def play(self, speed: float | None) -> None:
        """Let time pass at this speed.

        Raises:
            SessionError: There is no such speed.
        """
        if speed is not None and not (speed > 0 and isfinite(speed)):
            raise SessionError(
                f"the speed is {speed}; allowed: above 0 (1 is 60 ticks a second), or none for as fast as it can"
            )
        self._set(speed, 0)

    def pause(self) -> None:
        """Let no time pass, and none after what holds time has been settled."""
        self._set(0.0, 0)
        self.stops_in = None

    def stop_in(self, ticks: int | None) -> None:
        """Let time stop after so many more ticks, at whatever speed they pass; None if it is just to go on."""
        if ticks is None or ticks > 0:
            self.stops_in = ticks
        else:
            self.pause()

    def step(self, ticks: int) -> None:
        """Let so many more ticks pass, then none.

        Raises:
            SessionError: That is no number of ticks.
        """
        if ticks < 1:
            raise SessionError(f"a step is of 1 tick or more, but it is {ticks:,}")
        self._set(0.0, ticks + (self.due if self.going_to is None else 0))
        self.stops_in = None

    def go(self, to: int, ticks: int) -> None:
        """Let the ticks pass that are left on the way to tick *to*, then none."""
        self._set(0.0, ticks)
        self.going_to, self.stops_in = to if ticks else None, None

    def stop_going(self) -> None:
        """Stay where a journey has come to."""
        if self.going_to is not None:
            self.pause()

    def passed(self, ticks: int) -> None:
        """Ticks have passed."""
        self.due = max(0, self.due - ticks)
        if not self.due:
            self.going_to = None
        if self.stops_in is not None:
            self.stop_in(self.stops_in - ticks)

    def begin(self) -> None:
        """Forget the ticks that were asked for: they were of another world."""
        self.due, self.going_to, self.stops_in = 0, None, None
        if self._held is not None:
            self._held = self._held[0], 0

    def hold(self) -> None:
        """Let no time pass until `resume`."""
        held = self.speed, self.due
        self._set(0.0, 0)
        self._held = held

    def resume(self) -> None:
        """Go on as before `hold`, unless something else was asked for meanwhile."""
        if self._held is not None:
            self._set(*self._held)

    def _set(self, speed: float | None, due: int) -> None:
        self.speed, self.due, self.going_to, self._held = speed, due, None, None
