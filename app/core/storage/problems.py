"""What is wrong with the files of a project, in words that a user can act on."""

import json
from collections.abc import Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from pydantic import BaseModel, ValidationError

from ..amounts import exact
from ..errors import StorageError
from .fields import kinds_at, members_at
from .text import member

#: As many as a user reads; the rest are counted.
MOST_SHOWN = 20
LONGEST_SHOWN = 60

Step = int | str


@dataclass(frozen=True, slots=True)
class Problem:
    """One thing that is wrong.

    Attributes:
        file: Relative to the project's folder, with ``/``; empty if it is the folder itself.
        where: The place in the file, e.g. ``states[2].content.behavior`` or ``line 3, column 7``; empty for all of it.
    """

    file: str
    where: str
    message: str

    def __str__(self) -> str:
        """One line: file, place, message."""
        return ": ".join(part for part in (self.file, self.where, self.message) if part)


class FilesError(StorageError):
    """Files of a project cannot be read or written.

    Attributes:
        problems: All that was found, not only what the message has room for.
    """

    def __init__(self, folder: Path, problems: Sequence[Problem]) -> None:
        self.problems = tuple(problems)
        super().__init__(_message(folder, self.problems))


def _message(folder: Path, problems: tuple[Problem, ...]) -> str:
    if len(problems) == 1:
        problem = problems[0]
        path = str(folder / problem.file) if problem.file else str(folder)
        return str(Problem(path, problem.where, problem.message))
    lines = [f"{folder}: {len(problems)} problems", *(f"  {problem}" for problem in problems[:MOST_SHOWN])]
    if len(problems) > MOST_SHOWN:
        lines.append(f"  and {len(problems) - MOST_SHOWN} more")
    return "\n".join(lines)


# --------------------------------------------------------------------------------------------- wrong documents

_EXPECTED = {
    "string_type": "text",
    "int_type": "a whole number",
    "int_from_float": "a whole number",
    "float_type": "a number",
    "bool_type": "true or false",
    "list_type": "an array",
    "dict_type": "an object",
    "model_type": "an object",
    "model_attributes_type": "an object",
    "finite_number": "a finite number",
    "greater_than": "more than {gt}",
    "greater_than_equal": "at least {ge}",
    "less_than": "less than {lt}",
    "less_than_equal": "at most {le}",
    "literal_error": "{expected}",
    "enum": "{expected}",
    "string_pattern_mismatch": "16 hexadecimal digits in small letters, or empty",
    "string_too_short": "text that is not empty",
}


def of_document(file: str, model: type[BaseModel], document: object, error: ValidationError) -> list[Problem]:
    """What pydantic found wrong with *document*, a file of the kind *model*."""
    return [_problem(file, model, document, found) for found in error.errors(include_url=False)]


def _problem(file: str, model: type[BaseModel], document: object, error: Any) -> Problem:
    loc, kind, context = error["loc"], error["type"], error.get("ctx", {})
    if kind == "missing":
        return Problem(file, place(document, loc[:-1]), f"the key {loc[-1]!r} is missing")
    if kind == "extra_forbidden":
        return Problem(file, place(document, loc[:-1]), _unknown_key(model, loc))
    return Problem(file, place(document, loc), _wrong_value(model, loc, kind, context, error))


def _unknown_key(model: type[BaseModel], loc: tuple[Step, ...]) -> str:
    allowed = members_at(model, loc[:-1])
    near = get_close_matches(str(loc[-1]), allowed, n=1)
    hint = f"did you mean {near[0]!r}? " if near else ""
    return f"unknown key {loc[-1]!r}; {hint}allowed: {', '.join(allowed)}"


def _wrong_value(
    model: type[BaseModel], loc: tuple[Step, ...], kind: str, context: dict[str, Any], error: Any
) -> str:
    value = error["input"]
    if kind == "union_tag_not_found":
        return f"the key 'kind' is missing; allowed: {_either(kinds_at(model, loc))}"
    if kind == "union_tag_invalid":
        return f"the kind must be {_either(kinds_at(model, loc))}, but found {shown(context['tag'])}"
    if kind == "too_short":
        return f"must have at least {context['min_length']} entry, but has {context['actual_length']}"
    if kind.startswith("recursion"):
        return "is nested too deeply"
    if kind == "float_type" and isinstance(value, int) and not isinstance(value, bool):
        return f"must be a number that float64 can hold, but found {shown(value)}"
    if kind in _EXPECTED:
        bounds = {name: _plain(bound) for name, bound in context.items()}
        return f"must be {_EXPECTED[kind].format(**bounds)}, but found {shown(value)}"
    return str(error["msg"])


def _plain(bound: object) -> object:
    """A bound as people write it: 1, not 1.0."""
    return exact(bound) if isinstance(bound, int | float) else bound


def _either(names: Sequence[str]) -> str:
    quoted = [repr(name) for name in names]
    return f"{', '.join(quoted[:-1])} or {quoted[-1]}" if len(quoted) > 1 else "".join(quoted)


def place(document: object, loc: Sequence[Step]) -> str:
    """A place as the user reads it: ``states[2].content.behavior``.

    pydantic also counts the chosen kind of a value as a step; what the document does not hold is therefore left out.
    """
    text, here = "", document
    for step in loc:
        if isinstance(step, int) and isinstance(here, list) and step < len(here):
            text, here = f"{text}[{step}]", here[step]
        elif isinstance(here, dict) and step in here:
            text, here = text + member(str(step), first=not text), here[step]
    return text


def shown(value: object) -> str:
    """*value* as JSON writes it, cut where it gets long."""
    try:
        text = json.dumps(value, ensure_ascii=False)
    except (TypeError, ValueError):
        text = repr(value)
    return text if len(text) <= LONGEST_SHOWN else text[:LONGEST_SHOWN] + " ..."
