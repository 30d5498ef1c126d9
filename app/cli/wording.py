"""Sentences that several verbs say."""

import re
from collections.abc import Iterable
from difflib import get_close_matches


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


def counted(number: int, what: str, plural: str = "") -> str:
    """A number and what it counts: "1 run", "2 runs"."""
    return f"{number:,} {what if number == 1 else plural or what + 's'}"


def number(value: float) -> str:
    """*value* for people: whole numbers without a point, others to four digits, thousands apart."""
    if value == int(value):
        return f"{value:,.0f}"
    return f"{value:,.4g}" if abs(value) < 1000 else f"{value:,.1f}"


def percent(share: float | None) -> str:
    """*share* of 1 as a percentage; a dash where there is none."""
    return "–" if share is None else f"{share:.0%}"
