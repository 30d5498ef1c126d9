"""Tests that are met leave no choice about others."""

import pytest

from app.core.conditions import AtMost, Condition, Equals, InArc
from app.core.implication import guard_implied, implied


def yes(test: AtMost | Equals | InArc) -> Condition:
    return Condition(test)


def no(test: AtMost | Equals | InArc) -> Condition:
    return Condition(test, wanted=False)


@pytest.mark.parametrize(
    ("asked", "known", "surely"),
    [
        (yes(AtMost("d", 5.0)), yes(AtMost("d", 4.0)), True),
        (yes(AtMost("d", 4.0)), yes(AtMost("d", 5.0)), False),
        (no(AtMost("d", 4.0)), no(AtMost("d", 5.0)), True),
        (no(AtMost("d", 4.0)), yes(AtMost("d", 5.0)), False),
        (yes(AtMost("d", 5.0)), yes(AtMost("e", 4.0)), False),
        (no(Equals("b", 0.0)), yes(Equals("b", 1.0)), True),
        (yes(Equals("b", 0.0)), no(Equals("b", 1.0)), False),
        (yes(InArc("a", 0.0, 1.0)), yes(InArc("a", 0.0, 1.0)), True),
        (yes(InArc("a", 0.0, 1.0)), yes(InArc("a", 0.0, 0.5)), False),
    ],
)
def test_a_test_is_implied_only_where_it_is_sure(asked: Condition, known: Condition, surely: bool) -> None:
    assert implied(asked, [known]) is surely


def test_a_guard_is_implied_if_all_of_it_is() -> None:
    guard = (yes(AtMost("d", 5.0)), yes(Equals("b", 1.0)))
    assert guard_implied(guard, (yes(Equals("b", 1.0)), yes(AtMost("d", 1.0))))
    assert not guard_implied(guard, (yes(Equals("b", 1.0)),))
