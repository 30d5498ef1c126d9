"""One feature of an automaton in words, whatever it is made of: the world, a flag, time, or a statistic."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import floor, inf

from .crowds import Crowd
from .errors import ScenarioError
from .features import (
    Bindings,
    FeatureUse,
    FlagUp,
    Ground,
    Operation,
    Sense,
    Statistic,
    TicksInState,
    declaration,
)
from .phrasing import CAPTION, Who, number, said_of
from .predicates import is_of_nobody, is_true, named, predicate, reading, wants_nobody
from .spans import Between, Is, Span
from .vocabulary import DONE, FAILED, FINISHED, Feature, FeatureKind, Vocabulary

#: A threshold this little below a whole number separates it from the one before.
JUST_BELOW = 1e-6
#: What those say of themselves who raised a flag, and who did not.
FLAG_WORDS: Mapping[str, tuple[str, str]] = {
    DONE: ("is done", "is not done"),
    FAILED: ("has failed", "has not failed"),
    FINISHED: ("has finished", "has not finished"),
}


@dataclass(frozen=True, slots=True)
class Speech:
    """How tests are put.

    Attributes:
        clause: In clauses with a subject, "it sees a box", rather than captions, "sees a box".
        group: The name of the controller whose agents are summed up: "Group 3".
        held: What the current state holds, whose flags are tested: "Goto".
        targets: What the automaton's parameters stand for: "deposit" for "X".
        detailed: With what phrases leave out where they are short: "sees a box that still needs pullers".
    """

    clause: bool = False
    group: str = ""
    held: str = ""
    targets: Mapping[str, str] = field(default_factory=dict)
    detailed: bool = False


CAPTIONS = Speech()


def declared(use: FeatureUse, vocabulary: Vocabulary) -> Feature:
    """How a feature is declared; of one that the scenario lacks, no more than its name."""
    try:
        return declaration(use.source, vocabulary)
    except ScenarioError:
        return Feature(use.shown, FeatureKind.CONTINUOUS)


class Telling:
    """Tells of one feature."""

    def __init__(self, use: FeatureUse, vocabulary: Vocabulary, speech: Speech = CAPTIONS) -> None:
        self._use = use
        self._vocabulary = vocabulary
        self._feature = declared(use, vocabulary)
        self._speech = speech
        self._it = Who("it") if speech.clause else CAPTION

    def test(self, span: Span) -> str:
        """What the feature is to be."""
        words = ""
        match self._use.source:
            case FlagUp(flag):
                return self._flag(flag, up=is_true(span))
            case TicksInState() if isinstance(span, Between):
                return self._lasting(_ticks(span.low, span.high))
            case Sense(_, bindings):
                words = said_of(
                    self._it, self._detailed(predicate(self._feature, self._slots(bindings), span))
                )
            case Statistic() as statistic:
                words = self._statistic(statistic, span)
        return words or named(self._use.shown, self._feature, span, clause=self._speech.clause)

    def value(self, value: float) -> str:
        """What the feature is now."""
        if self._feature.kind in (FeatureKind.BOOLEAN, FeatureKind.CATEGORICAL):
            return self.test(Is(value))
        words = ""
        match self._use.source:
            case TicksInState() if value == 0.0:
                return (
                    f"it has just entered {self._here}" if self._speech.clause else "just entered this state"
                )
            case TicksInState():
                return self._lasting(_count(value, "tick"))
            case Sense(_, bindings):
                words = said_of(self._it, reading(self._feature, self._slots(bindings), value))
            case Statistic(operation) as statistic:
                words = self._amount(operation, statistic, value)
        return words or named(self._use.shown, self._feature, Is(value), clause=self._speech.clause)

    @property
    def targets(self) -> Bindings:
        """Whom it is sensed of; nobody in particular where this is empty."""
        return self._use.source.bindings if isinstance(self._use.source, Sense) else {}

    def wants_nobody(self, span: Span) -> bool:
        """Whether it is to be as it is only where there is no target."""
        return isinstance(self._use.source, Sense) and wants_nobody(self._feature, span)

    def is_of_nobody(self, value: float) -> bool:
        """Whether a value says that there is no target."""
        return isinstance(self._use.source, Sense) and is_of_nobody(self._feature, value)

    def _slots(self, bindings: Bindings) -> Mapping[str, str]:
        """Words for the target parameters of a feature."""
        known = self._speech.targets
        return {
            slot: bound.target if isinstance(bound, Ground) else known.get(bound.name, bound.name)
            for slot, bound in bindings.items()
        }

    def _detailed(self, phrase: str) -> str:
        """A phrase with what it leaves out where it is short."""
        detail = self._feature.phrases.detail
        return f"{phrase} {detail}" if phrase and detail and self._speech.detailed else phrase

    def _flag(self, flag: str, *, up: bool) -> str:
        if not self._speech.clause:
            return flag if up else f"not {flag}"
        return f"{self._speech.held or 'it'} {_flag_words(flag)[0 if up else 1]}"

    @property
    def _here(self) -> str:
        return self._speech.held or "this state"

    def _lasting(self, ticks: str) -> str:
        if self._speech.clause:
            return f"it has been in {self._here} for {ticks}"
        return f"{ticks} in this state"

    # ---------------------------------------------------------------------------------------- statistics

    def _statistic(self, statistic: Statistic, span: Span) -> str:
        """Who of those below is to be what; empty if there are no words for it."""
        crowd = Crowd(statistic.over, self._speech.group)
        match statistic.operation, span:
            case ((Operation.ANY | Operation.ALL), _) if says := self._says(statistic, Is(1.0)):
                return said_of(crowd.some_or_all(statistic.operation, wanted=is_true(span)), says)
            case Operation.COUNT, Between(low, high) if says := self._shows(statistic):
                return said_of(crowd.so_many(low, high), says)
            case ((Operation.MIN | Operation.MAX), Between(low, high)):
                return self._extreme(statistic, crowd, low, high)
            case Operation.MEAN, Between():
                return self._mean(statistic, crowd, span)
        return ""

    def _shows(self, statistic: Statistic) -> str:
        """What those are who count; empty unless that is something that one either is or is not."""
        inner = self._inner(statistic)
        either = isinstance(statistic.of, FlagUp) or (inner is not None and inner.kind is FeatureKind.BOOLEAN)
        return self._says(statistic, Is(1.0)) if either else ""

    def _says(self, statistic: Statistic, span: Span) -> str:
        """What each of those below is to be."""
        match statistic.of:
            case FlagUp(flag):
                return _flag_words(flag)[0 if is_true(span) else 1]
            case Sense(name, bindings):
                inner = self._vocabulary.features.get(name)
                return "" if inner is None else predicate(inner, self._slots(bindings), span)

    def _extreme(self, statistic: Statistic, crowd: Crowd, low: float, high: float) -> str:
        """The least is at most so much where someone is; it is above where everyone is. The greatest, the other way."""
        least = statistic.operation is Operation.MIN
        above = self._says(statistic, Between(low=low)) if low > -inf else ""
        within = self._says(statistic, Between(high=high)) if high < inf else ""
        told = [
            said_of(crowd.some_or_all(Operation.ALL if least else Operation.ANY, wanted=True), above)
            if above
            else "",
            said_of(crowd.some_or_all(Operation.ANY if least else Operation.ALL, wanted=True), within)
            if within
            else "",
        ]
        return " and ".join(filter(None, told))

    def _mean(self, statistic: Statistic, crowd: Crowd, span: Between) -> str:
        """A share of those below, or what they are on average."""
        inner = self._inner(statistic)
        if shows := self._shows(statistic):
            return said_of(crowd.share(span.low, span.high), shows)
        if inner is None:
            return ""
        says = self._says(statistic, span) if inner.kind is FeatureKind.CONTINUOUS else ""
        return said_of(crowd.average(), says) if says else ""

    def _inner(self, statistic: Statistic) -> Feature | None:
        of = statistic.of
        return self._vocabulary.features.get(of.feature) if isinstance(of, Sense) else None

    def _amount(self, operation: Operation, statistic: Statistic, value: float) -> str:
        """What a statistic that is a number is now; empty if there are no words for it."""
        crowd = Crowd(statistic.over, self._speech.group)
        inner = self._inner(statistic)
        if operation is Operation.COUNT and (says := self._shows(statistic)):
            return said_of(crowd.just(value), says)
        if operation is Operation.MEAN and inner is not None and inner.kind is FeatureKind.CONTINUOUS:
            bindings = statistic.of.bindings if isinstance(statistic.of, Sense) else {}
            says = reading(inner, self._slots(bindings), value)
            return said_of(crowd.average(), says) if says else ""
        return ""


def _flag_words(flag: str) -> tuple[str, str]:
    return FLAG_WORDS.get(flag, (f"has raised {flag}", f"has not raised {flag}"))


def _ticks(low: float, high: float) -> str:
    """Above *low* and up to *high* ticks."""
    words = [_bound(low, "at least", "more than")] if low > -inf else []
    words += [_bound(high, "fewer than", "at most")] if high < inf else []
    return " and ".join(words)


def _bound(threshold: float, at_next: str, at_this: str) -> str:
    whole = floor(threshold)
    if 0.0 < whole + 1 - threshold < JUST_BELOW:
        return f"{at_next} {_count(whole + 1, 'tick')}"
    return f"{at_this} {_count(whole, 'tick')}"


def _count(count: float, what: str) -> str:
    return f"{number(count)} {what}{'' if count == 1.0 else 's'}"
