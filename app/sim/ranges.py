"""Which values a feature can have, by its kind."""

from math import inf, isfinite, nextafter
from sys import float_info

from ..core.errors import ScenarioError
from ..core.vocabulary import Feature, FeatureKind


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
    """Raise a `ScenarioError` if a feature is declared with a period, categories or a default that cannot be."""
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
