"""Sentences out of a scenario's phrases: who does it, how many of them, and numbers as people write them."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from math import degrees, isfinite, tau

from .vocabulary import Feature, FeatureKind

#: Beginnings of phrases that say what something is, so that they need an "is": "within 5 of deposit".
STATES = frozenset(
    [
        "above",
        "ahead",
        "alone",
        "among",
        "apart",
        "at",
        "away",
        "behind",
        "below",
        "beneath",
        "beside",
        "between",
        "beyond",
        "by",
        "close",
        "closer",
        "elsewhere",
        "far",
        "farther",
        "further",
        "in",
        "inside",
        "left",
        "less",
        "more",
        "near",
        "nearer",
        "next",
        "no",
        "none",
        "not",
        "off",
        "on",
        "out",
        "outside",
        "over",
        "right",
        "somewhere",
        "under",
        "up",
        "within",
        "without",
    ]
)
#: Beginnings of clauses that have a subject of their own.
SUBJECTS = frozenset(
    [
        "a",
        "all",
        "an",
        "any",
        "anyone",
        "both",
        "each",
        "every",
        "everybody",
        "everyone",
        "everything",
        "it",
        "its",
        "most",
        "nobody",
        "nothing",
        "one",
        "some",
        "somebody",
        "someone",
        "something",
        "that",
        "the",
        "their",
        "there",
        "these",
        "they",
        "this",
        "those",
    ]
)
#: Words that end like a verb and are none.
NO_VERBS = frozenset(
    [
        "always",
        "across",
        "less",
        "plus",
        "minus",
        "perhaps",
        "sometimes",
        "besides",
        "as",
        "towards",
        "afterwards",
    ]
)
#: Verbs by which a clause with a subject of its own is recognized.
VERBS = re.compile(r" (is|are|has|have|lies|lie|does|do|needs|need|can|was|were) ")
#: Letters by themselves are called by their names.
BEGINS_WITH_VOWEL = re.compile(r"[aeioAEIO]|[uU][^ns]|[FHLMNRSX]\b")
#: So many digits are read at most where two numbers are to be told apart; closer ones are one for people.
MOST_DIGITS = 6
PLURALS = {"is": "are", "has": "have", "does": "do", "was": "were", "goes": "go", "its": "their"}


@dataclass(frozen=True, slots=True)
class Who:
    """Whom a phrase is said of.

    Attributes:
        words: "it", "someone in Group 3"; empty makes a caption without a subject: "sees a box".
        many: Whether it takes a verb in the plural.
    """

    words: str = ""
    many: bool = False


CAPTION = Who()


def said_of(who: Who, phrase: str) -> str:
    """*phrase* with its subject: "it sees a box", "it is within 5 of deposit"; nothing of nothing."""
    if not who.words or not phrase:
        return phrase
    first, _, rest = phrase.partition(" ")
    if first == "its":
        return phrase if who.words == "it" else _owned(who, rest)
    if _is_clause(phrase):
        return phrase if who.words == "it" else f"for {who.words}, {phrase}"
    if first in STATES or not _is_verb(first):
        return f"{who.words} {'are' if who.many else 'is'} {phrase}"
    return f"{who.words} {plural(first) if who.many else first}{' ' if rest else ''}{rest}"


def _owned(who: Who, rest: str) -> str:
    """The clause "its box is full", of someone else."""
    thing, _, more = rest.partition(" ")
    return f"the {thing} of {who.words} {more}"


def _is_clause(phrase: str) -> bool:
    first = phrase.partition(" ")[0].lower()
    if first in SUBJECTS:
        return True
    return first not in STATES and not _is_verb(first) and VERBS.search(phrase) is not None


def _is_verb(word: str) -> bool:
    return word.endswith("s") and word not in NO_VERBS and word not in SUBJECTS and word not in STATES


def plural(verb: str) -> str:
    """A verb for many: "see" from "sees"."""
    if verb in PLURALS:
        return PLURALS[verb]
    if verb.endswith("ies"):
        return verb[:-3] + "y"
    return verb[:-2] if re.search(r"(sh|ch|ss|x|zz)es$", verb) else verb.removesuffix("s")


def filled(phrase: str, slots: Mapping[str, str]) -> str:
    """*phrase* with words for its {slots}; what it has no words for stays as it stands there."""

    def word(slot: "re.Match[str]") -> str:
        article, words = slot[1] or "", slots.get(slot[2])
        if words is None:
            return slot[0]
        return ("an " if article and BEGINS_WITH_VOWEL.match(words) else article) + words

    return re.sub(r"(\ba )?\{(\w+)\}", word, phrase)


# ------------------------------------------------------------------------------------------------ numbers


def number(value: float, digits: int = 3) -> str:
    """A number with three significant digits, without an exponent as far as it can be read so: 12,345, 12.3, 0.0123."""
    if not isfinite(value):
        return str(value)
    rounded = float(f"{value:.{digits}g}") + 0.0  # no minus zero
    if abs(value) >= 10 ** (digits - 1):
        rounded = round(value)
    if rounded != 0.0 and not 1e-4 <= abs(rounded) < 1e9:
        return f"{value:.{digits}g}"
    return f"{rounded:,.10f}".rstrip("0").rstrip(".")


def apart(low: float, high: float) -> tuple[str, str]:
    """Two numbers with as many digits as it takes to tell them apart, three at least; as one, if it takes too many."""
    for digits in range(3, MOST_DIGITS + 1):
        pair = number(low, digits), number(high, digits)
        if pair[0] != pair[1]:
            return pair
    return number(low), number(high)


def in_degrees(feature: Feature) -> bool:
    """Whether a feature's values are angles in radians, which people read in degrees."""
    return feature.kind is FeatureKind.TOROIDAL and feature.unit in ("radians", "") and feature.period == tau


def for_people(feature: Feature, value: float) -> float:
    """A value in the unit in which people read it; an angle has no digits that are only an error of rounding."""
    return round(degrees(value), 9) if in_degrees(feature) else value


def unit_of(feature: Feature, told: str = "") -> str:
    """The unit in which people read a feature; of one, in the singular."""
    unit = "degrees" if in_degrees(feature) else feature.unit
    return unit.removesuffix("s") if told in ("1", "-1") else unit
