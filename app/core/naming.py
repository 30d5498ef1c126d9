"""Readable ids, free names, names in order and in small letters, and what a state is called."""

import re
import unicodedata
from collections.abc import Collection, Iterable

from .automaton import Automaton, Basic, Content, Nested, RaiseFlag, State
from .features import slots
from .library import Library

#: Ids become file names; longer names are cut.
LONGEST_ID = 40
#: Some systems keep these file names for devices.
DEVICES = re.compile(r"con|prn|aux|nul|com\d|lpt\d")


def slug(name: str, fallback: str = "unnamed") -> str:
    """*name* as an id of small letters, digits and hyphens: ``ReturnWithBox`` gives ``return-with-box``."""
    letters = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode()
    apart = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "-", letters).lower()
    return re.sub(r"[^a-z0-9]+", "-", apart).strip("-")[:LONGEST_ID].strip("-") or fallback


def fresh_id(taken: Collection[str], name: str, fallback: str = "unnamed") -> str:
    """An id made from *name* that is not *taken*: ``goto``, then ``goto-2``, ``goto-3``."""
    first = slug(name, fallback)
    free = first not in taken and not DEVICES.fullmatch(first)
    return first if free else _numbered(taken, first + "-")


def fresh_name(taken: Collection[str], name: str) -> str:
    """*name*, or the first of ``name 2``, ``name 3`` and so on that is not *taken*."""
    return name if name not in taken else _numbered(taken, name + " ")


def _numbered(taken: Collection[str], beginning: str) -> str:
    number = 2
    while f"{beginning}{number}" in taken:
        number += 1
    return f"{beginning}{number}"


def natural(name: str) -> tuple[tuple[str, int], ...]:
    """What to sort names by, so that ``Goto 2`` stands before ``Goto 10``."""
    parts = re.findall(r"([^0-9]*)([0-9]*)", name.casefold())
    return tuple((letters, int(digits or -1)) for letters, digits in parts)


def lowered(text: str) -> str:
    """*text* in lower case, sign by sign, so that places in one are places in the other: "İ" alone would become two."""
    if text.isascii():
        return text.lower()
    return "".join(small if len(small := sign.lower()) == 1 else sign for sign in text)


def next_number(ids: Iterable[str]) -> int:
    """One more than the highest of the *ids* that are numbers: ids of examples, rules and prunes count up."""
    return 1 + max((int(i) for i in ids if i.isascii() and i.isdigit()), default=0)


def shown_content(content: Content, library: Library) -> str:
    """What a state does, in words: ``Goto(nearest-box)``, ``Forward``, or the flag that it raises."""
    match content:
        case Basic(behavior, bindings):
            return behavior + slots(bindings)
        case Nested(automaton, bindings):
            held = library.automata.get(automaton)
            return (held.name if held else automaton) + slots(bindings)
        case RaiseFlag(flag):
            return flag
    return "Start"


def shown_state(automaton: Automaton, state_id: str, library: Library) -> str:
    """What the user calls a state: its name, or else what it does; the id itself if there is no such state."""
    found = next((state for state in automaton.states if state.id == state_id), None)
    return state_id if found is None else found.name or shown_content(found.content, library)


def named(states: Iterable[State], library: Library) -> str:
    """The states as a list to read, e.g. for what is allowed: ``'forward' (Forward), 'left' (RotateLeft)``."""
    return ", ".join(f"{s.id!r} ({s.name or shown_content(s.content, library)})" for s in states) or "none"
