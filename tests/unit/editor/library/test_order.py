"""Rows are brought in order, by no more moves than it takes."""

from collections.abc import Sequence
from itertools import combinations

from hypothesis import given
from hypothesis import strategies as st

from app.editor.library.order import moves


def rows_after(places: Sequence[int]) -> list[int]:
    rows = list(places)
    for at, to in moves(places):
        rows.insert(to, rows.pop(at))
    return rows


def least(places: Sequence[int]) -> int:
    """How many have to move, by trying which of them can stay."""
    return next(
        len(places) - many
        for many in range(len(places), -1, -1)
        if any(list(staying) == sorted(staying) for staying in combinations(places, many))
    )


@given(st.permutations(range(40)))
def test_all_are_in_order_after_the_moves(places: list[int]) -> None:
    assert rows_after(places) == sorted(places)


@given(st.permutations(range(7)))
def test_there_is_no_way_with_fewer_moves(places: list[int]) -> None:
    assert len(list(moves(places))) == least(places)


def test_one_row_that_goes_far_down_is_the_only_one_that_moves() -> None:
    assert list(moves([50, *range(50), *range(51, 100)])) == [(0, 50)]


def test_rows_that_are_in_order_stay() -> None:
    assert not list(moves(range(100)))
    assert not list(moves(()))
