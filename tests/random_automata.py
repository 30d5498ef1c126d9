"""Libraries, forests and worlds made at random, for properties that must hold for all of them."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from random import Random

from app.core.actor import Argument
from app.core.automaton import (
    START,
    Automaton,
    Basic,
    Content,
    Nested,
    Prune,
    RaiseFlag,
    Rule,
    Sampling,
    Settings,
    Start,
    State,
)
from app.core.chance import draw, world_key
from app.core.conditions import AtMost, Condition, Equals, Guard, InArc, Test
from app.core.features import (
    Binding,
    Bindings,
    FeatureUse,
    FlagUp,
    Ground,
    Operation,
    Over,
    Parameter,
    Sense,
    Source,
    Statistic,
    TicksInState,
    declaration,
)
from app.core.hierarchy import Hierarchy, Node
from app.core.library import Library, NodeType, Types, statistic_vocabulary
from app.core.machine import Machine
from app.core.tree import Branch, Forest, Leaf, Tree, TreeNode
from app.core.vocabulary import DONE, FAILED, FINISHED, NO_ENTITY, FeatureKind, Vocabulary
from tests.samples import AGENT, GROUP, SQUAD, vocabulary

#: Squads may have agents directly under them, so that forests can be irregular.
TYPES = (NodeType(AGENT), NodeType(GROUP, 1, (AGENT,)), NodeType(SQUAD, 2, (GROUP, AGENT)))
FLAGS = (DONE, FAILED, "thrown", "odd")
CATEGORIES = 3
#: Automata of a library, each of which may hold those before it.
LEVELS = 3
DEEPEST = 6


class NoisySenses:
    """Senses that are a fixed jumble: each value is a hash of what is asked, who asks, and when."""

    def __init__(self, seed: int) -> None:
        self.now = 0
        self._key = world_key(seed, 1)

    def _noise(self, name: str, who: int, salt: int = 0) -> float:
        return draw(self._key, self.now, who, sum(name.encode()) + 1000 * salt)

    def feature(self, name: str, agent: int, targets: tuple[int, ...]) -> float:
        noise = self._noise(name, agent, sum(targets))
        match name:
            case "DistanceTo":
                return 100.0 * noise
            case "DirectionTo":
                return 6.0 * noise - 3.0
            case "Ground":
                return float(int(CATEGORIES * noise))
            case _:
                return float(noise < 0.4)

    def group_feature(self, name: str, members: range) -> float:
        return float(self._noise(name, members.start, members.stop) < 0.4)

    def target(self, name: str, members: range, performer: int) -> int:
        noise = self._noise(name, performer, members.start + 100 * members.stop)
        return NO_ENTITY if noise < 0.2 else int(50 * noise)


@dataclass(slots=True)
class Author:
    """Writes the library of one node type.

    Attributes:
        reach: Up to where features without a period take other values in the worlds that are meant.
        written: What can be held by what is written next.
    """

    random: Random
    types: Types
    type_name: str
    reach: float = 8.0
    written: list[Automaton] = field(default_factory=list)

    @property
    def words(self) -> Vocabulary:
        return self.types.vocabulary(self.type_name)

    def write(self, level: int) -> None:
        """Add an automaton; the one at level 0 holds basic behaviors alone, others also those written before."""
        random = self.random
        parameters = random.choice(((), ("goal",), ("goal", "other"), ("goal", "other")))
        held = [State(f"s{k}", self.content(parameters, level)) for k in range(random.randrange(2, 5))]
        ids = (START, *(state.id for state in held))
        features = tuple(FeatureUse(f"f{k}", self.source(parameters)) for k in range(random.randrange(2, 6)))
        name = f"{self.type_name} {level}"
        bare = Automaton(name, name, parameters, (State(START, Start()), *held), features)
        self.written.append(
            replace(
                bare,
                rules=self.rules(ids, features),
                learned=self.learned(ids, features),
                prunes=self.prunes(ids, features),
                settings=Settings(sampling=random.choice(list(Sampling))),
            )
        )

    def content(self, parameters: tuple[str, ...], level: int) -> Content:
        random, sort = self.random, self.random.random()
        if level > 0 and sort < 0.5:
            nested = self.written[-1] if random.random() < 0.7 else random.choice(self.written)
            return Nested(nested.id, self.bindings(nested.parameters, parameters))
        if sort < 0.75 and level > 0:
            return RaiseFlag(random.choice((DONE, DONE, DONE, *FLAGS)))
        names = sorted(self.words.behaviors)
        liked = [name for name in names if " " in name]  # automata of the subsidiaries
        basic = self.words.behavior(random.choice(liked if liked and random.random() < 0.6 else names))
        return Basic(basic.name, self.bindings(basic.parameters, parameters))

    def bindings(self, slots: Sequence[str], parameters: Sequence[str]) -> Bindings:
        return {slot: self.binding(parameters) for slot in slots}

    def binding(self, parameters: Sequence[str]) -> Binding:
        random, targets = self.random, self.words.targets
        if parameters and random.random() < 0.6:
            return Parameter(random.choice(parameters))
        own = [name for name, target in targets.items() if target.level > 0]  # these differ by who binds them
        return Ground(random.choice(own if own and random.random() < 0.7 else sorted(targets)))

    def source(self, parameters: tuple[str, ...]) -> Source:
        random, controls = self.random, self.words.level > 0
        if random.random() < (0.2 if controls else 0.4):
            flag = FlagUp(random.choice((DONE, DONE, DONE, *FLAGS)))
            return random.choice((flag, flag, TicksInState()))
        if not controls or random.random() < 0.15:
            return self.sense(self.words, parameters)
        flag = FlagUp(random.choice((DONE, DONE, DONE, *FLAGS, FINISHED)))
        of = random.choice((flag, self.sense(statistic_vocabulary(self.types), parameters)))
        over = Over.AGENTS if random.random() < 0.6 else Over.SUBSIDIARIES
        return Statistic(random.choice(list(Operation)), of, over)

    def sense(self, declared: Vocabulary, parameters: tuple[str, ...]) -> Sense:
        """A feature; one with targets rather than another where the automaton has parameters to bind them to."""
        of_targets = [feature for feature in declared.features.values() if feature.parameters]
        liked = of_targets if parameters and of_targets and self.random.random() < 0.6 else None
        feature = self.random.choice(liked or list(declared.features.values()))
        return Sense(feature.name, self.bindings(feature.parameters, parameters))

    # --------------------------------------------------------------------------------------- transitions

    def rules(self, ids: Sequence[str], features: Sequence[FeatureUse]) -> tuple[Rule, ...]:
        random = self.random
        begin = Rule("begin", START, (), random.choice(ids[1:]), random.choice((0.3, 1.0)))
        several = (
            Rule(
                f"r{k}",
                random.choice(ids),
                self.guard(features),
                random.choice(ids),
                random.choice((0.0, 0.1, 0.4, 1.0)),
            )
            for k in range(random.randrange(5))
        )
        return (*several, begin)

    def learned(self, ids: Sequence[str], features: Sequence[FeatureUse]) -> dict[str, Tree | Forest]:
        found: dict[str, Tree | Forest] = {}
        labels = tuple(self.random.sample(ids, self.random.randrange(1, len(ids) + 1)))
        for state in ids:
            sort = self.random.random()
            if sort < 0.5:
                found[state] = self.tree(labels, features, self.random.randrange(DEEPEST + 1))
            elif sort < 0.6:
                found[state] = Forest(labels, tuple(self.tree(labels, features, 2) for _ in range(3)))
        return found

    def prunes(self, ids: Sequence[str], features: Sequence[FeatureUse]) -> tuple[Prune, ...]:
        random = self.random
        return tuple(
            Prune(
                f"p{k}",
                random.choice(ids),
                self.guard(features),
                frozenset(random.sample(ids, random.randrange(1, 3))),
            )
            for k in range(random.randrange(3))
        )

    def guard(self, features: Sequence[FeatureUse]) -> Guard:
        random = self.random
        chosen = random.choices(features, k=random.randrange(3))
        return tuple(Condition(self.test(use), random.random() < 0.6) for use in chosen)

    def tree(self, labels: tuple[str, ...], features: Sequence[FeatureUse], depth: int) -> Tree:
        def grow(depth: int) -> TreeNode:
            if depth == 0:
                return Leaf(tuple(float(self.random.choice((0, 0, 1, 2, 7))) for _ in labels))
            test = self.test(self.random.choice(features))
            below = depth - 1
            yes = grow(below)
            no = grow(below if self.random.random() < 0.7 else 0)
            return Branch(test, yes, no, tuple(a + b for a, b in zip(yes.counts, no.counts, strict=True)))

        return Tree(labels, grow(depth))

    def test(self, use: FeatureUse) -> Test:
        """A test that both passes and fails in the worlds that are meant."""
        random, source = self.random, use.source
        words = statistic_vocabulary(self.types) if isinstance(source, Statistic) else self.words
        declared = declaration(source, words)
        match declared.kind:
            case FeatureKind.BOOLEAN:
                return Equals(use.id, float(random.randrange(2)))
            case FeatureKind.CATEGORICAL:
                return Equals(use.id, float(random.randrange(3)))
            case FeatureKind.TOROIDAL:
                half = declared.period / 2
                return InArc(use.id, random.uniform(-half, half), random.uniform(-half, half))
        if isinstance(source, TicksInState) or (isinstance(source, Statistic) and random.random() < 0.5):
            return AtMost(use.id, random.choice((0.0, 0.5, 1.0, 2.0)))
        return AtMost(use.id, random.uniform(0.0, self.reach))


def random_types(
    random: Random,
    words: Vocabulary | None = None,
    types: tuple[NodeType, ...] = TYPES,
    *,
    reach: float = 100.0,
    beside: Mapping[str, Library] | None = None,
) -> Types:
    """Node types with automata up to three levels deep, made at random from *words* (those of `samples`).

    Args:
        reach: See `Author`.
        beside: What each type's library holds already, and the new automata may hold.
    """
    scenario, libraries = vocabulary() if words is None else words, dict[str, Library]()
    for node_type in types:
        author = Author(random, Types(types, libraries, scenario), node_type.name, reach)
        author.written += beside[node_type.name].automata.values() if beside else ()
        for level in range(LEVELS):
            author.write(level)
        libraries[node_type.name] = Library({a.id: a for a in author.written})
    return Types(types, libraries, scenario)


def random_forest(random: Random, types: tuple[NodeType, ...] = TYPES) -> Hierarchy:
    """One to three roots of any level, with agents at any depth."""
    count = 0

    def grow(node_type: NodeType) -> Node:
        nonlocal count
        count += 1
        node_id = f"{node_type.name}-{count}"
        kinds = [kind for kind in types if kind.name in node_type.subsidiaries]
        children = tuple(grow(random.choice(kinds)) for _ in range(random.randrange(1, 4))) if kinds else ()
        return Node(node_id, node_type.name, children)

    return Hierarchy(tuple(grow(random.choice(types)) for _ in range(random.randrange(1, 4))))


def random_machine(
    random: Random,
    forest: Hierarchy,
    types: Types,
    make: Callable[[Hierarchy, Types, int], Machine] = Machine,
) -> Machine:
    """A machine whose roots all run something."""
    machine = make(forest, types, world_key(random.randrange(1 << 32), 0))
    direct_roots(machine, random)
    return machine


def direct_roots(machine: Machine, random: Random) -> None:
    """Let every root do something, most of them their most complex behavior."""
    for root in [actor.node for actor in machine.actors.values() if actor.parent is None]:
        repertoire = machine.types.repertoire(root.type)
        name = f"{root.type} {LEVELS - 1}" if random.random() < 0.8 else random.choice(sorted(repertoire))
        slots = repertoire[name].parameters
        targets = sorted(machine.types.vocabulary(root.type).targets)
        machine.direct(root.id, name, {slot: Argument(random.choice(targets), root.id) for slot in slots})
