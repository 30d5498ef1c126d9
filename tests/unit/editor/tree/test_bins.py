"""The histogram counts every example once, and values that mean "nobody" apart."""

from math import pi

import numpy as np

from app.core.conditions import AtMost, InArc
from app.core.vocabulary import Feature, FeatureKind, Phrases
from app.editor.tree.bins import histogram

NONE = 1000.0
DISTANCE = Feature("d", FeatureKind.CONTINUOUS, default=NONE, phrases=Phrases(none="there is none"))
ANGLE = Feature("a", FeatureKind.TOROIDAL)


def test_every_example_is_counted_once_by_its_label() -> None:
    values, labels = np.array([1.0, 2.0, 3.0, NONE]), np.array([0, 1, 1, 0])
    found = histogram(values, labels, 2, AtMost("d", 2.5), DISTANCE)
    assert found.counts.sum(axis=0).tolist() == [1, 2]
    assert found.nobody.tolist() == [1, 0]
    assert found.low < 1.0
    assert 3.0 < found.high < 4.0


def test_places_and_values_are_inverse_within_what_is_shown() -> None:
    found = histogram(np.array([0.0, 10.0]), np.array([0, 1]), 2, AtMost("d", 5.0), DISTANCE)
    assert found.value(found.place(7.5)) == 7.5
    assert (found.place(-99.0), found.place(NONE)) == (0.0, 1.0)


def test_an_angle_is_shown_around_the_circle() -> None:
    found = histogram(np.array([0.1]), np.array([0]), 1, InArc("a", -0.5, 0.5), ANGLE)
    assert (found.low, found.high) == (-pi, pi)


def test_one_value_or_none_can_be_shown_too() -> None:
    one = histogram(np.array([2.0, 2.0]), np.array([0, 1]), 2, AtMost("d", 2.0), DISTANCE)
    none = histogram(np.array([]), np.array([], np.int64), 2, AtMost("d", 2.0), DISTANCE)
    assert one.counts.sum() == 2
    assert none.most == 1
    assert none.low < none.high
