"""How well a query fits what it may find: all of its words in any order, or a few letters of a name in order.

"theme dark" finds Dark theme, "pause" finds what plays, since that is among its other words, and "rwb" ReturnWithBox.
"""

import re
from collections.abc import Iterable, Sequence
from functools import lru_cache

from ...core.naming import lowered
from ..searching import has_word

#: What a word is worth in a name: as a whole word, at the beginning of one, and inside.
WHOLE, BEGINS, INSIDE = 40, 30, 12
#: The same in what else something is found by, and how much less after so many signs: what comes first says most.
ELSE_WHOLE, ELSE_BEGINS, ELSE_INSIDE = 20, 17, 1
LESS_AFTER, LEAST = 12, 6
#: For words that stand in a name as they were typed: next to the one before, or at least behind it.
NEXT, BEHIND = 10, 4
#: For a name that is just what was typed, for one whose words begin with its letters, and for one that has them anywhere.
SAME, INITIALS, SCATTERED = 30, -200, -1000
#: What one letter is worth where it begins a word or follows the letter before it; a gap costs a little.
LETTER_BEGINS, LETTER_FOLLOWS, GAP = 12, 8, 1


@lru_cache(maxsize=64)
def pattern(letters: str) -> re.Pattern[str]:
    """Matches what has these letters in this order, in the first way that there is: nothing is tried twice."""
    return re.compile("".join(f"[^{re.escape(letter)}]*{re.escape(letter)}" for letter in letters), re.DOTALL)


def matching(
    words: Sequence[str], names: Sequence[str], others: Sequence[str], among: Iterable[int]
) -> list[int]:
    """Those places of *among* at which all words are found, or all letters in the name; all in small letters.

    Args:
        others: What else is searched at each place; empty if that is nothing.
    """
    left = list(among)
    letters = pattern("".join(words)).match
    found = left
    for word in words:
        # To look for the bare word first saves ten thousand calls.
        found = [at for at in found if word in names[at] or (others and word in others[at])]
        if word[0].isdecimal():
            found = [at for at in found if has_word(word, f"{names[at]}\n{others[at] if others else ''}")]
    if len(found) == len(left):
        return found
    there = set(found)
    return [at for at in left if at in there or letters(names[at])]


def score(words: Sequence[str], name: str, others: str = "") -> int:
    """How well something fits; the higher the better. Only for what matches.

    Args:
        name: As it is written: capitals begin words.
        others: What else it is found by, the most telling first.
    """
    low, low_others = lowered(name), lowered(others)
    worth, end = -len(name) // 4, 0
    for word in words:
        at = _place(word, name, low)
        if at >= 0:
            worth += _worth(word, name, at, (WHOLE, BEGINS, INSIDE)) - min(at, 10) // 4
            worth += (NEXT if at <= end + 1 else BEHIND) if at >= end else 0
            end = at + len(word)
            continue
        at = _place(word, others, low_others)
        if at < 0:
            return _score_of_letters("".join(words), name)
        worth += _worth(word, others, at, (ELSE_WHOLE, ELSE_BEGINS, ELSE_INSIDE))
        worth -= min(at // LESS_AFTER, LEAST)
    return worth + (SAME if " ".join(words) == low.rstrip("…") else 0)


def places(words: Sequence[str], name: str) -> tuple[int, ...]:
    """Where in a name is what was typed: those of its words that are there, or else its letters if all are."""
    low = lowered(name)
    found: set[int] = set()
    for word in words:
        at = _place(word, name, low)
        if at >= 0:
            found.update(range(at, at + len(word)))
    return tuple(sorted(found)) if found else letter_places("".join(words), name)


def letter_places(letters: str, text: str) -> tuple[int, ...]:
    """Where in *text* the letters are best found; empty if they are not there in this order.

    Beginnings of words are preferred, then what comes first.
    """
    low, wanted = lowered(text), lowered(letters)
    return _by_beginnings(wanted, text, low) or _first(wanted, low)


def _place(word: str, text: str, low: str) -> int:
    """Where a word is: at the first beginning of one in the text, or else anywhere; below 0 if it is not there."""
    first = at = low.find(word)
    while at >= 0 and _inside_word(text, at):
        at = low.find(word, at + 1)
    return at if at >= 0 else first


def _worth(word: str, text: str, at: int, worths: tuple[int, int, int]) -> int:
    whole, begins, inside = worths
    if _inside_word(text, at):
        return inside
    end = at + len(word)
    return begins if end < len(text) and _inside_word(text, end) else whole


def _score_of_letters(letters: str, text: str) -> int:
    low, wanted = lowered(text), lowered(letters)
    initials = _by_beginnings(wanted, text, low)
    found = initials or _first(wanted, low)
    worth = (INITIALS if initials else SCATTERED) - len(text) // 4 - (found[0] if found else 0)
    for before, at in zip((-2, *found), found, strict=False):
        if at == before + 1:
            worth += LETTER_FOLLOWS
        elif not _inside_word(text, at):
            worth += LETTER_BEGINS
        else:
            worth -= min(at - before, 10) * GAP
    return worth


def _inside_word(text: str, at: int) -> bool:
    if at == 0:
        return False
    before, here = text[at - 1], text[at]
    if not before.isalnum() or not here.isalnum():
        return False
    return not (here.isupper() and before.islower()) and not (here.isdigit() and not before.isdigit())


def _by_beginnings(wanted: str, text: str, low: str) -> tuple[int, ...]:
    """Where each letter begins a word or follows the one before, found greedily; empty if that does not work out."""
    found: list[int] = []
    at = 0
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
