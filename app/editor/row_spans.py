"""Rows by runs of neighbors: Qt's selections and views are slow by the number of ranges, not by that of rows."""

from collections.abc import Iterable, Iterator
from itertools import chain

from PySide6.QtCore import QItemSelection


def spans(rows: Iterable[int]) -> Iterator[tuple[int, int]]:
    """The first and last row of each run of neighbors, in order."""
    ordered = sorted(set(rows))
    first = 0
    for k in range(1, len(ordered) + 1):
        if k == len(ordered) or ordered[k] != ordered[k - 1] + 1:
            yield ordered[first], ordered[k - 1]
            first = k


def selected_rows(selection: QItemSelection) -> tuple[int, ...]:
    """The rows of a table in which anything is selected, each once, in the order of selecting."""
    ranges = (selection.at(at) for at in range(selection.size()))
    return tuple(dict.fromkeys(chain.from_iterable(range(r.top(), r.bottom() + 1) for r in ranges)))
