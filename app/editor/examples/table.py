"""The table of examples as it is looked at: how wide columns are, and what is edited in place."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QItemSelectionModel, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QAbstractItemDelegate, QAbstractItemView, QTableView, QWidget

from .delegates import LabelDelegate, WeightDelegate
from .model import Column, ExamplesModel

#: Pixels; with `LEAST_WORDS`, all up to the weight are seen without scrolling in a window of 1280 pixels.
_WIDTHS: Mapping[Column, int] = {
    Column.ID: 76,
    Column.SOURCE: 112,
    Column.LABEL: 112,
    Column.VERDICT: 88,
    Column.WEIGHT: 64,
    Column.NODE: 76,
    Column.TICK: 60,
    Column.DEMONSTRATION: 112,
}
#: Pixels that the words get where room is short.
LEAST_WORDS = 152


class ExamplesTable(QTableView):
    """The words get what room the other columns leave, and some in any case.

    Signals:
        edit_ended: What was being edited in place is taken or given up.
    """

    edit_ended = Signal()

    def __init__(self, model: ExamplesModel) -> None:
        super().__init__()
        self.setModel(model)
        self.setAccessibleName("examples")
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setEditTriggers(
            QAbstractItemView.EditTrigger.DoubleClicked | QAbstractItemView.EditTrigger.EditKeyPressed
        )
        self.setSortingEnabled(True)
        self.sortByColumn(Column.ID, Qt.SortOrder.AscendingOrder)
        self.setShowGrid(False)
        self.setTabKeyNavigation(False)  # arrow keys go through it, Tab goes on
        self.setWordWrap(False)
        self.setItemDelegateForColumn(Column.LABEL, LabelDelegate(model, self))
        self.setItemDelegateForColumn(Column.WEIGHT, WeightDelegate(self))
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self._prepare_headers(model)

    def _prepare_headers(self, model: ExamplesModel) -> None:
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(24)
        header = self.horizontalHeader()
        header.setHighlightSections(False)
        # Of its own, since nothing in it is shown: whether a whole column is selected, it would ask every row.
        header.setSelectionModel(QItemSelectionModel(model, header))
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        for column, width in _WIDTHS.items():
            self.setColumnWidth(column, width)

    @property
    def is_editing(self) -> bool:
        """Whether something is being edited in place."""
        return self.state() is QAbstractItemView.State.EditingState

    def closeEditor(self, editor: QWidget, hint: QAbstractItemDelegate.EndEditHint) -> None:
        """See above."""
        super().closeEditor(editor, hint)
        self.edit_ended.emit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """See above."""
        super().resizeEvent(event)
        others = sum(self.columnWidth(column) for column in Column if column is not Column.WORDS)
        self.setColumnWidth(Column.WORDS, max(LEAST_WORDS, self.viewport().width() - others))
