"""A world that is a script, and a machine to play it through: for tests of deciding alone."""

from collections.abc import Callable, Iterable, Mapping
from typing import Generic, TypeVar

from app.core.actor import Actor, Argument, Run
from app.core.automaton import Automaton, Rule
from app.core.chance import world_key
from app.core.conditions import AtMost, Condition, Equals, Guard
from app.core.features import FeatureUse, FlagUp, Sense, Source, TicksInState
from app.core.hierarchy import Hierarchy, Node
from app.core.library import Library, NodeType, Types
from app.core.machine import Action, Classifiers, Leaving, Machine, stored_classifiers
from app.core.tree import Leaf, Tree
from app.core.vocabulary import DONE, Vocabulary
from tests.samples import AGENT, TYPES, vocabulary

T = TypeVar("T")
#: An entity, or what finds it from the members of the binding's owner and the performer.
Meaning = int | Callable[[range, int], int]


class Script(Generic[T]):
    """Lines by name, agent and tick; the latest that has begun is valid, one for the agent before one for all."""

    def __init__(self) -> None:
        self._lines: dict[tuple[str, int | None], dict[int, T]] = {}

    def write(self, name: str, said: T, agent: int | None, since: int) -> None:
        self._lines.setdefault((name, agent), {})[since] = said

    def read(self, name: str, agent: int | None, now: int) -> T | None:
        for who in (agent, None):
            begun = {since: said for since, said in self._lines.get((name, who), {}).items() if since <= now}
            if begun:
                return begun[max(begun)]
        return None


class FakeSenses:
    """`app.core.machine.Senses` that tests script.

    Features that nobody scripted are 0; asking for such a target fails the test.

    Attributes:
        now: The tick in which is sensed.
        asked: Every feature asked for: name, agent and targets.
    """

    def __init__(self) -> None:
        self.now = 0
        self.asked: list[tuple[str, int, tuple[int, ...]]] = []
        self._features: Script[float] = Script()
        self._groups: Script[float] = Script()
        self._targets: Script[Meaning] = Script()

    def feature_is(self, name: str, value: float, agent: int | None = None, since: int = 0) -> None:
        """From tick *since* on, *agent* (or every agent) senses *value*."""
        self._features.write(name, value, agent, since)

    def group_is(self, name: str, value: float, first: int | None = None, since: int = 0) -> None:
        """From tick *since* on, the controller whose first agent is *first* (or every one) senses *value*."""
        self._groups.write(name, value, first, since)

    def target_is(self, name: str, meaning: Meaning, performer: int | None = None, since: int = 0) -> None:
        """From tick *since* on, target *name* means this entity to *performer* (or to every agent)."""
        self._targets.write(name, meaning, performer, since)

    def feature(self, name: str, agent: int, targets: tuple[int, ...]) -> float:
        self.asked.append((name, agent, targets))
        return self._features.read(name, agent, self.now) or 0.0

    def group_feature(self, name: str, members: range) -> float:
        return self._groups.read(name, members.start, self.now) or 0.0

    def target(self, name: str, members: range, performer: int) -> int:
        meaning = self._targets.read(name, performer, self.now)
        assert meaning is not None, f"no line for target {name!r}"
        return meaning if isinstance(meaning, int) else meaning(members, performer)


class Play:
    """A machine and its scripted senses, ticked together."""

    def __init__(
        self,
        hierarchy: Hierarchy,
        types: Types,
        seed: int = 0,
        classifiers: Classifiers = stored_classifiers,
        leaving: Leaving | None = None,
    ) -> None:
        self.key = world_key(seed, 0)
        self.machine = Machine(hierarchy, types, self.key, classifiers, leaving)
        self.senses = FakeSenses()

    def direct(self, node_id: str, behavior: str, **targets: str) -> None:
        """Start a behavior on a node, its parameters bound by that node."""
        arguments = {slot: Argument(target, node_id) for slot, target in targets.items()}
        self.machine.direct(node_id, behavior, arguments)

    def tick(
        self, picks: Mapping[str, str] | None = None, taught: Iterable[str] = (), still: Iterable[str] = ()
    ) -> list[Action]:
        """Pass one tick."""
        self.senses.now = self.machine.now
        return self.machine.tick(self.senses, self.machine.now, picks, taught, still)

    def does(self, ticks: int = 1, agent: int = 0) -> list[str]:
        """Pass ticks; the basic behavior that *agent* performed in each, empty where it idled."""
        return [next((a.behavior for a in self.tick() if a.agent == agent), "") for _ in range(ticks)]

    def actor(self, node_id: str) -> Actor:
        """The actor of a node."""
        return self.machine.actors[node_id]

    def run(self, node_id: str) -> Run:
        """What a node runs."""
        run = self.actor(node_id).run
        assert run is not None, f"{node_id} idles"
        return run

    def states(self, node_id: str) -> str:
        """The current states of a node's automata, outermost first: ``fetch/home/forward``."""
        names: list[str] = []
        run = self.actor(node_id).run
        while run is not None and isinstance(run.behavior, Automaton):
            names.append(run.state)
            run = run.child
        return "/".join(names)

    def trace(self, node_id: str, ticks: int) -> list[str]:
        """Pass ticks; the states of a node after each."""
        seen = []
        for _ in range(ticks):
            self.tick()
            seen.append(self.states(node_id))
        return seen

    def shown(self, node_id: str) -> set[str]:
        """The flags that a controller of this node sees."""
        actor = self.actor(node_id)
        return actor.flags | (set() if actor.run is None else actor.run.flags)

    def sees(self, node_id: str, source: Source) -> float:
        """What a feature of the automaton that a node runs is now."""
        self.senses.now = self.machine.now
        return self.machine.value(
            self.actor(node_id), self.run(node_id), FeatureUse("f", source), self.senses
        )


def types_of(
    *agents: Automaton,
    types: tuple[NodeType, ...] = TYPES,
    scenario: Vocabulary | None = None,
    **controllers: Iterable[Automaton],
) -> Types:
    """Node types with these automata of agents, and of controllers by the name of their type."""
    libraries = {AGENT: agents, **controllers}
    filed = {name: Library({a.id: a for a in automata}) for name, automata in libraries.items()}
    return Types(types, filed, scenario or vocabulary())


def one_agent(*automata: Automaton, top: str, seed: int = 0, **targets: str) -> Play:
    """A play of a single agent ``a`` that has begun with the behavior *top*."""
    play = Play(Hierarchy((Node("a", AGENT),)), types_of(*automata), seed)
    play.direct("a", top, **targets)
    return play


def inner(node_id: str, node_type: str, *children: Node) -> Node:
    """A controller."""
    return Node(node_id, node_type, children)


def agents(*ids: str) -> tuple[Node, ...]:
    """Agents."""
    return tuple(Node(node_id, AGENT) for node_id in ids)


#: A rule's source, guard, target and, where it is not certain, probability.
Listed = tuple[str, Guard, str] | tuple[str, Guard, str, float]


def rules(*listed: Listed) -> tuple[Rule, ...]:
    """Authored rules in order: source, guard, target and, where it is not certain, probability."""
    return tuple(Rule(f"r{number}", *rule) for number, rule in enumerate(listed, 1))


def yes(feature: str) -> Guard:
    """Met where a boolean feature is 1."""
    return (Condition(Equals(feature, 1.0)),)


def no(feature: str) -> Guard:
    """Met where a boolean feature is not 1."""
    return (Condition(Equals(feature, 1.0), wanted=False),)


def at_least(feature: str, threshold: float) -> Guard:
    """Met where a feature that takes whole numbers is *threshold* or more."""
    return (Condition(AtMost(feature, threshold - 0.5), wanted=False),)


def leaf(**counts: float) -> Tree:
    """A tree that does not ask: class counts by state."""
    return Tree(tuple(counts), Leaf(tuple(counts.values())))


SEES = FeatureUse("sees", Sense("SeesABox"))
HOLDS = FeatureUse("holds", Sense("IsAttached"))
DONE_UP = FeatureUse("done", FlagUp(DONE))
TICKS = FeatureUse("ticks", TicksInState())
