"""Searching by words, in one way all over the window: all that were typed are looked for, in any order."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache

from ..core.naming import lowered


def words_in(query: str) -> tuple[str, ...]:
    """The words that are looked for, in small letters."""
    return tuple(lowered(query).split())


def has_words(words: Sequence[str], *texts: str) -> bool:
    """Whether every one of *words*, which are in small letters, is in one of *texts*; without words anything passes."""
    if not words:
        return True
    low = lowered("\n".join(texts))
    return all(has_word(word, low) for word in words)


def has_word(word: str, low: str) -> bool:
    """Whether a word is anywhere in a text; a number is where one begins: who looks for 17 does not mean 117."""
    return word in low and (not word[:1].isdecimal() or _number(word).search(low) is not None)


@lru_cache(maxsize=64)
def _number(word: str) -> re.Pattern[str]:
    return re.compile(rf"(?<!\d)0*{re.escape(word)}")
