"""The window's end of the engine: commands go in, snapshots come out once a frame, events become undoable edits."""

from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from ..core.edits import describe, record_pick
from ..core.edits.examples import Recorded
from ..core.errors import UnderstudyError
from ..core.history import Edit as Step
from ..core.project import Project, Value
from ..engine.commands import Command, RedoPick, UndoMove, UndoPick, UseProject
from ..engine.compiling import KernelCompiler
from ..engine.learning import WorkerLearner
from ..engine.session import Session
from ..engine.snapshots import (
    Edit,
    Event,
    Failed,
    Interrupted,
    Moved,
    Picked,
    Refused,
    Relearned,
    Snapshot,
    TakenBack,
    edited,
)
from ..engine.thread import EngineThread
from .document import Document
from .turn import Patience

#: Milliseconds between two looks at the engine.
FRAME = 16


@dataclass(frozen=True, slots=True)
class PickMark:
    """A step of the history that a pick recorded."""

    recorded: Recorded


@dataclass(frozen=True, slots=True)
class MoveMark:
    """A step of the history that moved something in the world."""

    moved: Moved


class Bridge(QObject):
    """Runs a session of the document's project in the background and keeps the two in step.

    Attributes:
        snapshot: The newest; None until the first has come.

    Signals:
        snapshot_changed: A newer snapshot is there, at most once a frame.
        place_changed: The world is another one, with other nodes or parameters.
        mode_changed: Teaching, testing, learning or running; playing and pausing; or whether time has passed at all.
        event_came: Anything that happened in the session, after the document has taken it in.
        told: Something did not go as asked; the message says what and why.
    """

    snapshot_changed = Signal(object)
    place_changed = Signal(object)
    mode_changed = Signal()
    event_came = Signal(object)
    told = Signal(str)
    _answered = Signal()

    def __init__(self, document: Document, make: Callable[..., EngineThread] = EngineThread) -> None:
        super().__init__()
        self._document = document
        self._make = make
        self._engine: EngineThread | None = None
        self._left: list[EngineThread] = []  # those that may still be at their last tick
        self.snapshot: Snapshot | None = None
        self._newest: Snapshot | None = None  # to be shown once all events have been taken in
        self._events: deque[Event] = deque()
        self._patience = Patience()
        self._applied = 0
        self._taking = False
        self._taking_back = self._doing_again = 0
        self._picks: list[Recorded] = []  # those that the session can take back, as far as we know
        self._taken_back: list[Recorded] = []  # and those that it can do again
        document.project_changed.connect(self._project_changed)
        self._timer = QTimer(self, interval=FRAME, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self.poll)
        self._again = QTimer(self, interval=0, singleShot=True)
        self._again.timeout.connect(self.poll)
        # An answer is looked at as soon as it is there: up to a frame sooner.
        self._answered.connect(self.poll, Qt.ConnectionType.QueuedConnection)

    # ------------------------------------------------------------------------------------- beginning, ending

    def open(self, arm: str, seed: int = 1, settings: Mapping[str, Value] | None = None) -> None:
        """Begin a session of the document's project in another engine."""
        self.close()
        document, project = self._document, self._document.project
        self._applied = 0
        self.forget_picks()
        self._engine = self._make(
            lambda wake: Session(
                project, document.scenario, arm, seed, WorkerLearner(wake), settings, KernelCompiler(wake)
            ),
            answered=self._answered.emit,
        )
        self._timer.start()

    def close(self) -> None:
        """End the session; its thread ends by itself after the tick that it is at, which nobody has to wait for."""
        self._timer.stop()
        self._again.stop()
        self._events.clear()
        if self._engine is not None:
            engine, self._engine = self._engine, None
            engine.leave()
            self._left = [*(left for left in self._left if not left.has_ended), engine]
        self.snapshot = self._newest = None

    def shut_down(self) -> None:
        """End the session and wait for all threads, also of sessions before it."""
        self.close()
        for engine in self._left:
            engine.close()
        self._left.clear()

    @property
    def is_open(self) -> bool:
        """Whether there is a session."""
        return self._engine is not None

    @property
    def rate(self) -> float:
        """Ticks per second, measured; 0 when paused."""
        return 0.0 if self._engine is None else self._engine.rate

    # ------------------------------------------------------------------------------------------- in and out

    def send(self, command: Command) -> int:
        """Send a command; its ticket comes back as `Snapshot.acknowledged`. Without a session nothing happens."""
        return 0 if self._engine is None else self._engine.send(command)

    def poll(self) -> None:
        """Take in what has happened since the last look; after each event whatever else has come, if it took long."""
        engine = self._engine
        if engine is None:
            return
        if not self._events:
            self._newest = engine.newest  # before the events, so that none is missing that the snapshot shows
            self._events.extend(engine.events())
        while not self._patience.waits():
            if not self._events:
                self._show(self._newest)
                return
            self._take(self._events.popleft())
        self._again.start()

    def _show(self, newest: Snapshot | None) -> None:
        if newest is None or newest is self.snapshot:
            return
        before, self.snapshot = self.snapshot, newest
        if before is None or before.place is not newest.place:
            self.place_changed.emit(newest.place)
        if before is None or _mode(before) != _mode(newest):
            self.mode_changed.emit()
        self.snapshot_changed.emit(newest)

    # ----------------------------------------------------------------------------- the session's edits, and ours

    def _take(self, event: Event) -> None:
        match event:
            case Picked() | TakenBack() | Relearned():
                self._apply(event)
            case Moved():
                self._document.push(f"Move {event.words}", self._document.project, mark=MoveMark(event))
            case Refused(ticket, _) if ticket and ticket in (self._taking_back, self._doing_again):
                pass  # the lesson of the pick is over; whoever asked for it undoes or redoes the examples
            case Failed():
                pass  # the canvas says it, for as long as it is so
            case Refused(_, message) | Interrupted(message):
                self.told.emit(message)
        self.event_came.emit(event)

    def _apply(self, edit: Edit) -> None:
        """Do to the document what the session has done to its copy."""
        self._applied += 1
        self._taking = True
        try:
            self._apply_one(edit)
        except UnderstudyError as error:
            self.told.emit(f"what was just taught could not be kept: {error}")
            self.send(UseProject(self._document.project, self._applied))
        finally:
            self._taking = False

    def _apply_one(self, edit: Edit) -> None:
        document = self._document
        match edit:
            case Picked(recorded):
                self._picks.append(recorded)
                asked, self._doing_again = self._doing_again, 0
                if asked and _is_pick(document.history.next, recorded):
                    self._taken_back = self._taken_back[:-1]
                    document.redo()
                    self.send(UseProject(document.project, self._applied))
                else:
                    self._taken_back = []
                    text = describe(record_pick, document.project, recorded)
                    document.push(text, edited(document.project, edit), mark=PickMark(recorded))
            case TakenBack(recorded):
                self._picks = [pick for pick in self._picks if pick != recorded]
                self._taking_back = 0
                if _is_pick(document.history.last, recorded):
                    self._taken_back.append(recorded)
                    document.undo()
                    self.send(UseProject(document.project, self._applied))
                else:
                    document.push("Take back a pick", edited(document.project, edit))
            case Relearned():
                document.amend(lambda project: edited(project, edit))

    def can_take_back(self, mark: object) -> bool:
        """Whether the session can undo the pick of a step, putting the node back as well."""
        return isinstance(mark, PickMark) and bool(self._picks) and self._picks[-1] == mark.recorded

    def take_back(self) -> int:
        """Have the session undo its last pick; returns the ticket. Only whoever asked hears of a refusal."""
        self._taking_back = self.send(UndoPick())
        return self._taking_back

    def forget_picks(self) -> None:
        """From now on picks are undone as examples only: their lesson is over."""
        self._picks, self._taking_back = [], 0
        self.forget_taken_back()

    def can_do_again(self, mark: object) -> bool:
        """Whether the session can do the pick of a step again, and let its node do what it did then."""
        return isinstance(mark, PickMark) and self._taken_back[-1:] == [mark.recorded]

    def do_again(self) -> int:
        """Have the session do again the pick that it took back last; returns the ticket. As for `take_back`."""
        self._doing_again = self.send(RedoPick())
        return self._doing_again

    def forget_taken_back(self) -> None:
        """From now on, of picks that were taken back only the examples come back."""
        self._taken_back, self._doing_again = [], 0

    def undo_move(self, mark: MoveMark) -> None:
        """Put back what was moved."""
        self.send(UndoMove(mark.moved.number))

    def _project_changed(self, _before: Project, after: Project) -> None:
        if not self._taking:
            self.send(UseProject(after, self._applied))


def _is_pick(step: Step | None, recorded: Recorded) -> bool:
    return step is not None and step.mark == PickMark(recorded)


def _mode(snapshot: Snapshot) -> object:
    plan = None if snapshot.lesson is None else snapshot.lesson.plan
    return snapshot.mode, snapshot.speed, snapshot.failure, plan, snapshot.tick > snapshot.earliest
