"""Plays the demonstrations in the background, and says which examples would come out otherwise."""

from __future__ import annotations

from contextlib import suppress
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QListWidget,
    QProgressBar,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from ...core.amounts import counted
from ...core.project import Project
from ...engine.replaying import Replayed, Replayer

if TYPE_CHECKING:
    from ..studio import Studio

TIP = "Play all demonstrations in the background, and compare what they record with the examples there are"
#: Milliseconds between two looks at how far it is.
LOOKS = 100
#: The progress bar's steps, and the most differences that are listed.
STEPS, MOST = 1000, 500


class ReplayCheck(QWidget):
    """A button that begins it, then how far it is, then what was found.

    Attributes:
        start, stop: Begin to play; give it up.
        bar: How far it is.
        words: What is being played, or what was found.
        differences: A line for each example that differs.

    Signals:
        ended: It has been played, or given up.
    """

    ended = Signal()
    _ready = Signal()

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self._replayer: Replayer | None = None
        self.start = QPushButton("Check by playing")
        self.start.setToolTip(TIP)
        self.start.clicked.connect(self.begin)
        self.stop = QPushButton("Cancel")
        self.stop.setToolTip("Play no further; nothing has been changed")
        self.stop.clicked.connect(self.cancel)
        self.bar = QProgressBar(maximum=STEPS, textVisible=False)
        self.bar.setAccessibleName("How much has been played")
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.words.setTextFormat(Qt.TextFormat.PlainText)
        self.words.setProperty("role", "caption")
        self.differences = QListWidget()
        self.differences.setAccessibleName("Examples that would come out otherwise")
        self.differences.setToolTip("What playing the demonstrations would record otherwise")
        self.differences.setWordWrap(True)
        self._looks = QTimer(self, interval=LOOKS)
        self._looks.timeout.connect(self._look)
        self._ready.connect(self._take, Qt.ConnectionType.QueuedConnection)
        self._lay_out()
        studio.document.project_changed.connect(self._project_changed)
        self._show(running=False)

    def _lay_out(self) -> None:
        row = QHBoxLayout()
        row.addWidget(self.start)
        row.addWidget(self.bar, 1)
        row.addWidget(self.stop)
        row.addStretch(0)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addLayout(row)
        column.addWidget(self.words)
        column.addWidget(self.differences)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Minimum)

    @property
    def is_running(self) -> bool:
        """Whether demonstrations are being played."""
        return self._looks.isActive()

    # ------------------------------------------------------------------------------------------ playing

    def begin(self) -> None:
        """Play all demonstrations."""
        document = self._studio.document
        if self._replayer is None:
            self._replayer = Replayer(self._wake)
        self.differences.clear()
        self._replayer.ask(document.project, document.scenario)
        self._show(running=True)
        self._look()
        self.stop.setFocus()

    def cancel(self) -> None:
        """Play no further."""
        if self._replayer is not None and self.is_running:
            self._replayer.cancel()
            self._end("Cancelled; nothing was changed.")

    def closeEvent(self, event: QCloseEvent) -> None:
        """Give up what is being played."""
        self._looks.stop()
        if self._replayer is not None:
            self._replayer.close()
            self._replayer = None
        super().closeEvent(event)

    def _wake(self) -> None:
        """In the thread that plays: an answer is there; the window may be gone by now."""
        with suppress(RuntimeError):
            self._ready.emit()

    def _look(self) -> None:
        if self._replayer is not None:
            share, what = self._replayer.progress
            self.bar.setValue(round(share * STEPS))
            self.words.setText(f"{what[:1].upper()}{what[1:]}…" if what else "Beginning…")

    def _take(self) -> None:
        for answer in self._replayer.answers() if self._replayer is not None else []:
            self.differences.addItems(list(answer.differences[:MOST]))
            if len(answer.differences) > MOST:
                self.differences.addItem(f"and {len(answer.differences) - MOST} more")
            self._end(_words(answer))

    def _end(self, words: str) -> None:
        had_focus = self.stop.hasFocus()
        self._show(running=False)
        self.words.setText(words)
        if had_focus:
            self.start.setFocus()
        self.ended.emit()

    def _show(self, *, running: bool) -> None:
        if running:
            self._looks.start()
        else:
            self._looks.stop()
        self.start.setEnabled(bool(self._studio.document.project.demonstrations))
        self.start.setVisible(not running)
        self.stop.setVisible(running)
        self.bar.setVisible(running)
        self.differences.setVisible(self.differences.count() > 0)

    def _project_changed(self, before: Project, after: Project) -> None:
        """What was found, or is being looked for, is about other examples."""
        if before.demonstrations is after.demonstrations and before.examples is after.examples:
            return
        if self.is_running:
            self.cancel()
            self.words.setText("The project was changed, so this was given up. Check again.")
        elif self.words.text():
            self.words.setText("The project has changed since it was checked.")
        self.differences.clear()
        self._show(running=False)


def _words(answer: Replayed) -> str:
    if answer.problem:
        return f"They cannot be played: {answer.problem}"
    if not answer.differences:
        return f"All is the same: {counted(answer.examples, 'example')} would be recorded just as they are."
    return f"{counted(len(answer.differences), 'difference')} among {counted(answer.examples, 'example')}:"
