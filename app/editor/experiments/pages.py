"""What was found: curves, the tables of arms and claims, all runs, and experiments side by side."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QHBoxLayout, QTabWidget, QVBoxLayout, QWidget

from ...engine.experiments.report import arm_columns, arm_rows, claim_columns, claim_rows, words_in_arms
from ..forms.word_list import WordList
from .comparing import ComparePage
from .curves import CurvesView
from .exporting import Exporting
from .runs_page import RunsPage
from .tables import TextTable, table_view

if TYPE_CHECKING:
    from ...engine.experiments.findings import Findings
    from .study import Kept, Study
    from .window import ExperimentsWindow


class Pages(QTabWidget):
    """The pages below the controls.

    Attributes:
        found: What they show; None if nothing was found yet.
    """

    def __init__(self, window: ExperimentsWindow) -> None:
        super().__init__()
        self.found: Findings | None = None
        self.measure = WordList()
        self.measure.setAccessibleName("measure")
        self.measure.setToolTip("What the curves show")
        self.measure.activated.connect(lambda _: self._show_curves())
        self.curves = CurvesView(window.studio.theme)
        self.arms, self.claims = TextTable(), TextTable()
        self.runs = RunsPage(window)
        self.compare = ComparePage(window)
        self.exporting = Exporting(window)
        self.setDocumentMode(True)
        self._curves_view = self._curves_page()
        self._arms_view = table_view(self.arms, "arms")
        self._claims_view = table_view(self.claims, "claims", wrapped=True)
        self.addTab(self._curves_view, "Curves")
        self.addTab(self._arms_view, "Arms")
        self.addTab(self._claims_view, "Claims")
        self.addTab(self.runs, "Runs")
        self.addTab(self.compare, "Side by side")
        self.currentChanged.connect(lambda _: self._fill())
        window.studio.theme.changed.connect(self._show_curves)

    def _curves_page(self) -> QWidget:
        page = QWidget()
        column = QVBoxLayout(page)
        column.setContentsMargins(0, 6, 0, 0)
        line = QHBoxLayout()
        line.addWidget(self.measure)
        line.addStretch(1)
        for button in self.exporting.buttons:
            line.addWidget(button)
        column.addLayout(line)
        column.addWidget(self.curves, 1)
        return page

    def offer_measures(self, study: Study) -> None:
        """Offer the measures of a study's scenario, the first that its figure shows being chosen."""
        measures = list(study.scenario.measures)
        if [self.measure.itemText(k) for k in range(self.measure.count())] != measures:
            self.measure.clear()
            self.measure.addItems(measures)
        panels = [panel.measure for panel in study.declared.panels if panel.measure in measures]
        self.measure.setCurrentText(panels[0] if panels else (measures[0] if measures else ""))

    def show_kept(self, kept: Kept | None, study: Study | None) -> None:
        """Show what was found so far; pages in the back are filled when they are turned to."""
        found = None if kept is None else kept.found
        if found is not None and found is self.found:
            return
        self.found = found
        self._fill()
        self.exporting.refresh(found)
        if study is not None:
            self.runs.show_rows(study, () if kept is None else kept.rows)

    def _fill(self) -> None:
        """Fill the page in front."""
        found, page = self.found, self.currentWidget()
        if page is self._arms_view:
            rows = ([], []) if found is None else (arm_columns(found), arm_rows(found))
            self.arms.show(*rows, 1 if found is None else words_in_arms(found.experiment))
        elif page is self._claims_view:
            rows = ([], []) if found is None else (claim_columns(found), claim_rows(found))
            self.claims.show(*rows, len(rows[0]))
        elif page is self._curves_view:
            self._show_curves()

    def _show_curves(self) -> None:
        self.curves.show_findings(self.found, self.measure.currentText())
