"""Questions in the window: what happened, in words that can be copied, and buttons for what can be done."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QFontDatabase, QGuiApplication
from PySide6.QtWidgets import (
    QDialog,
    QHBoxLayout,
    QLabel,
    QPlainTextEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from ..forms.buttons import stand_back
from ..icons import icon
from ..letters import plain

if TYPE_CHECKING:
    from ..theme import Theme

WIDTH = 560
DETAIL_HEIGHT = 200


@dataclass(frozen=True, slots=True)
class Answer:
    """What a button of a question does; one without *act* only closes it."""

    text: str
    act: Callable[[], object] | None = None
    tip: str = ""


class Question(QDialog):
    """A question that stands in the way of the window until it is answered.

    The first answer is the standard one; Esc and the window's button give one that only closes it, or else the last.

    Attributes:
        text: What is asked.
        buttons: One for each answer, in order.
        details: What can be read at length and copied; None if there is nothing.
    """

    def __init__(
        self,
        window: QWidget,
        theme: Theme,
        title: str,
        text: str,
        answers: Sequence[Answer],
        details: str = "",
        look: str = "help-circle-outline",
    ) -> None:
        """Ask it.

        Args:
            details: What can be read at length; code is not wrapped, which a shield as *look* tells.
        """
        super().__init__(window)
        self.setWindowTitle(title)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setMinimumWidth(WIDTH)
        self.text = text
        self._act: Callable[[], object] | None = _left(answers).act
        self.details = _details(details, wrapped=not look.startswith("shield")) if details else None
        layout = QVBoxLayout(self)
        layout.setContentsMargins(20, 18, 20, 16)
        layout.setSpacing(12)
        layout.addLayout(_head(theme, title, text, look))
        if self.details is not None:
            layout.addWidget(self.details)
        self.buttons = [self._button(answer, first=k == 0) for k, answer in enumerate(answers)]
        layout.addLayout(self._foot())
        self.finished.connect(self._finished)
        self.buttons[0].setFocus()

    def _button(self, answer: Answer, *, first: bool) -> QPushButton:
        button = QPushButton(plain(answer.text))
        button.setDefault(first)
        if not first:
            stand_back(button)
        button.setToolTip(answer.tip or answer.text)
        button.clicked.connect(lambda: self._answered(answer))
        return button

    def _foot(self) -> QHBoxLayout:
        foot = QHBoxLayout()
        foot.setSpacing(8)
        if self.details is not None:
            copy = QPushButton("Copy")
            stand_back(copy)
            copy.setToolTip("Put the text above into the clipboard")
            copy.clicked.connect(self.copy)
            foot.addWidget(copy)
        foot.addStretch(1)
        for button in reversed(self.buttons):  # the standard one stands last, where the eye ends
            foot.addWidget(button)
        return foot

    def copy(self) -> None:
        """Put what is shown into the clipboard."""
        if self.details is not None:
            QGuiApplication.clipboard().setText(self.details.toPlainText())

    def ask(self) -> None:
        """Show the question; the window below stays alive."""
        self.open()

    def _answered(self, answer: Answer) -> None:
        self._act = answer.act
        self.accept()

    def _finished(self) -> None:
        if self._act is not None:
            self._act()


def _left(answers: Sequence[Answer]) -> Answer:
    """What is answered by whoever leaves a question."""
    return next((answer for answer in answers if answer.act is None), answers[-1])


def _head(theme: Theme, title: str, text: str, look: str) -> QHBoxLayout:
    head = QHBoxLayout()
    head.setSpacing(14)
    sign = QLabel()
    sign.setPixmap(icon(look, theme, "accent").pixmap(QSize(28, 28)))
    head.addWidget(sign, 0, Qt.AlignmentFlag.AlignTop)
    words = QVBoxLayout()
    words.setSpacing(6)
    heading = QLabel(title)
    heading.setProperty("role", "title")
    body = QLabel(text)
    body.setTextFormat(Qt.TextFormat.PlainText)
    body.setWordWrap(True)
    body.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    body.setMinimumWidth(WIDTH - 90)
    words.addWidget(heading)
    words.addWidget(body)
    head.addLayout(words, 1)
    return head


def _details(text: str, *, wrapped: bool) -> QPlainTextEdit:
    shown = QPlainTextEdit(text)
    shown.setReadOnly(True)
    shown.setTabChangesFocus(True)
    shown.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
    modes = QPlainTextEdit.LineWrapMode
    shown.setLineWrapMode(modes.WidgetWidth if wrapped else modes.NoWrap)
    shown.setProperty("role", "details")
    metrics = shown.fontMetrics()
    each = max(1, (WIDTH - 60) // metrics.averageCharWidth()) if wrapped else len(text) + 1
    lines = sum(1 + len(line) // each for line in text.split("\n")) + 1
    height = 24 + lines * metrics.lineSpacing()
    shown.setMinimumHeight(min(DETAIL_HEIGHT, height))
    if height < DETAIL_HEIGHT:
        shown.setMaximumHeight(height)
    shown.setAccessibleName("Details")
    return shown
