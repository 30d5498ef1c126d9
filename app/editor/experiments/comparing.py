"""Results of several experiments side by side."""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QListWidget, QListWidgetItem, QVBoxLayout, QWidget

from ...core.errors import UnderstudyError
from ...engine.experiments.lengths import other_lengths
from ...engine.experiments.report import measures_in, place, with_interval
from .study import Kept, Study
from .tables import TextTable, table_view

if TYPE_CHECKING:
    from ...engine.experiments.findings import Findings, Summary
    from .window import ExperimentsWindow

FIRST = "Tick experiments to see their arms side by side."
#: Pixels of the list at most.
WIDTH = 200
#: Data of an entry: the experiment's name, and the ticks of runs of another length than its own; 0 for its own.
KEY = Qt.ItemDataRole.UserRole


class ComparePage(QWidget):
    """Experiments that can be ticked, runs of other lengths by themselves, and the arms of all that are."""

    def __init__(self, window: ExperimentsWindow) -> None:
        super().__init__()
        self._window = window
        self._names: tuple[str, ...] = ()
        self._found: dict[tuple[str, int], Findings] = {}
        self.list = QListWidget()
        self.list.setAccessibleName("experiments to compare")
        self.list.setMaximumWidth(WIDTH)
        self.list.itemChanged.connect(self._ticked)
        self.model = TextTable()
        self.told = QLabel(FIRST)
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
        self._names = tuple(names)
        self._list(self._entries(), set())
        self._show()

    def showEvent(self, event: QShowEvent) -> None:
        """Whoever looks again may have run something meanwhile."""
        super().showEvent(event)
        there = {
            tuple(item.data(KEY)): item.checkState() for item in map(self.list.item, range(self.list.count()))
        }
        entries = self._entries()
        if list(there) != entries:
            self._list(entries, {key for key, state in there.items() if state is Qt.CheckState.Checked})

    def _entries(self) -> list[tuple[str, int]]:
        results = self._window.results
        lengths = {name: other_lengths(name, results) if results is not None else [] for name in self._names}
        return [(name, ticks) for name in self._names for ticks in (0, *lengths[name])]

    def _list(self, entries: Sequence[tuple[str, int]], ticked: AbstractSet[tuple[str, int]]) -> None:
        self.list.blockSignals(True)
        self.list.clear()
        for name, ticks in entries:
            item = QListWidgetItem(f"    at {ticks:,} ticks" if ticks else name)
            item.setToolTip(_words(name, ticks))
            item.setData(KEY, (name, ticks))
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
            on = (name, ticks) in ticked
            item.setCheckState(Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)
            self.list.addItem(item)
        self.list.blockSignals(False)

    def _ticked(self, item: QListWidgetItem) -> None:
        name, ticks = item.data(KEY)
        if item.checkState() is not Qt.CheckState.Checked:
            self._found.pop((name, ticks), None)
            self._show()
            return
        study = self._window.load(name)
        if study is not None:
            self._look_up((name, ticks), study.asked_for(study.declared.runs, ticks) if ticks else study)

    def _look_up(self, key: tuple[str, int], study: Study) -> None:
        self._window.look_up(study, lambda kept: self._take(key, study, kept), self._failed)

    def _take(self, key: tuple[str, int], study: Study, kept: Kept | None) -> None:
        if whole := study.asking_for_all(kept):
            self._look_up(key, whole)
        elif kept is None or kept.found is None:
            self.told.setText(f"{_words(*key)} has not been run yet.")
        else:
            self._found[key] = kept.found
            self._show()

    def _failed(self, error: UnderstudyError) -> None:
        self.told.setText(str(error))

    def _show(self) -> None:
        measures = list(dict.fromkeys(name for found in self._found.values() for name in measures_in(found)))
        varied = any(found.experiment.factors for found in self._found.values())
        rows = [
            _row(name, found, summary, measures, varied=varied)
            for (name, _), found in self._found.items()
            for summary in found.summaries
        ]
        words = ["experiment", "arm", "where"] if varied else ["experiment", "arm"]
        head = [*words, "ticks", "runs", *measures, "stalled"] if rows else []
        self.model.show(head, rows, len(words))
        self.told.setText("Means with half the width of their 95% confidence intervals." if rows else FIRST)


def _row(name: str, found: Findings, summary: Summary, measures: Sequence[str], *, varied: bool) -> list[str]:
    """An arm of an experiment; with what is varied there, if any experiment that is shown varies something."""
    at = place(summary.cell.levels, found.experiment) if found.experiment.factors else ""
    return [
        name,
        summary.cell.arm,
        *([at] if varied else []),
        f"{found.experiment.ticks:,}",
        str(summary.runs),
        *(with_interval(summary.measures.get(measure)) for measure in measures),
        f"{summary.stalled_share:.0%}",
    ]


def _words(name: str, ticks: int) -> str:
    """An experiment, or its runs of another length."""
    return f"{name}, {ticks:,} ticks" if ticks else name
