"""Finding names by a few of their letters in order: "rwb" finds ReturnWithBox."""

import re
from collections.abc import Iterable, Sequence
from functools import lru_cache

from ...core.naming import lowered

#: What one letter is worth where it begins a word or follows the letter before it; a gap costs a little.
BEGINS, FOLLOWS, GAP = 12, 8, 1


@lru_cache(maxsize=64)
def pattern(letters: str) -> re.Pattern[str]:
    """Matches what has these letters in this order."""
    return re.compile(".*?".join(re.escape(letter) for letter in letters), re.IGNORECASE | re.DOTALL)


def letters_of(query: str) -> str:
    """What of a query is looked for: all but blanks."""
    return "".join(query.split())


def places(letters: str, text: str) -> tuple[int, ...]:
    """Where in *text* the letters are best found; empty if they are not there in this order.

    A whole run of letters is preferred, then beginnings of words, then what comes first.
    """
    low, wanted = lowered(text), lowered(letters)
    if not wanted:
        return ()
    at = low.find(wanted)
    if at >= 0 and (at == 0 or not _inside_word(text, at)):
        return tuple(range(at, at + len(wanted)))
    starts = _by_beginnings(wanted, text)
    if starts:
        return starts
    if at >= 0:
        return tuple(range(at, at + len(wanted)))
    return _first(wanted, low)


def score(letters: str, text: str) -> int:
    """How well *text* fits; the higher the better. Only for texts that match."""
    found = places(letters, text)
    if not found:
        return 0
    worth = -len(text) // 4 - found[0]
    for before, at in zip((-2, *found), found, strict=False):
        if at == before + 1:
            worth += FOLLOWS
        elif not _inside_word(text, at):
            worth += BEGINS
        else:
            worth -= min(at - before, 10) * GAP
    return worth + (20 if len(letters) == len(text) else 0)


def matching(letters: str, texts: Sequence[str], among: Iterable[int] | None = None) -> list[int]:
    """Places in *texts* of those that match, in their order.

    Args:
        among: Look only at these, which is enough when letters were added to an earlier query.
    """
    found = pattern(letters).search
    return [at for at in (range(len(texts)) if among is None else among) if found(texts[at])]


def _inside_word(text: str, at: int) -> bool:
    if at == 0:
        return False
    before, here = text[at - 1], text[at]
    if not before.isalnum():
        return False
    return not (here.isupper() and before.islower()) and not (here.isdigit() and not before.isdigit())


def _by_beginnings(wanted: str, text: str) -> tuple[int, ...]:
    """Where each letter begins a word or follows the one before, found greedily; empty if that does not work out."""
    found: list[int] = []
    at, low = 0, lowered(text)
    for letter in wanted:
        if found and at < len(low) and low[at] == letter:
            here = at
        else:
            here = next(
                (k for k in range(at, len(low)) if low[k] == letter and not _inside_word(text, k)), -1
            )
        if here < 0:
            return ()
        found.append(here)
        at = here + 1
    return tuple(found)


def _first(wanted: str, low: str) -> tuple[int, ...]:
    found: list[int] = []
    at = 0
    for letter in wanted:
        at = low.find(letter, at)
        if at < 0:
            return ()
        found.append(at)
        at += 1
    return tuple(found)
