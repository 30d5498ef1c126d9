"""Results of several experiments side by side."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QListWidget, QListWidgetItem, QVBoxLayout, QWidget

from ...core.errors import UnderstudyError
from ...engine.experiments.report import measures_in, place, with_interval
from .study import Kept, Study
from .tables import TextTable, table_view

if TYPE_CHECKING:
    from ...engine.experiments.findings import Findings
    from .window import ExperimentsWindow


class ComparePage(QWidget):
    """Experiments that can be ticked, and the arms of all that are."""

    def __init__(self, window: ExperimentsWindow) -> None:
        super().__init__()
        self._window = window
        self._found: dict[str, Findings] = {}
        self.list = QListWidget()
        self.list.setAccessibleName("experiments to compare")
        self.list.setMaximumWidth(150)
        self.list.itemChanged.connect(self._ticked)
        self.model = TextTable()
        self.told = QLabel("Tick experiments to see their arms side by side.")
        self.told.setProperty("role", "caption")
        right = QVBoxLayout()
        right.addWidget(self.told)
        right.addWidget(table_view(self.model, "arms side by side"), 1)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 6, 0, 0)
        row.addWidget(self.list)
        row.addLayout(right, 1)

    def offer(self, names: Sequence[str]) -> None:
        """Offer these experiments; nothing is ticked."""
        self._found = {}
        self.list.blockSignals(True)
        self.list.clear()
        for name in names:
            item = QListWidgetItem(name)
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            item.setCheckState(Qt.CheckState.Unchecked)
            self.list.addItem(item)
        self.list.blockSignals(False)
        self._show()

    def _ticked(self, item: QListWidgetItem) -> None:
        name = item.text()
        if item.checkState() is not Qt.CheckState.Checked:
            self._found.pop(name, None)
            self._show()
            return
        study = self._window.load(name)
        if study is not None:
            self._window.look_up(study, lambda kept: self._take(study, kept), self._failed)

    def _take(self, study: Study, kept: Kept | None) -> None:
        if kept is None or kept.found is None:
            self.told.setText(f"{study.declared.name} has not been run yet.")
            return
        self._found[study.declared.name] = kept.found
        self._show()

    def _failed(self, error: UnderstudyError) -> None:
        self.told.setText(str(error))

    def _show(self) -> None:
        measures = list(dict.fromkeys(name for found in self._found.values() for name in measures_in(found)))
        rows = [
            [
                name,
                summary.cell.arm,
                place(summary.cell.levels, found.experiment) if found.experiment.factors else "",
                f"{found.experiment.ticks:,}",
                str(summary.runs),
                *(with_interval(summary.measures.get(measure)) for measure in measures),
                f"{summary.stalled_share:.0%}",
            ]
            for name, found in self._found.items()
            for summary in found.summaries
        ]
        head = ["experiment", "arm", "where", "ticks", "runs", *measures, "stalled"] if rows else []
        self.model.show(head, rows, 3)
        if rows:
            self.told.setText("Means with half the width of their 95% confidence intervals.")
