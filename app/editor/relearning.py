"""Learning in the background from what the user has changed, as part of the step that changed it."""

from collections.abc import Mapping
from time import monotonic

from PySide6.QtCore import QObject, QTimer, Signal

from ..core.edits import set_values
from ..core.project import Project
from ..engine.relearning import RelearnAnswer, Relearner
from ..learner.trainer import apply
from .document import Document
from .settings import Settings

#: Milliseconds without another change before learning begins: a drag is learned from once.
PATIENCE = 120
UP_TO_DATE = "no behavior has changed since it was learned"


class Relearning(QObject):
    """Keeps the learned automata of the document up to date.

    Attributes:
        busy: Whether something is being learned.
        learned_at: When something was learned last, by the monotonic clock; 0.0 before the project's first.

    Signals:
        changed: Learning began or ended.
        told: What could not be learned, and why, or that there is nothing to learn.
    """

    changed = Signal()
    told = Signal(str)
    _ready = Signal()

    def __init__(self, document: Document, settings: Settings) -> None:
        super().__init__()
        self._document = document
        self._settings = settings
        self._relearner = Relearner(self._ready.emit, document.freshness)
        self.busy = False
        self.learned_at = 0.0
        self._problems: tuple[str, ...] = ()
        self._is_asked = False
        self._soon = QTimer(self, interval=PATIENCE, singleShot=True)
        self._soon.timeout.connect(self.learn)
        self._ready.connect(self._take)
        document.project_changed.connect(self._project_changed)
        document.opened.connect(self._opened)

    def ask(self) -> None:
        """Learn now what is stale, as the user has asked for: where nothing is, that is told."""
        self._is_asked = True
        self.learn()

    def learn(self) -> None:
        """Learn now what is stale."""
        document = self._document
        self._relearner.ask(document.revision, document.project, document.scenario)
        self._set_busy(busy=True)

    def close(self) -> None:
        """Give up what is open and end the thread."""
        self._soon.stop()
        self._relearner.close()

    def _opened(self) -> None:
        self._soon.stop()
        self._relearner.give_up()
        self._is_asked = False
        self._set_busy(busy=False)
        self.learned_at = 0.0

    def _project_changed(self, before: Project, after: Project) -> None:
        if before.examples is after.examples and before.libraries is after.libraries:
            return
        self._relearner.give_up()  # its answer would not fit, and until then it would be in the way of the window
        if self._settings.learns_by_itself:
            self._soon.start()
        else:
            self._is_asked = False
            self._set_busy(busy=False)

    def _take(self) -> None:
        for answer in self._relearner.answers():
            fits = answer.revision == self._document.revision
            if fits:
                self._use(answer)
            self._set_busy(busy=False)  # who has waited for it finds it in the document
            if not fits and self._settings.learns_by_itself:
                self._soon.start()

    def _use(self, answer: RelearnAnswer) -> None:
        if answer.teaches:
            self.learned_at = monotonic()
        if answer.learned.automata or answer.filled:
            self._document.amend(lambda project: _with(project, answer))
        for problem in answer.problems:
            if self._is_asked or problem not in self._problems:
                self.told.emit(problem)
        if self._is_asked and not answer.changes and not answer.problems:
            self.told.emit(UP_TO_DATE)
        self._problems, self._is_asked = answer.problems, False

    def _set_busy(self, *, busy: bool) -> None:
        if busy is not self.busy:
            self.busy = busy
            self.changed.emit()


def _with(project: Project, answer: RelearnAnswer) -> Project:
    """*project* with what was read from moments, and what was learned."""
    filled: Mapping[tuple[str, str], Mapping[str, Mapping[str, float]]] = answer.filled
    for where, values in filled.items():
        project = set_values(project, *where, values)
    return apply(project, answer.learned)
