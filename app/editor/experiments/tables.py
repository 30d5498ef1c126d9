"""Tables of an experiment: arms, claims, runs, and several experiments side by side."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from PySide6.QtCore import QAbstractItemModel, QAbstractTableModel, QModelIndex, QPersistentModelIndex, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView

Index = QModelIndex | QPersistentModelIndex
Role = Qt.ItemDataRole
#: Pixels that a column takes at most by itself.
WIDEST = 420
#: And at least, where room is short.
NARROWEST = 160
#: Between rows whose words go on below.
APART = 8
#: Columns are as wide as what so many rows hold.
MEASURED = 30


class TextTable(QAbstractTableModel):
    """Rows of text with a head; cells are made by whoever shows them.

    Attributes:
        words: How many columns, from the left, hold words; the others hold numbers and stand on the right.
    """

    def __init__(self) -> None:
        super().__init__()
        self._head: list[str] = []
        self._rows: list[list[str]] = []
        self.words = 1

    def show(self, head: Sequence[str], rows: Sequence[Sequence[str]], words: int = 1) -> None:
        """Show other rows; where only texts differ, what is selected stays so."""
        new = [list(row) for row in rows]
        same_shape = list(head) == self._head and len(new) == len(self._rows)
        if same_shape:
            self._rows, self.words = new, words
            if new:
                self.dataChanged.emit(self.index(0, 0), self.index(len(new) - 1, len(head) - 1))
            return
        self.beginResetModel()
        self._head, self._rows, self.words = list(head), new, words
        self.endResetModel()

    def row(self, number: int) -> list[str]:
        """The texts of a row."""
        return self._rows[number]

    def rowCount(self, parent: Index | None = None) -> int:
        """How many rows there are."""
        return 0 if parent is not None and parent.isValid() else len(self._rows)

    def columnCount(self, _parent: Index | None = None) -> int:
        """How many columns there are."""
        return len(self._head)

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = Role.DisplayRole) -> Any:
        """The head of a column."""
        if orientation is not Qt.Orientation.Horizontal or section >= len(self._head):
            return None
        if role == Role.TextAlignmentRole:
            return self._alignment(section)
        return self._head[section] if role == Role.DisplayRole else None

    def data(self, index: Index, role: int = Role.DisplayRole) -> Any:
        """What a cell shows."""
        if not index.isValid():
            return None
        if role in (Role.DisplayRole, Role.ToolTipRole):
            return self._rows[index.row()][index.column()]
        return self._alignment(index.column()) if role == Role.TextAlignmentRole else None

    def _alignment(self, column: int) -> int:
        side = Qt.AlignmentFlag.AlignLeft if column < self.words else Qt.AlignmentFlag.AlignRight
        return int(side | Qt.AlignmentFlag.AlignVCenter)


class _Table(QTableView):
    """Columns that do not fit in are fitted when it gets another size, too; Home and End go to the first and last row."""

    def resizeEvent(self, event: QResizeEvent) -> None:
        """See above."""
        super().resizeEvent(event)
        _narrow(self)

    def moveCursor(
        self, action: QAbstractItemView.CursorAction, modifiers: Qt.KeyboardModifier
    ) -> QModelIndex:
        """See above: rows are what is chosen, and Qt's own Home and End stay in their row."""
        ends = (QAbstractItemView.CursorAction.MoveHome, QAbstractItemView.CursorAction.MoveEnd)
        if action in ends:
            modifiers |= Qt.KeyboardModifier.ControlModifier
        return super().moveCursor(action, modifiers)


def table_view(model: QAbstractItemModel, name: str, *, wrapped: bool = False) -> QTableView:
    """A quiet table in which rows can be selected.

    Args:
        wrapped: Words that do not fit into their column go on below, rather than ending in dots; for few rows.
    """
    view = _Table()
    view.setModel(model)
    view.setAccessibleName(name)
    view.setShowGrid(False)
    view.setTabKeyNavigation(False)  # arrow keys go through it, Tab goes on
    view.setWordWrap(wrapped)
    view.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    view.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
    view.verticalHeader().hide()
    view.verticalHeader().setDefaultSectionSize(24)
    header = view.horizontalHeader()
    header.setHighlightSections(False)
    header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
    header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
    model.modelReset.connect(lambda: _fit(view))
    model.dataChanged.connect(lambda *_: _fit(view, grow=True))
    model.rowsInserted.connect(lambda _, first, __: _fit(view, grow=first > 0) if first < MEASURED else None)
    return view


def _fit(view: QTableView, *, grow: bool = False) -> None:
    """Columns as wide as what the first rows hold, so that a table of any length is fitted at once.

    Args:
        grow: Only make columns wider that have become too narrow.
    """
    view.horizontalHeader().setResizeContentsPrecision(MEASURED)
    before = [view.columnWidth(column) for column in range(view.model().columnCount())]
    view.resizeColumnsToContents()
    for column, width in enumerate(before):
        fitted = min(WIDEST, view.columnWidth(column) + 12)
        view.setColumnWidth(column, max(fitted, width) if grow else fitted)
    _narrow(view)


def _narrow(view: QTableView) -> None:
    """What does not fit in is taken from the widest column, whose words are in its tool tips as well."""
    widths = [view.columnWidth(column) for column in range(view.model().columnCount())]
    over = sum(widths) - view.viewport().width()
    if over > 0 and widths and view.isVisible():  # one that was never shown has no size yet
        widest = widths.index(max(widths))
        view.setColumnWidth(widest, max(NARROWEST, widths[widest] - over))
    if view.wordWrap():
        view.resizeRowsToContents()
        for row in range(view.model().rowCount()):
            view.setRowHeight(row, view.rowHeight(row) + APART)
