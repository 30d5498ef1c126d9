"""Where cuts are placed: between examples, and beside transitions."""

from math import inf, nextafter, pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.core.conditions import AtMost, Equals, InArc, Test
from app.core.tree import Branch
from app.learner.builder import build
from app.learner.dataset import Dataset
from app.learner.splits import Side, cut, midway, seam_cut, threshold
from tests.unit.learner.examples import BOOLEAN, CATEGORICAL, CONTINUOUS, TOROIDAL, at, of_one_feature

FINITE = st.floats(allow_nan=False, allow_infinity=False)
PAIRS = st.tuples(FINITE, FINITE).filter(lambda pair: pair[0] < pair[1])
SIDES = st.booleans()


def root_test(data: Dataset) -> Test:
    root = build(data).root
    assert isinstance(root, Branch)
    return root.test


def test_a_threshold_lies_midway() -> None:
    assert root_test(of_one_feature(CONTINUOUS, (1.0, "A"), (2.0, "A"), (5.0, "B"))) == AtMost("f", 3.5)


def test_a_threshold_lies_beside_the_transition_where_lower_values_continue() -> None:
    """Keeps going up to 5, where it was told to turn: 4.9 still goes on, 5 turns."""
    data = of_one_feature(CONTINUOUS, (1.0, "go"), (5.0, "turn"), continuations="go")
    assert root_test(data) == AtMost("f", nextafter(5.0, -inf))


def test_a_threshold_lies_beside_the_transition_where_higher_values_continue() -> None:
    """Told to stop at 2 while going on at 40: up to 2 it stops, just above it goes on."""
    data = of_one_feature(CONTINUOUS, (2.0, "stop"), (40.0, "go"), continuations="go")
    assert root_test(data) == AtMost("f", 2.0)


@pytest.mark.parametrize("continuing", ["", "AB"])
def test_a_threshold_lies_midway_between_two_transitions_and_between_two_continuations(
    continuing: str,
) -> None:
    sides = Side(2.0, bool(continuing)), Side(6.0, bool(continuing))
    assert threshold(*sides) == 4.0


def test_a_value_that_also_a_transition_has_is_no_continuation() -> None:
    data = of_one_feature(
        CONTINUOUS, (1.0, "go"), (1.0, "turn"), (5.0, "turn"), (5.0, "turn"), continuations="go"
    )
    assert root_test(data) == AtMost("f", 3.0)


@given(pair=PAIRS, low=SIDES, high=SIDES)
def test_a_threshold_always_parts_its_neighbors(pair: tuple[float, float], low: bool, high: bool) -> None:
    assert pair[0] <= threshold(Side(pair[0], low), Side(pair[1], high)) < pair[1]


@given(pair=PAIRS, low=SIDES, high=SIDES)
def test_an_arcs_cut_always_parts_its_neighbors(pair: tuple[float, float], low: bool, high: bool) -> None:
    assert pair[0] < cut(Side(pair[0], low), Side(pair[1], high)) <= pair[1]


def test_neighboring_floats_are_parted() -> None:
    above = nextafter(1.0, inf)
    assert threshold(Side(1.0, False), Side(above, False)) == 1.0
    assert cut(Side(1.0, False), Side(above, False)) == above


def test_midway_does_not_overflow() -> None:
    assert midway(-1.7e308, 1.7e308) == 0.0
    assert midway(1.6e308, 1.7e308) == pytest.approx(1.65e308)


def test_an_arc_is_found_around_a_direction() -> None:
    data = of_one_feature(TOROIDAL, (-2.0, "left"), (-0.5, "go"), (0.5, "go"), (2.0, "left"))
    test = root_test(data)
    assert isinstance(test, InArc)
    assert [test.start, test.end] == pytest.approx([-1.25, 1.25])


def test_an_arc_may_run_through_the_seam() -> None:
    """Behind means beyond 2.8 on either side: one test tells."""
    data = of_one_feature(TOROIDAL, (-3.0, "back"), (3.0, "back"), (2.6, "go"), (-2.6, "go"))
    tree = build(data)
    assert tree.depth() == 1
    labels = {value: tree.decide(at(value)).probabilities for value in (-pi, 3.1, 2.7, -2.7)}
    assert labels[-pi] == labels[3.1] == (1.0, 0.0)
    assert labels[2.7] == labels[-2.7] == (0.0, 1.0)


def test_both_cuts_of_an_arc_lie_beside_the_transitions() -> None:
    """Goes on at 0, was told to turn at both sides: up to these sides it goes on."""
    data = of_one_feature(TOROIDAL, (-1.0, "turn"), (0.0, "go"), (1.0, "turn"), continuations="go")
    assert root_test(data) == InArc("f", nextafter(-1.0, inf), 1.0)


def test_an_arc_of_transitions_among_continuations_is_as_narrow_as_it_can_be() -> None:
    data = of_one_feature(TOROIDAL, (-1.0, "go"), (0.0, "turn"), (1.0, "go"), continuations="go")
    assert root_test(data) == InArc("f", 0.0, nextafter(0.0, inf))


def test_a_cut_in_the_gap_with_the_seam_lies_midway_on_the_circle() -> None:
    assert seam_cut(Side(3.0, False), Side(-2.0, False), 2 * pi) == pytest.approx(
        3.0 + (2 * pi - 5.0) / 2 - 2 * pi
    )
    assert seam_cut(Side(2.0, False), Side(-3.0, False), 2 * pi) == pytest.approx(2.0 + (2 * pi - 5.0) / 2)


def test_a_cut_in_the_gap_with_the_seam_lies_beside_the_transition() -> None:
    assert seam_cut(Side(3.0, True), Side(-2.0, False), 2 * pi) == -2.0
    assert seam_cut(Side(3.0, False), Side(-2.0, True), 2 * pi) == nextafter(3.0, inf)


def test_beside_the_last_angle_below_the_seam_lies_the_first_one_above_it() -> None:
    assert seam_cut(Side(nextafter(pi, 0), False), Side(-2.0, True), 2 * pi) == -pi


@given(
    values=st.lists(st.floats(-pi, nextafter(pi, 0)), min_size=2, max_size=2, unique=True),
    last=SIDES,
    first=SIDES,
)
def test_a_cut_in_the_gap_with_the_seam_parts_the_highest_from_the_lowest_value(
    values: list[float], last: bool, first: bool
) -> None:
    lowest, highest = sorted(values)
    found = seam_cut(Side(highest, last), Side(lowest, first), 2 * pi)
    assert -pi <= found < pi
    assert found <= lowest or found > highest


@pytest.mark.parametrize("highest", [pi, 4.0])
def test_values_just_outside_the_circle_are_still_parted(highest: float) -> None:
    data = of_one_feature(TOROIDAL, (-pi, "A"), (0.0, "B"), (1.0, "C"), (highest, "A"))
    tree = build(data)
    for value, label in ((-pi, "A"), (0.0, "B"), (1.0, "C"), (highest, "A")):
        decision = tree.decide(at(value))
        assert decision.probabilities[tree.labels.index(label)] == 1.0


def test_a_boolean_is_tested_for_true() -> None:
    assert root_test(of_one_feature(BOOLEAN, (0.0, "A"), (1.0, "B"))) == Equals("f", 1.0)


def test_a_category_is_split_off_from_all_others() -> None:
    data = of_one_feature(CATEGORICAL, (0.0, "A"), (1.0, "B"), (2.0, "A"), (3.0, "A"))
    assert root_test(data) == Equals("f", 1.0)


def test_of_two_categories_the_higher_is_split_off() -> None:
    assert root_test(of_one_feature(CATEGORICAL, (2.0, "A"), (5.0, "B"))) == Equals("f", 5.0)
