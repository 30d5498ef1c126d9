"""The session: a world, its nodes, and a lesson; commands in, snapshots and events out, no threads and no clock.

Its caller owns the project. The session keeps a copy, applies what it records to that copy at once, and reports the
same edits as events for the caller to make undoable.
"""

from collections.abc import Callable, Mapping
from functools import singledispatchmethod

from ..core.actor import Actor
from ..core.edits.examples import Recorded, record_pick, take_back_pick
from ..core.errors import SessionError, UnderstudyError
from ..core.machine_state import rebase
from ..core.project import Project
from ..learner.trainer import apply, classifiers
from ..sim.engine import FREE, Engine
from ..sim.scenario import Scenario
from .commands import (
    Command,
    MoveEntity,
    Pause,
    Pick,
    Play,
    Reset,
    RunArm,
    ShouldNotHaveLeft,
    Step,
    Teach,
    Test,
    UndoPick,
    UseArm,
    UseProject,
)
from .learning import Answer, InlineLearner, Learner, Question
from .lesson import Lesson
from .runs import Treatment, start_engine, treatment
from .snapshots import Event, Mode, NodeView, Picked, Refused, Relearned, Snapshot, TakenBack, view


class Session:
    """Obeys commands and passes ticks.

    Attributes:
        project: The session's copy.
        revision: Grows with every change of that copy.
        speed: As in `Play`; 0 when paused.
        due: Ticks that `Step` asked for and that have not passed yet.
    """

    def __init__(
        self, project: Project, scenario: Scenario, arm: str, seed: int = 1, learner: Learner | None = None
    ) -> None:
        """Begin with *arm*, its roots running its top behavior, paused.

        Raises:
            UnderstudyError: The arm does not exist or cannot run.
        """
        self.project = project
        self.revision = 0
        self.speed: float | None = 0.0
        self.due = 0
        self._scenario = scenario
        self._seed = seed
        self._learner = learner or InlineLearner()
        self._tickets = 0
        self._events: list[Event] = []
        self._lesson: Lesson | None = None
        self._waits_for: Question | None = None
        self._failure = ""
        self._treatment = self._treat(arm)
        self._engine: Engine
        self._begin()

    # ------------------------------------------------------------------------------------- in and out

    def send(self, command: Command) -> int:
        """Obey a command now; returns its ticket. What cannot be obeyed changes nothing and is reported as an event."""
        self._tickets += 1
        try:
            self._obey(command)
        except UnderstudyError as error:
            self._events.append(Refused(self._tickets, str(error)))
        return self._tickets

    def advance(self, ticks: int = 1) -> Snapshot:
        """Take in what was learned, pass ticks, and show what has become of it."""
        self.settle()
        self._pass(ticks)
        return self.snapshot()

    def settle(self) -> None:
        """Take in models that were learned meanwhile."""
        for answer in self._learner.answers():
            self._take(answer)

    def events(self) -> list[Event]:
        """What happened since the last call, in order."""
        events, self._events = self._events, []
        return events

    @property
    def playing(self) -> bool:
        """Whether time is to pass. It stands still while a lesson waits for what it learns, and after a failure."""
        return (self.speed != 0.0 or self.due > 0) and self._waits_for is None and not self._failure

    @property
    def mode(self) -> Mode:
        """What the session is for at the moment."""
        if self._waits_for is not None:
            return Mode.LEARNING
        if self._lesson is None:
            return Mode.RUNNING
        return Mode.TESTING if self._lesson.testing else Mode.TEACHING

    @property
    def tick(self) -> int:
        """The tick that comes next."""
        return self._engine.tick

    def fail(self, message: str) -> None:
        """Stop the world and say why; the project is untouched."""
        self._failure = message
        self.speed, self.due = 0.0, 0
        self._events.append(Refused(self._tickets, f"{message}. The world stands still; reset it to go on."))

    def snapshot(self) -> Snapshot:
        """The session as it is now."""
        engine = self._engine
        return Snapshot(
            acknowledged=self._tickets,
            tick=engine.tick,
            revision=self.revision,
            mode=self.mode,
            speed=self.speed if self.due == 0 else 1.0,
            seed=self._seed,
            arm=self._treatment.arm.name,
            world=engine.frozen_world(),
            nodes=self._views(),
            measures=engine.measures(),
            failure=self._failure,
        )

    def close(self) -> None:
        """End what runs beside the session."""
        self._learner.close()

    def _views(self) -> Mapping[str, NodeView]:
        taught = self._lesson.taught if self._lesson else frozenset()
        return {
            node_id: view(actor, taught=node_id in taught)
            for node_id, actor in self._engine.machine.actors.items()
        }

    # ------------------------------------------------------------------------------------------- time

    def _pass(self, ticks: int) -> None:
        if self._waits_for is not None or self._failure:
            return
        try:
            if self._lesson is None:
                self._engine.step(ticks, FREE)
            else:
                for _ in range(ticks):
                    self._engine.step(1, self._lesson.control)
                    self._lesson.ticked()
        except UnderstudyError as error:
            self.fail(str(error))
        self.due = max(0, self.due - ticks)

    def _begin(self, *, idle: bool = False) -> None:
        self._lesson, self._waits_for, self._failure = None, None, ""
        self._engine = start_engine(self._treatment, self._seed, self._leaving, idle=idle)

    def _leaving(self, actor: Actor, state: str) -> None:
        if self._lesson is not None:
            self._lesson.leaving(actor, state)

    def _treat(self, arm: str, settings: Mapping[str, float | int | str | bool] | None = None) -> Treatment:
        models = classifiers(self.project, self._scenario.vocabulary)
        return treatment(self.project, self._scenario, self.project.arm(arm), settings, classifiers=models)

    # --------------------------------------------------------------------------------------- commands

    @singledispatchmethod
    def _obey(self, command: object) -> None:
        raise SessionError(f"{type(command).__name__} is not a command")

    @_obey.register
    def _(self, command: UseProject) -> None:
        self._use(command.project)

    @_obey.register
    def _(self, command: UseArm) -> None:
        self._treatment = self._treat(command.arm, command.settings)
        self._begin()

    @_obey.register
    def _(self, command: Reset) -> None:
        plan = self._lesson.plan if self._lesson else None
        self._seed = self._seed if command.seed is None else command.seed
        self._begin(idle=plan is not None)
        if plan is not None:
            self._lesson = Lesson(self._engine, self._treatment, plan)

    @_obey.register
    def _(self, _: RunArm) -> None:
        self._lesson, self._waits_for = None, None
        for root in self._treatment.arm.forest().roots:
            self._engine.machine.direct(root.id, self._treatment.arm.top)

    @_obey.register
    def _(self, command: Teach) -> None:
        self._lesson = Lesson(self._engine, self._treatment, command)
        self._waits_for = None

    @_obey.register
    def _(self, command: Pick) -> None:
        lesson = self._taught()
        lesson.check_pick(self.project, command.node, command.choice)
        for act in lesson.retract(command.node):
            self._take_back(act.recorded)
        self._record(lesson.pick(self.project, command.node, command.choice))

    @_obey.register
    def _(self, command: ShouldNotHaveLeft) -> None:
        lesson = self._taught()
        for act in lesson.retract(command.node):
            self._take_back(act.recorded)
        self._record(lesson.should_not_have_left(self.project, command.node))

    @_obey.register
    def _(self, _: UndoPick) -> None:
        self._take_back(self._taught().undo().recorded)

    @_obey.register
    def _(self, _: Test) -> None:
        self._taught()
        self._ask()

    @_obey.register
    def _(self, command: Play) -> None:
        if command.speed is not None and not command.speed > 0:
            raise SessionError(f"a speed is above 0 (1 is 60 ticks a second), but it is {command.speed}")
        self.speed = command.speed

    @_obey.register
    def _(self, _: Pause) -> None:
        self.speed, self.due = 0.0, 0

    @_obey.register
    def _(self, command: Step) -> None:
        if command.ticks < 1:
            raise SessionError(f"a step is of 1 tick or more, but it is {command.ticks}")
        self.speed, self.due = 0.0, self.due + command.ticks

    @_obey.register
    def _(self, command: MoveEntity) -> None:
        self._engine.move(command.entity, command.x, command.y)

    # ----------------------------------------------------------------------------------------- the project

    def _taught(self) -> Lesson:
        if self._lesson is None:
            raise SessionError("nothing is being taught; choose a behavior and an agent to teach first")
        return self._lesson

    def _record(self, recorded: Recorded) -> None:
        self._use(record_pick(self.project, recorded))
        self._events.append(Picked(recorded))

    def _take_back(self, recorded: Recorded) -> None:
        self._use(take_back_pick(self.project, recorded))
        self._events.append(TakenBack(recorded))

    def _use(self, project: Project) -> None:
        """Go on with another value of the project, every node in the same place as far as that still exists."""
        self.project = project
        self.revision += 1
        self._treatment = self._refreshed(project)
        rebase(
            self._engine.machine, project.types_with(self._scenario.vocabulary), self._treatment.classifiers
        )

    def _refreshed(self, project: Project) -> Treatment:
        old = self._treatment
        models = classifiers(project, self._scenario.vocabulary)
        return Treatment(project, self._scenario, old.arm, old.parameters, old.physics, models)

    # -------------------------------------------------------------------------------------------- learning

    def _ask(self) -> None:
        plan = self._taught().plan
        self._waits_for = Question(
            self.revision, self.project, self._scenario.vocabulary, plan.type, plan.automaton
        )
        self._learner.ask(self._waits_for)

    def _take(self, answer: Answer) -> None:
        """Use what was learned, unless the project has changed meanwhile: then learn again."""
        if self._waits_for is None or self._lesson is None:
            return
        if answer.question.revision != self.revision:
            self._ask()
            return
        self._waits_for = None
        if answer.learned is None:
            self._events.append(Refused(self._tickets, answer.problem))
            return
        self._use(apply(self.project, answer.learned))
        self._events.append(Relearned(answer.learned))
        self._lesson.test()


#: Makes the session for a thread, given what wakes that thread up.
MakeSession = Callable[[Callable[[], None]], Session]
