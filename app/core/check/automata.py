"""Checks of libraries and of what an automaton is made of: names, states, what they hold, recursion."""

from collections import Counter
from collections.abc import Iterator, Sequence
from functools import partial

from ..automaton import START, Basic, Nested, Prune, RaiseFlag, Rule, Start, State
from ..edits import bind_state, set_parameters
from ..errors import LibraryError, ScenarioError
from ..features import FeatureUse
from ..library import Behavior
from .bindings import Slots, binding_problems, bound_parameters
from .problem import Problem, allowed, automaton_file, place, twice
from .scope import Scope, Subject


def library_problems(scope: Scope) -> Iterator[Problem]:
    """What is wrong with a library as a whole: ids, names used twice, recursion."""
    type_name = scope.type.name
    names = Counter(automaton.name for automaton in scope.library.automata.values())
    for key, automaton in scope.library.automata.items():
        file = automaton_file(type_name, key)
        if key != automaton.id:
            yield Problem(
                file, "id", f"the id must be {key!r}, but it is {automaton.id!r}", raises=LibraryError
            )
        if not automaton.name.strip():
            yield Problem(file, "name", "the behavior has no name", raises=LibraryError)
        if names[automaton.name] > 1:
            message = f"another behavior of {type_name!r} is called {automaton.name!r} as well"
            yield Problem(file, "name", message, raises=LibraryError)
        if automaton.name in scope.vocabulary.behaviors:
            yield _hiding(scope, file, automaton.name)
    yield from _recursion(scope)


def _hiding(scope: Scope, file: str, name: str) -> Problem:
    """Two behaviors of one name: never clear for agents; a controller's own hides what it directs from those above."""
    if not scope.vocabulary.behaviors[name].derived:
        message = f"{scope.type.name!r} has a basic behavior called {name!r} already"
        return Problem(file, "name", message, raises=LibraryError)
    message = f"subsidiaries of {scope.type.name!r} have a behavior called {name!r} too; controllers above reach only this one"
    return Problem(file, "name", message, "warning", raises=LibraryError)


def _recursion(scope: Scope) -> Iterator[Problem]:
    """One problem for each knot of automata that hold each other, with a cycle spelled out."""
    import networkx as nx  # noqa: PLC0415 - it takes 0.1 s, and the window is to be there before

    graph = scope.library.graph()
    for knot in nx.strongly_connected_components(graph):
        inside = graph.subgraph(knot)
        if inside.number_of_edges():
            cycle = [edge[0] for edge in nx.find_cycle(inside, min(knot))]
            yield _cycle_problem(scope, [*cycle, cycle[0]])


def _cycle_problem(scope: Scope, cycle: list[str]) -> Problem:
    automata = scope.library.automata
    first = automata[cycle[0]]
    index = next(
        i
        for i, s in enumerate(first.states)
        if isinstance(s.content, Nested) and s.content.automaton == cycle[1]
    )
    message = f"recursion is not permitted, but {' holds '.join(automata[key].name for key in cycle)}"
    where = place("states", index, "content", "automaton")
    return Problem(automaton_file(scope.type.name, first.id), where, message, raises=LibraryError)


def automaton_problems(subject: Subject) -> Iterator[Problem]:
    """What is wrong with an automaton's parts: ids used twice, states, bindings, parameters."""
    yield from _doubled(subject)
    yield from _parameter_problems(subject)
    yield from _start_problems(subject)
    for index, state in enumerate(subject.automaton.states):
        yield from _state_problems(subject, index, state)


def _doubled(subject: Subject) -> Iterator[Problem]:
    automaton = subject.automaton
    parts: dict[str, Sequence[State | FeatureUse | Rule | Prune]] = {
        "states": automaton.states,
        "features": automaton.features,
        "rules": automaton.rules,
        "prunes": automaton.prunes,
    }
    for what, items in parts.items():
        for index, name in twice(item.id for item in items):
            yield subject.error(
                place(what, index, "id"), f"the id {name!r} stands twice among the {what}", LibraryError
            )


def _parameter_problems(subject: Subject) -> Iterator[Problem]:
    automaton = subject.automaton
    for index, name in twice(automaton.parameters):
        message = f"parameter {name!r} of {automaton.name} stands twice"
        yield subject.error(place("parameters", index), message, LibraryError)
    used = bound_parameters(automaton)
    for index, name in enumerate(automaton.parameters):
        if not name.strip():
            yield subject.error(
                place("parameters", index), f"a parameter of {automaton.name} has no name", LibraryError
            )
        elif name not in used:
            rest = [other for other in automaton.parameters if other != name]
            yield subject.warning(
                place("parameters", index),
                f"nothing in {automaton.name} is bound to its parameter {name!r}",
                "drop the parameter",
                subject.edit(set_parameters, rest),
            )


def _start_problems(subject: Subject) -> Iterator[Problem]:
    states = subject.automaton.states
    if not states or states[0].id != START or not isinstance(states[0].content, Start):
        found = states[0].id if states else "none"
        message = f"the first state of {subject.automaton.name} must be Start with the id {START!r}, but it is {found!r}"
        yield subject.error(place("states", 0), message, LibraryError)


def _state_problems(subject: Subject, index: int, state: State) -> Iterator[Problem]:
    where = ("states", index, "content")
    match state.content:
        case Start():
            if index > 0:
                message = f"state {subject.state(state.id)} is a second Start; only the first state idles"
                yield subject.error(place(*where), message, LibraryError)
        case RaiseFlag(flag):
            if not flag.strip():
                message = f"state {state.id!r} raises a flag without a name"
                yield subject.error(place(*where, "flag"), message, LibraryError)
        case Basic() | Nested() as content:
            held = _held(subject, content)
            if held is None:
                yield _missing(subject, content, state, where)
            else:
                drop = partial(subject.edit, bind_state, state.id, binding=None)
                slots = Slots(f"state {subject.state(state.id)}", held.name, held.parameters, drop)
                yield from binding_problems(subject, slots, content.bindings, where)


def _held(subject: Subject, content: Basic | Nested) -> Behavior | None:
    if isinstance(content, Basic):
        return subject.scope.vocabulary.behaviors.get(content.behavior)
    return subject.scope.library.automata.get(content.automaton)


def _missing(
    subject: Subject, content: Basic | Nested, state: State, where: tuple[str | int, ...]
) -> Problem:
    type_name = subject.scope.type.name
    who = f"state {subject.state(state.id)} of {subject.automaton.name} holds"
    if isinstance(content, Nested):
        message = (
            f"{who} the behavior with the id {content.automaton!r}, which the library of {type_name!r} lacks"
        )
        there = allowed(content.automaton, subject.scope.library.automata)
        return subject.error(place(*where, "automaton"), f"{message}; {there}", LibraryError)
    there = allowed(content.behavior, subject.scope.vocabulary.behaviors)
    if subject.scope.type.level > 0:
        shared = "that all its subsidiaries share by name and parameters"
        message = f"{who} {content.behavior!r}, which is no behavior of {type_name!r} {shared}; {there}"
    else:
        message = f"{who} {content.behavior!r}, which is no basic behavior of the scenario; {there}"
    return subject.error(place(*where, "behavior"), message, ScenarioError)
