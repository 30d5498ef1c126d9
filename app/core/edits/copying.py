"""Copying states with their transitions, within an automaton or into another."""

from collections.abc import Container, Mapping, Sequence
from dataclasses import replace

from ..automaton import START, Automaton, Content, Rule
from ..conditions import Guard
from ..features import FeatureUse
from ..naming import next_number
from ..project import Project
from ..tree import Tree
from .features import add_feature
from .place import change, find_automaton, find_feature
from .rules import author_learned
from .states import add_state, refuse_states
from .words import says

#: An automaton by type and id.
Where = tuple[str, str]


@says("Copy states")
def copy_states(
    project: Project, source: Where, state_ids: Sequence[str], into: Where
) -> tuple[Project, dict[str, str]]:
    """Copies of states, last in *into*, with their rules; also returns the copies' ids by the originals'.

    Rules that leave a copied state come along where their target does: among the copies, or in the same automaton.
    Start among *state_ids* means the other Start. Features that the rules test are added where they are missing.
    What a decision tree learned comes along as rules that do the same, since its examples stay where they were taught.

    Raises:
        EditError: A state is missing, or holds an automaton that *into* may not hold.
    """
    return copied_states(project, source, state_ids, into, {})


def copied_states(
    project: Project,
    source: Where,
    state_ids: Sequence[str],
    into: Where,
    contents: Mapping[str, Content],
    unseen: Container[str] = (),
) -> tuple[Project, dict[str, str]]:
    """The same, where some of the copies hold something else than their originals: *contents*, by the originals' ids.

    Rules that test one of the features *unseen* do not come along.
    """
    refuse_states(find_automaton(project, *source), state_ids)
    find_automaton(project, *into)
    original = with_rules_of_trees(project, source, state_ids)
    copies: dict[str, str] = {}
    for state in original.states:
        if state.id in state_ids and state.id != START:
            content = contents.get(state.id, state.content)
            project, copies[state.id] = add_state(project, *into, content, state.name, state.note)
    targets = {START: START} if source != into else {state.id: state.id for state in original.states}
    targets |= copies
    sources = {START: START, **copies} if START in state_ids else copies
    rules = [
        replace(rule, source=sources[rule.source], target=targets[rule.target])
        for rule in original.rules
        if rule.source in sources and rule.target in targets and not tests(rule, unseen)
    ]
    if source == into:  # rules of Start that lead to states that were not copied are there already
        rules = [rule for rule in rules if rule.source != START or rule.target in copies.values()]
    return _with_rules(project, original, rules, into), copies


def tests(rule: Rule, features: Container[str]) -> bool:
    """Whether a rule tests one of these features."""
    return any(condition.test.feature in features for condition in rule.guard)


def with_rules_of_trees(project: Project, where: Where, state_ids: Sequence[str]) -> Automaton:
    """An automaton with rules for what the trees of some states learned; none that it has already."""
    before = find_automaton(project, *where)
    for state_id in state_ids:
        if isinstance(before.learned.get(state_id), Tree):
            project = author_learned(project, *where, state_id)
    known = {(rule.source, rule.guard, rule.target) for rule in before.rules}
    made = find_automaton(project, *where).rules[len(before.rules) :]
    new = [rule for rule in made if (rule.source, rule.guard, rule.target) not in known]
    return replace(before, rules=(*before.rules, *new))


def _with_rules(project: Project, original: Automaton, rules: Sequence[Rule], into: Where) -> Project:
    tested = dict.fromkeys(condition.test.feature for rule in rules for condition in rule.guard)
    features = {}
    for feature_id in tested:
        project, features[feature_id] = _brought_along(project, find_feature(original, feature_id), into)
    target = find_automaton(project, *into)
    number = next_number(rule.id for rule in target.rules)
    copied = tuple(
        replace(rule, id=str(number + i), guard=_renamed(rule.guard, features))
        for i, rule in enumerate(rules)
    )
    return change(project, *into, rules=(*target.rules, *copied))


def _brought_along(project: Project, use: FeatureUse, into: Where) -> tuple[Project, str]:
    """The id under which *into* looks at the same; the feature is added if it does not yet."""
    for other in find_automaton(project, *into).features:
        if other.source == use.source:
            return project, other.id
    return add_feature(project, *into, use.source, use.name)


def _renamed(guard: Guard, features: Mapping[str, str]) -> Guard:
    return tuple(
        replace(condition, test=replace(condition.test, feature=features[condition.test.feature]))
        for condition in guard
    )
