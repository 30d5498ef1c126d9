"""The experiment that runs in the background, looked at by a timer."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QObject, QTimer, Signal

from ...engine.experiments.laboratory import Look, Stage
from ...engine.experiments.process import LaboratoryProcess
from ...engine.experiments.store import Row
from .standing import words_of
from .study import Study

#: Milliseconds between two looks.
GLANCE = 200


class Running(QObject):
    """At most one experiment at a time.

    Attributes:
        study: What runs, or ran last.

    Signals:
        changed: It is further than before, or over.
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.study: Study | None = None
        self._laboratory: LaboratoryProcess | None = None
        self._look: Look | None = None
        self._timer = QTimer(self, interval=GLANCE)
        self._timer.timeout.connect(self._glance)

    @property
    def look(self) -> Look | None:
        """How it stands; None before anything was run."""
        return self._look

    @property
    def is_on(self) -> bool:
        """Whether an experiment is under way, paused ones included."""
        return self._laboratory is not None and not self._laboratory.newest.is_over

    @property
    def what_ends(self) -> str:
        """What ends if the project is left, in words; nothing if no experiment is under way."""
        if not self.is_on or self.study is None or self._look is None:
            return ""
        return (
            f"The experiment {self.study.declared.name!r} is under way ({words_of(self._look, self.study)}), and stops "
            "when the project is closed. Finished runs are kept; Run goes on with the others."
        )

    @property
    def rows(self) -> Sequence[Row]:
        """The runs that are kept so far."""
        return () if self._laboratory is None else self._laboratory.rows

    def holds(self, study: Study) -> bool:
        """Whether the results of *study* are being written to."""
        return self.is_on and self.study is not None and self.study.path == study.path

    def begin(self, study: Study, jobs: int) -> None:
        """Begin, or go on where the results end."""
        self.close()
        self.study = study
        self._laboratory = LaboratoryProcess(
            study.project, study.scenario, study.experiment, study.path, jobs
        )
        self._look = self._laboratory.newest
        self._timer.start()
        self.changed.emit()

    def pause_or_resume(self) -> None:
        """Let all worlds stand still, or go on."""
        if self._laboratory is not None:
            paused = self._laboratory.newest.stage is Stage.PAUSED
            (self._laboratory.resume if paused else self._laboratory.pause)()
            self._glance()

    def cancel(self) -> None:
        """Stop; what is finished is kept."""
        if self._laboratory is not None:
            self._laboratory.cancel()

    def close(self) -> None:
        """Stop at once; what is finished is kept."""
        self._timer.stop()
        if self._laboratory is not None:
            self._laboratory.close()
            self._laboratory = None

    def _glance(self) -> None:
        if self._laboratory is None:
            return
        look = self._laboratory.newest
        if look is not self._look:
            self._look = look
            self.changed.emit()
        if look.is_over:
            self._timer.stop()
