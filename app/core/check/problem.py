"""A problem: what is wrong, where the user finds it, and what can be done."""

import json
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import Literal

from ..errors import UnderstudyError
from ..project import Project

Severity = Literal["error", "warning"]

PROJECT_FILE = "project.json"


@dataclass(frozen=True, slots=True)
class Problem:
    """One thing that is wrong with a project.

    Attributes:
        file: The path inside the project's folder, e.g. ``libraries/agent/goto.json``.
        where: The place in that file, e.g. ``states[2].content.bindings.target``; empty for the whole file.
        severity: An ``error`` keeps what it concerns from running; a ``warning`` is something to look at.
        fix: What *mend* does, in words: "remove the rule".
        mend: The edit that repairs it, where there is one that needs no decision of the user's. Like every edit it can
            be refused, if other problems stand in its way.
        raises: The kind of error that it is when the project is to run all the same.
    """

    file: str
    where: str
    message: str
    severity: Severity = "error"
    fix: str | None = None
    mend: Callable[[Project], Project] | None = field(default=None, compare=False, repr=False)
    raises: type[UnderstudyError] = field(default=UnderstudyError, compare=False, repr=False)

    def __str__(self) -> str:
        """One line: file, place, message."""
        return ": ".join(part for part in (self.file, self.where, self.message) if part)


def automaton_file(type_name: str, automaton_id: str) -> str:
    """The file of one automaton."""
    return f"libraries/{type_name}/{automaton_id}.json"


def examples_file(type_name: str, automaton_id: str) -> str:
    """The file of one automaton's examples."""
    return f"examples/{type_name}/{automaton_id}.json"


def demonstration_file(demonstration_id: str) -> str:
    """The file of one demonstration."""
    return f"demonstrations/{demonstration_id}.json"


def place(*steps: str | int) -> str:
    """A place in a file: ``place("states", 2, "content")`` is ``states[2].content``."""
    text = ""
    for step in steps:
        if isinstance(step, int):
            text += f"[{step}]"
        elif step.isidentifier():
            text += f".{step}" if text else step
        else:
            text += f"[{json.dumps(step, ensure_ascii=False)}]"
    return text


def allowed(wanted: str, names: Iterable[str], what: str = "there are") -> str:
    """What may stand where *wanted* stands: "did you mean 'Goto'? there are: 'Goto', 'Wander'"."""
    known = sorted(names)
    near = get_close_matches(wanted, known, n=1)
    hint = f"did you mean {near[0]!r}? " if near else ""
    return f"{hint}{what}: {', '.join(map(repr, known)) or 'none'}"


def twice(names: Iterable[str]) -> list[tuple[int, str]]:
    """The names that stood before, with their places."""
    seen: set[str] = set()
    found = []
    for index, name in enumerate(names):
        if name in seen:
            found.append((index, name))
        seen.add(name)
    return found
