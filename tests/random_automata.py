"""Libraries, forests and worlds made at random, for properties that must hold for all of them."""

from collections.abc import Callable, Sequence
from random import Random
from typing import TypeVar

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
)
from app.core.hierarchy import Hierarchy, Node
from app.core.library import Library, NodeType, Types
from app.core.machine import Machine
from app.core.tree import Branch, Forest, Leaf, Tree, TreeNode
from app.core.vocabulary import DONE, FAILED, FINISHED, NO_ENTITY, Vocabulary
from tests.samples import AGENT, GROUP, SQUAD, vocabulary

T = TypeVar("T")

#: Squads may have agents directly under them, so that forests can be irregular.
TYPES = (NodeType(AGENT), NodeType(GROUP, 1, (AGENT,)), NodeType(SQUAD, 2, (GROUP, AGENT)))
FLAGS = (DONE, FAILED, "odd")
CATEGORIES = 3


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


def random_guard(random: Random, features: Sequence[FeatureUse]) -> Guard:
    """None to two conditions."""
    if not features:
        return ()
    chosen = random.choices(features, k=random.randrange(3))
    return tuple(Condition(random_test(random, use), random.random() < 0.7) for use in chosen)


def random_test(random: Random, use: FeatureUse) -> Test:
    """A test that fits the values that a feature takes."""
    match use.source:
        case Sense("DistanceTo") | Statistic(_, Sense("DistanceTo")):
            return AtMost(use.id, random.uniform(0.0, 100.0))
        case Sense("DirectionTo"):
            return InArc(use.id, random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0))
        case Sense("Ground"):
            return Equals(use.id, float(random.randrange(CATEGORIES)))
        case TicksInState():
            return AtMost(use.id, random.randrange(4) + 0.5)
        case Statistic():
            return AtMost(use.id, random.choice((0.0, 0.5, 1.0)))
        case _:
            return Equals(use.id, float(random.randrange(2)))


def random_tree(
    random: Random, labels: tuple[str, ...], features: Sequence[FeatureUse], depth: int = 3
) -> Tree:
    """A tree over *labels*; some of its leaves are empty."""

    def grow(depth: int) -> TreeNode:
        if depth == 0 or not features or random.random() < 0.3:
            return Leaf(tuple(float(random.choice((0, 0, 1, 2, 5))) for _ in labels))
        test = random_test(random, random.choice(features))
        yes, no = grow(depth - 1), grow(depth - 1)
        return Branch(test, yes, no, tuple(a + b for a, b in zip(yes.counts, no.counts, strict=True)))

    return Tree(labels, grow(depth))


class Author:
    """Writes the automata of one node type, each from the vocabulary and those before it."""

    def __init__(self, random: Random, words: Vocabulary) -> None:
        self._random = random
        self._words = words
        self.written: list[Automaton] = []

    def write(self, number: int) -> None:
        """Add one more automaton."""
        random = self._random
        parameters = ("target",) if random.random() < 0.4 else ()
        held = [State(f"s{k}", self._content(parameters)) for k in range(random.randrange(1, 5))]
        ids = tuple(state.id for state in held)
        features = tuple(FeatureUse(f"f{k}", self._source(parameters)) for k in range(random.randrange(1, 5)))
        name = f"{AGENT if self._words.level == 0 else f'level{self._words.level}'}-{number}"
        self.written.append(
            Automaton(
                name,
                name,
                parameters,
                (State(START, Start()), *held),
                features,
                self._rules(ids, features),
                self._learned(ids, features),
                prunes=self._prunes(ids, features),
                settings=Settings(sampling=random.choice(list(Sampling))),
            )
        )

    def _content(self, parameters: tuple[str, ...]) -> Content:
        random = self._random
        sort = random.random()
        if sort < 0.35 and self.written:
            nested = random.choice(self.written)
            return Nested(nested.id, self._bindings(nested.parameters, parameters))
        if sort < 0.5 or not self._words.behaviors:
            return RaiseFlag(random.choice(FLAGS))
        known = list(self._words.behaviors.values())
        basic = random.choice([b for b in known if "-" in b.name and random.random() < 0.7] or known)
        return Basic(basic.name, self._bindings(basic.parameters, parameters))

    def _bindings(self, slots: tuple[str, ...], parameters: tuple[str, ...]) -> Bindings:
        targets = [target.name for target in self._words.targets.values()]
        choices: list[Binding] = [*map(Ground, targets), *map(Parameter, parameters)]
        return {slot: self._random.choice(choices) for slot in slots}

    def _source(self, parameters: tuple[str, ...]) -> Source:
        random, level = self._random, self._words.level
        built_in: Source = random.choice((FlagUp(random.choice(FLAGS)), TicksInState()))
        if level == 0:
            return random.choice((built_in, self._sense(self._words, parameters)))
        flag = FlagUp(random.choice((*FLAGS, FINISHED)))
        of = random.choice((flag, flag, flag, self._sense(vocabulary(), parameters)))
        statistic = Statistic(random.choice(list(Operation)), of, random.choice(list(Over)))
        return random.choice((built_in, Sense("SomeoneNeedsHelp"), statistic, statistic, statistic))

    def _sense(self, words: Vocabulary, parameters: tuple[str, ...]) -> Sense:
        feature = self._random.choice([f for f in words.features.values() if f.whose == "agent"])
        return Sense(feature.name, self._bindings(feature.parameters, parameters))

    def _rules(self, ids: tuple[str, ...], features: tuple[FeatureUse, ...]) -> tuple[Rule, ...]:
        random, places = self._random, (START, *ids)
        begin = Rule(
            "0", START, random_guard(random, features), random.choice(ids), random.choice((0.5, 1.0))
        )
        others = (
            Rule(
                str(number),
                random.choice(places),
                random_guard(random, features),
                random.choice(places),
                random.choice((0.2, 0.5, 1.0)),
            )
            for number in range(1, random.randrange(1, 7))
        )
        return (begin, *others)

    def _learned(self, ids: tuple[str, ...], features: tuple[FeatureUse, ...]) -> dict[str, Tree | Forest]:
        random, learned = self._random, dict[str, Tree | Forest]()
        for place in (START, *ids):
            if random.random() < 0.5:
                learned[place] = random_tree(random, ids, features)
            elif random.random() < 0.2:
                learned[place] = Forest(ids, tuple(random_tree(random, ids, features, 2) for _ in range(2)))
        return learned

    def _prunes(self, ids: tuple[str, ...], features: tuple[FeatureUse, ...]) -> tuple[Prune, ...]:
        random = self._random
        return tuple(
            Prune(
                str(number),
                random.choice((START, *ids)),
                random_guard(random, features),
                frozenset({random.choice(ids)}),
            )
            for number in range(random.randrange(3))
        )


def random_types(random: Random, each: int = 3) -> Types:
    """Node types with *each* random automata a type."""
    scenario, libraries = vocabulary(), dict[str, Library]()
    for node_type in TYPES:
        author = Author(random, Types(TYPES, libraries, scenario).vocabulary(node_type.name))
        for number in range(each):
            author.write(number)
        libraries[node_type.name] = Library({a.id: a for a in author.written})
    return Types(TYPES, libraries, scenario)


def random_forest(random: Random) -> Hierarchy:
    """One to three roots of any level, with agents at any depth."""
    count = 0

    def grow(node_type: NodeType) -> Node:
        nonlocal count
        count += 1
        node_id = f"{node_type.name}-{count}"
        kinds = [kind for kind in TYPES if kind.name in node_type.subsidiaries]
        children = tuple(grow(random.choice(kinds)) for _ in range(random.randrange(1, 4))) if kinds else ()
        return Node(node_id, node_type.name, children)

    return Hierarchy(tuple(grow(random.choice(TYPES)) for _ in range(random.randrange(1, 4))))


def random_machine(
    random: Random,
    forest: Hierarchy,
    types: Types,
    make: Callable[[Hierarchy, Types, int], Machine] = Machine,
) -> Machine:
    """A machine whose roots all run something."""
    machine = make(forest, types, world_key(random.randrange(1 << 32), 0))
    for root in forest.roots:
        repertoire = types.repertoire(root.type)
        name = random.choice(sorted(name for name in repertoire if "-" in name) or sorted(repertoire))
        machine.direct(
            root.id, name, {slot: Argument("deposit", root.id) for slot in repertoire[name].parameters}
        )
    return machine
