"""The behaviors that can be picked, as large buttons with keys."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QSizePolicy, QStackedWidget, QVBoxLayout, QWidget

from ...engine.snapshots import Snapshot
from .demonstrations_dialog import demonstration_rows
from .idle_page import IdlePage
from .lesson_page import LessonPage
from .question import MOST_ANSWERS, QuestionBar
from .rows import teach_panel_rows

if TYPE_CHECKING:
    from ..studio import Studio

#: Pixels that the panel takes at most before a lesson, and in one as many as it is given (Qt's number for no limit).
IDLE, ANY = 104, (1 << 24) - 1


class TeachPanel(QWidget):
    """What can be picked, for whom, what was recorded last; before a lesson, what one would be about.

    Signals:
        title_changed: What the dock is called.
    """

    title_changed = Signal(str)

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        studio.actions.add((*teach_panel_rows(), *demonstration_rows(self)))
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.question = QuestionBar(studio)
        self.idle = IdlePage(studio)
        self.lesson = LessonPage(studio)
        self._pages = QStackedWidget()
        for page in (self.idle, self.lesson):
            self._pages.addWidget(page)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(10, 2, 10, 6)
        layout.setSpacing(6)
        layout.addWidget(self.question)
        layout.addWidget(self._pages, 1)
        self._asked: object = None
        studio.teaching.asking.changed.connect(self._ask)
        studio.teaching.changed.connect(self._show)
        studio.bridge.mode_changed.connect(self._show)
        studio.bridge.snapshot_changed.connect(self._snapshot_changed)
        studio.opened.connect(self._show)
        self._show()

    def _snapshot_changed(self, snapshot: Snapshot) -> None:
        if (snapshot.lesson is not None) is not (self._pages.currentWidget() is self.lesson):
            self._show()

    def _show(self) -> None:
        teaching = self._studio.teaching
        lesson = teaching.lesson
        self._turn_to(self.idle if lesson is None else self.lesson)
        self.title_changed.emit(self._title())
        self._ask()

    def _turn_to(self, page: QWidget) -> None:
        """Show a page, and take no more height than it needs: what a lesson took goes back to the panel below."""
        for other in (self.idle, self.lesson):
            kept = QSizePolicy.Policy.Preferred if other is page else QSizePolicy.Policy.Ignored
            other.setSizePolicy(QSizePolicy.Policy.Preferred, kept)
        self._pages.setCurrentWidget(page)
        self.setMaximumHeight(IDLE if page is self.idle else ANY)

    def _title(self) -> str:
        teaching, snapshot = self._studio.teaching, self._studio.snapshot
        lesson, automaton = teaching.lesson, teaching.automaton
        if lesson is None or automaton is None or snapshot is None:
            return "Teach"
        who = snapshot.place.called(teaching.node)
        return f"Testing {automaton.name}" if lesson.testing else f"Teaching {automaton.name} to {who}"

    def _ask(self) -> None:
        asked = self._studio.teaching.asking.asked
        if asked is self._asked:
            return
        self._asked = asked
        if asked is None:
            self.question.clear()
            return
        states = [state for state, _ in asked.outcome][:MOST_ANSWERS]
        self.question.ask(asked, self.lesson.answers(states))
