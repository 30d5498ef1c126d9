"""How much of an experiment runs, what begins, holds and ends it, and how far it is."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QProgressBar, QPushButton, QSpinBox, QVBoxLayout, QWidget

from ...engine.cores import cores
from ...engine.experiments.laboratory import Look, Stage
from ...engine.experiments.plan import SEEDS_A_CELL
from ..forms.buttons import text_button
from ..forms.parts import caption
from ..icons import icon
from ..number_box import roomy
from .running import Running
from .standing import words_of

if TYPE_CHECKING:
    from ..theme import Theme
    from .study import Study


#: What the button says that holds an experiment, and lets it go on.
PAUSE, RESUME = "Pause", "Resume"
#: Pixels that an icon takes, which a button gets later.
ICON = 20


class Controls(QWidget):
    """Ticks, runs and how many at a time; Run, Pause and Cancel; progress.

    Signals:
        begun: The user wants it to run.
        asked_otherwise: The user wants another number of runs or ticks: that many runs, that many ticks.
    """

    begun = Signal()
    asked_otherwise = Signal(int, int)

    def __init__(self, running: Running, theme: Theme) -> None:
        super().__init__()
        self._running = running
        self._theme = theme
        self.ticks = _number("Ticks a run", 1, 10**9)
        self.runs = _number("Runs an arm", 1, SEEDS_A_CELL)
        self.jobs = _number("Runs at a time", 1, max(1, cores()))
        self.jobs.setValue(cores())
        self.run = text_button("Run", "Run what is missing (F5)", self.begun.emit)
        self.pause = text_button(PAUSE, "Let all worlds stand still, or go on (F6)", running.pause_or_resume)
        _keep_width(self.pause, RESUME)
        self.cancel = text_button("Cancel", "Stop; finished runs are kept (F7)", running.cancel)
        self.bar = QProgressBar()
        self.bar.setTextVisible(False)
        self.bar.setFixedHeight(6)
        self.bar.setRange(0, 1000)
        self.told = caption("")
        self._lay_out()
        for field in (self.ticks, self.runs):
            field.valueChanged.connect(
                lambda _: self.asked_otherwise.emit(self.runs.value(), self.ticks.value())
            )
        theme.changed.connect(self._dress)
        self._dress()

    def _lay_out(self) -> None:
        line = QHBoxLayout()
        for words, field in (("Ticks", self.ticks), ("Runs an arm", self.runs), ("At a time", self.jobs)):
            label = QLabel(words)
            label.setProperty("role", "caption")
            line.addWidget(label)
            line.addWidget(field)
        line.addStretch(1)
        for button in (self.run, self.pause, self.cancel):
            line.addWidget(button)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addLayout(line)
        column.addWidget(self.bar)
        column.addWidget(self.told)

    def _dress(self) -> None:
        hold = "play" if self.pause.text() == RESUME else "pause"
        for button, name in ((self.run, "play"), (self.pause, hold), (self.cancel, "close")):
            button.setIcon(icon(name, self._theme))

    def show_study(self, study: Study) -> None:
        """Show how much an experiment asks for."""
        for field, value in ((self.ticks, study.experiment.ticks), (self.runs, study.experiment.runs)):
            field.blockSignals(True)
            field.setValue(value)
            field.blockSignals(False)

    def show_look(self, look: Look, study: Study) -> None:
        """Show how far the experiment that runs is."""
        self.tell(words_of(look, study))
        self.bar.setValue(0 if look.progress is None else round(1000 * look.progress.share))

    def show_other(self, look: Look, study: Study) -> None:
        """Show how far an experiment is that runs while another one is shown."""
        self.show_look(look, study)
        self.tell(f"{study.declared.name} is running: {words_of(look, study)}")

    def tell(self, words: str) -> None:
        """Say this below the buttons."""
        self.told.setText(words[:1].upper() + words[1:])

    def allow(self, *, running: bool) -> None:
        """Let the user begin, or not; what is under way can always be held and ended."""
        on, look = self._running.is_on, self._running.look
        self.run.setEnabled(running)
        self.pause.setEnabled(on)
        self._say_what_pause_does(RESUME if look is not None and look.stage is Stage.PAUSED else PAUSE)
        self.cancel.setEnabled(on)
        self.bar.setVisible(on)
        for field in (self.ticks, self.runs, self.jobs):
            field.setEnabled(running)

    def _say_what_pause_does(self, words: str) -> None:
        if words != self.pause.text():
            self.pause.setText(words)
            self._dress()


def _keep_width(button: QPushButton, other: str) -> None:
    """Let a button stay as wide when it says something else, so that nothing beside it moves."""
    said = button.text()
    button.setText(other)
    button.setMinimumWidth(button.sizeHint().width() + ICON)
    button.setText(said)


def _number(tip: str, low: int, high: int) -> QSpinBox:
    box = roomy(QSpinBox())
    box.setRange(low, min(high, 2**31 - 1))
    box.setToolTip(tip)
    box.setAccessibleName(tip)
    box.setGroupSeparatorShown(True)
    box.setKeyboardTracking(False)
    return box
