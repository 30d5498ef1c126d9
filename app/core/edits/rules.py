"""Edits of authored transitions: rules in the order in which they are tried, also made from learned trees."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from ..automaton import Automaton, Model, Prune, Rule
from ..conditions import Condition, Guard
from ..errors import EditError
from ..naming import next_number
from ..project import Project
from ..transition import pruned
from ..tree import Branch, Leaf, Tree, TreeNode, shares
from .place import change, find_automaton, find_feature, find_index, listed, replaced
from .states import refuse_states
from .words import says


@says("Add a rule to {automaton_id}")
def add_rule(
    project: Project,
    type_name: str,
    automaton_id: str,
    source: str,
    target: str,
    guard: Guard = (),
    probability: float = 1.0,
) -> tuple[Project, str]:
    """One more rule, tried after the others of its source; also returns its id."""
    automaton = find_automaton(project, type_name, automaton_id)
    rule = Rule(str(next_number(r.id for r in automaton.rules)), source, guard, target, probability)
    refuse_rule(automaton, rule)
    return change(project, type_name, automaton_id, rules=(*automaton.rules, rule)), rule.id


@says("Change rule {rule_id} of {automaton_id}")
def replace_rule(
    project: Project,
    type_name: str,
    automaton_id: str,
    rule_id: str,
    *,
    source: str | None = None,
    target: str | None = None,
    guard: Guard | None = None,
    probability: float | None = None,
) -> Project:
    """Another source, target, guard or probability for a rule; what is None stays."""
    automaton = find_automaton(project, type_name, automaton_id)
    index = _rule_index(automaton, rule_id)
    old = automaton.rules[index]
    new = Rule(
        rule_id,
        old.source if source is None else source,
        old.guard if guard is None else guard,
        old.target if target is None else target,
        old.probability if probability is None else probability,
    )
    refuse_rule(automaton, new)
    rules = replaced(automaton.rules, index, new)
    return change(project, type_name, automaton_id, rules=rules)


@says("Remove rule {rule_id} of {automaton_id}")
def remove_rule(project: Project, type_name: str, automaton_id: str, rule_id: str) -> Project:
    """No such rule any more."""
    automaton = find_automaton(project, type_name, automaton_id)
    index = _rule_index(automaton, rule_id)
    rules = replaced(automaton.rules, index)
    return change(project, type_name, automaton_id, rules=rules)


@says("Remove the rules of state {state_id} of {automaton_id}")
def remove_rules_of(project: Project, type_name: str, automaton_id: str, state_id: str) -> Project:
    """No rules that leave a state any more, so that what it learned decides alone."""
    automaton = find_automaton(project, type_name, automaton_id)
    refuse_states(automaton, [state_id])
    rules = tuple(rule for rule in automaton.rules if rule.source != state_id)
    return change(project, type_name, automaton_id, rules=rules)


@says("Reorder the rules of state {state_id} of {automaton_id}")
def order_rules(
    project: Project, type_name: str, automaton_id: str, state_id: str, rule_ids: Sequence[str]
) -> Project:
    """Try the rules that leave a state in this order.

    Raises:
        EditError: *rule_ids* are not just the rules of that state.
    """
    automaton = find_automaton(project, type_name, automaton_id)
    there = {rule.id: rule for rule in automaton.rules_of(state_id)}
    if sorted(rule_ids) != sorted(there):
        raise EditError(
            f"the rules of state {state_id!r} of {automaton.name} are {listed(there)}, each to be named once, "
            f"but the order is {listed(rule_ids)}"
        )
    following = iter(rule_ids)
    rules = tuple(there[next(following)] if rule.source == state_id else rule for rule in automaton.rules)
    return change(project, type_name, automaton_id, rules=rules)


def refuse_rule(automaton: Automaton, rule: Rule) -> None:
    """Raise an `EditError` if a rule names what the automaton has not, or its probability is none."""
    refuse_states(automaton, (rule.source, rule.target))
    refuse_guard(automaton, rule.guard)
    if not 0.0 <= rule.probability <= 1.0:
        raise EditError(f"the probability of rule {rule.id!r} is {rule.probability}; allowed: 0 to 1")


def refuse_guard(automaton: Automaton, guard: Guard) -> None:
    """Raise an `EditError` if a guard tests a feature that the automaton has not."""
    for condition in guard:
        find_feature(automaton, condition.test.feature)


def _rule_index(automaton: Automaton, rule_id: str) -> int:
    return find_index([rule.id for rule in automaton.rules], rule_id, "rule", automaton.name)


# ------------------------------------------------------------------------------- rules from learned trees


@says("Turn what state {state_id} of {automaton_id} learned into rules")
def author_learned(project: Project, type_name: str, automaton_id: str, state_id: str) -> Project:
    """Rules that do what a state's tree and prunes do now, after the rules that it has.

    The tree stays, but is no longer reached; `remove_rules_of` gives it the word again.

    Raises:
        EditError: The state has learned nothing, or a model that is not one tree.
    """
    automaton = find_automaton(project, type_name, automaton_id)
    refuse_states(automaton, [state_id])
    tree = _only_tree(automaton, state_id)
    number = next_number(rule.id for rule in automaton.rules)
    made = tuple(
        Rule(str(number + i), state_id, guard, target, probability)
        for i, (guard, target, probability) in enumerate(
            _authored(tree, automaton.prunes_of(state_id), state_id)
        )
    )
    return change(project, type_name, automaton_id, rules=(*automaton.rules, *made))


def _only_tree(automaton: Automaton, state_id: str) -> Tree:
    model: Model | None = automaton.learned.get(state_id)
    if isinstance(model, Tree):
        return model
    found = "nothing" if model is None else f"a {type(model).__name__.lower()}"
    raise EditError(
        f"state {state_id!r} of {automaton.name} has learned {found}; only a tree can be turned into rules"
    )


def _authored(tree: Tree, prunes: Sequence[Prune], state_id: str) -> Iterator[tuple[Guard, str, float]]:
    """For each way down: a rule for each label that is left, each taking its share of what those before it left."""
    for path, counts in leaves(tree.root):
        for guard, forbidden in _cases(path, prunes):
            kept = pruned(shares(counts), tree.labels, forbidden, lambda _: 0.0)
            possible = [(label, p) for label, p in zip(tree.labels, kept, strict=True) if p > 0.0]
            yield from _shared_out(guard, possible or [(state_id, 1.0)])


def _shared_out(guard: Guard, possible: Sequence[tuple[str, float]]) -> Iterator[tuple[Guard, str, float]]:
    left = 1.0
    for label, p in possible[:-1]:
        yield guard, label, min(1.0, p / left)
        left -= p
    yield guard, possible[-1][0], 1.0


def leaves(node: TreeNode, path: Guard = ()) -> Iterator[tuple[Guard, tuple[float, ...]]]:
    """The leaves below a node: the tests on the way there as they must come out, and the class counts."""
    if isinstance(node, Leaf):
        yield path, node.counts
    elif isinstance(node, Branch):
        yield from leaves(node.yes, (*path, Condition(node.test)))
        yield from leaves(node.no, (*path, Condition(node.test, wanted=False)))


def _cases(path: Guard, prunes: Sequence[Prune]) -> Iterator[tuple[Guard, list[Prune]]]:
    """*path* told apart by the guards of *prunes*, each case with the prunes that hold in it, without their guards."""
    if not prunes:
        yield path, []
        return
    first, rest = prunes[0], prunes[1:]
    undecided = [condition for condition in first.guard if condition not in path]
    met = path
    for condition in undecided:
        opposite = replace(condition, wanted=not condition.wanted)
        if opposite in met:
            yield from _cases(met, rest)
            return
        yield from _cases((*met, opposite), rest)
        met = (*met, condition)
    for guard, forbidden in _cases(met, rest):
        yield guard, [replace(first, guard=()), *forbidden]
