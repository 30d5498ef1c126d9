"""Rows by runs of neighbors."""

from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QItemSelection, QStringListModel

from app.editor.row_spans import selected_rows, spans


@given(st.lists(st.integers(0, 30)))
def test_spans_hold_each_row_once_and_none_could_be_joined(rows: list[int]) -> None:
    found = list(spans(rows))
    assert [row for first, last in found for row in range(first, last + 1)] == sorted(set(rows))
    assert all(left[1] + 1 < right[0] for left, right in pairwise(found))


def test_selected_rows_are_each_told_once_in_the_order_of_selecting() -> None:
    model = QStringListModel([str(row) for row in range(6)])
    selection = QItemSelection(model.index(4), model.index(5))
    selection.select(model.index(0), model.index(1))
    assert selected_rows(selection) == (4, 5, 0, 1)
