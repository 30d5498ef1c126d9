"""The status bar: where the world is, how fast it goes, what the learner does, and when it was saved."""

from __future__ import annotations

from time import monotonic
from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QLabel, QStatusBar

from ...engine.snapshots import Snapshot
from ..cut_line import CutLine
from .physics import physics_words

if TYPE_CHECKING:
    from ..library.fits import Fits
    from ..studio import Studio

#: Milliseconds between two looks at what changes slowly.
SLOWLY = 500
#: How such a world is left.
BACK = "Choosing the arm again begins its own world."


class StatusBar(QStatusBar):
    """A line of facts."""

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self._fits: Fits | None = None
        self.setSizeGripEnabled(False)
        self.tick = self._label()
        self.rate = self._label()
        self.measures = self._label()
        self.measures.setToolTip("What the world counts so far; the panel Plots shows how it came")
        self.scenario = self._label()
        self.learner = self._label()
        self.fit = self._label()
        self.fit.setToolTip("How well what was learned of the selected behavior fits its examples")
        self.notice = self._label()
        self.undone = CutLine()
        self._place(self.undone, 1)  # all the room that is left: it makes no window wider
        self.saved = QLabel()
        self.saved.setProperty("role", "caption")
        self.saved.setContentsMargins(8, 2, 10, 2)
        self.addPermanentWidget(self.saved)
        self._timer = QTimer(self, interval=SLOWLY)
        self._timer.timeout.connect(self._slowly)
        self._timer.start()
        studio.bridge.snapshot_changed.connect(self._snapshot_changed)
        studio.opened.connect(self._cleared)
        studio.changed.connect(self._slowly)
        studio.relearning.changed.connect(self._slowly)
        studio.document.history_changed.connect(self._tell_what_is_undone)
        if studio.snapshot is not None:  # while time stands still, no other may come
            self._snapshot_changed(studio.snapshot)

    def tell_of(self, fits: Fits) -> None:
        """Say how well what was learned of the selected behavior fits its examples, as far as that is known."""
        self._fits = fits
        for signal in (fits.changed, self._studio.selection.behavior_changed, self._studio.changed):
            signal.connect(self._tell_fit)

    def _tell_fit(self, _what: object = None) -> None:
        key, document = self._studio.selection.behavior, self._studio.document
        automaton = None if key is None else document.automaton(key.type, key.id)
        words = ""
        if key is not None and automaton is not None and self._fits is not None:
            fit = self._fits.now((key.type, key.id), document.project)
            words = "" if fit is None else fit.brief
        self.fit.setText(f"{automaton.name} {words}" if automaton is not None and words else "")

    def _tell_what_is_undone(self) -> None:
        """What redo would bring back: it may have been in a behavior that is not in sight."""
        text = self._studio.document.history.redo_text
        self.undone.setText(f"undone: {text}" if text else "")

    def _label(self) -> QLabel:
        label = QLabel()
        self._place(label)
        return label

    def _place(self, label: QLabel, stretch: int = 0) -> None:
        label.setProperty("role", "caption")
        label.setContentsMargins(4, 2, 8, 2)
        self.addWidget(label, stretch)

    def _cleared(self) -> None:
        for label in (
            self.tick,
            self.rate,
            self.measures,
            self.scenario,
            self.learner,
            self.fit,
            self.undone,
            self.notice,
        ):
            label.clear()

    def _snapshot_changed(self, snapshot: Snapshot) -> None:
        self.tick.setText(f"tick {snapshot.tick:,}")

    def _slowly(self) -> None:
        snapshot = self._studio.snapshot
        if snapshot is not None:
            rate = 0.0 if snapshot.failure else self._studio.bridge.rate
            self.rate.setText(f"{rate:,.0f} ticks/s" if rate else "stopped" if snapshot.failure else "paused")
            self.measures.setText(
                " · ".join(f"{name} {count:,g}" for name, count in snapshot.measures.items())
            )
            place = snapshot.place
            departures = [f"{name} {value}" for name, value in self._studio.departures.items()]
            self.scenario.setText(" · ".join((place.scenario, place.physics, *departures)))
            bodies = self._studio.document.scenario.bodies
            words = [physics_words(place.physics, bodies, place.parameters)]
            if departures:
                words.append(
                    f"Unlike the arm, as in the run that was opened: {', '.join(departures)}. {BACK}"
                )
            self.scenario.setToolTip("\n".join(words))
            self.notice.setText(snapshot.notice)
        self.learner.setText(self._learner_words())
        self.saved.setText(self._saved_words())

    def _learner_words(self) -> str:
        relearning = self._studio.relearning
        if relearning.busy:
            return "learning…"
        if not relearning.learned_at:
            return ""
        return f"learned {ago(monotonic() - relearning.learned_at)}"

    def _saved_words(self) -> str:
        if not self._studio.is_open:
            return ""
        document = self._studio.document
        if document.saving:
            return "saving…"
        if document.is_saved:
            return "saved" if document.folder is not None else "not saved yet"
        kept = "" if document.autosaved is None else f" · autosaved {document.autosaved:%H:%M}"
        return f"unsaved changes{kept}"


def ago(seconds: float) -> str:
    """How long ago, in few words."""
    if seconds < 2:
        return "just now"
    if seconds < 90:
        return f"{seconds:.0f} s ago"
    return f"{seconds / 60:.0f} min ago"
