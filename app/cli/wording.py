"""Sentences that several verbs say."""

import re
from collections.abc import Iterable
from difflib import get_close_matches

from ..core.amounts import counted, number, percent

__all__ = ["counted", "number", "percent", "unknown"]


def unknown(what: str, word: str, known: Iterable[str]) -> str:
    """That there is no *what* called *word*: what may have been meant, and what there is."""
    names = list(known)
    # "boxes" is near to "world.boxes", and "goto" to "agent/Goto".
    spellings = {re.split("[./]", name)[-1].lower(): name for name in names} | {
        name.lower(): name for name in names
    }
    near = get_close_matches(word.lower(), spellings, n=1)
    meant = f" (did you mean {spellings[near[0]]!r}?)" if near else ""
    return f"there is no {what} {word!r}{meant}; there are: {', '.join(names) or 'none'}"
