"""The question that a test stops for, with its answers as buttons."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QFrame, QLabel, QPushButton, QSizePolicy, QVBoxLayout

from ...engine.snapshots import Asked
from .button import BehaviorButton
from .flow import ROW, ButtonFlow, Rows

if TYPE_CHECKING:
    from ..studio import Studio

#: So many answers are offered as buttons; the others are picked below.
MOST_ANSWERS = 5
LEFT, RIGHT = 12, 8


class QuestionBar(QFrame):
    """Says what is asked; shown while there is a question.

    Signals:
        answered: The id of a state.
    """

    answered = Signal(str)

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self.setObjectName("question")
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.words.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.let_go = QPushButton()
        self.let_go.setFixedHeight(ROW)
        self.let_go.clicked.connect(studio.actions["teach.let_go"].trigger)
        self.buttons: list[BehaviorButton] = []
        self._flow = ButtonFlow()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(LEFT, 6, RIGHT, 6)
        layout.setSpacing(6)
        layout.addWidget(self.words)
        layout.addWidget(Rows(self._flow))
        studio.theme.changed.connect(self._dress)
        self._dress()
        self.hide()

    def ask(self, asked: Asked, answers: list[BehaviorButton]) -> None:
        """Ask, with the buttons of the states that it wavers between."""
        self._clear()
        self.words.setText(self._studio.teaching.asking.words(asked))
        self.words.setToolTip(asked.reason)
        letting_go = self._studio.actions["teach.let_go"]
        keys = letting_go.shortcut().toString()
        words = self._studio.actions.text_of("teach.let_go")
        self.let_go.setText(f"{words}   {keys}" if keys else words)
        self.let_go.setToolTip(letting_go.toolTip())
        self.buttons = answers
        self._flow.hold((*answers, self.let_go))
        self._fit_words()
        self.show()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The words may take other lines."""
        super().resizeEvent(event)
        self._fit_words()

    def _fit_words(self) -> None:
        """Docks do not ask how high wrapped words are, so they have to be told."""
        if self.words.text():  # where nothing was asked yet, there is no height
            width = max(1, self.width() - LEFT - RIGHT)
            self.words.setFixedHeight(self.words.heightForWidth(width))

    def clear(self) -> None:
        """There is no question."""
        self._clear()
        self.hide()

    def _clear(self) -> None:
        self._flow.hold((self.let_go,))
        for button in self.buttons:
            button.hide()
            button.deleteLater()
        self.buttons = []

    def _dress(self) -> None:
        colors = self._studio.theme.palette
        self.setStyleSheet(
            f"#question {{ background: {colors.raised}; border: 1px solid {colors.hairline};"
            f" border-left: 3px solid {colors.accent}; border-radius: 7px; }}"
        )
