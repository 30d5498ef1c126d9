"""The window of experiments."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QCloseEvent, QKeySequence, QShortcut
from PySide6.QtWidgets import (
    QComboBox,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QProgressBar,
    QPushButton,
    QSpinBox,
    QSplitter,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from ...core.amounts import counted, lasting
from ...core.errors import UnderstudyError
from ...engine.experiments.keeping import delete_experiment
from ...engine.experiments.laboratory import Look, Stage
from ...engine.experiments.load import experiments_in
from ...engine.experiments.plan import SEEDS_A_CELL
from ...engine.experiments.report import arm_columns, arm_rows, claim_columns, claim_rows, words_in_arms
from ...engine.experiments.store import ResultsError
from ..documents.asking import Answer, Question
from ..documents.background import Background
from ..icons import icon
from .builder import ExperimentBuilder
from .comparing import ComparePage
from .curves import CurvesView
from .exporting import Exporting
from .running import Running, cores
from .runs_page import RunsPage
from .study import Kept, Study, kept_of, move_aside, results_folder, study_of
from .tables import TextTable, table_view

if TYPE_CHECKING:
    from ...engine.experiments.findings import Findings
    from ..studio import Studio

UNSAVED = "Experiments are kept in the project's folder: save the project first (Ctrl+S)."
EMPTY = "No experiments yet. “New…” makes one: arms to compare, what is varied, and how often."


class ExperimentsWindow(QWidget):
    """Experiments of the open project: a list, and for the one chosen its curves, tables, claims and runs.

    Attributes:
        running: The experiment that runs in the background.
        study: The one that is shown; None if there is none.
    """

    def __init__(self, studio: Studio, parent: QWidget) -> None:
        super().__init__(parent, Qt.WindowType.Window)
        self.setObjectName("experiments")
        self.studio = studio
        self.background = Background(self)
        self.running = Running()
        self.study: Study | None = None
        self.kept: Kept | None = None
        self._make_parts()
        self._lay_out()
        self._connect()
        self.resize(1100, 720)
        self._opened()

    # ------------------------------------------------------------------------------------------ its parts

    def _make_parts(self) -> None:
        studio = self.studio
        self.list = QListWidget()
        self.list.setAccessibleName("experiments")
        self.new = _button("New…", "Build an experiment", self.build)
        self.edit = _button("Edit…", "Change the experiment", partial(self.build, changed=True))
        self.copy = _button(
            "Duplicate…", "Begin another one with what this one has", partial(self.build, copied=True)
        )
        self.delete = _button(
            "Delete", "Delete the experiment; its results stay in their file", self._ask_delete
        )
        self.title = QLabel()
        self.title.setProperty("role", "title")
        self.title.setWordWrap(True)
        self.note = QLabel()
        self.note.setProperty("role", "caption")
        self.note.setWordWrap(True)
        self.ticks = _number("Ticks a run", 1, 10**9)
        self.runs = _number("Runs an arm", 1, SEEDS_A_CELL)
        self.jobs = _number("Runs at a time", 1, max(1, cores()))
        self.jobs.setValue(cores())
        self.run = _button("Run", "Run what is missing (F5)", self.begin)
        self.pause = _button(
            "Pause", "Let all worlds stand still, or go on (F6)", self.running.pause_or_resume
        )
        self.cancel = _button("Cancel", "Stop; finished runs are kept (F7)", self.running.cancel)
        self.bar = QProgressBar()
        self.bar.setTextVisible(False)
        self.bar.setFixedHeight(6)
        self.told = QLabel()
        self.told.setProperty("role", "caption")
        self.told.setWordWrap(True)
        self.measure = QComboBox()
        self.measure.setAccessibleName("measure")
        self.measure.setToolTip("What the curves show")
        self.curves = CurvesView(studio.theme)
        self.arms, self.claims = TextTable(), TextTable()
        self.runs_page = RunsPage(self)
        self.compare = ComparePage(self)
        self.exporting = Exporting(self)
        for keys, act in (
            ("F5", self.begin),
            ("F6", self.running.pause_or_resume),
            ("F7", self.running.cancel),
        ):
            QShortcut(QKeySequence(keys), self, act)
        QShortcut(QKeySequence("Ctrl+W"), self, self.close)

    def _lay_out(self) -> None:
        left = QWidget()
        column = QVBoxLayout(left)
        column.setContentsMargins(12, 12, 6, 12)
        column.addWidget(self.list, 1)
        for pair in ((self.new, self.edit), (self.copy, self.delete)):
            line = QHBoxLayout()
            for button in pair:
                line.addWidget(button, 1)
            column.addLayout(line)
        splitter = QSplitter()
        splitter.addWidget(left)
        splitter.addWidget(self._right())
        splitter.setStretchFactor(1, 1)
        splitter.setSizes([270, 830])
        splitter.setChildrenCollapsible(False)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.addWidget(splitter)

    def _right(self) -> QWidget:
        right = QWidget()
        column = QVBoxLayout(right)
        column.setContentsMargins(6, 12, 12, 12)
        column.addWidget(self.title)
        column.addWidget(self.note)
        line = QHBoxLayout()
        for caption, field in (("Ticks", self.ticks), ("Runs an arm", self.runs), ("At a time", self.jobs)):
            label = QLabel(caption)
            label.setProperty("role", "caption")
            line.addWidget(label)
            line.addWidget(field)
        line.addStretch(1)
        for button in (self.run, self.pause, self.cancel):
            line.addWidget(button)
        column.addLayout(line)
        column.addWidget(self.bar)
        column.addWidget(self.told)
        column.addWidget(self._tabs(), 1)
        return right

    def _tabs(self) -> QTabWidget:
        self.tabs = QTabWidget()
        self.tabs.setDocumentMode(True)
        curves = QWidget()
        column = QVBoxLayout(curves)
        column.setContentsMargins(0, 6, 0, 0)
        line = QHBoxLayout()
        line.addWidget(self.measure)
        line.addStretch(1)
        for button in self.exporting.buttons:
            line.addWidget(button)
        column.addLayout(line)
        column.addWidget(self.curves, 1)
        self.tabs.addTab(curves, "Curves")
        self.tabs.addTab(table_view(self.arms, "arms"), "Arms")
        self.tabs.addTab(table_view(self.claims, "claims"), "Claims")
        self.tabs.addTab(self.runs_page, "Runs")
        self.tabs.addTab(self.compare, "Side by side")
        return self.tabs

    def _connect(self) -> None:
        self.list.currentItemChanged.connect(lambda *_: self._chosen())
        self.list.itemActivated.connect(lambda _: self.build(changed=True))
        self.measure.activated.connect(lambda _: self._show_curves())
        self.running.changed.connect(self._progressed)
        self.ticks.valueChanged.connect(lambda _: self._asked_otherwise())
        self.runs.valueChanged.connect(lambda _: self._asked_otherwise())
        self.studio.opened.connect(self._opened)
        self.studio.document.history_changed.connect(self._folder_may_have_changed)
        self.studio.closing.connect(self.shut_down)
        self.studio.theme.changed.connect(self._dress)
        self._later = QTimer(self, interval=250, singleShot=True)
        self._later.timeout.connect(self._read)
        self._dress()

    def _dress(self) -> None:
        theme = self.studio.theme
        for button, name in (
            (self.new, "plus"),
            (self.run, "play"),
            (self.pause, "pause"),
            (self.cancel, "close"),
        ):
            button.setIcon(icon(name, theme))
        self._show_curves()

    # -------------------------------------------------------------------------------------------- the list

    @property
    def folder(self) -> Path | None:
        """The project's folder."""
        return self.studio.document.folder

    def _opened(self) -> None:
        self.running.close()
        self.study = self.kept = None
        self.setWindowTitle(f"Experiments – {self.studio.document.project.name}")
        self._known_folder = self.folder
        self.refresh()

    def _folder_may_have_changed(self) -> None:
        if self.folder != self._known_folder:
            self._known_folder = self.folder
            self.refresh()

    def refresh(self, chosen: str = "") -> None:
        """List the experiments that there are; *chosen*, or else the one that was chosen, is shown."""
        wanted = chosen or (self.study.declared.name if self.study else "")
        names = experiments_in(self.folder) if self.folder is not None else []
        self.list.blockSignals(True)
        self.list.clear()
        for name in names:
            self.list.addItem(QListWidgetItem(name))
        self.list.setCurrentRow(names.index(wanted) if wanted in names else (0 if names else -1))
        self.list.blockSignals(False)
        self.compare.offer(names)
        self._chosen()

    def choose(self, name: str) -> None:
        """Show the experiment *name*."""
        found = self.list.findItems(name, Qt.MatchFlag.MatchExactly)
        if found:
            self.list.setCurrentItem(found[0])

    def load(self, name: str) -> Study | None:
        """The experiment *name* of the open project; None, and a message, if it cannot be read."""
        if self.folder is None:
            return None
        document = self.studio.document
        results = results_folder(self.folder, self.studio.settings.state)
        try:
            return study_of(document.project, document.scenario, self.folder, name, results)
        except UnderstudyError as error:
            self._tell(str(error))
            return None

    def _chosen(self) -> None:
        item = self.list.currentItem()
        self.kept = None
        self._tell("")
        self.study = self.load(item.text()) if self.list.count() else None
        self._show_study()
        if self.study is not None:
            self._read()

    def _show_study(self) -> None:
        study = self.study
        empty = UNSAVED if self.folder is None else EMPTY
        if study is None:
            self.title.setText("" if self.list.count() else empty)
            self.note.setText("")
        else:
            self.title.setText(study.declared.title)
            self.note.setText(study.declared.note)
            for field, value in ((self.ticks, study.experiment.ticks), (self.runs, study.experiment.runs)):
                field.blockSignals(True)
                field.setValue(value)
                field.blockSignals(False)
            measures = list(study.scenario.measures)
            if [self.measure.itemText(k) for k in range(self.measure.count())] != measures:
                self.measure.clear()
                self.measure.addItems(measures)
            panels = [panel.measure for panel in study.declared.panels if panel.measure in measures]
            self.measure.setCurrentText(panels[0] if panels else (measures[0] if measures else ""))
        self._show_found(None)
        self._refresh_buttons()

    # ------------------------------------------------------------------------------------ building, deleting

    def build(self, *_: object, changed: bool = False, copied: bool = False) -> None:
        """Ask for an experiment: a new one, this one changed, or a copy of it."""
        if self.folder is None:
            self._tell(UNSAVED)
            return
        base = self.study.declared if self.study is not None and (changed or copied) else None
        if (changed or copied) and base is None:
            return
        builder = ExperimentBuilder(self.studio, self.folder, base, self, copied=copied)
        builder.kept.connect(self.refresh)
        builder.open()

    def _ask_delete(self) -> None:
        study, folder = self.study, self.folder
        if study is None or folder is None:
            return
        name = study.declared.name

        def delete() -> None:
            try:
                delete_experiment(folder, name)
            except UnderstudyError as error:
                self._tell(str(error))
            self.study = None
            self.refresh()

        Question(
            self,
            self.studio.theme,
            "Delete the experiment?",
            f"The file of {name!r} is deleted. What was found stays in {study.path.name}.",
            (Answer("Delete", delete), Answer("Keep it")),
        ).ask()

    # ------------------------------------------------------------------------------------------ running it

    def _asked_otherwise(self) -> None:
        if self.study is not None:
            self.study = self.study.asked_for(self.runs.value(), self.ticks.value())
            self._later.start()

    def begin(self) -> None:
        """Run what is missing of the experiment that is shown."""
        if self.study is None or self.running.is_on:
            return
        document = self.studio.document
        self.study = replace(self.study, project=document.project, scenario=document.scenario)
        self.running.begin(self.study, self.jobs.value())

    def _progressed(self) -> None:
        look, study = self.running.look, self.running.study
        self._refresh_buttons()
        if look is None or study is None:
            return
        if self.study is not None and study.declared.name == self.study.declared.name:
            self._show_look(look, study)
            if look.is_over:
                self._read()
        if look.is_over:
            self._end(look, study)

    def _show_look(self, look: Look, study: Study) -> None:
        self._tell(words_of(look, study))
        if look.progress is not None:
            self.bar.setValue(round(1000 * look.progress.share))
        if look.found is not None:
            self._show_found(look.found)

    def _end(self, look: Look, study: Study) -> None:
        if look.stage is Stage.FAILED and "another experiment" in look.notice:
            self._ask_aside(look, study)
        elif look.stage is Stage.FINISHED and not self.isActiveWindow():
            self.studio.say(
                f"the experiment {study.declared.name!r} has finished: {counted(study.total, 'run')}"
            )

    def _ask_aside(self, look: Look, study: Study) -> None:
        """Results of the project as it was stand in the way."""

        def anew() -> None:
            try:
                move_aside(study)
            except OSError as error:
                self._tell(f"{study.path}: cannot be renamed: {error.strerror}")
                return
            self.begin()

        Question(
            self,
            self.studio.theme,
            "The project has changed since",
            "There are results of this experiment already, but of the project as it was. They can be put aside under "
            "another name, and the experiment begins anew.",
            (Answer("Put aside and begin anew", anew), Answer("Leave all as it is")),
            details=look.notice,
        ).ask()

    def _refresh_buttons(self) -> None:
        shown, on = self.study is not None, self.running.is_on
        look = self.running.look
        paused = look is not None and look.stage is Stage.PAUSED
        self.run.setEnabled(shown and not on)
        self.pause.setEnabled(on)
        self.pause.setText("Resume" if paused else "Pause")
        self.cancel.setEnabled(on)
        for button in (self.edit, self.copy, self.delete):
            button.setEnabled(shown and not on)
        self.new.setEnabled(self.folder is not None)
        self.bar.setRange(0, 1000)
        self.bar.setVisible(on)
        for field in (self.ticks, self.runs, self.jobs):
            field.setEnabled(shown and not on)
        self.exporting.refresh()

    # ---------------------------------------------------------------------------------------- what was found

    def _read(self) -> None:
        """Read what is there of the experiment that is shown."""
        study = self.study
        if study is None or self.running.is_on:
            return

        def read(kept: Kept | None) -> None:
            if self.study is study:
                self.kept = kept
                self._show_found(None if kept is None else kept.found)
                self.runs_page.show_rows(study, () if kept is None else kept.rows)
                if not self.running.is_on and (self.running.look is None or self.running.study is not study):
                    self._tell(standing(kept, study))

        def failed(error: UnderstudyError) -> None:
            if self.study is study:
                of_before = isinstance(error, ResultsError) and "another experiment" in str(error)
                self._tell(
                    "There are results of the project as it was; running begins anew."
                    if of_before
                    else str(error)
                )
                self.runs_page.show_rows(study, ())

        self.background.do(lambda: kept_of(study), read, failed)

    def _show_found(self, found: Findings | None) -> None:
        self.found = found
        if found is None:
            self.arms.show([], [])
            self.claims.show([], [])
        else:
            self.arms.show(arm_columns(found), arm_rows(found), words_in_arms(found.experiment))
            self.claims.show(claim_columns(found), claim_rows(found), len(claim_columns(found)))
        self._show_curves()
        self.exporting.refresh()

    def _show_curves(self) -> None:
        self.curves.show_findings(getattr(self, "found", None), self.measure.currentText())

    def _tell(self, words: str) -> None:
        self.told.setText(words[:1].upper() + words[1:])

    # -------------------------------------------------------------------------------------------- closing

    def closeEvent(self, event: QCloseEvent) -> None:
        """Hide; what runs goes on, and says so when it is done."""
        event.accept()

    def shut_down(self) -> None:
        """End all threads."""
        self._later.stop()
        self.running.close()
        self.background.close()


def words_of(look: Look, study: Study) -> str:
    """How far an experiment is, in a sentence."""
    if look.stage is Stage.FAILED:
        return look.notice
    if look.notice:
        return look.notice
    progress = look.progress
    done = 0 if progress is None else progress.done
    runs = f"{done:,} of {counted(study.total, 'run')}"
    match look.stage:
        case Stage.PAUSED:
            return f"paused at {runs}"
        case Stage.CANCELLED:
            return f"cancelled; {runs} are kept, and Run goes on with the others"
        case Stage.FINISHED:
            return f"finished: {counted(study.total, 'run')}"
    left = None if progress is None else progress.seconds_left
    return runs if left is None else f"{runs}, {lasting(left)} left"


def standing(kept: Kept | None, study: Study) -> str:
    """What there is of an experiment that does not run."""
    if kept is None or not kept.rows:
        return f"not run yet: {counted(study.total, 'run')} of {counted(study.experiment.ticks, 'tick')}"
    if len(kept.rows) == study.total:
        return f"finished: {counted(study.total, 'run')}"
    return f"{len(kept.rows):,} of {counted(study.total, 'run')} are there; Run makes the others"


def _button(text: str, tip: str, act: Callable[[], object]) -> QPushButton:
    button = QPushButton(text)
    button.setToolTip(tip)
    button.clicked.connect(lambda _checked: act())
    return button


def _number(tip: str, low: int, high: int) -> QSpinBox:
    box = QSpinBox()
    box.setRange(low, min(high, 2**31 - 1))
    box.setToolTip(tip)
    box.setAccessibleName(tip)
    box.setGroupSeparatorShown(True)
    box.setKeyboardTracking(False)
    return box
