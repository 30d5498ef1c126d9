"""One neutral graph of an automaton: its states, and the ways from each to each, in words.

The window draws it, and export formats are made from it. Ways between the same two states share an edge. A tree can
have thousands of leaves, so an edge keeps its strongest ways and counts the others.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from heapq import nlargest

from ..core.automaton import Automaton, Basic, Content, Nested, Prune, RaiseFlag, Rule, State
from ..core.conditions import AtMost, Condition, Equals, Guard
from ..core.examples import Example
from ..core.implication import guard_implied
from ..core.library import Library
from ..core.phrasing import number
from ..core.transition import pruned
from ..core.tree import Branch, Tree, TreeNode, shares
from ..core.vocabulary import Vocabulary
from ..core.wording import feature_of, guard_words, rule_words, state_words

#: An edge lists no more ways than this; the others are counted.
MOST_WAYS = 8


class StateKind(StrEnum):
    """What a state holds."""

    START = "start"
    BASIC = "basic"
    NESTED = "nested"
    FLAG = "flag"


class WayKind(StrEnum):
    """What leads from a state to another."""

    RULE = "rule"
    LEAF = "leaf"
    MODEL = "model"


@dataclass(frozen=True, slots=True)
class GraphState:
    """A state as it is drawn.

    Attributes:
        name: What the user calls it.
        nested: Id of the automaton that it holds; empty if it holds none.
        raises: The flag that it raises itself, if it is a flag.
    """

    id: str
    name: str
    kind: StateKind
    content: Content
    nested: str = ""
    raises: str = ""
    note: str = ""


@dataclass(frozen=True, slots=True)
class Way:
    """One way from a state to a state.

    Attributes:
        guard: What must hold.
        words: The same in words.
        probability: A rule's own; of what was learned, the share at its leaf that prunes leave.
        support: How many examples (their weights) speak for it; 0 for a rule.
        total: How many there are at the leaf.
        order: Place of a rule among those of its state, from 1; 0 otherwise.
        id: The rule's; empty otherwise.
        prunes: Ids of the prunes that forbid it.
        shadowed: Rules before it leave it nothing.
    """

    kind: WayKind
    guard: Guard
    words: str
    probability: float
    support: float = 0.0
    total: float = 0.0
    order: int = 0
    id: str = ""
    prunes: tuple[str, ...] = ()
    shadowed: bool = False

    @property
    def is_open(self) -> bool:
        """Whether it can be gone."""
        return not self.prunes and not self.shadowed and self.probability > 0.0


@dataclass(frozen=True, slots=True)
class Edge:
    """All ways from one state to another.

    Attributes:
        ways: Rules in their order, then what was learned, the best supported first.
        more: How many further learned ways there are.
        support: How many examples speak for all of them.
    """

    source: str
    target: str
    ways: tuple[Way, ...]
    more: int = 0
    support: float = 0.0

    @property
    def rules(self) -> tuple[Way, ...]:
        """The authored ways."""
        return tuple(way for way in self.ways if way.kind is WayKind.RULE)

    @property
    def is_open(self) -> bool:
        """Whether one of its ways can be gone."""
        return self.more > 0 or any(way.is_open for way in self.ways)

    @property
    def is_pruned(self) -> bool:
        """Whether it was learned, but prunes forbid all of it."""
        return not self.more and bool(self.ways) and all(way.prunes for way in self.ways)


@dataclass(frozen=True, slots=True)
class AutomatonGraph:
    """An automaton as a graph."""

    id: str
    name: str
    states: tuple[GraphState, ...]
    edges: tuple[Edge, ...]


def graph_with(automaton: Automaton, library: Library, edges: Iterable[Edge]) -> AutomatonGraph:
    """The graph of an automaton whose edges are known, see `edges_from`."""
    states = tuple(_state(state, automaton, library) for state in automaton.states)
    there = {state.id for state in states}
    leading = tuple(edge for edge in edges if edge.target in there)
    return AutomatonGraph(automaton.id, automaton.name, states, leading)


def _state(state: State, automaton: Automaton, library: Library) -> GraphState:
    kind, nested, raises = StateKind.START, "", ""
    match state.content:
        case Basic():
            kind = StateKind.BASIC
        case Nested(nested):
            kind = StateKind.NESTED
        case RaiseFlag(raises):
            kind = StateKind.FLAG
    name = state_words(automaton, state.id, library)
    return GraphState(state.id, name, kind, state.content, nested, raises, state.note)


# ---------------------------------------------------------------------------------------------------- edges


def edges_from(
    source: str, automaton: Automaton, vocabulary: Vocabulary, examples: Sequence[Example] = ()
) -> Iterator[Edge]:
    """The edges that leave a state.

    Args:
        vocabulary: The scenario's.
        examples: Of the automaton; what a model without a table form learned is read from them.
    """
    rules, learned = _rules(source, automaton, vocabulary), _learned(source, automaton, examples)
    for target in dict.fromkeys([*rules, *learned]):
        leaves = learned.get(target, [])
        best = nlargest(MOST_WAYS, leaves, key=lambda leaf: leaf.support)
        ways = [leaf.way(automaton, vocabulary) for leaf in best]
        support = sum(leaf.support for leaf in leaves)
        yield Edge(source, target, (*rules.get(target, ()), *ways), len(leaves) - len(best), support)


def _rules(source: str, automaton: Automaton, vocabulary: Vocabulary) -> dict[str, list[Way]]:
    by_target: dict[str, list[Way]] = {}
    before: list[Rule] = []
    for order, rule in enumerate(automaton.rules_of(source), 1):
        way = Way(
            WayKind.RULE,
            rule.guard,
            rule_words(rule, automaton, vocabulary),
            rule.probability,
            order=order,
            id=rule.id,
            shadowed=_shadowed(before, rule.guard),
        )
        by_target.setdefault(rule.target, []).append(way)
        before.append(rule)
    return by_target


def _shadowed(rules: Iterable[Rule], guard: Guard) -> bool:
    """Whether one of *rules* is surely met wherever *guard* is, and leaves nothing."""
    return any(rule.probability >= 1.0 and guard_implied(rule.guard, guard) for rule in rules)


@dataclass(slots=True)
class _Leaf:
    """What one leaf says for one label, before it is put into words."""

    path: "_Path | None"
    probability: float
    support: float
    total: float
    kind: WayKind = WayKind.LEAF
    words: str = ""
    prunes: tuple[str, ...] = ()
    shadowed: bool = False

    def way(self, automaton: Automaton, vocabulary: Vocabulary) -> Way:
        guard = _guard(self.path)
        words = self.words or guard_words(guard, automaton, vocabulary)
        return Way(
            self.kind,
            guard,
            words,
            self.probability,
            self.support,
            self.total,
            prunes=self.prunes,
            shadowed=self.shadowed,
        )


#: A way down a tree: what was tested last, and what before.
_Path = tuple["_Path | None", Condition]


def _guard(path: _Path | None) -> Guard:
    found: list[Condition] = []
    while path is not None:
        path, condition = path
        found.append(condition)
    return tuple(reversed(found))


def _learned(source: str, automaton: Automaton, examples: Sequence[Example]) -> dict[str, list[_Leaf]]:
    model = automaton.learned.get(source)
    if model is None:
        return {}
    if isinstance(model, Tree):
        return _leaves(model, automaton.rules_of(source), automaton.prunes_of(source))
    return _by_example(source, automaton, examples)


def _leaves(tree: Tree, rules: Sequence[Rule], prunes: Sequence[Prune]) -> dict[str, list[_Leaf]]:
    by_target: dict[str, list[_Leaf]] = {}
    for path, counts in _ends(tree.root):
        guard = _guard(path) if rules or prunes else ()
        shadowed = _shadowed(rules, guard)
        holding = [prune for prune in prunes if guard_implied(prune.guard, guard)]
        bare = [Prune(prune.id, prune.source, (), prune.forbidden) for prune in holding]
        left = pruned(shares(counts), tree.labels, bare, lambda _: 0.0)
        for label, count, p in zip(tree.labels, counts, left, strict=True):
            if count > 0.0:
                by = tuple(prune.id for prune in holding if label in prune.forbidden)
                leaf = _Leaf(path, p, count, sum(counts), prunes=by, shadowed=shadowed)
                by_target.setdefault(label, []).append(leaf)
    return by_target


def _ends(root: TreeNode) -> Iterator[tuple[_Path | None, tuple[float, ...]]]:
    """The leaves with the ways to them, however deep."""
    stack: list[tuple[TreeNode, _Path | None]] = [(root, None)]
    while stack:
        node, path = stack.pop()
        if isinstance(node, Branch):
            stack.append((node.no, (path, Condition(node.test, wanted=False))))
            stack.append((node.yes, (path, Condition(node.test))))
        else:
            yield path, node.counts


def _by_example(source: str, automaton: Automaton, examples: Sequence[Example]) -> dict[str, list[_Leaf]]:
    """What a forest, or a model without a table form, learned: where the examples lead."""
    counts: dict[str, float] = {}
    for example in examples:
        if example.enabled and example.source == source:
            counts[example.label] = counts.get(example.label, 0.0) + example.weight
    total = sum(counts.values())
    forbidden = {
        label: tuple(prune.id for prune in automaton.prunes_of(source) if label in prune.forbidden)
        for label in counts
    }
    words = f"as its {automaton.settings.classifier} model says"
    return {
        label: [_Leaf(None, count / total, count, total, WayKind.MODEL, words, forbidden[label])]
        for label, count in counts.items()
        if total > 0.0
    }


# ---------------------------------------------------------------------------------------------------- words


def way_words(way: Way) -> str:
    """A way in full: "sees a box, 2 of 2 examples · p 1.0", "rule 2: sees a box · p 0.5"."""
    if way.kind is WayKind.RULE:
        share = "" if way.probability >= 1.0 else f" · p {number(way.probability)}"
        return f"rule {way.order}: {way.words}{share}" + (" (never reached)" if way.shadowed else "")
    ending = " (pruned)" if way.prunes else " (rules decide before)" if way.shadowed else ""
    return f"{way.words}, {count_words(way)}{ending}"


def count_words(way: Way) -> str:
    """How well a learned way is supported: "2 of 2 examples · p 1.0"."""
    many = "example" if way.total == 1.0 else "examples"
    p = f"{way.probability:.1f}" if way.probability in (0.0, 1.0) else number(way.probability, 2)
    return f"{number(way.support)} of {number(way.total)} {many} · p {p}"


def formal_words(condition: Condition, automaton: Automaton) -> str:
    """A test as it is computed, with its numbers: "DistanceTo(deposit) ≤ 4.5"."""
    test, name = condition.test, feature_of(automaton, condition.test.feature).shown
    match test:
        case AtMost(_, threshold):
            return f"{name} {'≤' if condition.wanted else '>'} {threshold!r}"
        case Equals(_, value):
            return f"{name} {'=' if condition.wanted else '≠'} {value:g}"
    return f"{name} {'in' if condition.wanted else 'not in'} [{test.start!r}, {test.end!r})"
