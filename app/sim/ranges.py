"""Which values a feature can have, by its kind."""

import re
from collections.abc import Mapping
from dataclasses import fields
from math import inf, isfinite, nextafter
from sys import float_info

from ..core.errors import ScenarioError
from ..core.vocabulary import Feature, FeatureKind

#: What a phrase can tell besides the targets.
SLOTS: Mapping[str, tuple[str, ...]] = {
    "true": ("start", "end", "value"),
    "false": ("start", "end", "value"),
    "above": ("value",),
    "below": ("value",),
    "between": ("low", "high"),
    "at": ("value",),
    "not_at": ("value",),
}


def closed_range(feature: Feature) -> tuple[float, float]:
    """The least and the greatest value that *feature* can have; NaN and infinity lie in no range."""
    match feature.kind:
        case FeatureKind.CONTINUOUS:
            return -float_info.max, float_info.max
        case FeatureKind.BOOLEAN:
            return 0.0, 1.0
        case FeatureKind.CATEGORICAL:
            return 0.0, len(feature.categories) - 1.0
        case FeatureKind.TOROIDAL:
            return -feature.period / 2, nextafter(feature.period / 2, -inf)


def is_value(feature: Feature, value: float) -> bool:
    """Whether *feature* can have this value: in its range, and whole where it is boolean or categorical."""
    low, high = closed_range(feature)
    counted = feature.kind in (FeatureKind.BOOLEAN, FeatureKind.CATEGORICAL)
    return low <= value <= high and (not counted or value == int(value))


def allowed(feature: Feature) -> str:
    """The values that *feature* can have, in words."""
    match feature.kind:
        case FeatureKind.CONTINUOUS:
            return "a finite number"
        case FeatureKind.BOOLEAN:
            return "0 or 1"
        case FeatureKind.CATEGORICAL:
            return f"a whole number from 0 to {len(feature.categories) - 1}"
        case FeatureKind.TOROIDAL:
            return f"a number in [{-feature.period / 2:g}, {feature.period / 2:g})"


def refuse_bad_feature(feature: Feature) -> None:
    """Raise a `ScenarioError` if a feature is declared with a period, categories, default or phrases that cannot be."""
    if feature.kind is FeatureKind.TOROIDAL and not (isfinite(feature.period) and feature.period > 0):
        raise ScenarioError(f"feature {feature.name!r} has the period {feature.period}; allowed: above 0")
    counted = len(set(feature.categories))
    if (feature.kind is FeatureKind.CATEGORICAL) is not (counted > 0) or counted != len(feature.categories):
        raise ScenarioError(
            f"feature {feature.name!r} is {feature.kind} with the categories {feature.categories}; categorical ones need "
            "one category or more, each once, others have none"
        )
    if not is_value(feature, feature.default):
        raise ScenarioError(
            f"the default of feature {feature.name!r} is {feature.default}; allowed: {allowed(feature)}"
        )
    _refuse_bad_phrases(feature)


def _refuse_bad_phrases(feature: Feature) -> None:
    for field in fields(feature.phrases):
        usable = (*SLOTS.get(field.name, ()), *feature.parameters)
        for slot in re.findall(r"\{([^{}]*)\}", getattr(feature.phrases, field.name)):
            if slot not in usable:
                there = ", ".join(f"{{{name}}}" for name in usable) or "none"
                raise ScenarioError(
                    f"phrase {field.name!r} of feature {feature.name!r} has no words for {{{slot}}}; it has for: {there}"
                )
