"""The session: a world, its nodes, and a lesson; commands in, snapshots and events out, no threads and no clock.

Its caller owns the project. The session keeps a copy, applies what it records to that copy at once, and reports the
same edits as events for the caller to make undoable.
"""

from collections.abc import Mapping
from dataclasses import replace
from functools import singledispatchmethod
from math import isfinite

from ..core.actor import Actor
from ..core.errors import SessionError, UnderstudyError
from ..core.machine_state import rebase
from ..core.project import Project, Value
from ..sim.engine import Control, Engine
from ..sim.engines import AUTO, COMPILED, REFERENCE
from ..sim.scenario import Scenario
from .acts import Act
from .carrying_over import EditLog, arm_now, losses
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
    Watch,
)
from .compiling import KernelCompiler
from .directing import direct_roots
from .learning import Answer, InlineLearner, Learner, Question
from .lesson import Lesson
from .models import Models
from .place import place_of
from .runs import Treatment, start_engine, treatment
from .snapshots import (
    Edit,
    Event,
    Interrupted,
    Mode,
    Picked,
    Refused,
    Relearned,
    Snapshot,
    TakenBack,
    Watched,
    edited,
    views,
)
from .watching import watched

#: Nobody is taught, and nobody has to be told who leaves a state.
UNOBSERVED = Control(listen=False)


class Session:
    """Obeys commands and passes ticks.

    Attributes:
        project: The session's copy.
        revision: Grows with every change of that copy.
        speed: As in `Play`; 0 when paused.
        due: Ticks that `Step` asked for and that have not passed yet.
    """

    def __init__(
        self,
        project: Project,
        scenario: Scenario,
        arm: str,
        seed: int = 1,
        learner: Learner | None = None,
        settings: Mapping[str, Value] | None = None,
        compiler: KernelCompiler | None = None,
    ) -> None:
        """Begin with *arm*, its roots running its top behavior, paused.

        Args:
            settings: As in `UseArm`.
            compiler: Compiles the scenario's kernel beside the session; without one, the session does so itself.

        Raises:
            UnderstudyError: The arm does not exist or cannot run.
        """
        self.project = project
        self.revision = 0
        self.speed: float | None = 0.0
        self.due = 0
        self._scenario = scenario
        self._learner = learner or InlineLearner()
        self._compiler = compiler
        self._models = Models(scenario.vocabulary)
        self._models.use(project)
        self._tickets = 0
        self._events: list[Event] = []
        self._log = EditLog()
        self._lesson: Lesson | None = None
        self._waits_for: Question | None = None
        self._asked_by = 0
        self._failure = ""
        self._settings = settings or {}
        self._seed = seed
        self._treatment = self._treat(arm, self._settings)
        self._engine: Engine = self._start(self._treatment, seed)
        self._columns = self._engine.columns()
        self._place = place_of(self._engine, arm)
        self._watch: tuple[str, ...] = ()

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

    def settle(self) -> None:
        """Take in models that were learned meanwhile, and a kernel that was compiled."""
        if self._compiler is not None and self._treatment.engine == AUTO:
            self._engine = self._compiler.compiled(self._engine)
            if self._lesson is not None:
                self._lesson.engine = self._engine
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

    @property
    def acknowledged(self) -> int:
        """The last ticket that was dealt with."""
        return self._tickets

    def fail(self, message: str) -> None:
        """Stop the world and say why; the project is untouched."""
        self._failure = message
        self.speed, self.due = 0.0, 0
        self._refuse(f"{message}. The world stands still; reset it to go on.")

    def snapshot(self) -> Snapshot:
        """The session as it is now; of a world that cannot be shown, the last that could."""
        engine = self._engine
        try:
            self._columns = engine.columns()
        except UnderstudyError as error:
            if not self._failure:
                self.fail(str(error))
        return Snapshot(
            acknowledged=self._tickets,
            tick=engine.tick,
            revision=self.revision,
            mode=self.mode,
            speed=self.speed if self.due == 0 else 1.0,
            seed=self._seed,
            arm=self._treatment.arm.name,
            columns=self._columns,
            place=self._place,
            doing=engine.doing(),
            measures=engine.measures(),
            taught=self._lesson.taught if self._lesson else frozenset(),
            watched=self._watched(),
            engine=COMPILED if engine.compiled else REFERENCE,
            notice=engine.obstacle,
            failure=self._failure,
            lesson=self._lesson.view() if self._lesson else None,
        )

    def _watched(self) -> Mapping[str, Watched]:
        there = [node_id for node_id in self._watch if node_id in self._place.rows]
        return watched(self._engine, there) if there else {}

    def close(self) -> None:
        """End what runs beside the session."""
        self._learner.close()
        if self._compiler is not None:
            self._compiler.close()

    def _refuse(self, why: object) -> None:
        self._events.append(Refused(self._tickets, str(why)))

    # ------------------------------------------------------------------------------------------- time

    def pass_ticks(self, ticks: int) -> None:
        """Pass ticks, unless a lesson waits for what it learns, or the world has failed."""
        if self._waits_for is not None or self._failure or ticks < 1:
            return
        first = self._engine.tick
        try:
            self._engine.step(ticks, UNOBSERVED if self._lesson is None else self._lesson.control)
        except UnderstudyError as error:
            self.fail(str(error))
        if self._lesson is not None:
            self._lesson.ticked()
        self.due = max(0, self.due - (self._engine.tick - first))

    def _leaving(self, actor: Actor, state: str) -> None:
        if self._lesson is not None:
            self._lesson.leaving(actor, state)

    # --------------------------------------------------------------------------------------- commands

    @singledispatchmethod
    def _obey(self, command: object) -> None:
        raise SessionError(f"{type(command).__name__} is not a command")

    @_obey.register
    def _(self, command: UseProject) -> None:
        project, lost = self._log.on_top(command.project, command.applied)
        self._use(project)
        self._events += [Interrupted(f"what was just taught could not be kept: {why}") for why in lost]

    @_obey.register
    def _(self, command: UseArm) -> None:
        of = self._treat(command.arm, command.settings)
        self._begin(self._start(of, self._seed), of, None)
        self._settings = command.settings
        self._waits_for = None

    @_obey.register
    def _(self, command: Reset) -> None:
        seed = self._seed if command.seed is None else command.seed
        of = self._treat(self._treatment.arm.name, self._settings)
        engine = self._start(of, seed, idle=self._lesson is not None)
        lesson = None
        if self._lesson is not None:
            lesson = Lesson(engine, of, self._lesson.plan, self._lesson.acts)
            if self._lesson.testing:
                lesson.test()
        self._begin(engine, of, lesson)
        self._seed = seed

    @_obey.register
    def _(self, _: RunArm) -> None:
        direct_roots(self._engine.machine, self._treatment.arm)
        self._lesson, self._waits_for = None, None

    @_obey.register
    def _(self, command: Teach) -> None:
        self._lesson = Lesson(self._engine, self._treatment, command)
        self._waits_for = None

    @_obey.register
    def _(self, command: Pick) -> None:
        lesson = self._taught()
        self._do(lesson, lesson.pick(self._without_waiting(command.node), command.node, command.choice))

    @_obey.register
    def _(self, command: ShouldNotHaveLeft) -> None:
        lesson = self._taught()
        self._do(lesson, lesson.should_not_have_left(self._without_waiting(command.node), command.node))

    @_obey.register
    def _(self, _: UndoPick) -> None:
        self._change(TakenBack(self._taught().undo().recorded))

    @_obey.register
    def _(self, _: Test) -> None:
        self._taught()
        self._asked_by = self._tickets
        self._ask()

    @_obey.register
    def _(self, command: Play) -> None:
        self._refuse_failed()
        if command.speed is not None and not (command.speed > 0 and isfinite(command.speed)):
            raise SessionError(
                f"the speed is {command.speed}; allowed: above 0 (1 is 60 ticks a second), or none for as fast as it can"
            )
        self.speed, self.due = command.speed, 0

    @_obey.register
    def _(self, _: Pause) -> None:
        self.speed, self.due = 0.0, 0

    @_obey.register
    def _(self, command: Step) -> None:
        self._refuse_failed()
        if command.ticks < 1:
            raise SessionError(f"a step is of 1 tick or more, but it is {command.ticks}")
        self.speed, self.due = 0.0, self.due + command.ticks

    @_obey.register
    def _(self, command: MoveEntity) -> None:
        self._engine.move(command.entity, command.x, command.y)

    @_obey.register
    def _(self, command: Watch) -> None:
        self._watch = tuple(dict.fromkeys(command.nodes))

    def _refuse_failed(self) -> None:
        if self._failure:
            raise SessionError(f"the world stands still: {self._failure}. Reset it to go on")

    def _start(self, of: Treatment, seed: int, *, idle: bool = False) -> Engine:
        start = start_engine if self._compiler is None else self._compiler.start
        return start(of, seed, self._leaving, idle=idle)

    def _begin(self, engine: Engine, of: Treatment, lesson: Lesson | None) -> None:
        """Go on in another world, in which nothing can fail any more."""
        self._columns, self._place = engine.columns(), place_of(engine, of.arm.name)
        self._engine, self._treatment, self._lesson, self._failure = engine, of, lesson, ""
        self.due = 0

    # ------------------------------------------------------------------------------------------ the lesson

    def _taught(self) -> Lesson:
        if self._lesson is None:
            raise SessionError("nothing is being taught; choose a behavior and an agent to teach first")
        return self._lesson

    def _without_waiting(self, node_id: str) -> Project:
        """The project without what picks recorded that are to be replaced."""
        project = self.project
        for act in self._taught().waiting(node_id):
            project = edited(project, TakenBack(act.recorded))
        return project

    def _do(self, lesson: Lesson, act: Act) -> None:
        replaced = [TakenBack(old.recorded) for old in lesson.waiting(act.node)]
        edited(self._without_waiting(act.node), Picked(act.recorded))  # raises before anything has changed
        lesson.add(act)
        self._change(*replaced, Picked(act.recorded))

    # ----------------------------------------------------------------------------------------- the project

    def _treat(self, arm: str, settings: Mapping[str, Value]) -> Treatment:
        return treatment(
            self.project,
            self._scenario,
            self.project.arm(arm),
            settings,
            classifiers=self._models.classifiers,
        )

    def _change(self, *edits: Edit) -> None:
        """Make edits of the session's own, at once, and report them."""
        project = self.project
        for edit in edits:
            project = edited(project, edit)
            self._log.add(edit)
        self._events += edits
        self._use(project)

    def _use(self, project: Project) -> None:
        """Go on with another value of the project, every node in the same place as far as that still exists."""
        old, self.project = self.project, project
        self.revision += 1
        arm = arm_now(self._treatment.arm, old, project)
        self._treatment = replace(self._treatment, project=project, arm=arm)
        if self._lesson is not None:
            self._lesson.treatment = self._treatment
        if project.libraries is old.libraries and project.types is old.types:
            return  # only examples have changed: nobody does anything else
        self._models.use(project)
        try:
            self._rebase()
        except UnderstudyError as error:
            self.fail(f"the world cannot go on with the changed project: {error}")

    def _rebase(self) -> None:
        machine, types = self._engine.machine, self.project.types_with(self._scenario.vocabulary)
        before = views(machine)
        rebase(machine, types, self._models.classifiers)
        self._events += [Interrupted(loss) for loss in losses(before, views(machine))]
        if self._lesson is not None:
            try:
                self._events += [Interrupted(lost) for lost in self._lesson.project_changed()]
            except UnderstudyError as error:
                self._lesson, self._waits_for = None, None
                self.speed, self.due = 0.0, 0
                self._events.append(Interrupted(f"the lesson is over: {error}"))

    # -------------------------------------------------------------------------------------------- learning

    def _ask(self) -> None:
        plan, vocabulary = self._taught().plan, self._scenario.vocabulary
        question = Question(self.revision, self.project, vocabulary, plan.type, plan.automaton)
        self._learner.ask(question)
        self._waits_for = question

    def _take(self, answer: Answer) -> None:
        """Use what was learned, unless the project has changed meanwhile: then learn again."""
        if self._lesson is None or answer.question is not self._waits_for:
            return
        if answer.question.revision != self.revision:
            self._ask()
            return
        self._waits_for = None
        if answer.learned is None:
            self._events.append(Refused(self._asked_by, answer.problem))
            return
        self._change(Relearned(answer.learned))
        if self._lesson is not None:  # it would be over if it could not go on
            self._lesson.test()
