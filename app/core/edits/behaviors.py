"""Edits of automata as wholes: add, rename, duplicate, delete, parameters, settings, notes."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TypeVar

from ..automaton import Automaton, Basic, Nested, Settings
from ..errors import EditError
from ..naming import fresh_id, fresh_name
from ..project import Project
from ..vocabulary import BasicBehavior
from .bindings import map_bindings, parameter_uses, renamed_parameter, with_bindings
from .calls import Call, change_calls, refuse_shared, starting, users
from .moments import without_stray_moments
from .place import (
    change,
    find_automaton,
    find_type,
    listed,
    with_automaton,
    with_examples,
    with_layout,
    with_library,
)
from .recursion import refuse_recursion
from .words import says

V = TypeVar("V")


@says("Add behavior {name}")
def add_automaton(
    project: Project,
    type_name: str,
    name: str,
    parameters: Sequence[str] = (),
    settings: Settings | None = None,
) -> tuple[Project, str]:
    """A new automaton with nothing but Start; also returns its id."""
    find_type(project, type_name)
    _refuse_name(project, type_name, name)
    _refuse_parameters(name, parameters)
    automaton_id = fresh_id(project.library(type_name).automata, name, "behavior")
    automaton = Automaton(automaton_id, name, tuple(parameters), settings=settings or Settings())
    return with_automaton(project, type_name, automaton), automaton_id


@says("Rename {automaton_id} to {name}")
def rename_automaton(project: Project, type_name: str, automaton_id: str, name: str) -> Project:
    """Another name, also for the controllers and arms that know the automaton by its name."""
    old = find_automaton(project, type_name, automaton_id).name
    if name == old:
        return project
    _refuse_name(project, type_name, name)
    refuse_shared(project, type_name, automaton_id, "rename")
    project = _rename_users(project, type_name, automaton_id, name)
    return change(project, type_name, automaton_id, name=name)


def _rename_users(project: Project, type_name: str, automaton_id: str, name: str) -> Project:
    def renamed(call: Call) -> Call:
        return replace(call, behavior=name) if isinstance(call, Basic) else call

    tops = {
        arm.name for arm, _ in starting(project, type_name, project.library(type_name).get(automaton_id).name)
    }
    arms = tuple(replace(arm, top=name) if arm.name in tops else arm for arm in project.arms)
    project = change_calls(project, type_name, automaton_id, renamed)
    return replace(project, arms=arms) if tops else project


@says("Duplicate {automaton_id}")
def duplicate_automaton(
    project: Project, type_name: str, automaton_id: str, name: str = ""
) -> tuple[Project, str]:
    """A copy with all it has, examples included; also returns its id. Without *name* it is called like "Goto 2"."""
    original = find_automaton(project, type_name, automaton_id)
    automata = project.library(type_name).automata
    if name:
        _refuse_name(project, type_name, name)
    name = name or fresh_name({a.name for a in automata.values()}, original.name)
    copy = replace(original, id=fresh_id(automata, name, "behavior"), name=name)
    examples = project.examples_of(type_name, automaton_id)
    layout = project.layout_of(type_name, automaton_id)
    project = with_layout(with_automaton(project, type_name, copy), type_name, copy.id, layout)
    return with_examples(project, type_name, copy.id, examples), copy.id


@says("Delete {automaton_id}")
def delete_automaton(
    project: Project, type_name: str, automaton_id: str, replacement: str | BasicBehavior | None = None
) -> Project:
    """No such automaton any more, nor its examples and demonstrations.

    Args:
        replacement: What everything that uses it uses from now on: another automaton of the type by id, or a basic
            behavior of the type. Bindings of slots that it does not have are dropped.

    Raises:
        EditError: Something uses the automaton, and there is no replacement.
    """
    doomed = find_automaton(project, type_name, automaton_id)
    using = users(project, type_name, automaton_id)
    if using and replacement is None:
        raise EditError(
            f"{doomed.name} is used by {listed(using)}: give a replacement, or delete these first"
        )
    if using and replacement is not None:
        project = _replace(project, type_name, automaton_id, replacement)
    rest = {i: a for i, a in project.library(type_name).automata.items() if i != automaton_id}
    project = with_examples(with_library(project, type_name, rest), type_name, automaton_id, ())
    project = with_layout(project, type_name, automaton_id, {})
    taught = [d for d in project.demonstrations if (d.type, d.automaton) != (type_name, automaton_id)]
    return without_stray_moments(replace(project, demonstrations=tuple(taught)))


def _replace(
    project: Project, type_name: str, automaton_id: str, replacement: str | BasicBehavior
) -> Project:
    refuse_shared(project, type_name, automaton_id, "replace")
    if replacement == automaton_id:
        raise EditError(f"{automaton_id!r} cannot be replaced by itself")
    new: Automaton | BasicBehavior = (
        find_automaton(project, type_name, replacement) if isinstance(replacement, str) else replacement
    )

    def replaced(call: Call) -> Call:
        bindings = {slot: bound for slot, bound in call.bindings.items() if slot in new.parameters}
        if isinstance(call, Nested) and isinstance(new, Automaton):
            return Nested(new.id, bindings)
        return Basic(new.name, bindings)

    tops = {
        arm.name for arm, _ in starting(project, type_name, project.library(type_name).get(automaton_id).name)
    }
    arms = tuple(replace(arm, top=new.name) if arm.name in tops else arm for arm in project.arms)
    project = replace(change_calls(project, type_name, automaton_id, replaced), arms=arms)
    refuse_recursion(project, type_name)
    return project


@says("Set the parameters of {automaton_id}")
def set_parameters(project: Project, type_name: str, automaton_id: str, parameters: Sequence[str]) -> Project:
    """These parameters in this order. New ones leave a slot open wherever the automaton is used.

    Raises:
        EditError: One that would go is bound to something in the automaton, or a name stands twice.
    """
    automaton = find_automaton(project, type_name, automaton_id)
    _refuse_parameters(automaton.name, parameters)
    if tuple(parameters) == automaton.parameters:
        return project
    refuse_shared(project, type_name, automaton_id, "change the parameters of")
    gone = [name for name in automaton.parameters if name not in parameters]
    for name in gone:
        if uses := parameter_uses(automaton, name, project.library(type_name)):
            raise EditError(
                f"parameter {name!r} of {automaton.name} is used by {listed(uses)}: rebind these first"
            )
    project = _rename_slots(project, type_name, automaton_id, dict.fromkeys(gone))
    return change(project, type_name, automaton_id, parameters=tuple(parameters))


@says("Rename parameter {old} of {automaton_id} to {new}")
def rename_parameter(project: Project, type_name: str, automaton_id: str, old: str, new: str) -> Project:
    """Another name for a parameter, inside the automaton and wherever it is used."""
    automaton = find_automaton(project, type_name, automaton_id)
    if old not in automaton.parameters:
        there = listed(repr(name) for name in automaton.parameters)
        raise EditError(f"{automaton.name} has no parameter {old!r}; there are: {there}")
    parameters = tuple(new if name == old else name for name in automaton.parameters)
    _refuse_parameters(automaton.name, parameters)
    if new == old:
        return project
    refuse_shared(project, type_name, automaton_id, "change the parameters of")
    project = _rename_slots(project, type_name, automaton_id, {old: new})
    renamed = renamed_parameter(old, new)
    inside = map_bindings(find_automaton(project, type_name, automaton_id), renamed)
    demonstrations = tuple(
        replace(d, removed=with_bindings(d.removed, renamed))
        if (d.type, d.automaton) == (type_name, automaton_id)
        else d
        for d in project.demonstrations
    )
    project = replace(project, demonstrations=demonstrations)
    return with_automaton(project, type_name, replace(inside, parameters=parameters))


def _rename_slots(
    project: Project, type_name: str, automaton_id: str, names: Mapping[str, str | None]
) -> Project:
    """Rename the automaton's slots wherever it is used or demonstrated; those renamed to None are dropped."""
    if not names:
        return project

    def changed(call: Call) -> Call:
        return replace(call, bindings=_renamed_keys(call.bindings, names))

    project = change_calls(project, type_name, automaton_id, changed)
    demonstrations = tuple(
        replace(d, arguments=_renamed_keys(d.arguments, names))
        if (d.type, d.automaton) == (type_name, automaton_id)
        else d
        for d in project.demonstrations
    )
    return replace(project, demonstrations=demonstrations)


def _renamed_keys(bound: Mapping[str, V], names: Mapping[str, str | None]) -> dict[str, V]:
    renamed = ((names.get(slot, slot), value) for slot, value in bound.items())
    return {slot: value for slot, value in renamed if slot is not None}


@says("Change the note on {automaton_id}")
def set_note(project: Project, type_name: str, automaton_id: str, note: str) -> Project:
    """Another note on an automaton."""
    return change(project, type_name, automaton_id, note=note)


@says("Change the settings of {automaton_id}")
def set_settings(project: Project, type_name: str, automaton_id: str, settings: Settings) -> Project:
    """Other settings: classifier, sampling, pruning confidence, options."""
    confidence = settings.pruning_confidence
    if confidence is not None and not 0.0 < confidence <= 0.5:
        raise EditError(f"the pruning confidence is {confidence}; allowed: above 0 up to 0.5, or none")
    return change(project, type_name, automaton_id, settings=settings)


def _refuse_name(project: Project, type_name: str, name: str) -> None:
    if not name.strip():
        raise EditError("a behavior needs a name")
    if project.library(type_name).by_name(name) is not None:
        raise EditError(f"the library of {type_name!r} already has a behavior called {name!r}")


def _refuse_parameters(name: str, parameters: Sequence[str]) -> None:
    if any(not parameter.strip() for parameter in parameters):
        raise EditError(f"a parameter of {name} has no name")
    if twice := [p for i, p in enumerate(parameters) if p in parameters[:i]]:
        raise EditError(f"parameter {twice[0]!r} of {name} stands twice")
