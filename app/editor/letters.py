"""The letters of menus: with Alt one opens a menu, and by itself one chooses an entry.

Qt reads an ampersand before a letter as its mark, so that one which is meant has to be doubled.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from ..core.naming import lowered

#: Words that say little: their initials come after those of others.
_SMALL = frozenset(
    {"a", "an", "and", "as", "in", "into", "of", "or", "out", "over", "the", "to", "what", "with"}
)


def letters_of(texts: Sequence[str], taken: Iterable[str] = ()) -> tuple[str, ...]:
    """A letter of each text, in lower case, and no letter twice; empty where all of a text are others'.

    Those of words that begin a text are given first, in order, then other initials, then any others.

    Args:
        taken: Letters that none may have.
    """
    holders = dict.fromkeys((letter.lower() for letter in taken), -1)
    for choose in (_first, _initials):
        for at, text in enumerate(texts):
            free = [letter for letter in choose(text) if letter not in holders]
            if free and at not in holders.values():
                holders[free[0]] = at
    for at in range(len(texts)):
        if at not in holders.values():
            _find(at, texts, holders, set())
    owned = {at: letter for letter, at in holders.items()}
    return tuple(owned.get(at, "") for at in range(len(texts)))


def marked(text: str, letter: str) -> str:
    """*text* as Qt takes it, with *letter* underlined where it has it: where a word begins, if one does."""
    at = _place(text, letter) if letter else -1
    return plain(text) if at < 0 else f"{plain(text[:at])}&{plain(text[at:])}"


def plain(text: str) -> str:
    """*text*, such as a name that somebody gave, as Qt takes it where it looks for marks: nothing is underlined."""
    return text.replace("&", "&&")


def unmarked(text: str) -> str:
    """What a text that Qt has taken says, marks aside."""
    return re.sub("&(.?)", r"\1", text)


def _words(text: str) -> list[str]:
    return [word for word in lowered(text).split() if _is_letter(word[0])]


def _is_letter(sign: str) -> bool:
    """Whether every keyboard has it: letters of other alphabets may not be there to be pressed."""
    return sign.isascii() and sign.isalnum()


def _first(text: str) -> list[str]:
    return [word[0] for word in _words(text)[:1]]


def _initials(text: str) -> list[str]:
    return [word[0] for word in sorted(_words(text), key=lambda word: word in _SMALL)]


def _all(text: str) -> list[str]:
    letters = [*_initials(text), *(sign for sign in lowered(text) if _is_letter(sign))]
    return list(dict.fromkeys(letters))


def _find(at: int, texts: Sequence[str], holders: dict[str, int], asked: set[str]) -> bool:
    """Give a text any letter that is free, or that becomes so because its holder finds another."""
    letters = [letter for letter in _all(texts[at]) if letter not in asked]
    for letter in sorted(letters, key=lambda letter: letter in holders):
        asked.add(letter)
        holder = holders.get(letter)
        if holder is None or (holder >= 0 and _find(holder, texts, holders, asked)):
            holders[letter] = at
            return True
    return False


def _place(text: str, letter: str) -> int:
    low = lowered(text)
    starts = [at for at, sign in enumerate(low) if sign == letter and (at == 0 or low[at - 1] == " ")]
    return starts[0] if starts else low.find(letter)
