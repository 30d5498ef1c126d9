"""The runs of an experiment as the rows of a table, which grows while they are made and can be sorted."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from operator import attrgetter
from typing import TYPE_CHECKING, Any

from PySide6.QtCore import QAbstractTableModel, QModelIndex, Qt

from ...core.amounts import number
from .tables import Index, Role

if TYPE_CHECKING:
    from ...engine.experiments.plan import Cell, Experiment
    from ...engine.experiments.store import Row

Key = Callable[["Row"], Any]
#: Columns with words, from the left.
WORDS = 1
_LAST = -float("inf")


class RunsTable(QAbstractTableModel):
    """Makes the text of a cell when it is looked at, so that any number of runs is there at once.

    Attributes:
        rows: In the order in which they are shown.
    """

    def __init__(self) -> None:
        super().__init__()
        self.rows: list[Row] = []
        self._placed: list[Row] = []  # the same, cell by cell
        self._experiment: Experiment | None = None
        self._cells: tuple[Cell, ...] = ()
        self._measures: tuple[str, ...] = ()
        self._there: set[tuple[int, int]] = set()
        self._sorted_by = -1, Qt.SortOrder.AscendingOrder

    def show(self, experiment: Experiment, rows: Sequence[Row]) -> None:
        """Show the runs of an experiment; if they are those that are shown and some more, the selection stays."""
        measures = tuple(sorted(rows[0].measures)) if rows else ()
        new = [row for row in rows if (row.cell, row.run) not in self._there]
        goes_on = experiment == self._experiment and measures == self._measures
        if not goes_on or len(self.rows) + len(new) != len(rows):
            self._begin(experiment, measures, rows)
        elif new:
            self._add(new)

    def _begin(self, experiment: Experiment, measures: tuple[str, ...], rows: Sequence[Row]) -> None:
        self.beginResetModel()
        self._experiment, self._cells, self._measures = experiment, experiment.cells(), measures
        self._there = {(row.cell, row.run) for row in rows}
        self._placed = sorted(rows, key=_place)
        self.rows = self._ordered()
        self.endResetModel()

    def _add(self, new: Sequence[Row]) -> None:
        self.beginInsertRows(QModelIndex(), len(self.rows), len(self.rows) + len(new) - 1)
        self.rows += new
        self._there |= {(row.cell, row.run) for row in new}
        self.endInsertRows()
        self._placed = sorted([*self._placed, *new], key=_place)
        self._arrange()

    # -------------------------------------------------------------------------------------------- sorting

    def sort(self, column: int, order: Qt.SortOrder = Qt.SortOrder.AscendingOrder) -> None:
        """Put runs into the order of a column; what is selected stays so."""
        self._sorted_by = column, order
        self._arrange()

    def _ordered(self) -> list[Row]:
        column, order = self._sorted_by
        if not 0 <= column < self.columnCount():
            return list(self._placed)
        return sorted(self._placed, key=self._keys()[column], reverse=order is Qt.SortOrder.DescendingOrder)

    def _arrange(self) -> None:
        ordered = self._ordered()
        self.layoutAboutToBeChanged.emit()
        before = self.persistentIndexList()
        moved = [self.rows[index.row()] for index in before]
        places = {id(row): place for place, row in enumerate(ordered)} if moved else {}
        self.rows = ordered
        after = [
            self.index(places[id(row)], index.column()) for row, index in zip(moved, before, strict=True)
        ]
        self.changePersistentIndexList(before, after)
        self.layoutChanged.emit()

    def _keys(self) -> list[Key]:
        def measured(name: str) -> Key:
            return lambda row: row.measures.get(name, _LAST)

        return [
            _place,
            attrgetter("run"),
            attrgetter("seed"),
            *(measured(name) for name in self._measures),
            attrgetter("stalled"),
            attrgetter("seconds"),
        ]

    # ---------------------------------------------------------------------------------------- as a model

    @property
    def _head(self) -> Sequence[str]:
        return ("arm", "run", "seed", *self._measures, "stalled", "seconds")

    def rowCount(self, parent: Index | None = None) -> int:
        """How many runs there are."""
        return 0 if parent is not None and parent.isValid() else len(self.rows)

    def columnCount(self, _parent: Index | None = None) -> int:
        """How many columns there are."""
        return len(self._head)

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = Role.DisplayRole) -> Any:
        """The head of a column."""
        if orientation is not Qt.Orientation.Horizontal or section >= len(self._head):
            return None
        if role == Role.TextAlignmentRole:
            return _alignment(section)
        if role == Role.ToolTipRole:
            return "Click to sort by this column"
        return self._head[section] if role == Role.DisplayRole else None

    def data(self, index: Index, role: int = Role.DisplayRole) -> Any:
        """What a cell shows."""
        if not index.isValid():
            return None
        if role in (Role.DisplayRole, Role.ToolTipRole):
            return self._text(self.rows[index.row()], index.column())
        return _alignment(index.column()) if role == Role.TextAlignmentRole else None

    def _text(self, row: Row, column: int) -> str:
        measured = {3 + k: row.measures.get(name) for k, name in enumerate(self._measures)}
        if column in measured:
            value = measured[column]
            return "" if value is None else number(value)
        others = {
            "arm": self._cells[row.cell].name,
            "run": str(row.run + 1),
            "seed": str(row.seed),
            "stalled": "yes" if row.stalled else "",
            "seconds": f"{row.seconds:.2f}",
        }
        return others[self._head[column]]


def _place(row: Row) -> tuple[int, int]:
    """Cell by cell, the order in which runs are shown at first."""
    return row.cell, row.run


def _alignment(column: int) -> int:
    side = Qt.AlignmentFlag.AlignLeft if column < WORDS else Qt.AlignmentFlag.AlignRight
    return int(side | Qt.AlignmentFlag.AlignVCenter)
