"""Random libraries, forests and worlds of the playground, for engines that must agree on every run."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from random import Random

from app.core.actor import Actor, Argument, Run
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
    State,
)
from app.core.automaton import Start as StartContent
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
from app.core.hierarchy import Hierarchy, Node, from_table
from app.core.library import Library, NodeType, Types, statistic_vocabulary
from app.core.machine import Senses
from app.core.machine_state import freeze
from app.core.tree import Branch, Forest, Leaf, Tree, TreeNode
from app.core.vocabulary import DONE, FAILED, FINISHED, FeatureKind, Vocabulary
from app.sim.engine import Engine, Start
from app.sim.reference import ReferenceEngine
from tests.playground import scenario as playground

TYPES = (
    NodeType("child"),
    NodeType("group", 1, ("child",)),
    NodeType("school", 2, ("group", "child")),
)
FLAGS = (DONE, FAILED, "thrown", "odd")
#: Automata of a library, each of which may hold those before it.
LEVELS = 3
DEEPEST = 6


@dataclass(slots=True)
class Author:
    """Writes the library of one node type."""

    random: Random
    types: Types
    type_name: str
    written: list[Automaton] = field(default_factory=list)

    @property
    def words(self) -> Vocabulary:
        return self.types.vocabulary(self.type_name)

    def write(self, level: int) -> None:
        """Add an automaton; the one at level 0 holds basic behaviors alone, others those written before."""
        random = self.random
        parameters = random.choice(((), ("goal",), ("goal", "other"), ("goal", "other")))
        held = [State(f"s{k}", self.content(parameters, level)) for k in range(random.randrange(2, 5))]
        ids = (START, *(state.id for state in held))
        features = tuple(FeatureUse(f"f{k}", self.source(parameters)) for k in range(random.randrange(2, 6)))
        name = f"{self.type_name} {level}"
        bare = Automaton(name, name, parameters, (State(START, StartContent()), *held), features)
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
        if random.random() < (0.1 if controls else 0.3):
            return random.choice((FlagUp(random.choice(FLAGS)), TicksInState()))
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
        """A test that both passes and fails in a playground."""
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
        return AtMost(use.id, random.uniform(0.0, 8.0))


def harmless() -> Vocabulary:
    """What can be done and seen in the playground, without what is there to go wrong."""
    full = playground.vocabulary
    return Vocabulary(
        0,
        {name: b for name, b in full.behaviors.items() if name != "Swing"},
        {name: f for name, f in full.features.items() if name != "Doubt"},
        {name: t for name, t in full.targets.items() if name != "somebody"},
    )


def random_types(random: Random) -> Types:
    """Libraries of automata up to three levels deep for children, groups and schools."""
    words = harmless()
    libraries: dict[str, Library] = {}
    for node_type in TYPES:
        author = Author(random, Types(TYPES, libraries, words), node_type.name)
        for level in range(LEVELS):
            author.write(level)
        libraries[node_type.name] = Library({a.id: a for a in author.written})
    return Types(TYPES, libraries, words)


def random_forest(random: Random) -> Hierarchy:
    """One to three roots of any level, children at any depth."""
    count = 0

    def grow(node_type: NodeType) -> Node:
        nonlocal count
        count += 1
        node_id = f"{node_type.name}-{count}"
        kinds = [kind for kind in TYPES if kind.name in node_type.subsidiaries]
        children = tuple(grow(random.choice(kinds)) for _ in range(random.randrange(1, 4))) if kinds else ()
        return Node(node_id, node_type.name, children)

    return Hierarchy(tuple(grow(random.choice(TYPES)) for _ in range(random.randrange(1, 4))))


def random_start(seed: int) -> Start:
    """A run that is ready to begin; the roots idle."""
    random = Random(seed)
    parameters = {
        "stones": random.randrange(5),
        "slippery": random.random() < 0.5,
        "ground": random.choice(("flat", "hilly")),
    }
    types, forest = random_types(random), random_forest(random)
    return Start(playground, playground.settle(parameters), forest, types, random.randrange(1 << 62))


def two_owners() -> Start:
    """A school and a group both bind "last" for the same child, which looks at both: who means whom matters."""
    slots = {"a": Parameter("goal"), "b": Parameter("other")}
    gap = FeatureUse("gap", Sense("Gap", slots))
    child = Automaton(
        "child 2",
        "child 2",
        ("goal", "other"),
        (State(START, StartContent()), State("near", Basic("Between", slots)), State("far", Basic("Take"))),
        (gap,),
        tuple(
            Rule(f"{source}-{goal}", source, (Condition(AtMost("gap", 2.0), wanted),), goal)
            for source in (START, "near", "far")
            for goal, wanted in (("near", True), ("far", False))
        ),
    )
    group = _passes_on("group 2", "child 2", ("goal",), {"goal": Parameter("goal"), "other": Ground("last")})
    school = _passes_on("school 2", "group 2", (), {"goal": Ground("last")})
    made = {name: Library({a.id: a}) for name, a in (("child", child), ("group", group), ("school", school))}
    schools = replace(TYPES[2], subsidiaries=("group",))
    types = Types((*TYPES[:2], schools), made, playground.vocabulary)
    forest = from_table((1, 2, 3), ("school", "group", "child"))
    return Start(playground, playground.settle({}), forest, types, 1, top="school 2")


def _passes_on(name: str, behavior: str, parameters: tuple[str, ...], bindings: Bindings) -> Automaton:
    """A controller's automaton that directs one thing for good."""
    states = (State(START, StartContent()), State("go", Basic(behavior, bindings)))
    return Automaton(name, name, parameters, states, rules=(Rule("1", START, (), "go"),))


def direct_roots(engine: Engine, seed: int) -> None:
    """Let every root do something, most of them their most complex behavior."""
    random, machine = Random(seed), engine.machine
    for root in [actor.node for actor in machine.actors.values() if actor.parent is None]:
        repertoire = machine.types.repertoire(root.type)
        name = f"{root.type} {LEVELS - 1}" if random.random() < 0.8 else random.choice(sorted(repertoire))
        slots = repertoire[name].parameters
        targets = sorted(machine.types.vocabulary(root.type).targets)
        machine.direct(root.id, name, {slot: Argument(random.choice(targets), root.id) for slot in slots})


# -------------------------------------------------------------------------------------------- comparing


def difference(found: Engine, wanted: Engine) -> str:
    """The first quantity in which two engines differ, or nothing."""
    world, right = found.frozen_world(), wanted.frozen_world()
    for name, column in right.items():
        for entity, value in enumerate(column):
            if repr(world[name][entity]) != repr(value):
                return f"{name} of entity {entity} is {world[name][entity]!r}, not {value!r}"
    nodes, rightly = freeze(found.machine)["nodes"], freeze(wanted.machine)["nodes"]
    for node, does in rightly.items():
        for what, value in does.items():
            if nodes[node][what] != value:
                return f"{what} of node {node} is {nodes[node][what]!r}, not {value!r}"
    return ""


def compare(found: Engine, wanted: ReferenceEngine, ticks: int) -> None:
    """Pass ticks in both engines; they must agree after each."""
    assert difference(found, wanted) == ""
    for _ in range(ticks):
        tick = wanted.tick
        found.step()
        wanted.step()
        differs = difference(found, wanted)
        assert not differs, f"after tick {tick}: {differs}"


# --------------------------------------------------------------------------------------- what was reached


class Witness:
    """Notes what happens in a reference engine's runs.

    Attributes:
        reached: Words for what happened at least once.
    """

    def __init__(self) -> None:
        self.reached: set[str] = set()

    def watch(self, engine: ReferenceEngine) -> None:
        """Note what is sensed from now on."""
        machine = engine.machine
        plain = machine.value

        def noted(actor: Actor, run: Run, use: FeatureUse, senses: Senses) -> float:
            value = plain(actor, run, use, senses)
            self.reached.add(f"{_sort(use.source)} {'zero' if value == 0.0 else 'not zero'}")
            if isinstance(use.source, Sense | Statistic):
                self.reached.add(_name(use.source))
            return value

        machine.value = noted  # type: ignore[method-assign]

    def look(self, engine: ReferenceEngine) -> None:
        """Note what the nodes do and hold after a tick."""
        for actor in engine.machine.actors.values():
            level = actor.node.level
            self.reached |= {f"{flag} on level {level}" for flag in actor.flags}
            run, depth = actor.run, 0
            while run is not None:
                self.reached |= {f"{flag} on level {level}" for flag in run.flags}
                if isinstance(run.behavior, Automaton):
                    if run.entered == engine.tick - 1 and run.child is not None:
                        self.reached.add(f"transition of depth {depth} on level {level}")
                    if run.key is not None:
                        self.reached.add(f"{run.behavior.settings.sampling.value} on level {level}")
                run, depth = run.child, depth + 1
        if any(holds >= 0 for holds in engine.world.holds):
            self.reached.add("a child holds a stone")
        if engine.world.dropped[0] > 0:
            self.reached.add("a stone is in the pit")


def _sort(source: Source) -> str:
    if isinstance(source, Statistic):
        return f"{source.operation.value} {_sort(source.of)}"
    return type(source).__name__


def _name(source: Sense | Statistic) -> str:
    if isinstance(source, Statistic):
        return f"{source.over.value}: {_name(source.of) if isinstance(source.of, Sense) else source.of.flag}"
    return source.feature


def everything() -> set[str]:
    """What runs have to reach so that comparing them means something."""
    sources = {"Sense", "FlagUp", "TicksInState"}
    sources |= {f"{operation.value} {of}" for operation in Operation for of in ("Sense", "FlagUp")}
    wanted = {f"{source} {value}" for source in sources for value in ("zero", "not zero")}
    wanted |= set(harmless().features)
    agent = [name for name, f in harmless().features.items() if f.whose == "agent"]
    wanted |= {f"{over.value}: {of}" for over in Over for of in (*agent, *FLAGS, FINISHED)}
    wanted |= {f"{flag} on level {level}" for flag in FLAGS for level in range(3)}
    wanted |= {f"transition of depth {depth} on level {level}" for depth in range(3) for level in range(3)}
    wanted |= {f"{sampling.value} on level {level}" for sampling in Sampling for level in range(3)}
    return wanted | {"finished on level 0", "a child holds a stone", "a stone is in the pit"}
