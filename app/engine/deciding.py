"""What decides between the states that can come next: a rule, a leaf of a tree, or another model; found without a draw."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from ..core.automaton import Automaton, Prune, Rule
from ..core.conditions import Condition, Guard
from ..core.examples import Example, enabled
from ..core.tree import Leaf, Tree, TreeNode

Values = Mapping[str, float]


@dataclass(frozen=True, slots=True)
class Way:
    """A way from a state to others: an authored rule, or a leaf of its tree.

    Attributes:
        guard: Where it is gone; for a rule without tests, where the rules before it do not apply.
        shares: State -> probability, of those that can come next; what is left goes on to the next way.
        rule: The rule's id; empty for a leaf.
        by_chance: It is a rule that does not always apply where its tests come out so.
        examples: The enabled examples of the state that end in the leaf.
        prunes: Those that take something away from the leaf.
    """

    guard: Guard
    shares: Mapping[str, float]
    rule: str = ""
    by_chance: bool = False
    examples: tuple[Example, ...] = ()
    prunes: tuple[str, ...] = ()

    def failing(self, values: Values) -> Guard:
        """The tests that come out otherwise now."""
        return tuple(condition for condition in self.guard if not _met(condition, values))


def deciding_way(
    automaton: Automaton, state: str, values: Values, goes: str, examples: Iterable[Example]
) -> Way | None:
    """What speaks most for *goes* as the next state: the rule, or the leaf; None if neither does.

    Args:
        values: What is seen now. A feature that is missing counts as failing every test.
        examples: Of the automaton.
    """
    found: tuple[float, Way] | None = None
    left = 1.0
    for way in ways(automaton, state, values, examples):
        if left > 0.0 and not way.failing(values):
            share = left * way.shares.get(goes, 0.0)
            if share > 0.0 and (found is None or share > found[0]):
                found = share, way
            left *= 1.0 - sum(way.shares.values()) if way.rule else 0.0
    if goes == state and left > (found[0] if found else 0.0):
        return _staying(automaton, state, values)
    return None if found is None else found[1]


def _staying(automaton: Automaton, state: str, values: Values) -> Way | None:
    """Where nothing is left but to stay: since no rule applies, or only by chance."""
    rules = automaton.rules_of(state)
    if not rules or state in automaton.learned:
        return None
    by_chance = any(not _fails(rule.guard, values) for rule in rules)
    return Way(_otherwise(rules, values), {state: 1.0}, by_chance=by_chance)


def _fails(guard: Guard, values: Values) -> bool:
    return any(not _met(condition, values) for condition in guard)


def ways(automaton: Automaton, state: str, values: Values, examples: Iterable[Example]) -> Iterator[Way]:
    """All ways that lead on from *state*: its rules in order, then the leaves of its tree."""
    before: list[Rule] = []
    for rule in automaton.rules_of(state):
        guard = rule.guard or _otherwise(before, values)
        yield Way(guard, {rule.target: rule.probability}, rule.id, by_chance=rule.probability < 1.0)
        before.append(rule)
    model = automaton.learned.get(state)
    if isinstance(model, Tree):
        own = enabled(tuple(examples), state)
        for path, leaf in leaves(model.root):
            prunes = [prune for prune in automaton.prunes_of(state) if _applies(prune, path, values)]
            yield _leaf_way(model, path, leaf, own, prunes)


def _leaf_way(
    tree: Tree, path: Guard, leaf: Leaf, examples: Sequence[Example], prunes: Sequence[Prune]
) -> Way:
    ending = tuple(example for example in examples if not _fails(path, example.values))
    forbidden = {label for prune in prunes for label in prune.forbidden}
    counts = {
        label: count
        for label, count in zip(tree.labels, leaf.counts, strict=True)
        if count > 0.0 and label not in forbidden
    }
    total = sum(counts.values())
    shares = {label: count / total for label, count in counts.items()}
    return Way(path, shares, examples=ending, prunes=tuple(prune.id for prune in prunes))


def _applies(prune: Prune, path: Guard, values: Values) -> bool:
    """Whether a prune takes something away from a leaf: from the one reached now, or from all that reaches it."""
    return set(prune.guard) <= set(path) or not (_fails(path, values) or _fails(prune.guard, values))


def leaves(node: TreeNode, path: Guard = ()) -> Iterator[tuple[Guard, Leaf]]:
    """Each leaf with the tests on the way to it, as they come out there."""
    waiting: list[tuple[TreeNode, Guard]] = [(node, path)]
    while waiting:
        here, way = waiting.pop()
        if isinstance(here, Leaf):
            yield way, here
        else:
            waiting += [
                (here.no, (*way, Condition(here.test, wanted=False))),
                (here.yes, (*way, Condition(here.test))),
            ]


def _otherwise(before: Sequence[Rule], values: Values) -> Guard:
    """Why the rules before do not apply now: of each, the first test that fails, turned around."""
    turned: list[Condition] = []
    for rule in before:
        failing = next((condition for condition in rule.guard if not _met(condition, values)), None)
        if failing is not None:
            turned.append(Condition(failing.test, not failing.wanted))
    return tuple(turned)


def _met(condition: Condition, values: Values) -> bool:
    value = values.get(condition.test.feature)
    return value is not None and condition.test.holds(value) == condition.wanted
