"""The card of the first lesson: what to do next, how far it is, and leaving it."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QObject, QSize, Qt
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
from .corners import AWAY, corners, lies_upon
from .ring import Ring
from .scratch import NAME, lacks_wander, scratch_project, with_wander
from .steps import SECOND, STEPS, Seen, picked_state

if TYPE_CHECKING:
    from ...engine.snapshots import Snapshot
    from ..window.main_window import MainWindow

WIDTH = 330
#: What the button that goes on says, and its tip.
SKIP = "Skip", "Go on without doing this"
NEXT = "Next", "Go on; time passes as before"
CLOSE = "Close", "The lesson is over; Help, Guided first lesson begins it again"
#: Said of a step that asks for what is so already.
SO_ALREADY = "That is so already: press Next."
#: The speed that the lesson begins at, whatever was watched before: at many times that, each moment would be missed.
PACE = 1.0
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
        self._is_so_already = False  # what the step asks for, since before it began
        self._to_do = 0  # the first later step that asked for something not done when this one began
        self._is_above = False  # in the upper corner
        self.setObjectName("guide")
        self.setAccessibleName("Guided first lesson")
        self.ring = Ring(window, self._studio.theme)
        self.title, self.words, self.progress = QLabel(), QLabel(), QLabel()
        self.bar = QProgressBar()
        self.close_button, self.back, self.skip = QToolButton(), QPushButton("Back"), QPushButton("Skip")
        self._build()
        over.installEventFilter(self)
        window.canvas.on_top.legend.resized.connect(self._place)
        window.canvas.looking.changed.connect(self._keep_clear)
        studio = self._studio
        studio.selection.nodes_changed.connect(self._keep_clear)
        studio.bridge.snapshot_changed.connect(self._keep_clear)
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
            self._window.speed.choose(self._studio, PACE)
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
        seen = self._seen()
        self._is_so_already = STEPS[self.step].done(seen)
        self._to_do = next(
            (n for n in range(self.step + 1, len(STEPS)) if not STEPS[n].done(seen)), len(STEPS)
        )
        self._say_step()

    def _say_step(self) -> None:
        """What to do; who finds it done already has read what it is about before going on."""
        now, is_so = STEPS[self.step], self._is_so_already
        self.title.setText(now.title)
        self.words.setText(f"{now.text}\n\n{SO_ALREADY}" if is_so else now.text)
        self.progress.setText(f"Step {self.step + 1} of {len(STEPS)}")
        self._offer_to_go_on(*(NEXT if now.is_watched or is_so else SKIP))
        self.ring.point_at("" if is_so else now.points_at)
        self._place()

    def _seen(self) -> Seen:
        """What the user has done since the step began."""
        snapshot = self._studio.snapshot
        tick = 0 if snapshot is None else snapshot.tick
        self._from_tick = min(self._from_tick, tick)  # the world may have begun again
        return Seen(self._studio, self._picked, tick - self._from_tick)

    def _skip(self) -> None:
        """Go on; the second half gets what it needs of a first one that was not done."""
        if self.step == len(STEPS):
            self.leave()
            return
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
            "the foraging project (Open recent in the menu File), where groups of agents have controllers that were "
            "taught the same way."
        )
        self.progress.setText("Done")
        self._offer_to_go_on(*CLOSE)
        self.ring.point_at("")
        self._place()

    def _offer_to_go_on(self, words: str, tip: str) -> None:
        self.skip.setText(words)
        self.skip.setToolTip(tip)

    def _event_came(self, event: object) -> None:
        picked = picked_state(event)
        if picked:
            self._picked = picked
            self._look()

    def _look(self, *_: object) -> None:
        """Go on if the user has done what the step asks for."""
        if not self.isVisible() or self.step >= len(STEPS):
            return
        snapshot, seen, step = self._studio.snapshot, self._seen(), STEPS[self.step]
        is_done = step.done(seen)
        if self._is_ahead(seen, is_done=is_done):
            self._go(self._to_do + 1)
            return
        if is_done:
            if not self._is_so_already:
                self._go(self.step + 1)
            return
        if self._is_so_already:
            self._is_so_already = False
            self._say_step()
        if snapshot is not None:
            step.prepares(self._studio)
            self._stop_in_time(snapshot, step.stops(seen))

    def _is_ahead(self, seen: Seen, *, is_done: bool) -> bool:
        """Whether the user has done what only a later step asks for, where this one keeps nobody from it."""
        if not is_done and not STEPS[self.step].is_watched:
            return False
        return any(step.done(replace(seen, ticks=0)) for step in STEPS[self._to_do : self._to_do + 1])

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
        """Stay in a corner of the canvas."""
        if watched is self._over and event.type() == QEvent.Type.Resize:
            self._place()
        return super().eventFilter(watched, event)

    def leaveEvent(self, event: QEvent) -> None:
        """No button is about to be pressed any more."""
        super().leaveEvent(event)
        self._keep_clear()

    def _place(self) -> None:
        width = min(WIDTH, self._over.width() - 2 * AWAY)
        size = QSize(width, self.heightForWidth(width))
        self.setGeometry(corners(self._window.canvas, size)[self._is_above])
        self._keep_clear()

    def _keep_clear(self) -> None:
        """Go to the other corner where it lies upon who is selected; not while the mouse is about to press a button."""
        if not self.isVisible() or self.underMouse():
            return
        canvas, node = self._window.canvas, self._studio.selection.node
        both = corners(canvas, self.size())
        if lies_upon(both[self._is_above], canvas, node) and not lies_upon(
            both[not self._is_above], canvas, node
        ):
            self._is_above = not self._is_above
            self.setGeometry(both[self._is_above])

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
