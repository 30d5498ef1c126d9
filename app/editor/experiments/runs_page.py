"""All runs of an experiment; each can be opened in the world at any tick."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QSpinBox, QVBoxLayout, QWidget

from ...core.errors import UnderstudyError
from ...engine.commands import GoTo, Reset
from ...engine.experiments.store import Row
from ...engine.experiments.treatments import Ready, Treatments, sorted_settings
from ..documents.asking import Answer, Question
from ..number_box import roomy
from .runs_table import RunsTable
from .study import Study
from .tables import table_view

if TYPE_CHECKING:
    from .window import ExperimentsWindow


class RunsPage(QWidget):
    """A table of runs, and what opens one of them."""

    def __init__(self, window: ExperimentsWindow) -> None:
        super().__init__()
        self._window = window
        self._study: Study | None = None
        self.model = RunsTable()
        self.table = table_view(self.model, "runs")
        header = self.table.horizontalHeader()
        header.setSortIndicatorClearable(True)
        header.setSortIndicator(-1, Qt.SortOrder.AscendingOrder)
        self.table.setSortingEnabled(True)
        self.tick = roomy(QSpinBox())
        self.tick.setToolTip("The tick to open the world at")
        self.tick.setAccessibleName("tick")
        self.tick.setGroupSeparatorShown(True)
        self.open_button = QPushButton("Open in the world")
        self.open_button.setToolTip("Show the world of the selected run at this tick (Enter, double click)")
        self.open_button.clicked.connect(self.open_chosen)
        line = QHBoxLayout()
        line.addStretch(1)
        caption = QLabel("at tick")
        caption.setProperty("role", "caption")
        line.addWidget(caption)
        line.addWidget(self.tick)
        line.addWidget(self.open_button)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.table, 1)
        column.addLayout(line)
        self.table.activated.connect(lambda _: self.open_chosen())
        self.table.selectionModel().selectionChanged.connect(lambda *_: self._refresh())
        self.model.modelReset.connect(self._refresh)
        self._refresh()

    def show_rows(self, study: Study, rows: Sequence[Row]) -> None:
        """Show the runs of a study."""
        if self._study is None or self._study.path != study.path:
            self.tick.setRange(0, study.experiment.ticks)
            self.tick.setValue(study.experiment.ticks)
        self._study = study
        self.model.show(study.experiment, rows)

    @property
    def chosen(self) -> Row | None:
        """The run that is selected."""
        rows = self.table.selectionModel().selectedRows()
        return self.model.rows[rows[0].row()] if rows else None

    def _refresh(self) -> None:
        self.open_button.setEnabled(self.chosen is not None)

    # ---------------------------------------------------------------------------------------- opening a run

    def open_chosen(self) -> None:
        """Open the world of the selected run."""
        row, study = self.chosen, self._study
        if row is None or study is None:
            return
        cell = study.experiment.cells()[row.cell]
        treatments = Treatments(study.project, study.scenario, study.experiment)
        tick = self.tick.value()
        self._window.background.do(
            lambda: treatments.of(cell, row.run),
            lambda ready: self._open(study, row, ready, tick),
            self._failed,
        )

    def _failed(self, error: UnderstudyError) -> None:
        self._window.studio.warn(str(error))

    def _open(self, study: Study, row: Row, ready: Ready, tick: int) -> None:
        """Show a run: in this world where only the world differs, otherwise in a project of its own."""
        studio, treatment = self._window.studio, ready.treatment
        cell = study.experiment.cells()[row.cell]
        project = studio.document.project
        same = treatment.project is project and any(arm is treatment.arm for arm in project.arms)
        if same:
            studio.use_arm(treatment.arm.name, sorted_settings(cell.settings).scenario)
            studio.bridge.send(Reset(row.seed))
            studio.bridge.send(GoTo(tick))
            studio.say(f"run {row.run + 1} of {cell.name}, seed {row.seed}, at tick {tick:,}")
            self._window.studio.world_wanted.emit()
            return
        name = f"{study.declared.name}, {cell.name}, run {row.run + 1}"
        arm = replace(treatment.arm, parameters=dict(treatment.parameters), world="")
        own = replace(treatment.project, name=name, arms=(arm,), demonstrations=(), worlds={})
        Question(
            self._window,
            studio.theme,
            "Open the run as a project of its own?",
            "This run differs from the open project in more than its world: in its forest, its behaviors, or how they "
            "were learned. It can be opened in a window of its own.",
            (
                Answer(
                    "Open it",
                    lambda: studio.window_wanted.emit(own, study.scenario, arm.name, row.seed, tick),
                ),
                Answer("Leave it"),
            ),
        ).ask()
