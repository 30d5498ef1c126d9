"""One tick of deciding, in plain Python: the specification that every faster engine must match (DESIGN section 3).

The machine knows nothing of any world. It asks `Senses` for features and targets and returns the basic behaviors that
the agents are to perform; the world then lets them act.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Protocol

from .automaton import START, Automaton, Basic, Nested, RaiseFlag
from .chance import FIRST_CONTROLLER, draw
from .errors import SessionError
from .features import (
    Binding,
    Bindings,
    FeatureUse,
    FlagUp,
    Ground,
    Over,
    Sense,
    Source,
    Statistic,
    TicksInState,
    declaration,
    summarize,
)
from .hierarchy import Hierarchy, Node
from .library import Behavior, Types, statistic_vocabulary
from .transition import Classifier, Outcome, choose, distribution
from .vocabulary import FINISHED, NO_ENTITY, BasicBehavior


class Senses(Protocol):
    """What the machine asks of a world. Agents are meant by number, controllers by the numbers of their agents."""

    def feature(self, name: str, agent: int, targets: tuple[int, ...]) -> float:
        """An agent's feature; *targets* are entities, none of them `NO_ENTITY`."""

    def group_feature(self, name: str, members: range) -> float:
        """A controller's own feature; *members* are the agents below it."""

    def target(self, name: str, members: range, performer: int) -> int:
        """The entity that target *name* means to agent *performer* when bound by the owner of *members*."""


@dataclass(frozen=True, slots=True)
class Argument:
    """What a parameter stands for while a behavior runs: a ground target, and the node that bound it."""

    target: str
    owner: str


Arguments = Mapping[str, Argument]


@dataclass(frozen=True, slots=True)
class Action:
    """A pulse of a basic behavior by an agent, its targets resolved to entities."""

    agent: int
    behavior: str
    targets: tuple[int, ...]


@dataclass(slots=True)
class Run:
    """A behavior while one node runs it.

    Attributes:
        arguments: What the behavior's parameters stand for.
        flags: Flags that are up on it; its parent sees them from the parent's next tick on.
        state, entered: The automaton's current state, and the tick in which it was entered.
        child: What the current state runs; none in Start and after a flag was raised.
        key: What decided the last evaluation since the state was entered (for `hold`).
        pulsed: Whether a one-shot has had its pulse.
    """

    behavior: Behavior
    arguments: Arguments
    flags: set[str] = field(default_factory=set)
    state: str = START
    entered: int = 0
    child: "Run | None" = None
    key: object = None
    pulsed: bool = False


@dataclass(slots=True)
class Actor:
    """A node while the machine runs.

    Attributes:
        number: An agent's number; a controller's place among the controllers.
        members: The agents at or below it.
        run: What it does; None idles.
        flags: Flags of the agent itself: `finished`.
        direction: What a controller last told its subsidiaries to start.
    """

    node: Node
    number: int
    members: range
    parent: str | None
    run: Run | None = None
    flags: set[str] = field(default_factory=set)
    direction: tuple[str, Arguments] | None = None

    @property
    def is_agent(self) -> bool:
        """Whether it has a body."""
        return not self.node.children

    @property
    def drawer(self) -> int:
        """Who it is when it draws."""
        return self.number if self.is_agent else FIRST_CONTROLLER + self.number


#: Called when an automaton that a node runs directly is about to change state by itself: actor and next state.
Leaving = Callable[[Actor, str], None]
#: Finds the learned model of a state in a form that decides, by node type, automaton and state.
Classifiers = Callable[[str, Automaton, str], Classifier | None]


def stored_classifiers(type_name: str, automaton: Automaton, state: str) -> Classifier | None:
    """The trees and forests that are kept in the automata themselves."""
    model = automaton.learned.get(state)
    return None if model is None or not hasattr(model, "decide") else model  # type: ignore[return-value]


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
        self.types = types
        self.now = 0
        self._key = key
        self._classifiers = classifiers
        self._leaving = leaving
        self._agent_features = statistic_vocabulary(types)
        self.actors = _actors(hierarchy)
        self._order = [
            *(self.actors[node.id] for node in hierarchy.controllers()),
            *(self.actors[node.id] for node in hierarchy.agents()),
        ]

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
        """
        self.now = now
        picks, taught, still = picks or {}, frozenset(taught), frozenset(still)
        actions: list[Action] = []
        for actor in self._order:
            if actor.run is not None and actor.node.id not in still:
                if actor.parent is None or actor.parent in still:
                    self._lower(actor)
                self._tick(actor, actor.run, senses, actions, 0, actor.node.id in taught, picks.get(actor.node.id))
        self.now = now + 1
        return actions

    def _lower(self, actor: Actor) -> None:
        """A node without a controller lowers its flags one tick after they were raised."""
        actor.flags.clear()
        if actor.run is not None:
            actor.run.flags.clear()

    def _tick(
        self,
        actor: Actor,
        run: Run,
        senses: Senses,
        actions: list[Action],
        depth: int,
        taught: bool = False,
        pick: str | None = None,
    ) -> None:
        """One tick of one behavior, recursing into what its current state holds (DESIGN section 3, steps 1 to 5)."""
        if isinstance(run.behavior, BasicBehavior):
            self._pulse(actor, run, senses, actions)
            return
        if pick is not None:
            self.enter(actor, run, pick)
        elif not taught:
            self._change(actor, run, senses, depth)
        state = run.behavior.state(run.state)
        if isinstance(state.content, RaiseFlag):
            self._raise(run, state.content.flag)
        elif run.child is not None:
            self._tick(actor, run.child, senses, actions, depth + 1)
            basic = run.child.behavior
            if isinstance(basic, BasicBehavior) and basic.raises is not None:
                self._raise(run, basic.raises)

    def _change(self, actor: Actor, run: Run, senses: Senses, depth: int) -> None:
        """Steps 1 and 2: evaluate the transition function of the current state; if the state differs, change."""
        outcome = self.outcome(actor, run, senses)
        automaton = self._automaton(run)
        sampling = automaton.settings.sampling
        new = choose(outcome, sampling, run.state, run.key, lambda: draw(self._key, self.now, actor.drawer, depth))
        run.key = outcome.key
        if new != run.state:
            if depth == 0 and self._leaving is not None:
                self._leaving(actor, new)
            self.enter(actor, run, new)

    def outcome(self, actor: Actor, run: Run, senses: Senses) -> Outcome:
        """The distribution over next states of the automaton that *run* is."""
        automaton = self._automaton(run)
        classifier = self._classifiers(actor.node.type, automaton, run.state)
        seen: dict[str, float] = {}

        def value(feature_id: str) -> float:
            if feature_id not in seen:
                seen[feature_id] = self.value(actor, run, automaton.feature(feature_id), senses)
            return seen[feature_id]

        return distribution(automaton, run.state, classifier, value)

    def enter(self, actor: Actor, run: Run, state_id: str) -> None:
        """Stop what the current state runs and start what *state_id* holds, even if it is the same state."""
        run.state, run.entered, run.key = state_id, self.now, None
        content = self._automaton(run).state(state_id).content
        run.child = self._start(actor, run, content)

    def _start(self, actor: Actor, run: Run, content: object) -> Run | None:
        match content:
            case Basic(name, bindings):
                basic = self.types.vocabulary(actor.node.type).behavior(name)
                child = Run(basic, self._bind(actor, run, bindings), entered=self.now)
                if basic.derived:
                    self._direct_subsidiaries(actor, name, child.arguments)
                return child
            case Nested(automaton_id, bindings):
                nested = self.types.library(actor.node.type).get(automaton_id)
                return Run(nested, self._bind(actor, run, bindings), entered=self.now)
        return None

    def _raise(self, run: Run, flag: str) -> None:
        """Step 4: raise a flag on the automaton and put it in Start within the same tick."""
        run.flags.add(flag)
        run.state, run.entered, run.key, run.child = START, self.now, None, None

    def _pulse(self, actor: Actor, run: Run, senses: Senses, actions: list[Action]) -> None:
        """Pulse a basic behavior; one whose target has no referent idles."""
        basic = run.behavior
        assert isinstance(basic, BasicBehavior)
        if basic.derived or (run.pulsed and basic.runs_once):
            return
        run.pulsed = True
        if basic.finishes:
            actor.flags.add(FINISHED)
        if basic.raises is not None and run is actor.run:
            run.flags.add(basic.raises)
        targets = tuple(self._resolve(run.arguments[p], actor.number, senses) for p in basic.parameters)
        if NO_ENTITY not in targets:
            actions.append(Action(actor.number, basic.name, targets))

    # ---------------------------------------------------------------------------------------- directing

    def direct(self, node_id: str, behavior: str, arguments: Arguments | None = None) -> None:
        """Start *behavior*, by name, on a node: its flags fall, an automaton begins in Start.

        Raises:
            SessionError: The node's type has no such behavior.
        """
        actor = self.actors[node_id]
        repertoire = self.types.repertoire(actor.node.type)
        if behavior not in repertoire:
            allowed = ", ".join(sorted(repertoire)) or "none"
            raise SessionError(f"{node_id!r} of type {actor.node.type!r} has no {behavior!r}; there are: {allowed}")
        actor.flags.clear()
        actor.run = Run(repertoire[behavior], arguments or {}, entered=self.now)
        found = repertoire[behavior]
        if isinstance(found, BasicBehavior) and found.derived:
            self._direct_subsidiaries(actor, behavior, actor.run.arguments)

    def _direct_subsidiaries(self, actor: Actor, behavior: str, arguments: Arguments) -> None:
        actor.direction = (behavior, arguments)
        for child in actor.node.children:
            self.direct(child.id, behavior, arguments)

    def join(self, node_id: str) -> None:
        """Let a node that comes under a controller start what that one last directed; idle if it directed nothing."""
        actor = self.actors[node_id]
        direction = self.actors[actor.parent].direction if actor.parent else None
        if direction is None:
            actor.run = None
        else:
            self.direct(node_id, *direction)

    # ----------------------------------------------------------------------------------------- features

    def value(self, actor: Actor, run: Run, use: FeatureUse, senses: Senses) -> float:
        """The value of one of the automaton's features, as the world and the flags are now."""
        source = use.source
        match source:
            case FlagUp(flag):
                return float(run.child is not None and flag in run.child.flags)
            case TicksInState():
                return float(self.now - run.entered)
            case Statistic():
                return self._statistic(actor, run, source, senses)
            case Sense(name, _) if self.types.vocabulary(actor.node.type).feature(name).whose == "group":
                return senses.group_feature(name, actor.members)
            case Sense():
                return self._sensed(actor, run, source, actor.number, senses)

    def _sensed(self, owner: Actor, run: Run, source: Sense, performer: int, senses: Senses) -> float:
        feature = self._agent_features.feature(source.feature)
        arguments = self._bind(owner, run, source.bindings)
        targets = tuple(self._resolve(arguments[p], performer, senses) for p in feature.parameters)
        return feature.default if NO_ENTITY in targets else senses.feature(source.feature, performer, targets)

    def _statistic(self, actor: Actor, run: Run, source: Statistic, senses: Senses) -> float:
        below = self._below(actor, source)
        of = source.of
        if isinstance(of, FlagUp):
            values = [float(of.flag in node.flags or (node.run is not None and of.flag in node.run.flags)) for node in below]
        else:
            values = [self._sensed(actor, run, of, node.number, senses) for node in below]
        return summarize(source.operation, values, declaration(of, self._agent_features).default)

    def _below(self, actor: Actor, source: Statistic) -> list[Actor]:
        if source.over is Over.AGENTS:
            return [self.actors[node.id] for node in actor.node.agents()]
        direct = [self.actors[child.id] for child in actor.node.children]
        return direct if isinstance(source.of, FlagUp) else [child for child in direct if child.is_agent]

    def _bind(self, actor: Actor, run: Run, bindings: Bindings) -> Arguments:
        return {slot: self._argument(actor, run, binding) for slot, binding in bindings.items()}

    def _argument(self, actor: Actor, run: Run, binding: Binding) -> Argument:
        if isinstance(binding, Ground):
            return Argument(binding.target, actor.node.id)
        return run.arguments[binding.name]

    def _resolve(self, argument: Argument, performer: int, senses: Senses) -> int:
        return senses.target(argument.target, self.actors[argument.owner].members, performer)

    @staticmethod
    def _automaton(run: Run) -> Automaton:
        assert isinstance(run.behavior, Automaton)
        return run.behavior


def _actors(hierarchy: Hierarchy) -> dict[str, Actor]:
    parents = hierarchy.parents()
    numbers = {node.id: number for number, node in enumerate(hierarchy.agents())}
    numbers |= {node.id: number for number, node in enumerate(hierarchy.controllers())}
    actors = {}
    for node in hierarchy.walk():
        agents = [numbers[agent.id] for agent in node.agents()]
        members = range(agents[0], agents[-1] + 1)
        actors[node.id] = Actor(node, numbers[node.id], members, parents.get(node.id))
    return actors
