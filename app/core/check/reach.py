"""Which automata an arm can come to run: what its roots start with, what that holds, and what it directs."""

from collections.abc import Iterable, Iterator

from ..automaton import Automaton, Basic, Nested
from ..edits.calls import root_types
from ..library import Types
from ..project import Arm

#: An automaton by node type and id.
Where = tuple[str, str]


def in_use(types: Types, arm: Arm, taught: Iterable[Where] = ()) -> frozenset[Where]:
    """The automata that can run in *arm*, where *taught* ones run as well."""
    found: set[Where] = set()
    waiting = list(taught)
    for root_type in root_types(arm):
        waiting += _called(types, root_type, arm.top)
    while waiting:
        where = waiting.pop()
        automaton = types.library(where[0]).automata.get(where[1])
        if automaton is not None and where not in found:
            found.add(where)
            waiting += _uses(types, where[0], automaton)
    return frozenset(found)


def _uses(types: Types, type_name: str, automaton: Automaton) -> Iterator[Where]:
    for state in automaton.states:
        match state.content:
            case Nested(held, _):
                yield type_name, held
            case Basic(name, _):
                for below in _below(types, type_name):
                    yield from _called(types, below, name)


def _called(types: Types, type_name: str, name: str) -> Iterator[Where]:
    """What nodes of a type run when they are directed to do *name*: an automaton of theirs, or what they direct in turn."""
    if type_name not in types.types:
        return
    own = types.library(type_name).by_name(name)
    if own is not None:
        yield type_name, own.id
        return
    for below in _below(types, type_name):
        yield from _called(types, below, name)


def _below(types: Types, type_name: str) -> tuple[str, ...]:
    return types.type(type_name).subsidiaries if type_name in types.types else ()
