"""The card of the first lesson: what to do next, how far it is, and leaving it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ...core.errors import UnderstudyError
from ...core.project import Project
from ...engine.commands import StopAt
from ...sim.scenario import Scenario
from ..actions import ActionRow
from ..icons import icon
from ..message import Message
from .ring import Ring
from .scratch import NAME, lacks_wander, scratch_project, with_wander
from .steps import SECOND, STEPS, Seen, picked_state

if TYPE_CHECKING:
    from ...engine.snapshots import Snapshot
    from ..window.main_window import MainWindow

WIDTH, AWAY = 330, 16
#: The flag among the settings that the lesson was offered.
OFFERED = "lesson_offered"


class Guide(QFrame):
    """Leads through the first lesson without ever standing in the way.

    Attributes:
        step: The number of the step that the user is at; as many as there are once all is done.
        ring: Points at what is to be used.
    """

    def __init__(self, window: MainWindow, over: QWidget) -> None:
        super().__init__(over)
        self._window = window
        self._over = over
        self._studio = window.studio
        self.step = 0
        # The step to begin at, while the user is asked whether to leave a project.
        self._wanted: int | None = None
        self._picked, self._from_tick = "", 0
        self._stopped = False  # at the moment that the step is about
        self.setObjectName("guide")
        self.setAccessibleName("Guided first lesson")
        self.ring = Ring(window, self._studio.theme)
        self.title, self.words, self.progress = QLabel(), QLabel(), QLabel()
        self.bar = QProgressBar()
        self.close_button, self.back, self.skip = QToolButton(), QPushButton("Back"), QPushButton("Skip")
        self._build()
        over.installEventFilter(self)
        window.canvas.on_top.legend.resized.connect(self._place)
        studio = self._studio
        studio.bridge.event_came.connect(self._event_came)
        for signal in (
            studio.bridge.snapshot_changed,
            studio.bridge.mode_changed,
            studio.selection.behavior_changed,
        ):
            signal.connect(self._look)
        studio.opened.connect(self._opened)
        studio.theme.changed.connect(self._dress)
        self._dress()
        self.hide()

    def _build(self) -> None:
        self.title.setProperty("role", "title")
        self.words.setWordWrap(True)
        self.words.setTextFormat(Qt.TextFormat.PlainText)
        self.words.setAlignment(Qt.AlignmentFlag.AlignTop)
        self.progress.setProperty("role", "caption")
        self.bar.setTextVisible(False)
        self.bar.setFixedHeight(4)
        self.bar.setRange(0, len(STEPS))
        self.close_button.setProperty("flat", "true")
        self.close_button.setToolTip("Leave the lesson; Help, Guided first lesson takes it up again")
        self.close_button.setAccessibleName("Leave the lesson")
        self.close_button.clicked.connect(self.leave)
        self.back.setToolTip("Show the step before")
        self.back.clicked.connect(lambda: self._go(self.step - 1))
        self.skip.setToolTip("Go on without doing this")
        self.skip.clicked.connect(self._skip)
        for button in (self.close_button, self.back, self.skip):
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # keys stay with the window after a click
        head, foot = QHBoxLayout(), QHBoxLayout()
        head.addWidget(self.title, 1)
        head.addWidget(self.close_button)
        foot.addWidget(self.progress, 1)
        foot.addWidget(self.back)
        foot.addWidget(self.skip)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(14, 8, 10, 12)
        layout.setSpacing(8)
        layout.addLayout(head)
        layout.addWidget(self.words)
        layout.addWidget(self.bar)
        layout.addLayout(foot)

    # ------------------------------------------------------------------------------------- coming and going

    def start(self) -> None:
        """Begin the lesson, or take it up where it was left."""
        step = self._studio.settings.lesson_step
        step = step if 0 <= step < len(STEPS) else 0
        if self._is_here:
            self._show(step)
            return
        first = SECOND if step >= SECOND else 0
        self._window.files.background.do(
            lambda: scratch_project(wander_is_taught=first == SECOND),
            lambda made: self._begin(first, made),
            self._failed,
        )

    def offer(self) -> None:
        """Ask a user who has never been here whether to begin it; once in a lifetime."""
        settings = self._studio.settings
        if settings.lesson_step or settings.flag(OFFERED) or self._is_here:
            return
        settings.set_flag(OFFERED, on=True)
        words = "New here? The guided first lesson takes five minutes. Later, it is in the menu Help."
        answers = ("Begin it", self.start), ("Not now", lambda: None)
        self._studio.said.emit(Message(words, answers=answers))

    @property
    def _is_here(self) -> bool:
        document = self._studio.document
        return self._studio.is_open and document.project.name == NAME and document.folder is None

    def _begin(self, step: int, made: tuple[Project, Scenario]) -> None:
        self._wanted = step
        self._window.files.scratch(*made)
        if self._is_here:
            self._show(step)

    def _failed(self, error: UnderstudyError) -> None:
        self._studio.warn(str(error))

    def _opened(self) -> None:
        """The lesson's project was opened after a question, or another one in its place."""
        if not self._is_here:
            self.leave()
        elif self._wanted is not None:
            step, self._wanted = self._wanted, None
            self._show(step)

    def leave(self) -> None:
        """Put the lesson away; it can be taken up again. Time does not stop for it any more."""
        self.ring.point_at("")
        if self.isVisible() and self._studio.bridge.is_open:
            self._studio.bridge.send(StopAt(None))
        self.hide()

    def _show(self, step: int) -> None:
        self._wanted = None
        self.show()
        self.raise_()
        self._go(step)

    # ------------------------------------------------------------------------------------------------ steps

    def _go(self, step: int) -> None:
        self.step = max(0, min(step, len(STEPS)))
        self._studio.settings.lesson_step = self.step
        self._picked, self._stopped = "", False
        snapshot = self._studio.snapshot
        self._from_tick = 0 if snapshot is None else snapshot.tick
        if snapshot is not None and snapshot.stops_at is not None:  # for the step before
            self._studio.bridge.send(StopAt(None))
        self.bar.setValue(self.step)
        self.back.setEnabled(self.step > 0)
        if self.step == len(STEPS):
            self._end()
            return
        now = STEPS[self.step]
        self.title.setText(now.title)
        self.words.setText(now.text)
        self.progress.setText(f"Step {self.step + 1} of {len(STEPS)}")
        self.skip.setVisible(True)
        self.ring.point_at(now.points_at)
        self._place()

    def _skip(self) -> None:
        """Go on; the second half gets what it needs of a first one that was not done."""
        self._go(self.step + 1)
        if self.step == SECOND and lacks_wander(self._studio.document.project):
            self._window.files.background.do(
                lambda: scratch_project(wander_is_taught=True), self._give_wander, self._failed
            )

    def _give_wander(self, made: tuple[Project, Scenario]) -> None:
        document = self._studio.document
        if self._is_here and lacks_wander(document.project):
            document.push("Put in a Wander that was taught", with_wander(document.project, made[0]))
            self._studio.say("you skipped teaching Wander, so one that was taught is there now")

    def _end(self) -> None:
        self.title.setText("That is all it takes")
        self.words.setText(
            "You taught two behaviors and used one in the other. Save this project (Ctrl+S) to go on with it, or open "
            "the foraging project, where groups of agents have controllers that were taught the same way."
        )
        self.progress.setText("Done")
        self.skip.setVisible(False)
        self.ring.point_at("")
        self._place()

    def _event_came(self, event: object) -> None:
        picked = picked_state(event)
        if picked:
            self._picked = picked
            self._look()

    def _look(self, *_: object) -> None:
        """Go on if the user has done what the step asks for."""
        if not self.isVisible() or self.step >= len(STEPS):
            return
        snapshot = self._studio.snapshot
        tick = 0 if snapshot is None else snapshot.tick
        self._from_tick = min(self._from_tick, tick)  # the world may have begun again
        seen = Seen(self._studio, self._picked, tick - self._from_tick)
        if STEPS[self.step].done(seen):
            self._go(self.step + 1)
        elif snapshot is not None:
            STEPS[self.step].prepares(self._studio)
            self._stop_in_time(snapshot, STEPS[self.step].stops(seen))

    def _stop_in_time(self, snapshot: Snapshot, left: int | None) -> None:
        """Have time stop after *left* ticks, also where the window is late; None if it is to go on.

        Once the moment is missed, because the user let time go on, it is the next one that counts.
        """
        if left is None:
            self._stopped = False
        elif snapshot.speed == 0.0:
            self._stopped = left == 0
        wanted = None if left is None or self._stopped else snapshot.tick + left
        if snapshot.stops_at != wanted:
            self._studio.bridge.send(StopAt(wanted))

    # ------------------------------------------------------------------------------------------------ looks

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Stay in the corner of the canvas, above the legend where that reaches there."""
        if watched is self._over and event.type() == QEvent.Type.Resize:
            self._place()
        return super().eventFilter(watched, event)

    def _place(self) -> None:
        width = min(WIDTH, self._over.width() - 2 * AWAY)
        height = self.heightForWidth(width)
        left, canvas = self._over.width() - width - AWAY, self._window.canvas
        legend_reaches = canvas.on_top.legend.geometry().right() >= left - AWAY
        below = round(canvas.on_top.below) if legend_reaches else AWAY
        self.setGeometry(left, self._over.height() - height - below, width, height)

    def _dress(self) -> None:
        theme = self._studio.theme
        self.close_button.setIcon(icon("close", theme, "dim"))
        self.setStyleSheet(
            f"#guide {{ background: {theme.palette.raised}; border: 1px solid {theme.palette.accent};"
            " border-radius: 9px; }"
        )


def guide_rows(guide: Guide) -> tuple[ActionRow, ...]:
    """Beginning the lesson."""
    return (
        ActionRow(
            "help.lesson",
            "Guided first lesson",
            "Help",
            lambda _: guide.start(),
            "lesson",
            tip="Teach a first behavior in five minutes, step by step; goes on where it was left",
            icon="school-outline",
        ),
    )
