"""JSON as the project's files have it: one text for one document, made to be read in a diff."""

import json
import re
from collections.abc import Iterator
from typing import Any

#: Shorter objects and arrays stand on one line.
WIDTH = 110
#: Arrays of which every item is on a line of its own, however long: one example or pick a line.
ROWS = frozenset({"examples", "picks"})
STEP = 2
WORDS = ("true", "false", "null", "NaN", "Infinity")
NUMBER = frozenset("-+.eE0123456789")

_ENCODER = json.JSONEncoder(ensure_ascii=False, allow_nan=False, sort_keys=True)


class TextError(ValueError):
    """Bytes that are no JSON document; *where* and *message* say why."""

    def __init__(self, where: str, message: str) -> None:
        super().__init__(message)
        self.where = where
        self.message = message


class _Doubled(dict[str, Any]):
    """An object in which a key stood twice."""

    key = ""


# ------------------------------------------------------------------------------------------------------- reading


def parsed(data: bytes) -> Any:
    """The document that *data* holds.

    Raises:
        TextError: It is no JSON in UTF-8, or a key stands twice in one object.
    """
    doubled: list[_Doubled] = []

    def members(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        members = dict(pairs)
        if len(members) == len(pairs):
            return members
        doubled.append(_Doubled(members))
        doubled[-1].key = _first_twice([key for key, _ in pairs])
        return doubled[-1]

    document = _loaded(_decoded(data), members)
    if doubled:
        where = next(path for path, here in _everything(document) if here is doubled[0])
        raise TextError(where, f"the key {doubled[0].key!r} stands here more than once")
    if b"\\u" in data:
        _refuse_half_characters(document)
    return document


def _decoded(data: bytes) -> str:
    try:
        return data.decode("utf-8-sig")  # some editors begin a file with a byte order mark
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise TextError(f"line {line}", f"the byte 0x{data[error.start]:02x} is not UTF-8") from None


def _loaded(text: str, members: Any) -> Any:
    try:
        return json.loads(text, object_pairs_hook=members)
    except json.JSONDecodeError as error:
        raise TextError(f"line {error.lineno}, column {error.colno}", _explained(text, error)) from None
    except RecursionError:
        raise TextError("", "it is nested too deeply") from None
    except ValueError:
        found = re.search(r"\d{4301}", text)  # as long as Python converts
        line = text.count("\n", 0, found.start()) + 1 if found else 1
        raise TextError(f"line {line}", "a number has too many digits") from None


def _explained(text: str, error: json.JSONDecodeError) -> str:
    if not text.strip():
        return "the file is empty"
    if _cut_short(text[error.pos :].rstrip(), error.msg):
        return "the file ends too early: it has been cut short"
    return f"this is not JSON: {error.msg[0].lower()}{error.msg[1:]}"


def _cut_short(rest: str, complaint: str) -> bool:
    """Whether *rest*, from where it cannot be read on, could be the beginning of something right."""
    if complaint.startswith("Unterminated") or any(word.startswith(rest) for word in WORDS):
        return True
    return set(rest) <= NUMBER or (complaint.startswith("Invalid \\") and '"' not in rest)


def _first_twice(keys: list[str]) -> str:
    return next(key for index, key in enumerate(keys) if key in keys[:index])


def _refuse_half_characters(document: Any) -> None:
    """Raise a `TextError` if a text holds half of a surrogate pair, which no file can."""
    for path, here in _everything(document):
        if isinstance(here, str) and any("\ud800" <= character <= "\udfff" for character in here):
            raise TextError(path, "the text holds half of a surrogate pair, which is no character")


def _everything(document: Any) -> Iterator[tuple[str, Any]]:
    """All that *document* consists of, keys included, with its place."""
    waiting: list[tuple[str, Any]] = [("", document)]
    while waiting:
        path, here = waiting.pop()
        yield path, here
        if isinstance(here, dict):
            yield from ((path, key) for key in here)
        waiting += _below(path, here)


def _below(path: str, here: Any) -> Iterator[tuple[str, Any]]:
    if isinstance(here, list):
        yield from ((f"{path}[{index}]", item) for index, item in enumerate(here))
    elif isinstance(here, dict):
        yield from ((path + member(key, first=not path), item) for key, item in here.items())


def member(key: str, *, first: bool) -> str:
    """*key* as a step of a place: ``.name``, or ``["two words"]``."""
    if key.isidentifier():
        return key if first else "." + key
    return f"[{json.dumps(key, ensure_ascii=False)}]"


# ------------------------------------------------------------------------------------------------------- writing


def written(document: dict[str, Any]) -> bytes:
    """*document* as the bytes of a file.

    Keys are sorted and floats as short as they are exact. What is short stands on one line; the members of the
    document itself, and the items of its arrays, each begin a line, so that a change to one is a change of one line.

    Raises:
        TextError: A text in it cannot be written.
    """
    try:
        return (_expanded(document, 0) + "\n").encode()
    except UnicodeEncodeError:
        _refuse_half_characters(document)
        raise


def _expanded(value: Any, depth: int) -> str:
    """*value* over several lines, its inner ones indented for *depth*."""
    if not value:
        return _ENCODER.encode(value)
    inner = " " * STEP * (depth + 1)
    end = "\n" + " " * STEP * depth
    if isinstance(value, dict):
        items = [f"{inner}{_ENCODER.encode(key)}: {_member(key, value[key], depth)}" for key in sorted(value)]
        return "{\n" + ",\n".join(items) + end + "}"
    if not any(isinstance(item, dict | list) for item in value):
        return "[\n" + _filled(value, inner) + end + "]"
    items = [inner + _fitted(item, depth + 1, len(inner)) for item in value]
    return "[\n" + ",\n".join(items) + end + "]"


def _member(key: str, value: Any, depth: int) -> str:
    if key in ROWS and depth == 0 and value and isinstance(value, list):
        rows = [" " * STEP * 2 + _ENCODER.encode(row) for row in value]
        return "[\n" + ",\n".join(rows) + "\n" + " " * STEP + "]"
    if depth == 0 and _holds_containers(value):
        return _expanded(value, 1)
    return _fitted(value, depth + 1, STEP * (depth + 1) + len(key) + 4)


def _holds_containers(value: Any) -> bool:
    items = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    return any(isinstance(item, dict | list) for item in items)


def _fitted(value: Any, depth: int, taken: int) -> str:
    """*value* on the rest of a line of which *taken* columns are gone, or else over several."""
    line = _ENCODER.encode(value)
    if taken + len(line) < WIDTH or not isinstance(value, dict | list):
        return line
    return _expanded(value, depth)


def _filled(items: list[Any], indent: str) -> str:
    """Numbers or words, as many to a line as fit."""
    lines, line = [], indent
    for index, item in enumerate(items):
        text = _ENCODER.encode(item) + ("," if index < len(items) - 1 else "")
        if len(line) + len(text) + 1 > WIDTH and line != indent:
            lines.append(line.rstrip())
            line = indent
        line += text + " "
    return "\n".join([*lines, line.rstrip()])
