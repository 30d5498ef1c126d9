"""One lesson: nodes in training mode, and testing with corrections (DESIGN section 4).

A lesson changes only what the nodes do. What a pick teaches reaches the caller as a `Recorded` value, an edit.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

from ..core.actor import Actor, Argument, Run
from ..core.automaton import Automaton, Content, State
from ..core.edits.examples import Recorded, next_pick
from ..core.errors import SessionError
from ..core.examples import Example, Moment
from ..core.hierarchy import Node
from ..core.machine import Machine
from ..core.machine_state import MachineState, freeze, thaw_node
from ..core.naming import next_number
from ..core.project import Project
from ..core.storage.moments import moment_hash
from ..sim.engine import Control, Engine
from .commands import Others, Teach
from .recording import Triple, Values, on_entry, seen, state_for, triples
from .runs import Treatment


@dataclass(frozen=True, slots=True)
class Departure:
    """A node left a state by itself: what it saw, and the moment."""

    state: str
    values: Values
    tick: int
    moment: Moment


@dataclass(frozen=True, slots=True)
class Act:
    """A pick with what it takes to undo it.

    Attributes:
        goal: The state that the node enters in the next tick.
        before: What the nodes did before.
        was_taught: The node was in training mode before.
        done: The tick that carries it out has passed.
    """

    node: str
    recorded: Recorded
    goal: str
    before: MachineState
    was_taught: bool
    done: bool = False


class Lesson:
    """Teaching one automaton to one or more nodes of its type.

    Attributes:
        plan: What is taught to whom.
        testing: Whether what was learned is being tested.
        taught: Nodes that are in training mode now.
    """

    def __init__(self, engine: Engine, treatment: Treatment, plan: Teach) -> None:
        """Put the nodes of *plan* into training mode, in Start.

        Raises:
            SessionError: A node does not exist or is of another type, or a parameter of the automaton is open.
        """
        self.plan = plan
        self.testing = False
        self.taught = frozenset(plan.nodes)
        self._engine = engine
        self._treatment = treatment
        self._forest = treatment.arm.forest()
        self._acts: list[Act] = []
        self._departures: dict[str, Departure] = {}
        check_plan(engine.machine, plan)
        for node_id in plan.nodes:
            self._begin(node_id)

    def test(self) -> None:
        """Let all nodes of the type run what was learned, from Start."""
        self.testing = True
        self.taught = frozenset()
        self._acts = [act for act in self._acts if act.done]
        self._departures.clear()
        for node in self._pupils():
            self._begin(node.id)

    def _begin(self, node_id: str) -> None:
        arguments = {slot: Argument(target, node_id) for slot, target in self.plan.arguments.items()}
        automaton = automaton_of(self._engine.machine, self.plan)
        self._engine.machine.direct(node_id, automaton.name, arguments)

    # ------------------------------------------------------------------------------------------- control

    @property
    def control(self) -> Control:
        """Who decides in the coming tick."""
        picks = {act.node: act.goal for act in self._acts if not act.done}
        return Control(picks, self.taught, self._still())

    def ticked(self) -> None:
        """A tick has passed, and with it the picks were carried out."""
        self._acts = [act if act.done else replace(act, done=True) for act in self._acts]

    def _pupils(self) -> list[Node]:
        """The nodes that the lesson is about: those taught; in a test, all of the type."""
        return [
            n
            for n in self._forest.walk()
            if n.id in self.taught or (self.testing and n.type == self.plan.type)
        ]

    def _still(self) -> frozenset[str]:
        """Ancestors of the pupils do not tick; nor do nodes beside them, unless the others are to run."""
        pupils = self._pupils()
        if self.plan.others is Others.RUN:
            return _ancestors(self._forest.parents(), pupils)
        at_work = {node.id for pupil in pupils for node in pupil.walk()}
        return frozenset(node.id for node in self._forest.walk()) - at_work

    # -------------------------------------------------------------------------------------------- picking

    def check_pick(self, project: Project, node_id: str, choice: str | Content) -> None:
        """Refuse what cannot be picked.

        Raises:
            SessionError: The node is not part of the lesson.
            EditError: The choice is not possible in the automaton.
        """
        self._running(node_id)
        state_for(project, self.plan.type, self.plan.automaton, choice)

    def retract(self, node_id: str) -> list[Act]:
        """Take back a pick of this node that no tick has carried out yet: a second click replaces the first."""
        waiting = [act for act in self._acts if act.node == node_id and not act.done]
        self._acts = [act for act in self._acts if act.node != node_id or act.done]
        return waiting

    def pick(self, project: Project, node_id: str, choice: str | Content) -> Recorded:
        """Record what the user picks for a node; it takes effect in the next tick. In a test, the node is taught again.

        Raises:
            SessionError, EditError: As in `check_pick`.
        """
        actor, run = self._running(node_id)
        machine, senses = self._engine.machine, self._engine.senses
        state, added = state_for(project, self.plan.type, self.plan.automaton, choice)
        automaton = project.library(self.plan.type).get(self.plan.automaton)
        values = seen(machine, senses, actor, run, automaton)
        entered = on_entry(machine, actor, automaton, state, values)
        taught = triples(automaton, machine.types.vocabulary(self.plan.type), run, state, values, entered)
        recorded = self._filed(project, node_id, taught, added, self.moment(), self._engine.tick)
        self._act(node_id, recorded, state.id)
        return recorded

    def should_not_have_left(self, project: Project, node_id: str) -> Recorded:
        """Record <A, f, A> for the state A that a node left by itself last, and take it back there.

        Raises:
            SessionError: It left none since the test began.
        """
        self._running(node_id)
        left = self._departures.pop(node_id, None)
        if left is None:
            raise SessionError(
                f"{node_id!r} has not left a state by itself since the test began: nothing to mend"
            )
        stays = [Triple(left.state, left.state, left.values)]
        recorded = self._filed(project, node_id, stays, None, left.moment, left.tick)
        self._act(node_id, recorded, left.state)
        return recorded

    def undo(self) -> Act:
        """Take back the last pick; the node does again what it did before.

        Raises:
            SessionError: There is none left in this lesson.
        """
        if not self._acts:
            raise SessionError("there is no pick left to take back in this lesson")
        act = self._acts.pop()
        thaw_node(self._engine.machine, act.node, act.before)
        if not act.was_taught:
            self.taught -= {act.node}
        return act

    def leaving(self, actor: Actor, _next: str) -> None:
        """Remember that a node of the lesson is about to leave its state by itself."""
        run = actor.run
        if (
            self.testing
            and run is not None
            and actor.node.type == self.plan.type
            and _is_plan(run, self.plan)
        ):
            automaton = automaton_of(self._engine.machine, self.plan)
            values = seen(self._engine.machine, self._engine.senses, actor, run, automaton)
            self._departures[actor.node.id] = Departure(run.state, values, self._engine.tick, self.moment())

    def moment(self) -> Moment:
        """The world and what all nodes do, now."""
        of, engine = self._treatment, self._engine
        return Moment(
            of.scenario.name, of.parameters, of.arm.name, engine.frozen_world(), freeze(engine.machine)
        )

    def _running(self, node_id: str) -> tuple[Actor, Run]:
        pupils = {node.id for node in self._pupils()}
        if node_id not in pupils:
            raise SessionError(
                f"{node_id!r} is not taught or tested now; pick for one of: {_some(sorted(pupils))}"
            )
        actor = self._engine.machine.actors[node_id]
        if actor.run is None or not _is_plan(actor.run, self.plan):
            raise SessionError(
                f"{node_id!r} does not run {self.plan.automaton!r} now; start teaching it again"
            )
        return actor, actor.run

    def _act(self, node_id: str, recorded: Recorded, goal: str) -> None:
        self._acts.append(Act(node_id, recorded, goal, freeze(self._engine.machine), node_id in self.taught))
        self.taught |= {node_id}

    def _filed(
        self,
        project: Project,
        node_id: str,
        taught: Iterable[Triple],
        added: State | None,
        moment: Moment,
        tick: int,
    ) -> Recorded:
        """The examples with their numbers, and the moment they refer to."""
        plan, known = self.plan, project.examples_of(self.plan.type, self.plan.automaton)
        number = next_number(example.id for example in known)
        pick = next_pick(project, plan.type, plan.automaton)
        digest = moment_hash(moment)
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
                snapshot=digest,
                pick=pick,
            )
            for k, triple in enumerate(taught)
        )
        return Recorded(plan.type, plan.automaton, examples, {digest: moment} if examples else {}, added)


def check_plan(machine: Machine, plan: Teach) -> None:
    """Refuse a plan that cannot be taught here.

    Raises:
        SessionError: A node does not exist or is of another type, or a parameter of the automaton is open.
    """
    if not plan.nodes:
        raise SessionError("choose at least one agent or controller to teach")
    for node_id in plan.nodes:
        actor = machine.actors.get(node_id)
        if actor is None:
            raise SessionError(
                f"there is no node {node_id!r} in this arm; there are: {_some(list(machine.actors))}"
            )
        if actor.node.type != plan.type:
            raise SessionError(
                f"{node_id!r} is of type {actor.node.type!r}, but {plan.type!r} is being taught"
            )
    _check_arguments(machine, plan)


def _check_arguments(machine: Machine, plan: Teach) -> None:
    targets = machine.types.vocabulary(plan.type).targets
    for parameter in automaton_of(machine, plan).parameters:
        given = plan.arguments.get(parameter)
        if given not in targets:
            what = "open" if given is None else f"{given!r}"
            raise SessionError(
                f"while teaching, {parameter!r} is {what}; choose one of: {_some(list(targets))}"
            )


def automaton_of(machine: Machine, plan: Teach) -> Automaton:
    """The automaton that is taught."""
    return machine.types.library(plan.type).get(plan.automaton)


def _is_plan(run: Run, plan: Teach) -> bool:
    return isinstance(run.behavior, Automaton) and run.behavior.id == plan.automaton


def _ancestors(parents: Mapping[str, str], nodes: Iterable[Node]) -> frozenset[str]:
    above: set[str] = set()
    for node in nodes:
        node_id = node.id
        while node_id in parents:
            node_id = parents[node_id]
            above.add(node_id)
    return frozenset(above)


def _some(names: list[str], most: int = 8) -> str:
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")
