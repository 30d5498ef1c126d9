"""What is wrong with the project, found beside the window after every change, with what can be done about it."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QObject, QTimer, Signal

from ...core.check import Checker, Problem, automaton_file
from ...core.check.fixes import Fix, fixes
from ...core.check.spots import Spot, spot_of
from ...core.errors import UnderstudyError
from ...core.library import Types
from ...core.naming import shown_state
from ...core.project import Project
from ...core.vocabulary import Vocabulary
from ...engine.turns import AFTER_EDITS
from ...engine.worker import IsCancelled, Worker
from ...learner.trainer import Key, every_automaton
from ..document import Document

#: Milliseconds without another change before the project is checked.
PATIENCE = 120
#: More problems than this nobody reads; the rest are counted.
MOST = 500
STALE = "it has changed since it was learned, so what runs is not what was taught"


@dataclass(frozen=True, slots=True)
class Finding:
    """One problem as the panel lists it.

    Attributes:
        place: Where it is, in words.
        fixes: What one click can do.
        relearns: Learning again mends it.
    """

    problem: Problem
    spot: Spot
    place: str
    fixes: tuple[Fix, ...] = ()
    relearns: bool = False

    @property
    def is_error(self) -> bool:
        """Whether it keeps something from running."""
        return self.problem.severity == "error"

    @property
    def mendable(self) -> bool:
        """Whether one click can do something about it."""
        return self.relearns or bool(self.fixes)

    @property
    def fix_words(self) -> str:
        """What the click does; that of the first way, where there are several."""
        if self.relearns:
            return "Learn it again"
        if not self.fixes:
            return ""
        first = self.fixes[0].text
        return first[:1].upper() + first[1:] + ("…" if len(self.fixes) > 1 else "")


@dataclass(frozen=True, slots=True)
class Found:
    """All that was found in one value of the project.

    Attributes:
        more: How many there are besides those that are listed.
    """

    revision: int
    findings: tuple[Finding, ...] = ()
    more: int = 0


_Question = tuple[int, Project, Vocabulary]


class Findings(QObject):
    """Checks the document whenever it has changed.

    Attributes:
        found: The newest.

    Signals:
        changed: There is a newer answer.
    """

    changed = Signal()
    _ready = Signal()

    def __init__(self, document: Document, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self.found = Found(0)
        self._checker = Checker()  # only the thread looks at it
        self._worker: Worker[_Question, Found] = Worker(
            AFTER_EDITS.taken(self._work), _broken, self._ready.emit, "problems"
        )
        self._soon = QTimer(self, interval=PATIENCE, singleShot=True)
        self._soon.timeout.connect(self._ask)
        self._ready.connect(self._take)
        document.project_changed.connect(self._changed)
        document.opened.connect(self._changed)

    def close(self) -> None:
        """End the thread."""
        self._soon.stop()
        self._worker.close()

    def _changed(self) -> None:
        """What is being found out is of no use any more."""
        self._worker.give_up()
        self._soon.start()

    def _ask(self) -> None:
        document = self._document
        self._worker.ask((document.revision, document.project, document.scenario.vocabulary))

    def _take(self) -> None:
        for answer in self._worker.answers():
            if answer.revision == self._document.revision:
                self.found = answer
                self.changed.emit()
            else:
                self._soon.start()

    # ------------------------------------------------------------------------------------- in the thread

    def _work(self, question: _Question, cancelled: IsCancelled) -> Found:
        revision, project, vocabulary = question
        if cancelled():
            return Found(revision)
        types = project.types_with(vocabulary)
        problems = self._checker.check(project, vocabulary)
        listed = []
        for problem in sorted(problems, key=lambda p: p.severity)[:MOST]:  # errors first
            if cancelled():
                return Found(revision)
            listed.append(_finding(problem, project, types))
        listed += [self._stale_finding(project, key) for key in self._stale(project, cancelled)]
        return Found(revision, tuple(listed), max(0, len(problems) - MOST))

    def _stale(self, project: Project, cancelled: IsCancelled) -> list[Key]:
        """The automata that have changed since they were learned."""
        freshness, keys = self._document.freshness, every_automaton(project)
        freshness.keep(keys)
        found = []
        for key in keys:
            if cancelled():
                return []
            if freshness.is_stale(project, key):
                found.append(key)
        return found

    def _stale_finding(self, project: Project, key: Key) -> Finding:
        name = project.library(key[0]).get(key[1]).name
        problem = Problem(automaton_file(*key), "learned", f"{name}: {STALE}", "warning")
        spot = Spot(*key)
        return Finding(problem, spot, _place(spot, project), relearns=True)


def _broken(question: _Question, why: str) -> Found:
    problem = Problem("", "", f"the project could not be checked: {why}")
    return Found(question[0], (Finding(problem, Spot(), ""),))


def _finding(problem: Problem, project: Project, types: Types) -> Finding:
    spot = spot_of(problem, project)
    try:
        ways = fixes(problem, project, types)
    except UnderstudyError:  # what is wrong elsewhere stands in the way
        ways = ()
    return Finding(problem, spot, _place(spot, project), ways)


def _place(spot: Spot, project: Project) -> str:
    """Where a problem is, by the names that the user reads."""
    library = project.library(spot.type)
    automaton = library.automata.get(spot.automaton)
    if automaton is None:
        return spot.words
    words = automaton.name if spot.type == project.types[0].name else f"{automaton.name} ({spot.type})"
    if spot.feature:
        use = next((use for use in automaton.features if use.id == spot.feature), None)
        return f"{words}, {use.shown}" if use is not None else words
    return f"{words}, {shown_state(automaton, spot.state, library)}" if spot.state else words
