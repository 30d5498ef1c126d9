from math import pi

import pytest

from app.core.conditions import AtMost, Condition, Equals, InArc, Test, Values, guard_met


def values(**known: float) -> Values:
    return known.__getitem__


@pytest.mark.parametrize(
    ("test", "value", "holds"),
    [
        (AtMost("d", 2.0), 2.0, True),
        (AtMost("d", 2.0), 2.0000000001, False),
        (AtMost("d", -1.0), -1.5, True),
        (Equals("b", 1.0), 1.0, True),
        (Equals("b", 1.0), 0.0, False),
        (Equals("c", 2.0), 2.0, True),
    ],
)
def test_at_most_includes_its_threshold_and_equals_is_exact(test: Test, value: float, holds: bool) -> None:
    assert test.holds(value) is holds


@pytest.mark.parametrize(
    ("start", "end", "inside", "outside"),
    [
        (-1.0, 1.0, (-1.0, 0.0, 0.999), (1.0, 2.0, -1.001, -pi)),
        (3.0, -3.0, (3.0, pi - 1e-9, -pi, -3.001), (-3.0, 0.0, 2.999)),
        (-pi, -3.0, (-pi, -3.001), (-3.0, 0.0, pi - 1e-9)),
        (3.0, -pi, (3.0, pi - 1e-9), (-pi, 0.0, 2.999)),
        (0.5, 0.5, (), (0.5, 0.4, 0.6, -pi)),
        (-pi, -pi, (), (-pi, 0.0)),
    ],
    ids=["plain", "through the seam", "from the seam", "up to the seam", "empty", "empty at the seam"],
)
def test_an_arc_includes_its_start_and_not_its_end_even_through_the_seam(
    start: float, end: float, inside: tuple[float, ...], outside: tuple[float, ...]
) -> None:
    arc = InArc("angle", start, end)
    assert [arc.holds(value) for value in inside] == [True] * len(inside)
    assert [arc.holds(value) for value in outside] == [False] * len(outside)


def test_an_arc_and_the_arc_back_share_the_circle_without_overlap() -> None:
    there, back = InArc("angle", -2.0, 2.5), InArc("angle", 2.5, -2.0)
    circle = [-pi + k * pi / 500 for k in range(1000)] + [-2.0, 2.5]
    assert all(there.holds(value) != back.holds(value) for value in circle)


def test_a_condition_can_want_its_test_to_fail() -> None:
    far = Condition(AtMost("d", 2.0), wanted=False)
    assert [far.met(values(d=d)) for d in (1.0, 2.0, 3.0)] == [False, False, True]


def test_a_guard_is_met_where_every_condition_is_and_the_empty_one_always() -> None:
    guard = (Condition(AtMost("d", 2.0)), Condition(Equals("b", 1.0)))
    assert guard_met(guard, values(d=1.0, b=1.0))
    assert not guard_met(guard, values(d=1.0, b=0.0))
    assert guard_met((), values())


def test_a_guard_asks_for_no_feature_after_a_condition_that_is_not_met() -> None:
    guard = (Condition(AtMost("d", 2.0)), Condition(Equals("never asked", 1.0)))
    assert not guard_met(guard, values(d=3.0))
