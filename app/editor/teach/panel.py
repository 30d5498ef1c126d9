"""The behaviors that can be picked, as large buttons with keys."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QStackedWidget, QVBoxLayout, QWidget

from ...engine.snapshots import Snapshot
from .demonstrations_dialog import demonstration_rows
from .idle_page import IdlePage
from .lesson_page import LessonPage
from .question import MOST_ANSWERS, QuestionBar
from .rows import teach_panel_rows

if TYPE_CHECKING:
    from ..studio import Studio


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
        self._pages.setCurrentWidget(self.idle if lesson is None else self.lesson)
        self.title_changed.emit(self._title())
        self._ask()

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
