"""The tool bar: mode, time, speed, seed, undo, and the arm."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QComboBox,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QSizePolicy,
    QSlider,
    QToolBar,
    QToolButton,
    QWidget,
)

from ...engine.commands import Reset
from ...engine.snapshots import Mode
from ..forms.word_list import WordList
from ..icons import icon
from ..letters import plain
from .rows import MOST_SEED, SPEEDS, Speed, is_playing, speed_words, undo_words

if TYPE_CHECKING:
    from ..studio import Studio

#: The field of the seed has room for at least and at most so many digits; longer seeds are scrolled in.
SEED_DIGITS = (5, 10)
#: Pixels of the buttons for reset and undo where there is room to say what they do; of undo at least and at most.
RESET_WORDS, UNDO_WORDS = 80, (170, 420)
#: Pixels that words may take more than they measure: each of the sums around them is rounded.
ROUNDED = 2
#: Pixels of the list of arms, at least; where there is no room for it, it is in what the tool bar opens at its end.
NARROWEST_ARM = 120


class ModeSwitch(QWidget):
    """Teach or Test, as one glance has to tell; the two are the actions ``teach.teach`` and ``teach.test``."""

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self._worn: object = None  # what it is dressed for
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        self.teach = self._button("teach.teach", "left")
        self.test = self._button("teach.test", "right")
        for button in (self.teach, self.test):
            layout.addWidget(button)
        studio.theme.changed.connect(self._dress)
        studio.bridge.mode_changed.connect(self._dress)
        studio.changed.connect(self._dress)
        self._dress()

    def _button(self, action: str, side: str) -> QToolButton:
        button = QToolButton()
        button.setDefaultAction(self._studio.actions[action])
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        button.setObjectName(f"mode-{side}")
        return button

    def _dress(self) -> None:
        theme = self._studio.theme
        colors, mode = theme.palette, self._studio.mode
        on = "#ffffff" if not theme.is_dark else "#16181d"
        chosen = {Mode.TEACHING: ("left", colors.teach)}.get(mode, ("", "")) if mode else ("", "")
        if mode in (Mode.TESTING, Mode.LEARNING):
            chosen = "right", colors.accent
        side, ground = chosen
        if self._worn == (colors, side):
            return
        self._worn = colors, side
        self.setStyleSheet(
            "QToolButton { padding: 4px 12px; font-weight: 600; }"
            "#mode-left { border-top-right-radius: 0; border-bottom-right-radius: 0; }"
            "#mode-right { border-top-left-radius: 0; border-bottom-left-radius: 0; border-left: none; }"
            + (
                f"#mode-{side} {{ background: {ground}; border-color: {ground}; color: {on}; }}"
                if side
                else ""
            )
        )
        actions = self._studio.actions
        for button, action, name in (
            (self.teach, "teach.teach", "school-outline"),
            (self.test, "teach.test", "play-outline"),
        ):
            lit = button.objectName() == f"mode-{side}"
            actions[action].setIcon(icon(name, theme, "panel" if lit else "text"))


class Toolbar(QToolBar):
    """What is used all the time."""

    def __init__(self, studio: Studio, speed: Speed) -> None:
        super().__init__("Tools")
        self.setObjectName("tools")
        self.setMovable(False)
        self.setIconSize(QSize(18, 18))
        self._studio = studio
        self._worn: object = None  # what it is dressed for
        self._speed = speed
        self.mode = ModeSwitch(studio)
        self.addWidget(self.mode)
        self.addSeparator()
        for action in ("run.begin", "run.back", "run.play", "run.step"):
            self._add(action)
        self._add_speed()
        self.addSeparator()
        self._add_seed()
        self.reset = self._add("run.reset")
        self.addSeparator()
        self.undo = self._add("edit.undo")
        self._button_width = self.undo.sizeHint().width()  # without words
        self._around_words = self._measured_around_words()
        self._words_width = 0  # of undo with words; 0 without
        self._longest = 0  # what the longest words took so far, so that nothing moves from step to step
        self._add("edit.redo")
        self.spacer = QWidget()
        self.spacer.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.addWidget(self.spacer)
        self._add_arm()
        studio.bridge.snapshot_changed.connect(self._snapshot_changed)
        studio.changed.connect(self._refresh)
        studio.opened.connect(self._refresh)
        studio.opened.connect(self._begin_words)
        studio.theme.changed.connect(self._dress)
        studio.bridge.mode_changed.connect(self._dress)
        studio.document.history_changed.connect(self._say_what_undo_undoes)
        self.seed.textChanged.connect(self._fit_words)
        self._dress()
        self._refresh()
        self._say_what_undo_undoes()
        if studio.snapshot is not None:  # while time stands still, no other may come
            self._snapshot_changed(studio.snapshot)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Where there is room, reset and undo say what they do; nothing else has to go for it."""
        super().resizeEvent(event)
        self._fit_words()

    def _fit_words(self) -> None:
        now = self._words_width
        taken = RESET_WORDS + now if now else 2 * self._button_width
        room = self.width() - (self.sizeHint().width() - taken) - RESET_WORDS
        least, most = UNDO_WORDS
        wanted = max(least, min(room, most, self._longest)) if room >= least else 0
        if wanted != now:
            self._words_width = wanted
            self._show_words()

    def _show_words(self) -> None:
        style, shown = Qt.ToolButtonStyle, self._words_width > 0
        for button, width in ((self.reset, RESET_WORDS), (self.undo, self._words_width)):
            button.setFixedWidth(width if shown else self._button_width)
            button.setToolButtonStyle(style.ToolButtonTextBesideIcon if shown else style.ToolButtonIconOnly)
        self._elide_words()

    def _begin_words(self) -> None:
        """Another project is open: what was said of the one before needs no room in it."""
        self._longest = 0
        self._say_what_undo_undoes()

    def _measured_around_words(self) -> int:
        """Pixels of the button for undo besides its words, as the style and the font of this machine have it."""
        style = Qt.ToolButtonStyle
        self.undo.setToolButtonStyle(style.ToolButtonTextBesideIcon)
        around = self.undo.sizeHint().width() - self._width_of(self.undo.text())
        self.undo.setToolButtonStyle(style.ToolButtonIconOnly)
        return around

    def _width_of(self, words: str) -> int:
        return self.undo.fontMetrics().horizontalAdvance(words)

    def _say_what_undo_undoes(self) -> None:
        needed = self._width_of(undo_words(self._studio)) + ROUNDED + self._around_words
        self._longest = max(self._longest, needed)
        self._fit_words()
        self._elide_words()

    def _elide_words(self) -> None:
        action, text = self._studio.actions["edit.undo"], undo_words(self._studio)
        room = max(self._words_width, UNDO_WORDS[0]) - self._around_words
        action.setIconText(plain(self.undo.fontMetrics().elidedText(text, Qt.TextElideMode.ElideRight, room)))

    def _add(self, action: str) -> QToolButton:
        button = QToolButton()
        button.setDefaultAction(self._studio.actions[action])
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonIconOnly)
        self.addWidget(button)
        return button

    def _caption(self, text: str) -> QLabel:
        label = QLabel(text)
        label.setProperty("role", "caption")
        self.addWidget(label)
        return label

    def _add_speed(self) -> None:
        self._caption("Speed")
        self.slider = QSlider(Qt.Orientation.Horizontal)
        self.slider.setRange(0, len(SPEEDS) - 1)
        self.slider.setPageStep(1)
        self.slider.setFixedWidth(88)
        self.slider.setAccessibleName("Speed")
        self.slider.setToolTip("How fast time passes: 1 is 60 ticks a second (+ and -)")
        self.slider.setValue(SPEEDS.index(self._speed.chosen))
        self.slider.valueChanged.connect(lambda at: self._speed.choose(self._studio, SPEEDS[at]))
        self.addWidget(self.slider)
        self.speed_words = QLabel(speed_words(self._speed.chosen))
        self.speed_words.setFixedWidth(38)
        self.addWidget(self.speed_words)

    def _add_seed(self) -> None:
        self._caption("Seed")
        self.seed = QLineEdit("1")
        self.seed.textChanged.connect(self._fit_seed)
        self._fit_seed("")
        self.seed.setAccessibleName("Seed")
        self.seed.setToolTip("The seed of the world; Enter begins it again with this one")
        self.seed.returnPressed.connect(self._reset)
        self.addWidget(self.seed)

    def _fit_seed(self, text: str) -> None:
        """Give the field the room that the seed needs: that of a low window is short."""
        least, most = SEED_DIGITS
        digits = max(least, min(len(text), most))
        self.seed.setFixedWidth(self.seed.fontMetrics().horizontalAdvance("0" * digits) + 26)

    def _add_arm(self) -> None:
        self.arm = WordList()
        self.arm.setAccessibleName("Arm")
        self.arm.setToolTip(
            "The arm: which agents and controllers there are, in which world, and what they run"
        )
        self.arm.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.arm.setMinimumContentsLength(14)
        self.arm.setMinimumWidth(NARROWEST_ARM)  # a tool bar would make it narrower than it can be read
        self.arm.setMaximumWidth(200)
        self.arm.activated.connect(lambda _: self._studio.use_arm(self.arm.currentData()))
        self.before_arm = self.addWidget(self.arm)

    def _reset(self) -> None:
        text = self.seed.text().strip()
        if text.isdecimal() and int(text) <= MOST_SEED:
            self._studio.bridge.send(Reset(int(text)))
        else:
            self._studio.warn(f"a seed is a whole number from 0 to {MOST_SEED}, but this one is {text!r}")
        self.seed.clearFocus()

    def _snapshot_changed(self, snapshot: object) -> None:
        seed = str(getattr(snapshot, "seed", ""))
        if not self.seed.hasFocus() and self.seed.text() != seed:
            self.seed.setText(seed)

    def _refresh(self) -> None:
        arms = [arm.name for arm in self._studio.document.project.arms]
        shown = [self.arm.itemData(k) for k in range(self.arm.count())]
        if arms != shown:
            self.arm.clear()
            for arm in self._studio.document.project.arms:
                self.arm.addItem(f"Arm: {arm.name}", arm.name)
        current = self._studio.arm
        if current is not None and current.name in arms:
            self.arm.setCurrentIndex(arms.index(current.name))
        self.arm.setEnabled(bool(arms))
        self.seed.setEnabled(bool(arms))
        self.slider.setValue(SPEEDS.index(self._speed.chosen))
        self.speed_words.setText(speed_words(self._speed.chosen))

    def _dress(self) -> None:
        name, theme = "pause" if is_playing(self._studio) else "play", self._studio.theme
        if self._worn != (theme.palette, name):
            self._worn = theme.palette, name
            self._studio.actions["run.play"].setIcon(icon(name, theme))
            self._dress_more()

    def _dress_more(self) -> None:
        """What opens the rest, where the window is too narrow for all, can be seen as such."""
        more = self.findChild(QToolButton, "qt_toolbar_ext_button")
        assert isinstance(more, QToolButton)
        more.setIcon(icon("chevron-double-right", self._studio.theme))
        more.setToolTip("What there is no room for")
        more.setAccessibleName("More")
