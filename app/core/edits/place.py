"""Finding what an edit names, and putting the changed value back with everything else shared."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from ..automaton import Automaton, State
from ..errors import EditError
from ..examples import Example
from ..features import FeatureUse
from ..library import Library, NodeType
from ..naming import named
from ..project import Positions, Project


def find_type(project: Project, type_name: str) -> NodeType:
    """The node type called *type_name*; `EditError` names those there are."""
    for node_type in project.types:
        if node_type.name == type_name:
            return node_type
    raise EditError(
        f"there is no node type {type_name!r}; there are: {listed(t.name for t in project.types)}"
    )


def find_automaton(project: Project, type_name: str, automaton_id: str) -> Automaton:
    """The automaton with this id; `EditError` names those there are."""
    find_type(project, type_name)
    automata = project.library(type_name).automata
    if automaton_id not in automata:
        raise EditError(
            f"the library of {type_name!r} has no behavior with the id {automaton_id!r}; "
            f"there are: {listed(sorted(automata))}"
        )
    return automata[automaton_id]


def find_state(project: Project, type_name: str, automaton: Automaton, state_id: str) -> State:
    """The state with this id; `EditError` names those there are."""
    if not automaton.has_state(state_id):
        there = named(automaton.states, project.library(type_name))
        raise EditError(f"{automaton.name} has no state {state_id!r}; there are: {there}")
    return automaton.state(state_id)


def find_feature(automaton: Automaton, feature_id: str) -> FeatureUse:
    """The feature with this id; `EditError` names those there are."""
    for use in automaton.features:
        if use.id == feature_id:
            return use
    there = listed(f"{use.id!r} ({use.shown})" for use in automaton.features)
    raise EditError(f"{automaton.name} has no feature {feature_id!r}; there are: {there}")


def find_index(ids: Iterable[str], wanted: str, what: str, where: str) -> int:
    """The place of *wanted* among *ids*; `EditError` names those there are."""
    there = list(ids)
    if wanted not in there:
        raise EditError(f"{where} has no {what} {wanted!r}; there are: {listed(repr(i) for i in there)}")
    return there.index(wanted)


def listed(names: Iterable[str]) -> str:
    """*names* with commas between them, or "none"."""
    return ", ".join(names) or "none"


def with_automaton(project: Project, type_name: str, automaton: Automaton) -> Project:
    """*project* with this automaton in its type's library, new or in the place of the one with the same id."""
    library = project.library(type_name)
    if library.automata.get(automaton.id) is automaton:
        return project
    return with_library(project, type_name, {**library.automata, automaton.id: automaton})


def with_library(project: Project, type_name: str, automata: Mapping[str, Automaton]) -> Project:
    """*project* with these automata as the library of a type; an empty library leaves no trace."""
    libraries = {**project.libraries, type_name: Library(automata)}
    if not automata:
        del libraries[type_name]
    return replace(project, libraries=libraries)


def change(project: Project, type_name: str, automaton_id: str, **fields: Any) -> Project:
    """*project* with other values for some fields of one automaton."""
    automaton = find_automaton(project, type_name, automaton_id)
    return with_automaton(project, type_name, replace(automaton, **fields))


def with_examples(
    project: Project, type_name: str, automaton_id: str, examples: tuple[Example, ...]
) -> Project:
    """*project* with these as all examples of one automaton."""
    before = project.examples_of(type_name, automaton_id)
    if examples is before or (not examples and not before):
        return project
    kept = {**project.examples.get(type_name, {}), automaton_id: examples}
    if not examples:
        del kept[automaton_id]
    by_type = {**project.examples, type_name: kept}
    if not kept:
        del by_type[type_name]
    return replace(project, examples=by_type)


def with_layout(project: Project, type_name: str, automaton_id: str, layout: Positions) -> Project:
    """*project* with this as the layout of an automaton; an empty one leaves no trace."""
    if layout == project.layout_of(type_name, automaton_id):
        return project
    of_type = {**project.layouts.get(type_name, {}), automaton_id: layout}
    if not layout:
        del of_type[automaton_id]
    layouts = {**project.layouts, type_name: of_type}
    if not of_type:
        del layouts[type_name]
    return replace(project, layouts=layouts)


def replaced(items: tuple[Any, ...], index: int, *new: Any) -> tuple[Any, ...]:
    """*items* with those of *new* in the place of the one at *index*; without any, it is gone."""
    return (*items[:index], *new, *items[index + 1 :])


def moved(items: tuple[Any, ...], index: int, to: int) -> tuple[Any, ...]:
    """*items* with the one at *index* taken out and put in at *to*, which is cut to the range there is."""
    rest = [*replaced(items, index)]
    rest.insert(max(0, min(to, len(rest))), items[index])
    return tuple(rest)
