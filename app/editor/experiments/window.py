"""The window of experiments."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QCloseEvent, QKeySequence, QShortcut
from PySide6.QtWidgets import QLabel, QSplitter, QVBoxLayout, QWidget

from ...core.amounts import counted
from ...core.errors import UnderstudyError
from ...engine.experiments.laboratory import Look, Stage
from ...engine.experiments.load import experiments_in
from ...engine.experiments.store import ResultsError
from ..documents.asking import Answer, Question
from ..documents.background import Background
from ..forms.parts import caption
from ..room import resize_within
from ..soon import Soon
from .controls import Controls
from .listing import EMPTY, UNSAVED, ExperimentList
from .pages import Pages
from .running import Running
from .standing import standing
from .study import Kept, Study, kept_of, move_aside, results_folder, study_of

if TYPE_CHECKING:
    from ..studio import Studio


class ExperimentsWindow(QWidget):
    """Experiments of the open project: a list, and for the one chosen its controls, curves, tables, claims and runs.

    Attributes:
        running: The experiment that runs in the background.
        study: The one that is shown; None if there is none.
        kept: What its results hold; None until they were read.
    """

    def __init__(self, studio: Studio, parent: QWidget) -> None:
        super().__init__(parent, Qt.WindowType.Window)
        self.setObjectName("experiments")
        self.studio = studio
        self.background = Background(self)
        self.running = Running()
        self.study: Study | None = None
        self.kept: Kept | None = None
        self.title = QLabel()
        self.title.setProperty("role", "title")
        self.title.setWordWrap(True)
        self.note = caption("")
        self.listing = ExperimentList(self)
        self.controls = Controls(self.running, studio.theme)
        self.pages = Pages(self)
        self._list = Soon(self, self.refresh)  # the window is there before the first experiment has been read
        self._lay_out()
        self._connect()
        resize_within(self, 1100, 720)
        self._opened()

    def _lay_out(self) -> None:
        right = QWidget()
        column = QVBoxLayout(right)
        column.setContentsMargins(6, 12, 12, 12)
        for part in (self.title, self.note, self.controls):
            column.addWidget(part)
        column.addWidget(self.pages, 1)
        splitter = QSplitter()
        splitter.addWidget(self.listing)
        splitter.addWidget(right)
        splitter.setStretchFactor(1, 1)
        splitter.setSizes([270, 830])
        splitter.setChildrenCollapsible(False)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.addWidget(splitter)

    def _connect(self) -> None:
        self.listing.chosen.connect(self._chosen)
        self.controls.begun.connect(self.begin)
        self.controls.asked_otherwise.connect(self._asked_otherwise)
        self.running.changed.connect(self._progressed)
        self.studio.opened.connect(self._opened)
        self.studio.document.history_changed.connect(self._folder_may_have_changed)
        self.studio.closing.connect(self.shut_down)
        self._later = QTimer(self, interval=250, singleShot=True)
        self._later.timeout.connect(self._read)
        for keys, act in (
            ("F5", self.begin),
            ("F6", self.running.pause_or_resume),
            ("F7", self.running.cancel),
            ("Ctrl+W", self.close),
            ("Esc", self.close),
            ("Ctrl+Q", self.studio.actions["file.quit"].trigger),
        ):
            QShortcut(QKeySequence(keys), self, act)

    # ------------------------------------------------------------------------------------- what is chosen

    @property
    def folder(self) -> Path | None:
        """The project's folder."""
        return self.studio.document.folder

    @property
    def results(self) -> Path | None:
        """Where its experiments' results are."""
        return None if self.folder is None else results_folder(self.folder, self.studio.settings.state)

    def _opened(self) -> None:
        self.running.close()
        self.study = self.kept = None
        self.setWindowTitle(f"Experiments – {self.studio.document.project.name}")
        self._known_folder = self.folder
        self._refresh_buttons()
        self._list.ask()

    def _folder_may_have_changed(self) -> None:
        if self.folder != self._known_folder:
            self._known_folder = self.folder
            self.refresh()

    def refresh(self, chosen: str = "") -> None:
        """List the experiments that there are; *chosen*, or else the one that was chosen, is shown."""
        wanted = chosen or (self.study.declared.name if self.study else "")
        names = experiments_in(self.folder) if self.folder is not None else []
        self.pages.compare.offer(names)
        self.listing.show_names(names, wanted)

    def load(self, name: str) -> Study | None:
        """The experiment *name* of the open project; None, and a message, if it cannot be read."""
        results = self.results
        if self.folder is None or results is None:
            return None
        document = self.studio.document
        try:
            return study_of(document.project, document.scenario, self.folder, name, results)
        except UnderstudyError as error:
            self.controls.tell(str(error))
            return None

    def _chosen(self) -> None:
        name = self.listing.current
        self.kept = None
        self.controls.tell("")
        self.study = self._study_called(name)
        self._show_study()
        if self.study is not None:
            self._read()

    def _study_called(self, name: str) -> Study | None:
        """The experiment *name*; one that runs as it was begun."""
        under_way = self.running.study if self.running.is_on else None
        if under_way is not None and under_way.declared.name == name:
            return under_way
        return self.load(name) if name else None

    def _show_study(self) -> None:
        study = self.study
        if study is None:
            empty = UNSAVED if self.folder is None else EMPTY
            name = self.listing.current
            self.title.setText(f"{name} cannot be read: mend its file, or delete it" if name else empty)
            self._show_note("")
        else:
            self.title.setText(study.declared.title)
            self._show_note(study.declared.note)
            self.controls.show_study(study)
            self.pages.offer_measures(study)
        self.pages.show_kept(None, study)
        self._refresh_buttons()

    def _show_note(self, words: str) -> None:
        self.note.setText(words)
        self.note.setVisible(bool(words))

    def _refresh_buttons(self) -> None:
        free = self.study is not None and not self.running.is_on
        self.controls.allow(running=free)
        self.listing.allow(changes=free, deletes=bool(self.listing.current) and not self.running.is_on)

    # ------------------------------------------------------------------------------------------ running it

    def _asked_otherwise(self, runs: int, ticks: int) -> None:
        if self.study is not None:
            self.study = self.study.asked_for(runs, ticks)
            self._later.start()

    def begin(self) -> None:
        """Run what is missing of the experiment that is shown."""
        if self.study is None or self.running.is_on:
            return
        document = self.studio.document
        self.study = replace(self.study, project=document.project, scenario=document.scenario)
        self.running.begin(self.study, self.controls.jobs.value())

    def _progressed(self) -> None:
        look, study = self.running.look, self.running.study
        self._refresh_buttons()
        if look is None or study is None:
            return
        if self.study is not None and study.declared.name == self.study.declared.name:
            self.controls.show_look(look, study)
            if look.is_over:
                self._read()
            elif look.progress is not None:  # until it has begun, what was there is shown
                self._show_kept(Kept(look.found, self.running.rows), study)
        elif look.is_over:
            self._read()
        else:
            self.controls.show_other(look, study)
        if look.is_over:
            self._end(look, study)

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
                self.controls.tell(f"{study.path}: cannot be renamed: {error.strerror}")
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

    # ------------------------------------------------------------------------------------ reading results

    def _read(self) -> None:
        """Read what is there of the experiment that is shown."""
        study = self.study
        if study is None:
            return

        def read(kept: Kept | None) -> None:
            if self.study is study and not self._asks_for_all(kept, study):
                self._show_kept(kept, study)

        def failed(error: UnderstudyError) -> None:
            if self.study is study:
                self.controls.tell(_why_unread(error))
                self.pages.runs.show_rows(study, ())

        self.look_up(study, read, failed)

    def _asks_for_all(self, kept: Kept | None, study: Study) -> bool:
        """Where more runs were asked for than the experiment's file says, ask for as many again."""
        whole = study.asking_for_all(kept) if study.experiment is study.declared else None
        if whole is None:
            return False
        self.study = whole
        self.controls.show_study(whole)
        self._read()
        return True

    def look_up(
        self,
        study: Study,
        found: Callable[[Kept | None], object],
        failed: Callable[[UnderstudyError], object],
    ) -> None:
        """Find what there is of a study: in its file, or, while that is written to, at whoever writes."""
        look = self.running.look
        if self.running.holds(study) and look is not None:
            found(Kept(look.found, self.running.rows))
        else:
            self.background.do(lambda: kept_of(study), found, failed)

    def _show_kept(self, kept: Kept | None, study: Study) -> None:
        self.kept = kept
        self.pages.show_kept(kept, study)
        if not self.running.is_on and (self.running.look is None or self.running.study is not study):
            self.controls.tell(standing(kept, study))

    # -------------------------------------------------------------------------------------------- closing

    def closeEvent(self, event: QCloseEvent) -> None:
        """Hide; what runs goes on, and says so, and when it is done."""
        study = self.running.study
        if self.running.is_on and study is not None:
            self.studio.say(
                f"the experiment {study.declared.name!r} goes on in the background; Experiment, Experiments… shows it"
            )
        event.accept()

    def shut_down(self) -> None:
        """End all threads."""
        self._later.stop()
        self.running.close()
        self.background.close()


def _why_unread(error: UnderstudyError) -> str:
    if isinstance(error, ResultsError) and "another experiment" in str(error):
        return "There are results of the project as it was; running begins anew."
    return str(error)
