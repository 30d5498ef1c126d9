"""Messages to the user: a bar that says what happened and what can be done, and goes away by itself if it may."""

from __future__ import annotations

from collections import deque
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QSize, Qt, QTimer, Signal
from PySide6.QtWidgets import (
    QApplication,
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QToolButton,
    QWidget,
)

from ..escape import takes_escape
from ..icons import icon
from ..letters import plain
from ..message import Kind, Message

if TYPE_CHECKING:
    from ..studio import Studio

#: Milliseconds that a message stays if it asks for nothing, and for each letter to read.
AT_LEAST, A_LETTER = 4000, 45
_ICONS = {
    Kind.INFO: ("information-outline", "accent"),
    Kind.WARNING: ("alert-outline", "accent"),
    Kind.ERROR: ("alert-circle-outline", "teach"),
}


class MessageBar(QFrame):
    """Shows one message at a time; those that come meanwhile wait, the same one twice is shown once.

    Signals:
        shown: A message is on the screen; its text.
    """

    shown = Signal(str)

    def __init__(self, studio: Studio, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._studio = studio
        self._waiting: deque[Message] = deque()
        self.current: Message | None = None
        self.setObjectName("messages")
        self._icon = QLabel()
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.words.setTextFormat(Qt.TextFormat.PlainText)
        self.words.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.words.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._answers: list[QPushButton] = []
        self._close = QToolButton()
        self._close.setProperty("flat", "true")
        self._close.setToolTip("Dismiss")
        self._close.setAccessibleName("Dismiss the message")
        self._close.clicked.connect(self.dismiss)
        self._layout = QHBoxLayout(self)
        self._layout.setContentsMargins(12, 6, 6, 6)
        self._layout.addWidget(self._icon)
        self._layout.addWidget(self.words, 1)
        self._layout.addWidget(self._close)
        self._timer = QTimer(self, singleShot=True)
        self._timer.timeout.connect(self.dismiss)
        studio.said.connect(self.say)
        studio.changed.connect(self._drop_what_is_over)
        studio.theme.changed.connect(self._dress)
        self._dress()
        self.hide()

    def say(self, message: Message) -> None:
        """Show a message, after those that are waiting; a warning is shown before what is only good to know, or can wait."""
        if message == self.current or message in self._waiting:
            return
        if self.current is not None and self._gives_way(self.current, message):
            self._waiting.extendleft((self.current, message))  # what it asks is asked again after that
            self._next()
        elif self._timer.isActive() and message.kind is not Kind.INFO:
            self._waiting.appendleft(message)
            self._next()
        else:
            self._waiting.append(message)
            if self.current is None:
                self._next()

    def _gives_way(self, current: Message, message: Message) -> bool:
        """Whether what waits for an answer does so behind a message: one that is more urgent, or that goes by itself."""
        if self._timer.isActive() or message.kind is Kind.INFO or current.kind is Kind.ERROR:
            return False
        return current.kind is Kind.INFO or not message.answers

    def dismiss(self) -> None:
        """Take the message away, and show the next."""
        self.current = None
        focus = QApplication.focusWidget()
        if isinstance(focus, QWidget) and self.isAncestorOf(focus):
            self.window().setFocus()  # rather than whoever comes next, who would take keys that are shortcuts
        self.hide()
        self._next()

    def _drop_what_is_over(self) -> None:
        """Show no message that does not hold any more."""
        self._waiting = deque(message for message in self._waiting if message.holds())
        if self.current is not None and not self.current.holds():
            self.dismiss()

    def _next(self) -> None:
        if not self._waiting:
            return
        message = self.current = self._waiting.popleft()
        self.words.setText(message.text[:1].upper() + message.text[1:])
        for button in self._answers:
            self._layout.removeWidget(button)
            button.deleteLater()
        self._answers = [self._button(text, act) for text, act in message.answers]
        self.setFocusProxy((*self._answers, self._close)[0])
        self._dress()
        self.show()
        self.raise_()
        self._timer.stop()
        if not message.answers and message.kind is not Kind.ERROR:
            self._timer.start(AT_LEAST + A_LETTER * len(message.text))
        self.shown.emit(message.text)

    def event(self, event: QEvent) -> bool:
        """Escape dismisses a message that the keys go to, and does nothing else."""
        return takes_escape(event, self.dismiss) or super().event(event)

    def _button(self, text: str, act: object) -> QPushButton:
        button = QPushButton(plain(text))
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # keys stay with the window after a click
        button.clicked.connect(self.dismiss)
        button.clicked.connect(act)
        self._layout.insertWidget(self._layout.count() - 1, button)
        return button

    def _dress(self) -> None:
        theme = self._studio.theme
        kind = Kind.INFO if self.current is None else self.current.kind
        name, color = _ICONS[kind]
        self._icon.setPixmap(icon(name, theme, color).pixmap(QSize(18, 18)))
        self._close.setIcon(icon("close", theme, "dim"))
        colors = theme.palette
        edge = colors.teach if kind is Kind.ERROR else colors.accent
        self.setStyleSheet(
            f"#messages {{ background: {colors.raised}; border: 1px solid {colors.hairline};"
            f" border-left: 3px solid {edge}; border-radius: 7px; }}"
        )
