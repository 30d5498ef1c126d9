"""Edits of what an automaton looks at.

Learned models that test a feature that goes or changes its meaning are removed: they would have to be learned again.
Examples keep the values of dropped features; those of rebound ones are forgotten, since they were measured otherwise.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from ..automaton import Automaton, Model, Prune, Refit, Rule
from ..conditions import Condition, Guard
from ..errors import EditError
from ..examples import Example
from ..features import FeatureUse, Sense, Source, Statistic, describe
from ..naming import fresh_id
from ..project import Project
from ..tree import Forest
from .place import change, find_automaton, find_feature, listed, moved, with_examples
from .words import says


@says("Add a feature to {automaton_id}")
def add_feature(
    project: Project, type_name: str, automaton_id: str, source: Source, name: str = ""
) -> tuple[Project, str]:
    """One more feature, the last; also returns its id. Examples have no value of it until `set_values` gives them one."""
    automaton = find_automaton(project, type_name, automaton_id)
    _refuse_twice(automaton, source)
    feature_id = fresh_feature_id(project, type_name, automaton, name or _plain_name(source))
    features = (*automaton.features, FeatureUse(feature_id, source, name))
    return change(project, type_name, automaton_id, features=features), feature_id


def fresh_feature_id(project: Project, type_name: str, automaton: Automaton, name: str) -> str:
    """An id that neither a feature has nor an example's value."""
    taken = {use.id for use in automaton.features}
    for example in project.examples_of(type_name, automaton.id):
        taken.update(example.values)
    return fresh_id(taken, name, "feature")


def _plain_name(source: Source) -> str:
    """A name without bindings, since those change."""
    match source:
        case Sense(name, _):
            return name
        case Statistic(operation, of, _):
            return f"{operation.value} {_plain_name(of)}"
    return describe(source)


def _refuse_twice(automaton: Automaton, source: Source) -> None:
    for use in automaton.features:
        if use.source == source:
            raise EditError(f"{automaton.name} already looks at {describe(source)}: feature {use.id!r}")


@says("Drop feature {feature_id} of {automaton_id}")
def drop_feature(
    project: Project, type_name: str, automaton_id: str, feature_id: str, *, force: bool = False
) -> Project:
    """No such feature any more, nor the learned models that test it.

    Args:
        force: Also remove the rules and prunes that test it; otherwise these make the edit refused.
    """
    automaton = find_automaton(project, type_name, automaton_id)
    dropped = find_feature(automaton, feature_id)
    if not force and (uses := tests_of(automaton, feature_id)):
        raise EditError(
            f"feature {dropped.shown} of {automaton.name} is tested by {listed(uses)}: change these first"
        )
    return change(
        project,
        type_name,
        automaton_id,
        features=tuple(use for use in automaton.features if use.id != feature_id),
        rules=tuple(rule for rule in automaton.rules if not _tests(rule.guard, feature_id)),
        prunes=tuple(prune for prune in automaton.prunes if not _tests(prune.guard, feature_id)),
        cuts=tuple(
            cut for cut in automaton.cuts if not _tests((*cut.guard, Condition(cut.test)), feature_id)
        ),
        **without_models(automaton, [feature_id]),
    )


def tests_of(automaton: Automaton, feature_id: str) -> tuple[str, ...]:
    """The authored rules and prunes that test a feature, in words."""
    guarded: tuple[Rule | Prune, ...] = (*automaton.rules, *automaton.prunes)
    return tuple(
        f"{'rule' if isinstance(g, Rule) else 'prune'} {g.id!r} of state {g.source!r}"
        for g in guarded
        if _tests(g.guard, feature_id)
    )


def _tests(guard: Guard, feature_id: str) -> bool:
    return any(condition.test.feature == feature_id for condition in guard)


def without_models(automaton: Automaton, feature_ids: Iterable[str]) -> dict[str, object]:
    """The fields that hold what the automaton learned, without the models that test one of these features.

    A model without a table form may look at everything, so it goes as well.
    """
    gone = set(feature_ids)
    learned = {
        s: model
        for s, model in automaton.learned.items()
        if not (_tested(model) & gone or isinstance(model, Refit))
    }
    unchanged = len(learned) == len(automaton.learned)
    return {"learned": learned, "learned_from": automaton.learned_from if unchanged else ""}


def _tested(model: Model) -> set[str]:
    if isinstance(model, Refit):
        return set()
    trees = model.trees if isinstance(model, Forest) else (model,)
    return {feature for tree in trees for feature in tree.features()}


@says("Rename feature {feature_id} of {automaton_id} to {name}")
def rename_feature(
    project: Project, type_name: str, automaton_id: str, feature_id: str, name: str
) -> Project:
    """Another name for a feature; an empty one shows what it is."""
    return _change_feature(project, type_name, automaton_id, feature_id, name=name)


@says("Rebind feature {feature_id} of {automaton_id}")
def rebind_feature(
    project: Project, type_name: str, automaton_id: str, feature_id: str, source: Source
) -> Project:
    """Let a feature be something else, e.g. the distance to another target.

    Rules and prunes that test it stay. Examples lose their value of it, to be measured again from their moments.
    """
    automaton = find_automaton(project, type_name, automaton_id)
    if find_feature(automaton, feature_id).source == source:
        return project
    _refuse_twice(automaton, source)
    project = change(project, type_name, automaton_id, **without_models(automaton, [feature_id]))
    project = _change_feature(project, type_name, automaton_id, feature_id, source=source)
    examples = tuple(_forgotten(e, feature_id) for e in project.examples_of(type_name, automaton_id))
    return with_examples(project, type_name, automaton_id, examples)


def _forgotten(example: Example, feature_id: str) -> Example:
    if feature_id not in example.values:
        return example
    values: Mapping[str, float] = {f: value for f, value in example.values.items() if f != feature_id}
    return replace(example, values=values)


@says("Move feature {feature_id} of {automaton_id}")
def move_feature(project: Project, type_name: str, automaton_id: str, feature_id: str, to: int) -> Project:
    """Put a feature at place *to* among the features. The order decides between equally good splits."""
    automaton = find_automaton(project, type_name, automaton_id)
    index = automaton.features.index(find_feature(automaton, feature_id))
    return change(project, type_name, automaton_id, features=moved(automaton.features, index, to))


def _change_feature(
    project: Project, type_name: str, automaton_id: str, feature_id: str, **fields: Any
) -> Project:
    automaton = find_automaton(project, type_name, automaton_id)
    old = find_feature(automaton, feature_id)
    new = replace(old, **fields)
    features = tuple(new if use is old else use for use in automaton.features)
    return change(project, type_name, automaton_id, features=features)
