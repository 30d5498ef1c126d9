"""Who uses an automaton: automata that hold it, controllers that direct it, arms that start with it.

Automata of the same type hold it by id. Controllers and arms know it by name, and controllers of controllers through
the behaviors derived from it. Where a name is shared by several types of subsidiaries, only one of which is this
automaton's, a change of the name or the parameters would take the behavior from the controller, and is refused.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from enum import Enum

from ..automaton import Automaton, Basic, Nested, State
from ..errors import EditError
from ..naming import shown_state
from ..project import Arm, LevelTable, Project
from .place import find_automaton, listed, with_automaton

Call = Basic | Nested


class Meaning(Enum):
    """What the automaton's name stands for in another type."""

    SOLE = "it, and nothing else"
    SHARED = "it for some subsidiaries, and something else for others"


@dataclass(frozen=True, slots=True)
class Caller:
    """A state that holds the automaton or directs it."""

    type: str
    automaton: Automaton
    state: State
    meaning: Meaning = Meaning.SOLE


def callers(project: Project, type_name: str, automaton_id: str) -> Iterator[Caller]:
    """The states that hold or direct an automaton."""
    name = find_automaton(project, type_name, automaton_id).name
    for user in project.library(type_name).users(automaton_id):
        for state in user.states:
            if isinstance(state.content, Nested) and state.content.automaton == automaton_id:
                yield Caller(type_name, user, state)
    for above, meaning in meanings(project, type_name, name).items():
        for controller in project.library(above).automata.values():
            for state in controller.states:
                if isinstance(state.content, Basic) and state.content.behavior == name:
                    yield Caller(above, controller, state, meaning)


def meanings(project: Project, type_name: str, name: str) -> dict[str, Meaning]:
    """The controller types among whose derived behaviors *name* stands for the automaton of *type_name*."""
    derived: dict[str, Meaning] = {}
    repertoire = {type_name: Meaning.SOLE}
    for controller in sorted(project.types, key=lambda t: t.level):
        below = {repertoire.get(child) for child in controller.subsidiaries}
        if controller.name == type_name or not below - {None}:
            continue
        derived[controller.name] = Meaning.SOLE if below == {Meaning.SOLE} else Meaning.SHARED
        if project.library(controller.name).by_name(name) is None:
            repertoire[controller.name] = derived[controller.name]
    return derived


def starting(project: Project, type_name: str, name: str) -> Iterator[tuple[Arm, Meaning]]:
    """The arms whose top is the automaton of *type_name* called *name*."""
    arms = [arm for arm in project.arms if arm.top == name]  # few are, and the roots of an arm can be many
    derived = meanings(project, type_name, name) if arms else {}
    known = {type_name: Meaning.SOLE}
    known |= {t: m for t, m in derived.items() if project.library(t).by_name(name) is None}
    for arm in arms:
        roots = {known.get(root) for root in root_types(arm)}
        if roots - {None}:
            yield arm, Meaning.SOLE if roots == {Meaning.SOLE} else Meaning.SHARED


def root_types(arm: Arm) -> frozenset[str]:
    """The types of an arm's roots."""
    if isinstance(arm.hierarchy, LevelTable):
        return frozenset(arm.hierarchy.types[:1])
    return frozenset(root.type for root in arm.hierarchy.roots)


def users(project: Project, type_name: str, automaton_id: str) -> tuple[str, ...]:
    """Everything that uses an automaton, in words: "state approach of Forage", "arm 'independent'"."""
    name = find_automaton(project, type_name, automaton_id).name
    states = [_words(project, caller, type_name) for caller in callers(project, type_name, automaton_id)]
    return (*states, *(f"arm {arm.name!r}" for arm, _ in starting(project, type_name, name)))


def _words(project: Project, caller: Caller, type_name: str) -> str:
    state = shown_state(caller.automaton, caller.state.id, project.library(caller.type))
    of_type = "" if caller.type == type_name else f" ({caller.type})"
    return f"state {state} of {caller.automaton.name}{of_type}"


def refuse_shared(project: Project, type_name: str, automaton_id: str, act: str) -> None:
    """Raise an `EditError` if something uses the automaton's name for several behaviors at once."""
    name = find_automaton(project, type_name, automaton_id).name
    shared = [
        _words(project, caller, type_name)
        for caller in callers(project, type_name, automaton_id)
        if caller.meaning is Meaning.SHARED
    ]
    shared += [f"arm {a.name!r}" for a, m in starting(project, type_name, name) if m is Meaning.SHARED]
    if shared:
        raise EditError(
            f"cannot {act} {name}: {listed(shared)} also means the {name!r} of other node types by that name; "
            "let these use another behavior first"
        )


def change_calls(
    project: Project, type_name: str, automaton_id: str, changed: Callable[[Call], Call]
) -> Project:
    """*project* with the content of every state that holds or directs the automaton *changed*.

    That goes for states, too, that were removed and are only remembered by demonstrations.
    """
    found = list(callers(project, type_name, automaton_id))
    project = _change_removed(project, type_name, automaton_id, changed)
    for caller_type, user_id in dict.fromkeys((caller.type, caller.automaton.id) for caller in found):
        called = {c.state.id for c in found if (c.type, c.automaton.id) == (caller_type, user_id)}
        user = find_automaton(project, caller_type, user_id)
        states = tuple(_changed(state, changed) if state.id in called else state for state in user.states)
        if states != user.states:  # who holds it by id does not mind its name
            project = with_automaton(project, caller_type, replace(user, states=states))
    return project


def _change_removed(
    project: Project, type_name: str, automaton_id: str, changed: Callable[[Call], Call]
) -> Project:
    if not any(demonstration.removed for demonstration in project.demonstrations):
        return project
    name = find_automaton(project, type_name, automaton_id).name
    above = meanings(project, type_name, name)

    def in_step(state: State, of_type: str) -> State:
        held, basic = state.content, of_type in above
        calls = (isinstance(held, Nested) and of_type == type_name and held.automaton == automaton_id) or (
            isinstance(held, Basic) and basic and held.behavior == name
        )
        return _changed(state, changed) if calls else state

    demonstrations = tuple(
        replace(d, removed=tuple(in_step(state, d.type) for state in d.removed))
        for d in project.demonstrations
    )
    return replace(project, demonstrations=demonstrations)


def _changed(state: State, changed: Callable[[Call], Call]) -> State:
    assert isinstance(state.content, Basic | Nested)
    return replace(state, content=changed(state.content))
