"""How a session goes on: its project, world, time and lesson, which change together; commands are in `session.py`."""

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace

from ..core.actor import Actor
from ..core.errors import SessionError, UnderstudyError
from ..core.machine_state import rebase
from ..core.project import Pick as DemonstratedAct
from ..core.project import Project, Value
from ..sim.engine import Control, Engine
from ..sim.engines import AUTO
from ..sim.scenario import Scenario
from .acts import Act
from .ask import Asking
from .carrying_over import EditLog, LeftOff, arm_now, losses
from .clock import Clock
from .compiling import KernelCompiler
from .directing import direct_roots
from .learning import Answer, InlineLearner, Learner, Question
from .lesson import Lesson
from .live_world import LiveWorld
from .models import Models
from .plan import deleted
from .runs import Treatment, start_engine, treatment
from .snapshots import (
    Asked,
    Demonstrated,
    Edit,
    Event,
    Failed,
    Interrupted,
    Picked,
    Refused,
    Relearned,
    TakenBack,
    edited,
)
from .transcript import Transcript

#: Nobody is taught, and nobody has to be told who leaves a state.
UNOBSERVED = Control(listen=False)


class Course:
    """What goes on in a session.

    Attributes:
        project: The session's copy.
        revision: Grows with every change of that copy.
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
        self._scenario = scenario
        self._learner = learner or InlineLearner()
        self._compiler = compiler
        self._models = Models(scenario.vocabulary)
        self._models.use(project)
        self._tickets = 0
        self._events: list[Event] = []
        self._log = EditLog()
        self._left_off = LeftOff()
        self._lesson: Lesson | None = None
        self._waits_for: Question | None = None
        self._asked_by = 0
        self._asking = Asking(scenario.vocabulary)
        self._asked: Asked | None = None
        self._answered: set[str] = set()
        self._watch: tuple[str, ...] = ()
        self._settings = settings or {}
        self._transcript = Transcript(arm, seed, self._settings)
        self._clock = Clock()
        of = self._treat(arm, self._settings)
        self._world = LiveWorld(self._start(of, seed), of, seed)
        self._world.run_free()

    def close(self) -> None:
        """End what runs beside the session."""
        self._learner.close()
        if self._compiler is not None:
            self._compiler.close()

    def _refuse(self, why: object) -> None:
        self._events.append(Refused(self._tickets, str(why)))

    # ------------------------------------------------------------------------------------------- time

    @property
    def playing(self) -> bool:
        """Whether time is to pass; not while a lesson waits for what it learns or for an answer, nor after a failure."""
        return self._clock.running and not self._stands_still

    @property
    def _stands_still(self) -> bool:
        return self._waits_for is not None or self._asked is not None or bool(self._world.failure)

    @property
    def speed(self) -> float | None:
        """As in `Play`; 0 when paused."""
        return self._clock.speed

    @property
    def due(self) -> int:
        """Ticks that were asked for and that have not passed yet."""
        return self._clock.due

    @property
    def tick(self) -> int:
        """The tick that comes next."""
        return self._world.tick

    def fail(self, message: str) -> None:
        """Stop the world and say why; the project is untouched."""
        self._world.failure = message
        self._clock.pause()
        told = f"{message}. The world stands still; reset it to go on."
        self._events.append(Failed(self._tickets, told))

    def settle(self) -> None:
        """Take in models that were learned meanwhile, and a kernel that was compiled."""
        if self._compiler is not None and self._world.treatment.engine == AUTO:
            self._world.engine = self._compiler.compiled(self._world.engine)
            if self._lesson is not None:
                self._lesson.engine = self._world.engine
        for answer in self._learner.answers():
            self._take(answer)

    def pass_ticks(self, ticks: int) -> None:
        """Pass ticks, unless a lesson waits for what it learns or for an answer, or the world has failed."""
        if self._stands_still or ticks < 1:
            return
        try:
            most = self._clock.most
            self._pass(ticks if most is None else min(ticks, most))
        except UnderstudyError as error:
            self.fail(str(error))

    def _pass(self, ticks: int) -> None:
        lesson = self._lesson
        if lesson is None:
            self._step(ticks, UNOBSERVED)
        elif not (self._answered or self._asking.looks_at(self._world.engine, lesson)):
            self._step_lesson(lesson, ticks)
        else:
            while ticks and not self._ask_user(lesson):
                self._step_lesson(lesson, 1)
                ticks -= 1

    def _step_lesson(self, lesson: Lesson, ticks: int) -> None:
        try:
            self._step(ticks, lesson.control)
        finally:
            lesson.ticked()
            for node_id in self._answered:
                lesson.hand_back(node_id)
            self._answered.clear()

    def _step(self, ticks: int, control: Control) -> None:
        first = self.tick
        try:
            self._world.step(ticks, control)
        finally:
            self._clock.passed(self.tick - first)

    def _leaving(self, actor: Actor, state: str) -> None:
        if self._lesson is not None:
            self._lesson.leaving(actor, state)

    # ------------------------------------------------------------------------------------------- beginning

    def _start(self, of: Treatment, seed: int, *, idle: bool = False) -> Engine:
        start = start_engine if self._compiler is None else self._compiler.start
        return start(of, seed, self._leaving, idle=idle)

    def _begin(
        self,
        engine: Engine,
        of: Treatment,
        seed: int,
        lesson: Lesson | None,
        waits_for: Question | None = None,
    ) -> None:
        """Go on in another world, in which nothing can fail any more."""
        self._world = LiveWorld(engine, of, seed, first_move=self._world.next_move)
        self._clock.begin()
        self._enter(lesson, waits_for)

    def _enter(self, lesson: Lesson | None, waits_for: Question | None = None) -> None:
        """Begin a lesson, go on with it in another world, or let nobody be taught."""
        if lesson is None:
            self._transcript.leave()
        self._lesson, self._waits_for = lesson, waits_for
        self._left_off.forget()
        self._answered.clear()
        self._close_question()
        self._clock.stop_going()
        if lesson is None:
            self._world.run_free()
        else:
            self._world.run_taught()

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
        if self._asked is not None and self._asked.node == act.node:
            self._answered.add(act.node)
            self._close_question()

    def _noted(self, lesson: Lesson, act: Act, state: str, kind: str, *, answers: bool) -> None:
        """Remember an act of the hand, for whoever keeps demonstrations."""
        if answers and kind == "pick":
            kind = "answer"
        elif answers:
            self._transcript.spoil("a question was answered by what should not have been left")
        done = DemonstratedAct(self.tick, act.node, state, kind)
        self._transcript.pick(done, learning=self._will_test(lesson), added=act.recorded.state)
        self._tell_demonstrated()

    def _will_test(self, lesson: Lesson) -> bool:
        """Whether a test waits for what it learns."""
        return self._waits_for is not None and not lesson.testing

    def _tell_demonstrated(self) -> None:
        transcript = self._transcript
        self._events.append(Demonstrated(transcript.demonstration(self.project), transcript.obstacle))

    # --------------------------------------------------------------------------------------- asking the user

    def _ask_user(self, lesson: Lesson) -> bool:
        """Whether there is a question about the coming tick; it is asked then, and time stands still."""
        asked = self._asking.question(self._world.engine, lesson, self.project)
        if asked is not None:
            self._clock.hold()
            self._asked = asked
            self._events.append(asked)
        return asked is not None

    def _ask_again(self) -> bool:
        """Whether the question that is open is still one, after something has changed; it may be another by now."""
        if self._asked is None:
            return False
        again = None
        if self._lesson is not None:
            nodes = [self._asked.node]
            again = self._asking.question(self._world.engine, self._lesson, self.project, nodes)
        if again is not None and again != self._asked:
            self._events.append(again)
        self._asked = again
        return again is not None

    def _reconsider(self) -> None:
        """Something has changed by the user's hand: if the question is none any more, time waits for the user."""
        if self._asked is not None and not self._ask_again():
            self._clock.pause()

    def _close_question(self) -> None:
        """Nothing is asked any more: time goes on as before."""
        self._asked = None
        self._clock.resume()

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
        world = self._world
        world.treatment = replace(
            world.treatment, project=project, arm=arm_now(world.treatment.arm, old, project)
        )
        if self._lesson is not None:
            self._lesson.treatment = world.treatment
        if project.libraries is old.libraries and project.types is old.types:
            return  # only examples have changed: nobody does anything else
        self._models.use(project)
        try:
            self._rebase(old)
        except UnderstudyError as error:
            self.fail(f"the world cannot go on with the changed project: {error}")
        world.changed()

    def _rebase(self, old: Project) -> None:
        machine, types = self._world.engine.machine, self.project.types_with(self._scenario.vocabulary)
        did = rebase(machine, types, self._models.classifiers)
        resumed = self._left_off.resume(machine)
        self._left_off.note(did, machine)
        free = self._lesson is None
        begun = self._left_off.begin_instead(machine, self._world.treatment.arm) if free else {}
        lost = [node_id for node_id in did["nodes"] if node_id not in resumed]
        self._events += [Interrupted(loss) for loss in losses(lost, machine, begun)]
        if self._lesson is not None:
            try:
                self._events += [Interrupted(lost) for lost in self._lesson.project_changed()]
            except UnderstudyError as error:
                why = deleted(self._lesson.plan, old, self.project) or error
                self._run_arm()
                self._clock.pause()
                self._events.append(Interrupted(f"the lesson is over: {why}"))

    def _run_arm(self) -> None:
        """Nobody is taught any more: the arm runs, from the beginning of its behavior."""
        self._enter(None)
        with suppress(UnderstudyError):  # the arm cannot run either, which is told where it is made
            direct_roots(self._world.engine.machine, self._world.treatment.arm)

    # -------------------------------------------------------------------------------------------- learning

    def _learn(self) -> None:
        plan, vocabulary = self._taught().plan, self._scenario.vocabulary
        question = Question(self.revision, self.project, vocabulary, plan.type, plan.automaton)
        self._learner.ask(question)
        self._waits_for = question

    def _take(self, answer: Answer) -> None:
        """Use what was learned, unless the project has changed meanwhile: then learn again."""
        if self._lesson is None or answer.question is not self._waits_for:
            return
        if answer.question.revision != self.revision:
            self._learn()
            return
        self._waits_for = None
        if answer.learned is None:
            self._transcript.not_tested()
            self._events.append(Refused(self._asked_by, answer.problem))
            return
        self._change(Relearned(answer.learned))
        if self._lesson is not None:  # it would be over if it could not go on
            self._lesson.test()
            self._asking.begin()
