"""The session: a world, its nodes, and a lesson; commands in, snapshots and events out, no threads and no clock.

Its caller owns the project. The session keeps a copy, applies what it records to that copy at once, and reports the
same edits as events for the caller to make undoable.
"""

from collections.abc import Mapping
from dataclasses import replace
from functools import singledispatchmethod

from ..core.errors import SessionError, UnderstudyError
from ..core.project import Pick as DemonstratedAct
from ..sim.engines import COMPILED, REFERENCE
from .commands import (
    AskMe,
    Command,
    GoTo,
    LetGo,
    MoveEntities,
    Others,
    Pause,
    Pick,
    Play,
    RedoMove,
    RedoPick,
    Reset,
    RunArm,
    ShouldNotHaveLeft,
    Step,
    StopAt,
    Teach,
    Test,
    UndoMove,
    UndoPick,
    UseArm,
    UseProject,
    Watch,
)
from .course import Course
from .directing import direct_roots
from .lesson import Lesson
from .snapshots import Event, Interrupted, Mode, Picked, Snapshot, TakenBack, Watched, edited
from .watching import watched


class Session(Course):
    """Obeys commands and passes ticks.

    Attributes:
        project: The session's copy.
        revision: Grows with every change of that copy.
    """

    # ------------------------------------------------------------------------------------- in and out

    def send(self, command: Command) -> int:
        """Obey a command now; returns its ticket. What cannot be obeyed changes nothing and is reported as an event."""
        self._tickets += 1
        try:
            self._obey(command)
        except UnderstudyError as error:
            self._refuse(error)
        return self._tickets

    def advance(self, ticks: int = 1) -> Snapshot:
        """Take in what was learned, pass ticks, and show what has become of it."""
        self.settle()
        self.pass_ticks(ticks)
        return self.snapshot()

    def events(self) -> list[Event]:
        """What happened since the last call, in order."""
        events, self._events = self._events, []
        return events

    @property
    def mode(self) -> Mode:
        """What the session is for at the moment."""
        if self._waits_for is not None:
            return Mode.LEARNING
        if self._lesson is None:
            return Mode.RUNNING
        return Mode.TESTING if self._lesson.testing else Mode.TEACHING

    @property
    def acknowledged(self) -> int:
        """The last ticket that was dealt with."""
        return self._tickets

    def snapshot(self) -> Snapshot:
        """The session as it is now; of a world that cannot be shown, the last that could."""
        world, engine = self._world, self._world.engine
        try:
            world.columns()
        except UnderstudyError as error:
            if not world.failure:
                self.fail(str(error))
        return Snapshot(
            acknowledged=self._tickets,
            tick=engine.tick,
            revision=self.revision,
            mode=self.mode,
            speed=self._clock.shown,
            seed=world.seed,
            arm=world.treatment.arm.name,
            columns=world.shown,
            place=world.place,
            doing=engine.doing(),
            measures=engine.measures(),
            taught=self._lesson.taught if self._lesson else frozenset(),
            watched=self._watched(),
            engine=COMPILED if engine.compiled else REFERENCE,
            notice=engine.obstacle,
            failure=world.failure,
            lesson=replace(self._lesson.view(), obstacle=self._transcript.obstacle) if self._lesson else None,
            asked=self._asked,
            going_to=self._clock.going_to,
            stops_at=None if self._clock.stops_in is None else engine.tick + self._clock.stops_in,
            earliest=world.earliest,
        )

    def _watched(self) -> Mapping[str, Watched]:
        there = [node_id for node_id in self._watch if node_id in self._world.place.rows]
        return watched(self._world.engine, there) if there else {}

    # --------------------------------------------------------------------------------------- commands

    @singledispatchmethod
    def _obey(self, command: object) -> None:
        raise SessionError(f"{type(command).__name__} is not a command")

    @_obey.register
    def _(self, command: UseProject) -> None:
        before = self.project
        project, lost = self._log.on_top(command.project, command.applied)
        self._transcript.changed(before, project, self.tick, runs=self._runs_taught)
        if self._lesson is not None:
            self._lesson.project_edited(before, project)
        self._use(project)
        self._reconsider()
        self._events += [Interrupted(f"what was just taught could not be kept: {why}") for why in lost]

    @_obey.register
    def _(self, command: UseArm) -> None:
        of = self._treat(command.arm, command.settings)
        self._begin(self._start(of, self._world.seed), of, self._world.seed, None)
        self._settings = command.settings
        self._transcript.begin(command.arm, self._world.seed, command.settings)

    @_obey.register
    def _(self, command: Reset) -> None:
        seed = self._world.seed if command.seed is None else command.seed
        of = self._treat(self._world.treatment.arm.name, self._settings)
        engine = self._start(of, seed, idle=self._lesson is not None)
        lesson = None
        if self._lesson is not None:
            lesson = Lesson(engine, of, self._lesson.plan, self._lesson.acts)
            if self._lesson.testing:
                lesson.test()
        self._begin(engine, of, seed, lesson, self._waits_for)
        self._transcribe_anew(lesson)

    def _transcribe_anew(self, lesson: Lesson | None) -> None:
        """Another world has begun; in one that begins with a lesson, others have nothing to do, unlike in a demonstration."""
        transcript, world = self._transcript, self._world
        transcript.begin(world.treatment.arm.name, world.seed, self._settings)
        if lesson is not None:
            transcript.spoil(
                "the world was begun again in the middle of the lesson. End it, reset, and teach again"
            )
            transcript.teach(lesson.plan, self.tick)

    @_obey.register
    def _(self, _: RunArm) -> None:
        direct_roots(self._world.engine.machine, self._world.treatment.arm)
        self._enter(None)

    @_obey.register
    def _(self, command: Teach) -> None:
        self._enter(Lesson(self._world.engine, self._world.treatment, command))
        self._transcript.teach(command, self.tick)

    @_obey.register
    def _(self, command: Pick) -> None:
        lesson, node = self._taught(), command.node
        act = lesson.pick(self._without_waiting(node), node, command.choice)
        hand_back = lesson.testing and (command.hand_back or self._asks_about(node))
        self._do(lesson, act)
        if hand_back:
            self._answered.add(node)
        self._noted(lesson, act, act.goal, "pick", answers=hand_back)

    @_obey.register
    def _(self, command: ShouldNotHaveLeft) -> None:
        lesson, node = self._taught(), command.node
        act, asked = lesson.should_not_have_left(self._without_waiting(node), node), self._asks_about(node)
        self._do(lesson, act)
        self._noted(lesson, act, "", "should not have left", answers=asked)

    @_obey.register
    def _(self, _: UndoPick) -> None:
        lesson = self._taught()
        recorded = lesson.undo().recorded
        self._change(TakenBack(recorded))
        self._reconsider()
        taught = self.project.library(recorded.type).automata.get(recorded.automaton)
        removes = recorded.state is not None and not (taught and taught.has_state(recorded.state.id))
        self._transcript.undo(self.tick, learning=self._will_test(lesson), removes=removes)
        self._tell_demonstrated()

    @_obey.register
    def _(self, _: RedoPick) -> None:
        lesson = self._taught()
        act = lesson.undone()
        edited(self.project, Picked(act.recorded))  # raises before anything has changed
        self._change(Picked(act.recorded))
        lesson.redo()
        if not act.done and self._asks_about(act.node):
            self._answered.add(act.node)
            self._close_question()
        self._reconsider()
        self._transcript.redo(self.tick, learning=self._will_test(lesson), waits=not act.done)
        self._tell_demonstrated()

    @_obey.register
    def _(self, _: Test) -> None:
        self._taught()
        self._asked_by = self._tickets
        self._close_question()
        self._learn()
        self._transcript.test(self.tick)

    @_obey.register
    def _(self, command: AskMe) -> None:
        self._asking.wish(command)
        if not self._ask_again():
            self._close_question()

    @_obey.register
    def _(self, _: LetGo) -> None:
        if self._asked is None:
            raise SessionError("nothing is asked now, so there is nothing to let go")
        self._asking.let_go(self._world.engine, self._taught(), self._asked.node)
        self._close_question()

    @_obey.register
    def _(self, command: Play) -> None:
        self._refuse_standing()
        self._clock.play(command.speed)

    @_obey.register
    def _(self, _: Pause) -> None:
        self._clock.pause()

    @_obey.register
    def _(self, command: StopAt) -> None:
        self._clock.stop_in(None if command.tick is None else command.tick - self.tick)

    @_obey.register
    def _(self, command: Step) -> None:
        self._refuse_standing()
        self._clock.step(command.ticks)

    @_obey.register
    def _(self, command: GoTo) -> None:
        if self._lesson is not None:
            raise SessionError(
                "a lesson cannot be gone back in: what was taught belongs to its own ticks. Run the arm first"
            )
        if command.tick < 0:
            raise SessionError(f"there is no tick {command.tick}; the first is 0")
        back = command.tick < self.tick
        self._world.go_near(command.tick)
        if back:
            self._transcript.go_back()
        self._clock.go(command.tick, command.tick - self.tick)

    @_obey.register
    def _(self, command: MoveEntities) -> None:
        self._refuse_failed()
        moved, tick = self._world.move(command.to), self.tick
        self._events.append(moved)
        acts = [
            DemonstratedAct(tick, "", act="move", entity=entity, x=x, y=y)
            for entity, (x, y) in command.to.items()
        ]
        self._transcript.move(moved.number, acts, learning=self._learns)
        self._touched()

    @_obey.register
    def _(self, command: UndoMove) -> None:
        self._refuse_failed()
        self._world.undo_move(command.number)
        self._transcript.undo_move(command.number, self.tick)
        self._touched()

    @_obey.register
    def _(self, command: RedoMove) -> None:
        self._refuse_failed()
        self._world.redo_move(command.number)
        self._transcript.redo_move(command.number, self.tick, learning=self._learns)
        self._touched()

    @_obey.register
    def _(self, command: Watch) -> None:
        self._watch = tuple(dict.fromkeys(command.nodes))

    def _asks_about(self, node_id: str) -> bool:
        return self._asked is not None and self._asked.node == node_id

    @property
    def _learns(self) -> bool:
        """Whether a lesson's test waits for what it learns."""
        return self._lesson is not None and self._will_test(self._lesson)

    @property
    def _runs_taught(self) -> bool:
        """Whether somebody runs what is taught, so that it matters when it is learned."""
        lesson = self._lesson
        return lesson is not None and (lesson.testing or lesson.plan.others is Others.RUN)

    def _touched(self) -> None:
        """The world was changed by hand: a journey ends here, and a question may be another."""
        self._clock.stop_going()
        self._reconsider()

    def _refuse_failed(self) -> None:
        if self._world.failure:
            raise SessionError(f"the world stands still: {self._world.failure}. Reset it to go on")

    def _refuse_standing(self) -> None:
        self._refuse_failed()
        if self._asked is not None:
            raise SessionError(
                f"{self._asked.reason}. Pick what it is to do, or let it decide by itself; then time goes on"
            )
