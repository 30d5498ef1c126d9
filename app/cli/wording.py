"""Sentences that several verbs say."""

import re
from collections.abc import Iterable, Sequence
from difflib import get_close_matches

from ..core.amounts import counted, number, percent

__all__ = ["counted", "listed", "number", "percent", "unknown"]


def unknown(what: str, word: str, known: Iterable[str]) -> str:
    """That there is no *what* called *word*: what may have been meant, and what there is."""
    names = list(known)
    # Without what stands before them, "boxes" is near to "world.boxes", and "world.nope" is not.
    spellings = {_last_part(name): name for name in names} | {name.lower(): name for name in names}
    near = get_close_matches(_last_part(word), spellings, n=1)
    meant = f" (did you mean {spellings[near[0]]!r}?)" if near else ""
    return f"there is no {what} {word!r}{meant}; there are: {listed(names) or 'none'}"


def listed(names: Sequence[str]) -> str:
    """The *names* in a row, in quotes where a comma in one of them would make two of it."""
    return ", ".join(map(repr, names) if any("," in name for name in names) else names)


def _last_part(name: str) -> str:
    return re.split("[./]", name)[-1].lower()
