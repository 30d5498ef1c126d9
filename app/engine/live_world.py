"""The world that a session goes on in: stepped, moved in by hand, and gone back in."""

from collections.abc import Mapping

from ..core.errors import SessionError, UnderstudyError
from ..sim.engine import Columns, Control, Engine
from .keyframes import Timeline
from .moves import Moves
from .place import place_of
from .runs import Treatment
from .snapshots import Moved


class LiveWorld:
    """One world, from its beginning until another takes its place.

    Attributes:
        engine: What passes its ticks.
        treatment: The arm in it, as it is in the project now.
        seed: What it began with.
        place: What does not change in it.
        failure: What stopped it, in words; empty if nothing did.
    """

    def __init__(self, engine: Engine, treatment: Treatment, seed: int, *, first_move: int = 1) -> None:
        """Show a world that has just begun.

        Args:
            first_move: The number of the first move by hand.

        Raises:
            ScenarioError: It cannot be shown.
        """
        self._columns = engine.columns()
        self.place = place_of(engine, treatment.arm.name)
        self.engine = engine
        self.treatment = treatment
        self.seed = seed
        self.failure = ""
        self._moves = Moves(first_move)
        self._timeline: Timeline | None = None

    @property
    def next_move(self) -> int:
        """The number of the next move by hand."""
        return self._moves.next

    @property
    def tick(self) -> int:
        """The tick that comes next."""
        return self.engine.tick

    @property
    def earliest(self) -> int:
        """The first tick that can be gone back to; the one that is now while nothing is kept."""
        return self.tick if self._timeline is None else self._timeline.beginning

    def columns(self) -> Columns:
        """Its columns.

        Raises:
            ScenarioError: It cannot be shown.
        """
        self._columns = self.engine.columns()
        return self._columns

    @property
    def shown(self) -> Columns:
        """Its columns when they could be shown last."""
        return self._columns

    # -------------------------------------------------------------------------------------------- passing ticks

    def run_free(self) -> None:
        """Nobody is taught from here on: remember how it goes, so that it can be gone back in as far as here."""
        try:
            self._timeline = Timeline(self.engine)
        except UnderstudyError:
            self._timeline = None  # what cannot be shown cannot be kept

    def run_taught(self) -> None:
        """Somebody is taught from here on: what a hand teaches is not repeated, so there is no going back."""
        self._timeline = None

    def changed(self) -> None:
        """The behaviors have changed: what ran before cannot be repeated."""
        if self._timeline is not None:
            self.run_free()

    def step(self, ticks: int, control: Control) -> None:
        """Pass ticks.

        Raises:
            UnderstudyError: The world has failed; fewer have passed.
        """
        engine, timeline = self.engine, self._timeline
        self._moves.passed()
        goal = engine.tick + ticks
        while engine.tick < goal:
            stop = goal if timeline is None else timeline.next_stop(engine)
            engine.step(min(stop, goal) - engine.tick, control)
            if timeline is not None and engine.tick == stop:
                timeline.arrive(engine)

    def go_near(self, tick: int) -> None:
        """Go to a moment of this run from which *tick* can be reached by passing ticks.

        Raises:
            SessionError: There is none.
        """
        if self._timeline is None:
            raise SessionError("this world cannot be gone back in; reset it, or run the arm first")
        self._timeline.go_near(self.engine, tick, broken=bool(self.failure))
        self.failure = ""
        self._moves.passed()

    # ----------------------------------------------------------------------------------------- moved by hand

    def move(self, to: Mapping[int, tuple[float, float]]) -> Moved:
        """Put entities somewhere else.

        Raises:
            UnderstudyError: There is no such entity or place, or the scenario failed; the world is as it was.
        """
        return self._moves.move(self.engine, self.place, to, self._timeline)

    def undo_move(self, number: int) -> None:
        """Take a move back.

        Raises:
            UnderstudyError: That is not possible; the world is as it was.
        """
        self._moves.undo(self.engine, number, self._timeline)

    def redo_move(self, number: int) -> None:
        """Move again what was moved back.

        Raises:
            UnderstudyError: That is not possible; the world is as it was.
        """
        self._moves.redo(self.engine, number, self._timeline)
