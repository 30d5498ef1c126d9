"""The question that a test stops for, with its answers as buttons."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QPushButton, QSizePolicy

from ...engine.snapshots import Asked
from .button import BehaviorButton

if TYPE_CHECKING:
    from ..studio import Studio

#: So many answers are offered as buttons; the others are picked below.
MOST_ANSWERS = 5


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
        self.let_go = QPushButton("It may decide")
        self.let_go.clicked.connect(studio.actions["teach.let_go"].trigger)
        self.buttons: list[BehaviorButton] = []
        self._layout = QHBoxLayout(self)
        self._layout.setContentsMargins(10, 4, 6, 4)
        self._layout.addWidget(self.words, 1)
        self._layout.addWidget(self.let_go)
        studio.theme.changed.connect(self._dress)
        self._dress()
        self.hide()

    def ask(self, asked: Asked, answers: list[BehaviorButton]) -> None:
        """Ask, with the buttons of the states that it wavers between."""
        self._clear()
        self.words.setText(self._studio.teaching.asking.words(asked))
        self.words.setToolTip(asked.reason)
        self.let_go.setToolTip(self._studio.actions["teach.let_go"].toolTip())
        self.buttons = answers
        for button in answers:
            self._layout.insertWidget(self._layout.count() - 1, button)
        self.show()

    def clear(self) -> None:
        """There is no question."""
        self._clear()
        self.hide()

    def _clear(self) -> None:
        for button in self.buttons:
            self._layout.removeWidget(button)
            button.hide()
            button.deleteLater()
        self.buttons = []

    def _dress(self) -> None:
        colors = self._studio.theme.palette
        self.setStyleSheet(
            f"#question {{ background: {colors.raised}; border: 1px solid {colors.hairline};"
            f" border-left: 3px solid {colors.accent}; border-radius: 7px; }}"
        )
