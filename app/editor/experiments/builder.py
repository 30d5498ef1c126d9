"""The dialog that builds an experiment: arms, what is varied, how often, and what is claimed."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QHBoxLayout,
    QHeaderView,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QPlainTextEdit,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from ...core.errors import ParameterError, UnderstudyError
from ...core.naming import slug
from ...engine.experiments.keeping import save_experiment
from ...engine.experiments.load import experiments_in
from ...engine.experiments.plan import Design, Experiment, Kind, Treated
from ..forms.choosing import Choice, Chooser
from ..forms.parts import Complaint, caption, framed
from ..forms.word_list import WordList
from ..room import resize_within
from .draft import SAYS, Draft, drafted, shown_claim, shown_factor

if TYPE_CHECKING:
    from ..studio import Studio

USUAL_TICKS, USUAL_RUNS = 20_000, 20
#: What the parts of a claim are called, above their columns.
CLAIM = ("Arm", "says", "Arm", "in")


class ExperimentBuilder(QDialog):
    """Asks for an experiment, and keeps it in the project's folder.

    Signals:
        kept: It was written, under this name.
    """

    kept = Signal(str)

    def __init__(
        self,
        studio: Studio,
        folder: Path,
        base: Experiment | None,
        parent: QWidget,
        *,
        copied: bool = False,
    ) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setObjectName("experiment-builder")
        self._studio = studio
        self._folder = folder
        self._base = base
        self._old_name = base.name if base is not None and not copied else ""
        self.setWindowTitle("Edit the experiment" if self._old_name else "New experiment")
        self._make_fields(base, copied=copied)
        self.trouble = Complaint(studio.theme)
        self.buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        self.buttons.button(QDialogButtonBox.StandardButton.Ok).setText("Keep it")
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        tabs = QTabWidget()
        tabs.setDocumentMode(True)
        for title, page in (
            ("General", self._general()),
            ("Arms", self._arms_page()),
            ("Varied", self._factors_page()),
            ("Claims", self._claims_page()),
        ):
            tabs.addTab(page, title)
        self.tabs = tabs
        column = QVBoxLayout(self)
        column.addWidget(tabs, 1)
        column.addWidget(self.trouble)
        column.addWidget(self.buttons)
        resize_within(self, 760, 520)
        self._watch()
        self.title.setFocus()

    def _watch(self) -> None:
        """What was refused is not what stands here any more once something has changed."""
        for field in (self.title, self.name, self.ticks, self.runs, self.seed):
            field.textEdited.connect(self._touched)
        for listed in (self.measures, self.arms, self.factors):
            listed.itemChanged.connect(self._touched)

    def _touched(self, _what: object = None) -> None:
        self.trouble.say("")

    # --------------------------------------------------------------------------------------------- fields

    def _make_fields(self, base: Experiment | None, *, copied: bool) -> None:
        title = "" if base is None else f"{base.title} (copy)" if copied else base.title
        self.title = QLineEdit(title)
        self.title.setCursorPosition(0)
        self.title.setPlaceholderText("What it compares, in a line")
        self.name = QLineEdit(self._old_name)
        self.name.setPlaceholderText("made from the title")
        self.name.setToolTip("The name of its file in experiments/, and on the command line")
        self.note = QPlainTextEdit("" if base is None else base.note)
        self.note.setMaximumHeight(90)
        framed(self.note, self._studio.theme)
        self.ticks = QLineEdit(f"{USUAL_TICKS if base is None else base.ticks:,}")
        self.runs = QLineEdit(f"{USUAL_RUNS if base is None else base.runs:,}")
        self.seed = QLineEdit(str(1 if base is None else base.seed))
        self.measures = QListWidget()
        self.measures.setMaximumHeight(76)
        framed(self.measures, self._studio.theme)
        shown = [panel.measure for panel in base.panels] if base is not None else []
        for measure in self._studio.document.scenario.measures:
            _add_ticked(self.measures, measure, ticked=measure in shown or not shown)
        self.design = WordList()
        self.design.setAccessibleName("Which values are combined")
        self.design.setToolTip(
            "Run every combination of the values, or vary one setting while the others stay"
        )
        self.design.addItem("All combinations", Design.FACTORIAL)
        self.design.addItem("One thing at a time; the first value is the usual one", Design.ONE_AT_A_TIME)
        if base is not None:
            self.design.setCurrentIndex(self.design.findData(base.design))

    def _general(self) -> QWidget:
        page = QWidget()
        form = QFormLayout(page)
        for label, field in (
            ("Title", self.title),
            ("Name", self.name),
            ("Note", self.note),
            ("Ticks a run", self.ticks),
            ("Runs an arm", self.runs),
            ("First seed", self.seed),
            ("Curves of", self.measures),
        ):
            field.setAccessibleName(label)
            form.addRow(label, field)
        return page

    def _arms_page(self) -> QWidget:
        page = QWidget()
        column = QVBoxLayout(page)
        column.addWidget(
            caption("Tick the arms that take part. What an arm of this experiment sets is kept.")
        )
        self.arms = QListWidget()
        self.arms.setAccessibleName("arms")
        framed(self.arms, self._studio.theme)
        taking_part = self._base.arms if self._base is not None else ()
        for treated in taking_part:
            _add_ticked(self.arms, treated.name, ticked=True, value=treated)
        for arm in self._studio.document.project.arms:
            if all(treated.arm != arm.name or treated.settings for treated in taking_part):
                _add_ticked(self.arms, arm.name, ticked=self._base is None, value=Treated(arm.name, arm.name))
        column.addWidget(self.arms, 1)
        return page

    def _factors_page(self) -> QWidget:
        page = QWidget()
        column = QVBoxLayout(page)
        column.addWidget(
            caption(
                "Each row varies a setting in all arms: a parameter of the world, the sizes of the levels (such as "
                "2 x 5 x 5), the physics, the learner. Values have commas between them."
            )
        )
        self.factors = _table(["Setting", "Values"])
        for factor in self._base.factors if self._base is not None else ():
            self.add_factor(*shown_factor(factor))
        column.addWidget(self.factors, 1)
        column.addLayout(_below(self.factors, lambda: self.add_factor("", "")))
        column.addWidget(self.design)
        return page

    def settings(self) -> list[str]:
        """What can be varied."""
        world = [f"world.{name}" for name in self._studio.document.scenario.parameter_fields()]
        return [*world, "sizes", "physics", "top", "world", "learner.classifier", "learner.picks"]

    def add_factor(self, setting: str, values: str) -> None:
        """One more row of what is varied."""
        row = self.factors.rowCount()
        self.factors.insertRow(row)
        box = Chooser("setting", "what is varied")
        box.offer(Choice(name, name) for name in self.settings())
        box.setEditText(setting)  # which may be one that only files name
        box.editTextChanged.connect(self._touched)
        values_item = QTableWidgetItem(values)
        values_item.setToolTip("All values that it is to have, with commas between them: 5, 10, 20")
        self.factors.setCellWidget(row, 0, box)
        self.factors.setItem(row, 1, values_item)
        box.setFocus()

    def _claims_page(self) -> QWidget:
        page = QWidget()
        column = QVBoxLayout(page)
        column.addWidget(
            caption("Each claim is tested (two-tailed Welch t-tests, Bonferroni) and gets a verdict.")
        )
        self.claims = _table(CLAIM)
        for at, width in ((1, 152), (3, 108)):  # the names of arms are what may be long
            self.claims.horizontalHeader().setSectionResizeMode(at, QHeaderView.ResizeMode.Fixed)
            self.claims.setColumnWidth(at, width)
        for claim in self._base.claims if self._base is not None else ():
            if (row := shown_claim(claim)) is not None:
                self.add_claim(*row)
        column.addWidget(self.claims, 1)
        column.addLayout(_below(self.claims, self._add_usual_claim))
        return page

    def _add_usual_claim(self) -> None:
        """A claim about the first two arms that take part."""
        first, second = (*(_text(item) for item in _ticked(self.arms)), "", "")[:2]
        self.add_claim(first, Kind.GREATER, second, "")

    def add_claim(self, first: str, kind: Kind, second: str, measure: str) -> None:
        """One more row of claims."""
        row = self.claims.rowCount()
        self.claims.insertRow(row)
        arms = [_text(item) for item in _items(self.arms)]
        measures = list(self._studio.document.scenario.measures)
        for place, names, chosen in ((0, arms, first), (2, ["", *arms], second), (3, measures, measure)):
            box = WordList()
            box.setAccessibleName(CLAIM[place])
            box.addItems(list(dict.fromkeys(names)))
            box.setCurrentText(chosen or (names[0] if names else ""))
            box.activated.connect(self._touched)
            self.claims.setCellWidget(row, place, box)
        says = WordList()
        says.setAccessibleName(CLAIM[1])
        for one, words in SAYS.items():
            says.addItem(words, one)
        says.setCurrentIndex(says.findData(kind))
        self.claims.setCellWidget(row, 1, says)
        other = self.claims.cellWidget(row, 2)

        def compare() -> None:
            other.setEnabled(_said(says) is not Kind.NEVER_STALLS)

        says.currentIndexChanged.connect(compare)
        compare()

    # -------------------------------------------------------------------------------------------- keeping

    def draft(self) -> Draft:
        """What the fields hold."""
        title = self.title.text()
        return Draft(
            self.name.text().strip() or slug(title, "experiment"),
            title,
            self.note.toPlainText(),
            self.ticks.text(),
            self.runs.text(),
            self.seed.text(),
            tuple(item.data(Qt.ItemDataRole.UserRole) for item in _ticked(self.arms)),
            tuple(self._factor_row(row) for row in range(self.factors.rowCount())),
            Design(self.design.currentData()),
            tuple(self._claim_row(row) for row in range(self.claims.rowCount())),
            tuple(_text(item) for item in _ticked(self.measures)),
        )

    def _factor_row(self, row: int) -> tuple[str, str]:
        box, item = self.factors.cellWidget(row, 0), self.factors.item(row, 1)
        assert isinstance(box, QComboBox)
        return self._setting(box.currentText().strip()), "" if item is None else item.text()

    def _setting(self, typed: str) -> str:
        """A setting by what the user calls it: a parameter of the world needs no more than its name."""
        world = f"world.{typed}"
        return world if typed not in self.settings() and world in self.settings() else typed

    def _claim_row(self, row: int) -> tuple[str, Kind, str, str]:
        boxes = [self.claims.cellWidget(row, column) for column in range(4)]
        first, says, second, measure = (box for box in boxes if isinstance(box, QComboBox))
        kind = _said(says)
        other = "" if kind is Kind.NEVER_STALLS else second.currentText()
        return first.currentText(), kind, other, measure.currentText()

    def accept(self) -> None:
        """Keep it, unless something in it is not possible."""
        document = self._studio.document
        try:
            experiment = drafted(self.draft(), self._base, document.project, document.scenario)
            taken = experiment.name in experiments_in(self._folder)
            if taken and experiment.name != self._old_name:
                raise ParameterError(f"there is an experiment {experiment.name!r} already; give another name")
            save_experiment(self._folder, experiment)
        except UnderstudyError as error:
            self.trouble.say(str(error))
            return
        self.kept.emit(experiment.name)
        super().accept()


def _table(head: Sequence[str]) -> QTableWidget:
    table = QTableWidget(0, len(head))
    table.setHorizontalHeaderLabels(list(head))
    table.verticalHeader().hide()
    table.setTabKeyNavigation(False)
    table.horizontalHeader().setHighlightSections(False)
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
    table.horizontalHeader().setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
    table.verticalHeader().setDefaultSectionSize(32)
    return table


def _below(table: QTableWidget, add: object) -> QHBoxLayout:
    """Buttons that add and remove rows."""
    more, less = QPushButton("Add a row"), QPushButton("Remove the row")
    less.setToolTip("Remove the row that is selected, or else the last one")
    less.setEnabled(table.rowCount() > 0)
    for changed in (table.model().rowsInserted, table.model().rowsRemoved):
        changed.connect(lambda: less.setEnabled(table.rowCount() > 0))
    more.clicked.connect(add)
    less.clicked.connect(
        lambda: table.removeRow(table.currentRow() if table.currentRow() >= 0 else table.rowCount() - 1)
    )
    line = QHBoxLayout()
    line.addWidget(more)
    line.addWidget(less)
    line.addStretch(1)
    return line


def _add_ticked(where: QListWidget, text: str, *, ticked: bool, value: object = None) -> None:
    item = QListWidgetItem(text)
    item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
    item.setCheckState(Qt.CheckState.Checked if ticked else Qt.CheckState.Unchecked)
    item.setData(Qt.ItemDataRole.UserRole, value)
    where.addItem(item)


def _items(where: QListWidget) -> list[QListWidgetItem]:
    return [where.item(row) for row in range(where.count())]


def _said(says: QComboBox) -> Kind:
    """What a claim says: Qt gives back plain text."""
    return Kind(says.currentData())


def _ticked(where: QListWidget) -> list[QListWidgetItem]:
    return [item for item in _items(where) if item.checkState() is Qt.CheckState.Checked]


def _text(item: QListWidgetItem) -> str:
    return item.text()
