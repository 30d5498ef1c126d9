"""One lesson: nodes in training mode, and testing with corrections (paper, section 3.1).

A lesson changes only what the nodes do. What a pick teaches reaches the caller as a `Recorded` value, an edit.
"""

from collections.abc import Iterable, Sequence
from dataclasses import replace

from ..core.actor import Actor, Argument, Run
from ..core.automaton import Basic, Content, Nested, State
from ..core.binding import bind
from ..core.edits.examples import Recorded, next_pick
from ..core.edits.picking import state_for
from ..core.errors import SessionError, UnderstudyError
from ..core.examples import Example, Moment
from ..core.hierarchy import Node
from ..core.machine_state import MachineState, freeze
from ..core.naming import next_number
from ..core.project import Project
from ..core.storage.moments import moment_hash
from ..core.wording import node_words
from ..sim.engine import Control, Engine, Past
from .acts import Act, Undone, part_of, past, past_undone, put_back
from .commands import Teach
from .departures import Departure, Departures
from .looking_back import LookBack
from .moments import forest_hash, take
from .plan import automaton_of, check_plan, is_taught_one, some, still_nodes
from .recording import Triple, on_entry, seen, triples
from .runs import Treatment
from .snapshots import LessonView


class Lesson:
    """Teaching one automaton to one or more nodes of its type.

    Attributes:
        plan: What is taught to whom.
        testing: Whether what was learned is being tested.
        taught: Nodes that are in training mode now.
        treatment: Where it takes place.
    """

    def __init__(
        self, engine: Engine, treatment: Treatment, plan: Teach, earlier: Sequence[Act] = ()
    ) -> None:
        """Put the nodes of *plan* into training mode, in Start.

        Args:
            earlier: Acts of the same lesson before its world began again; they can be undone.

        Raises:
            SessionError: A node does not exist or is of another type, or a parameter of the automaton is open.
            LibraryError: There is no such automaton.
        """
        self.plan = plan
        self.testing = False
        self.taught = frozenset(plan.nodes)
        self.treatment = treatment
        self.engine = engine
        self._forest = treatment.arm.forest()
        self._forest_hash = forest_hash(self._forest)
        self._acts = past(earlier)
        self._undone: list[Undone] = []
        check_plan(engine.machine, plan)
        self._begin(node for node in self._forest.walk() if node.id in self.taught)

    def test(self) -> None:
        """Let all nodes of the type run what was learned, from Start.

        Raises:
            SessionError, LibraryError: The plan cannot be carried out any more, see `check_plan`.
        """
        check_plan(self.engine.machine, self.plan)
        self.testing = True
        self.taught = frozenset()
        self._acts, self._undone = past(self._acts), past_undone(self._undone)
        self._begin(node for node in self._forest.walk() if node.type == self.plan.type)

    def _begin(self, pupils: Iterable[Node]) -> None:
        self._pupils = {node.id: node for node in pupils}
        machine = self.engine.machine
        self._departures = Departures(self._moment, len(machine.actors))
        self._still = still_nodes(self._forest, self._pupils.values(), self.plan.others)
        name = automaton_of(machine, self.plan).name
        for node_id in self._pupils:
            arguments = {slot: Argument(target, node_id) for slot, target in self.plan.arguments.items()}
            machine.direct(node_id, name, arguments)

    @property
    def engine(self) -> Engine:
        """What passes its ticks; one that takes over its world may take its place."""
        return self._engine

    @engine.setter
    def engine(self, engine: Engine) -> None:
        self._engine = engine
        engine.departed = self._look_back

    @property
    def acts(self) -> Sequence[Act]:
        """What can be undone, the oldest first."""
        return self._acts

    def view(self) -> LessonView:
        """What a snapshot shows of it."""
        waiting = frozenset(act.node for act in self._acts if not act.done)
        return LessonView(self.plan, self.testing, self.taught, len(self._acts), waiting)

    # ------------------------------------------------------------------------------------------- control

    @property
    def control(self) -> Control:
        """Who decides in the coming tick."""
        picks = {act.node: act.goal for act in self._acts if not act.done}
        return Control(picks, self.taught, self._still, listen=self.testing)

    def decides(self, node_id: str) -> bool:
        """Whether a node is tested and decides by itself in the coming tick."""
        return (
            self.testing
            and node_id in self._pupils
            and node_id not in self.taught
            and node_id not in self._still
        )

    def hand_back(self, node_id: str) -> None:
        """Let a node of the test decide by itself again."""
        if self.testing:
            self.taught -= {node_id}

    def ticked(self) -> None:
        """A tick has passed, and with it the picks were carried out."""
        self._acts = [act if act.done else replace(act, done=True) for act in self._acts]

    def leaving(self, actor: Actor, _next: str) -> None:
        """Remember that a node of the lesson is about to leave its state by itself."""
        run = actor.run
        if run is None or not self.testing or actor.node.id not in self._pupils:
            return
        if is_taught_one(run, self.plan):
            engine = self.engine
            values = seen(engine.machine, engine.senses, actor, run, automaton_of(engine.machine, self.plan))
            self._departures.note(actor.node.id, Departure(run.state, values, engine.tick))

    def _look_back(self, past: Past) -> None:
        """Remember who of the lesson has left a state by itself in a tick that has passed."""
        nodes = [n for n, automaton in past.left if n in self._pupils and automaton == self.plan.automaton]
        if nodes and self.testing:
            back = LookBack(past, nodes, self.plan, self.treatment, self._forest_hash)
            self._departures.note_unasked(back)

    def project_changed(self) -> list[str]:
        """Go on after an edit of the project; returns what picks cannot be carried out any more, and why.

        Raises:
            SessionError, LibraryError: The lesson cannot go on, see `check_plan`.
        """
        check_plan(self.engine.machine, self.plan)
        lost = {act.node: why for act in self._acts if not act.done and (why := self._obstacle(act))}
        self._acts = [replace(act, done=True) if act.node in lost else act for act in self._acts]
        return [f"what was picked for {self._called(node)} is not done: {why}" for node, why in lost.items()]

    def _obstacle(self, act: Act) -> str:
        """Why a pick cannot be carried out; empty if it can."""
        automaton = automaton_of(self.engine.machine, self.plan)
        if not automaton.has_state(act.goal):
            return f"the state {act.goal!r} is gone from {automaton.name!r}"
        try:
            self._refuse_open(*self._running(act.node), automaton.state(act.goal))
        except UnderstudyError as error:
            return str(error)
        return ""

    # -------------------------------------------------------------------------------------------- picking

    def waiting(self, node_id: str) -> list[Act]:
        """Picks for a node that no tick has carried out yet: a second click replaces them."""
        return [act for act in self._acts if act.node == node_id and not act.done]

    def pick(self, project: Project, node_id: str, choice: str | Content) -> Act:
        """What it means that the user picks for a node; in a test, the node is taught again. Nothing changes yet.

        Args:
            project: As it is without what this pick replaces.

        Raises:
            SessionError: The node is not part of the lesson.
            EditError, BindingError: The choice is not possible in the automaton, or needs a target that is open.
        """
        actor, run = self._running(node_id)
        machine, plan = self.engine.machine, self.plan
        state, added = state_for(
            project,
            self.treatment.scenario.vocabulary,
            plan.type,
            plan.automaton,
            self._wanted(node_id, choice),
        )
        self._refuse_open(actor, run, state)
        automaton = automaton_of(machine, plan)
        values = seen(machine, self.engine.senses, actor, run, automaton)
        entered = on_entry(machine, actor, automaton, state, values)
        taught = triples(automaton, machine.types.vocabulary(plan.type), run, state, values, entered)
        moment = self._moment()
        recorded = self._filed(project, node_id, taught, added, moment, self.engine.tick)
        return self._act(node_id, recorded, state.id, moment.machine)

    def should_not_have_left(self, project: Project, node_id: str) -> Act:
        """What it means that a node should have stayed in the state A that it left by itself last: <A, f, A>, back to A.

        Args:
            project: As it is without what this act replaces.

        Raises:
            SessionError: It left none since the test began, or that state is gone.
            BindingError: The state needs a target that is open now.
        """
        actor, run = self._running(node_id)
        left = self._departures.last(node_id)
        if left is None:
            raise SessionError(
                f"{self._called(node_id)} has left no state by itself since the test began: nothing to mend"
            )
        automaton = automaton_of(self.engine.machine, self.plan)
        if not automaton.has_state(left.state):
            raise SessionError(
                f"{self._called(node_id)} left the state {left.state!r}, which is gone from {automaton.name!r}"
            )
        self._refuse_open(actor, run, automaton.state(left.state))
        stays = [Triple(left.state, left.state, left.values)]
        recorded = self._filed(project, node_id, stays, None, self._departures.moment(left), left.tick)
        act = self._act(node_id, recorded, left.state, freeze(self.engine.machine))
        return replace(act, mended=left)

    def add(self, act: Act) -> None:
        """Let the next tick carry out an act, which replaces those waiting for the same node."""
        replaced = self.waiting(act.node)
        first = replaced[0] if replaced else act
        self._acts = [other for other in self._acts if other.done or other.node != act.node]
        for old in replaced:
            self._unmend(old)
        self._acts.append(replace(act, was_taught=first.was_taught))
        self._undone.clear()
        self.taught |= {act.node}
        if act.mended is not None:
            self._departures.mended(act.node)

    def undo(self) -> Act:
        """Take back the last act; the node does again what it did before.

        Raises:
            SessionError: There is none left in this lesson.
        """
        if not self._acts:
            raise SessionError("there is no pick left to take back in this lesson")
        act = self._acts.pop()
        self._unmend(act)
        after = None if act.before is None else self._does(act.node)
        self._undone.append(Undone(act, after, act.node in self.taught))
        if act.before is not None:
            put_back(self.engine.machine, act.node, act.before)
            if not act.was_taught:
                self.taught -= {act.node}
        return act

    def undone(self) -> Act:
        """The act that was taken back last, which `redo` does again.

        Raises:
            SessionError: There is none, or its node cannot go on with it any more.
        """
        if not self._undone:
            raise SessionError("there is no pick in this lesson that was taken back and could be done again")
        last = self._undone[-1]
        if last.after is not None:
            self._running(last.act.node)
        if not last.act.done and last.act.recorded.state is None and (why := self._obstacle(last.act)):
            raise SessionError(why)
        return last.act

    def redo(self) -> None:
        """Do again the act that was taken back last: the node does what it did then, or will in the next tick."""
        last = self._undone.pop()
        act, after = last.act, last.after
        if after is None:
            self._acts.append(act)
            return
        before, was_taught = self._does(act.node), act.node in self.taught
        self._acts.append(replace(act, before=before, was_taught=was_taught))
        put_back(self.engine.machine, act.node, after)
        self.taught = self.taught | {act.node} if last.was_taught else self.taught - {act.node}
        if act.mended is not None:
            self._departures.mended(act.node)

    def project_edited(self, old: Project, new: Project) -> None:
        """The user has changed the project: where its examples are others now, nothing that was taken back is done again."""
        where = self.plan.type, self.plan.automaton
        if old.examples_of(*where) != new.examples_of(*where):
            self._undone.clear()

    def _does(self, node_id: str) -> MachineState:
        return part_of(freeze(self.engine.machine), self._pupils[node_id])

    def _unmend(self, act: Act) -> None:
        if act.mended is not None and act.before is not None:
            self._departures.restore(act.node, act.mended)

    def _wanted(self, node_id: str, choice: str | Content) -> str | Content:
        """A state that only the replaced pick added is gone with it, so it is meant by what it holds."""
        added = [act.recorded.state for act in self.waiting(node_id)]
        return next((state.content for state in added if state and state.id == choice), choice)

    def _refuse_open(self, actor: Actor, run: Run, state: State) -> None:
        types, type_name = self.engine.machine.types, self.plan.type
        match state.content:
            case Basic(name, bindings):
                bind(types.vocabulary(type_name).behavior(name).parameters, bindings, actor, run, state)
            case Nested(automaton_id, bindings):
                bind(types.library(type_name).get(automaton_id).parameters, bindings, actor, run, state)

    def _running(self, node_id: str) -> tuple[Actor, Run]:
        if node_id not in self._pupils:
            there = some(list(self._pupils))
            raise SessionError(f"{node_id!r} is not taught or tested now; pick for one of: {there}")
        actor = self.engine.machine.actors[node_id]
        if actor.run is None or not is_taught_one(actor.run, self.plan):
            raise SessionError(
                f"{self._called(node_id)} does not run {self.plan.automaton!r} now; start teaching it again"
            )
        return actor, actor.run

    def _called(self, node_id: str) -> str:
        actor = self.engine.machine.actors.get(node_id)
        return repr(node_id) if actor is None else node_words(actor.node)

    def _act(self, node_id: str, recorded: Recorded, goal: str, machine: MachineState) -> Act:
        before = part_of(machine, self._pupils[node_id])
        return Act(node_id, recorded, goal, before, node_id in self.taught)

    def _moment(self) -> Moment:
        return take(self.engine, self.treatment, self._forest_hash)

    def _filed(
        self,
        project: Project,
        node_id: str,
        taught: Sequence[Triple],
        added: State | None,
        moment: Moment | None,
        tick: int,
    ) -> Recorded:
        """The examples with their numbers, and the moment they refer to."""
        plan, known = self.plan, project.examples_of(self.plan.type, self.plan.automaton)
        number = next_number(example.id for example in known)
        pick = next_pick(project, plan.type, plan.automaton)
        moments = {moment_hash(moment): moment} if taught and moment is not None else {}
        examples = tuple(
            Example(
                id=str(number + k),
                source=triple.source,
                label=triple.label,
                values=triple.values,
                continuation=triple.continuation,
                demonstration=plan.demonstration,
                tick=tick,
                node=node_id,
                snapshot=next(iter(moments), ""),
                pick=pick,
            )
            for k, triple in enumerate(taught)
        )
        return Recorded(plan.type, plan.automaton, examples, moments, added)
