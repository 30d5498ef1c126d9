"""What a feature is, or is to be, in the scenario's phrases where it has some, and otherwise in the feature's name."""

from collections.abc import Mapping
from math import inf

from .phrasing import apart, filled, for_people, number, unit_of
from .spans import Arc, Between, Is, IsNot, Span
from .vocabulary import Feature, FeatureKind

#: A bound so near a default above all other values leaves nothing between the two.
ALMOST = 0.99


def is_true(span: Span) -> bool:
    """What a boolean feature is to be."""
    match span:
        case Is(value):
            return value != 0.0
        case IsNot(values):
            return 0.0 in values
        case Between(low, _):
            return low >= 0.0
    return False


def predicate(feature: Feature, slots: Mapping[str, str], span: Span) -> str:
    """What the feature is to be, in its phrases: "within 5 of deposit"; empty where it has none for that.

    Args:
        slots: Words for its target parameters.
    """
    match feature.kind, span:
        case FeatureKind.BOOLEAN, _:
            return _boolean(feature, slots, wanted=is_true(span))
        case FeatureKind.CATEGORICAL, Is() | IsNot():
            return _categorical(feature, slots, span)
        case FeatureKind.TOROIDAL, Arc(start, end) if start != end:
            return _toroidal(feature, slots, Arc(start, end))
        case FeatureKind.CONTINUOUS, Between(low, high):
            return _continuous(feature, slots, low, high)
        case _, Is(value):
            return reading(feature, slots, value)
    return ""


def reading(feature: Feature, slots: Mapping[str, str], value: float) -> str:
    """What a number is now, in the feature's phrases: "4.2 from deposit"; empty where it has none for that."""
    if is_of_nobody(feature, value):
        return filled(feature.phrases.none, slots)
    return _put(feature.phrases.at, slots, value=_with_unit(feature, value))


def is_of_nobody(feature: Feature, value: float) -> bool:
    """Whether a value says that there is no target."""
    return value == feature.default and _is_beyond(feature)


def wants_nobody(feature: Feature, span: Span) -> bool:
    """Whether only the value that says that there is no target passes."""
    return isinstance(span, Between) and _is_beyond(feature) and span.low >= ALMOST * feature.default


def _boolean(feature: Feature, slots: Mapping[str, str], *, wanted: bool) -> str:
    return filled(feature.phrases.true if wanted else feature.phrases.false, slots)


def _categorical(feature: Feature, slots: Mapping[str, str], span: Is | IsNot) -> str:
    values = (span.value,) if isinstance(span, Is) else span.values
    left = [name for index, name in enumerate(feature.categories) if float(index) not in values]
    if isinstance(span, IsNot) and len(left) == 1:
        return _put(feature.phrases.true, slots, value=left[0])
    listed = " or ".join(category(feature, value) for value in values)
    if isinstance(span, Is):
        return _put(feature.phrases.true, slots, value=listed)
    refused = _put(feature.phrases.false, slots, value=listed)
    otherwise = _put(feature.phrases.true, slots, value=listed)
    return refused or (f"not {otherwise}" if otherwise else "")


def _toroidal(feature: Feature, slots: Mapping[str, str], arc: Arc) -> str:
    seam = -feature.period / 2
    inside = arc.start < arc.end or arc.end <= seam
    start, end = (arc.start, arc.end) if inside else (arc.end, arc.start)
    first, last = ends(feature, start, feature.period / 2 if end <= seam else end)
    phrases = feature.phrases
    if last == _united(feature, first):
        only = _put(phrases.at if inside else phrases.not_at, slots, value=last)
        if only:
            return only
    return _put(phrases.true if inside else phrases.false, slots, start=first, end=last)


def _continuous(feature: Feature, slots: Mapping[str, str], low: float, high: float) -> str:
    phrases = feature.phrases
    if low == -inf:
        there = _of_target(feature, slots, phrases.some, high)
        return there or _put(phrases.below, slots, value=number(high))
    above = _put(phrases.above, slots, value=number(low))
    if high == inf:
        return _of_target(feature, slots, phrases.none, low) or above
    if _is_beyond(feature) and high >= ALMOST * feature.default:
        return above
    lowest, highest = apart(low, high)
    within = _put(phrases.below, slots, value=highest)
    both = f"{_put(phrases.above, slots, value=lowest)} and {within}" if above and within else ""
    return _put(phrases.between, slots, low=lowest, high=highest) or both


def _is_beyond(feature: Feature) -> bool:
    """Whether the default, which means that there is no target, is above all other values."""
    return bool(feature.phrases.none) and feature.default > 0.0


def _of_target(feature: Feature, slots: Mapping[str, str], phrase: str, bound: float) -> str:
    """That there is a target or none, if that is what a bound tells apart: one nearer to the default than to 0."""
    if not phrase or not _is_beyond(feature) or bound < feature.default / 2:
        return ""
    return filled(phrase, slots) + ("" if bound >= ALMOST * feature.default else f" within {number(bound)}")


def _put(phrase: str, slots: Mapping[str, str], **words: str) -> str:
    """A phrase with its words; empty if it has no place for one of them."""
    if any("{" + name + "}" not in phrase for name in words):
        return ""
    return filled(phrase, {**slots, **words})


# ------------------------------------------------------------------------------------------ without phrases


def named(name: str, feature: Feature, span: Span, *, clause: bool) -> str:
    """The same in the feature's own name: "Place is at most 12 steps", "not AtEnd"."""
    match feature.kind, span:
        case FeatureKind.BOOLEAN, _:
            wanted = is_true(span)
            return f"{name} is {str(wanted).lower()}" if clause else name if wanted else f"not {name}"
        case _, Is(value):
            return f"{name} is {_said(feature, value)}"
        case _, IsNot(values):
            return f"{name} is not {' or '.join(_said(feature, value) for value in values)}"
        case _, Arc(start, end) if start == end:
            return f"{name} is nowhere"
        case _, Arc():
            return f"{name} is {_arc(feature, span)}"
        case _, Between(low, high):
            return f"{name} is {_range(feature, low, high)}"
    raise TypeError(span)


def _arc(feature: Feature, arc: Arc) -> str:
    seam = -feature.period / 2
    inside = arc.start < arc.end or arc.end <= seam
    start, end = (arc.start, arc.end) if inside else (arc.end, arc.start)
    first, last = ends(feature, start, -seam if end <= seam else end)
    where = last if last == _united(feature, first) else f"between {first} and {last}"
    return f"{'' if inside else 'not '}{where}"


def _range(feature: Feature, low: float, high: float) -> str:
    if low == -inf:
        return f"at most {_with_unit(feature, high)}"
    if high == inf:
        return f"above {_with_unit(feature, low)}"
    first, last = apart(low, high)
    return f"between {first} and {_united(feature, last)}"


def _said(feature: Feature, value: float) -> str:
    if feature.kind is FeatureKind.CATEGORICAL:
        return category(feature, value)
    return _with_unit(feature, value)


def ends(feature: Feature, start: float, end: float) -> tuple[str, str]:
    """The ends of an arc: "-10" and "10 degrees"."""
    first, last = apart(for_people(feature, start), for_people(feature, end))
    return first, _united(feature, last)


def _with_unit(feature: Feature, value: float) -> str:
    return _united(feature, number(for_people(feature, value)))


def _united(feature: Feature, told: str) -> str:
    unit = unit_of(feature, told)
    return f"{told} {unit}" if unit else told


def category(feature: Feature, value: float) -> str:
    """The name of a category; of one that is not there, its number."""
    known = float(value).is_integer() and 0 <= value < len(feature.categories)
    return feature.categories[int(value)] if known else number(value)
