"""One tick of deciding, in plain Python: the specification that every faster engine must match (paper, section 3).

The machine knows nothing of any world. It asks `Senses` for features and targets and returns the basic behaviors that
the agents are to perform; the world then lets them act.

All features read the flags as they were when the tick began, although nodes tick one after the other: all who can see a
flag (the automaton above, the controllers above) have evaluated before it is raised or falls. The nodes between a
controller and a flag that its direction lowers only pass the direction on; they evaluate nothing in that tick.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Protocol

from .actor import Actor, Argument, Arguments, Run, actors
from .automaton import START, Automaton, Basic, Nested, RaiseFlag, State
from .binding import bind
from .chance import draw
from .errors import BindingError, LibraryError, SessionError
from .features import (
    FeatureUse,
    FlagUp,
    Over,
    Sense,
    Statistic,
    TicksInState,
    summarize,
)
from .hierarchy import Hierarchy
from .library import Types, statistic_vocabulary
from .transition import Classifier, Outcome, choose, distribution
from .tree import Forest, Tree
from .vocabulary import FINISHED, NO_ENTITY, BasicBehavior, Feature

__all__ = [
    "Action",
    "Actor",
    "Argument",
    "Arguments",
    "Classifiers",
    "Leaving",
    "Machine",
    "Run",
    "Senses",
    "stored_classifiers",
]


class Senses(Protocol):
    """What the machine asks of a world. Agents are meant by number, controllers by the numbers of their agents."""

    def feature(self, name: str, agent: int, targets: tuple[int, ...]) -> float:
        """An agent's feature; *targets* are entities, none of them `NO_ENTITY`."""

    def group_feature(self, name: str, members: range) -> float:
        """A controller's own feature; *members* are the agents below it."""

    def target(self, name: str, members: range, performer: int) -> int:
        """The entity that target *name* means to agent *performer* when bound by the owner of *members*."""


@dataclass(frozen=True, slots=True)
class Action:
    """A pulse of a basic behavior by an agent, its targets resolved to entities."""

    agent: int
    behavior: str
    targets: tuple[int, ...]


#: Called when an automaton that a node runs directly is about to change state by itself: actor and next state.
Leaving = Callable[[Actor, str], None]
#: Finds the learned model of a state in a form that decides, by node type, automaton and state.
Classifiers = Callable[[str, Automaton, str], Classifier | None]


def stored_classifiers(_type_name: str, automaton: Automaton, state: str) -> Classifier | None:
    """The trees and forests that are kept in the automata themselves."""
    model = automaton.learned.get(state)
    return model if isinstance(model, Tree | Forest) else None


class Machine:
    """All nodes of a forest, each with what it runs.

    Between ticks, `direct` starts behaviors. `tick` is the whole semantics; `now` is the tick that runs or comes next.
    """

    def __init__(
        self,
        hierarchy: Hierarchy,
        types: Types,
        key: int,
        classifiers: Classifiers = stored_classifiers,
        leaving: Leaving | None = None,
    ) -> None:
        """Prepare idle nodes.

        Args:
            key: The world's key for chance, see `app.core.chance.world_key`.
            classifiers: Where learned models come from.
            leaving: Told of every change of state at the top of a node, before it happens.
        """
        self.now = 0
        self.actors = actors(hierarchy)
        self.key = key
        self._leaving = leaving
        self.use(types, classifiers)

    def use(self, types: Types, classifiers: Classifiers) -> None:
        """Decide by these libraries and models; `app.core.machine_state.rebase` does so while nodes are running."""
        self.types = types
        self.classifiers = classifiers
        self._agent_features = statistic_vocabulary(types)

    # ------------------------------------------------------------------------------------------ one tick

    def tick(
        self,
        senses: Senses,
        now: int,
        picks: Mapping[str, str] | None = None,
        taught: Iterable[str] = (),
        still: Iterable[str] = (),
    ) -> list[Action]:
        """Let every node decide, controllers first, the top level first; return what the agents do.

        Args:
            now: The tick that begins.
            picks: Node id -> state: what the user picked for taught nodes, entered instead of evaluating.
            taught: Nodes that do just what the user picks: their automaton changes state by picks only.
            still: Nodes that do not tick.

        Raises:
            SessionError: A pick names a node or state that is not there; nothing has changed then.
        """
        self.now = now
        picks, taught, still = picks or {}, frozenset(taught), frozenset(still)
        for node_id, state_id in picks.items():
            self._refuse_bad_pick(node_id, state_id, still)
        actions: list[Action] = []
        for actor in self.actors.values():
            run = actor.run
            if run is None or actor.node.id in still:
                continue
            if actor.parent is None or actor.parent in still:
                actor.lower()  # no controller looks: what the last tick raised falls
            if actor.node.id in picks:
                self._pick(actor, run, picks[actor.node.id])
            elif actor.node.id not in taught:
                self._change_state(actor, run, senses, 0)
            action = self._perform(actor, run, senses, 0)
            if action is not None:
                actions.append(action)
            if actor.left:
                actor.lower_directed()  # only now: in its turn the controller saw them as the tick began
        self.now = now + 1
        return actions

    def _change_state(self, actor: Actor, run: Run, senses: Senses, depth: int) -> None:
        """Steps 1 and 2: evaluate the transition function of the current state; if the state differs, change.

        The automaton that the node runs directly draws number 0 of the tick, the one that its state holds number 1,
        and so on.
        """
        automaton = run.behavior
        if isinstance(automaton, BasicBehavior):
            return
        outcome = self.outcome(actor, run, senses)
        sampling = automaton.settings.sampling
        new = choose(
            outcome, sampling, run.state, run.key, lambda: draw(self.key, self.now, actor.drawer, depth)
        )
        run.key = outcome.key
        if new != run.state:
            if depth == 0 and self._leaving is not None:
                self._leaving(actor, new)
            self.enter(actor, run, new)

    def outcome(self, actor: Actor, run: Run, senses: Senses) -> Outcome:
        """The distribution over next states of the automaton that *run* is."""
        automaton = _automaton(run)
        classifier = self.classifiers(actor.node.type, automaton, run.state)
        seen: dict[str, float] = {}

        def value(feature_id: str) -> float:
            if feature_id not in seen:
                seen[feature_id] = self.value(actor, run, _feature(automaton, feature_id), senses)
            return seen[feature_id]

        return distribution(automaton, run.state, classifier, value)

    def enter(self, actor: Actor, run: Run, state_id: str) -> None:
        """Stop what the current state runs and start what *state_id* holds, even if it is the same state.

        Raises:
            LibraryError: The automaton has no such state.
        """
        state = _state(_automaton(run), state_id)
        actor.left |= run.directs()
        child = self._start(actor, run, state)
        run.state, run.entered, run.key, run.child = state_id, self.now, None, child

    def _start(self, actor: Actor, run: Run, state: State) -> Run | None:
        match state.content:
            case Basic(name, bindings):
                basic = self.types.vocabulary(actor.node.type).behavior(name)
                child = Run(basic, bind(basic.parameters, bindings, actor, run, state), entered=self.now)
                if basic.derived:
                    self._direct_subsidiaries(actor, name, child.arguments)
                return child
            case Nested(automaton_id, bindings):
                nested = self.types.library(actor.node.type).get(automaton_id)
                return Run(nested, bind(nested.parameters, bindings, actor, run, state), entered=self.now)
            case _:
                return None

    def _perform(self, actor: Actor, run: Run, senses: Senses, depth: int) -> Action | None:
        """Steps 3 and 4: pulse what the current state holds, recursing into automata; raise its flag, if it has one."""
        if isinstance(run.behavior, BasicBehavior):
            return self._pulse(actor, run, run.behavior, senses)
        flag, action = None, None
        if run.child is not None:
            self._change_state(actor, run.child, senses, depth + 1)
            action = self._perform(actor, run.child, senses, depth + 1)
            held = run.child.behavior
            flag = held.raises if isinstance(held, BasicBehavior) else None
        elif isinstance(content := run.behavior.state(run.state).content, RaiseFlag):
            flag = content.flag
        if flag is not None:
            run.flags.add(flag)
            run.state, run.entered, run.key, run.child = START, self.now, None, None
        return action

    def _pulse(self, actor: Actor, run: Run, basic: BasicBehavior, senses: Senses) -> Action | None:
        """Pulse a basic behavior.

        One that runs once is pulsed once; a controller's own does nothing but direct, on entry. One whose target has
        no referent idles, but the flags that it raises go up all the same, and a one-shot has had its pulse.
        """
        if basic.derived or (run.pulsed and basic.runs_once):
            return None
        run.pulsed = True
        if basic.finishes:
            actor.flags.add(FINISHED)
        if basic.raises is not None:
            run.flags.add(basic.raises)  # for a controller that directed the agent to do just this
        targets = self._resolve(run.arguments, basic.parameters, actor.number, senses)
        return None if NO_ENTITY in targets else Action(actor.number, basic.name, targets)

    # ------------------------------------------------------------------------------------------- picking

    def _pick(self, actor: Actor, run: Run, state_id: str) -> None:
        """Enter the state that the user picked; the current one just goes on, unless it runs once: that runs again."""
        held = None if run.child is None else run.child.behavior
        if state_id != run.state or (isinstance(held, BasicBehavior) and held.runs_once):
            self.enter(actor, run, state_id)

    def _refuse_bad_pick(self, node_id: str, state_id: str, still: frozenset[str]) -> None:
        actor = self.actors.get(node_id)
        if actor is None:
            raise SessionError(f"there is no node {node_id!r} to pick {state_id!r} for")
        if node_id in still or actor.run is None or isinstance(actor.run.behavior, BasicBehavior):
            raise SessionError(f"{node_id!r} runs no automaton now, so {state_id!r} cannot be picked for it")
        if not actor.run.behavior.has_state(state_id):
            raise SessionError(
                f"{state_id!r} cannot be picked for {node_id!r}: {_states(actor.run.behavior)}"
            )

    # ---------------------------------------------------------------------------------------- directing

    def direct(self, node_id: str, behavior: str, arguments: Arguments | None = None) -> None:
        """Start *behavior*, by name, on a node: its flags fall, an automaton begins in Start.

        Raises:
            SessionError: The node's type has no such behavior.
            BindingError: One of the behavior's parameters has no argument.
        """
        actor, arguments = self.actors[node_id], arguments or {}
        repertoire = self.types.repertoire(actor.node.type)
        if behavior not in repertoire:
            allowed = ", ".join(sorted(repertoire)) or "none"
            raise SessionError(
                f"{node_id!r} of type {actor.node.type!r} has no {behavior!r}; there are: {allowed}"
            )
        found = repertoire[behavior]
        if missing := [slot for slot in found.parameters if slot not in arguments]:
            raise BindingError(f"{missing[0]!r} of {behavior!r} is open: {node_id!r} needs a target for it")
        actor.lower()
        actor.left |= actor.run is not None and actor.run.directs()
        actor.run = Run(found, arguments, entered=self.now)
        if isinstance(found, BasicBehavior) and found.derived:
            self._direct_subsidiaries(actor, behavior, arguments)

    def _direct_subsidiaries(self, actor: Actor, behavior: str, arguments: Arguments) -> None:
        actor.direction = (behavior, arguments)
        for child in actor.children:
            self.direct(child.node.id, behavior, arguments)

    def join(self, node_id: str) -> None:
        """Let a node that comes under a controller start what that one last directed; idle if it directed nothing."""
        actor = self.actors[node_id]
        direction = self.actors[actor.parent].direction if actor.parent else None
        if direction is None:
            actor.lower()
            actor.run = None
        else:
            self.direct(node_id, *direction)

    # ----------------------------------------------------------------------------------------- features

    def value(self, actor: Actor, run: Run, use: FeatureUse, senses: Senses) -> float:
        """The value of one of the automaton's features, as the world and the flags are now."""
        match use.source:
            case FlagUp(flag):
                return float(run.child is not None and flag in run.child.flags)
            case TicksInState():
                # The world's ticks, even those in which the node stood still.
                return float(self.now - run.entered)
            case Statistic() as statistic:
                return self._statistic(actor, run, use, statistic, senses)
            case Sense(name, bindings):
                feature = self.types.vocabulary(actor.node.type).feature(name)
                if feature.whose == "group":  # these take no targets
                    return senses.group_feature(name, actor.members)
                arguments = bind(feature.parameters, bindings, actor, run, use)
                return self._sensed(feature, arguments, actor.number, senses)

    def _statistic(
        self, actor: Actor, run: Run, use: FeatureUse, statistic: Statistic, senses: Senses
    ) -> float:
        below, of = self.below(actor, statistic), statistic.of
        if isinstance(of, FlagUp):
            return summarize(statistic.operation, [float(node.shows(of.flag)) for node in below], 0.0)
        feature = self._agent_features.feature(of.feature)
        arguments = bind(feature.parameters, of.bindings, actor, run, use)
        values = [self._sensed(feature, arguments, node.number, senses) for node in below]
        return summarize(statistic.operation, values, feature.default)

    def below(self, actor: Actor, statistic: Statistic) -> tuple[Actor, ...]:
        """The nodes that a controller's statistic ranges over; an agent's ranges over nobody."""
        if statistic.over is Over.AGENTS:
            return actor.agents
        if isinstance(statistic.of, FlagUp):
            return actor.children
        return tuple(node for node in actor.children if node.is_agent)

    def _sensed(self, feature: Feature, arguments: Arguments, performer: int, senses: Senses) -> float:
        targets = self._resolve(arguments, feature.parameters, performer, senses)
        return feature.default if NO_ENTITY in targets else senses.feature(feature.name, performer, targets)

    def _resolve(
        self, arguments: Arguments, slots: Iterable[str], performer: int, senses: Senses
    ) -> tuple[int, ...]:
        """The entities that the arguments mean now, to an agent that performs, as bound by their owners."""
        bound = [arguments[slot] for slot in slots]
        return tuple([senses.target(a.target, self.actors[a.owner].members, performer) for a in bound])


def _automaton(run: Run) -> Automaton:
    assert isinstance(run.behavior, Automaton)
    return run.behavior


def _state(automaton: Automaton, state_id: str) -> State:
    if not automaton.has_state(state_id):
        raise LibraryError(f"there is no state {state_id!r} to enter: {_states(automaton)}")
    return automaton.state(state_id)


def _feature(automaton: Automaton, feature_id: str) -> FeatureUse:
    try:
        return automaton.feature(feature_id)
    except KeyError:
        there = ", ".join(use.id for use in automaton.features) or "none"
        raise LibraryError(
            f"{automaton.name!r} has no feature {feature_id!r} to test; its features are: {there}"
        ) from None


def _states(automaton: Automaton) -> str:
    return f"the states of {automaton.name!r} are: {', '.join(state.id for state in automaton.states)}"
