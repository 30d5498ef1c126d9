"""What the window shows while no project is open: how to begin, what ships with Understudy, and what was open before."""

from __future__ import annotations

from datetime import datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QSize, Qt, QTimer, Signal
from PySide6.QtGui import QHideEvent, QIcon, QShowEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ...core.errors import UnderstudyError
from ...core.storage import file_is_there
from ...engine.shipped import shipped_projects
from ..icons import icon
from ..letters import plain
from ..theme import text_font
from .background import Background
from .thumbnails import Preview, preview, thumbnail
from .words import clock

if TYPE_CHECKING:
    from ..studio import Studio

WIDTH = 760
PICTURE = QSize(220, 132)


class WelcomePage(QScrollArea):
    """The welcome page.

    Attributes:
        shipped: Buttons of the projects that ship, by folder.
        previews: What pictures show, by folder; they come one after the other.
        recent: Buttons of recent projects, by folder.
        removers: Buttons that take a recent project out of the list, by folder.

    Signals:
        chosen: The user wants to open the project in this folder.
    """

    chosen = Signal(object)

    def __init__(self, studio: Studio) -> None:
        super().__init__()
        self._studio = studio
        self._background = Background(self)
        self.previews: dict[Path, Preview] = {}
        self._asked: set[Path] = set()
        self.shipped: dict[Path, QToolButton] = {}
        self.recent: dict[Path, QPushButton] = {}
        self.removers: dict[Path, QToolButton] = {}
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        studio.settings.changed.connect(self._setting_changed)
        studio.theme.changed.connect(self.fill)

    def showEvent(self, event: QShowEvent) -> None:
        """Show what is there now; pictures come when they are drawn."""
        super().showEvent(event)
        self.fill()
        # Not for a page that gives way at once to a project that is being opened.
        QTimer.singleShot(0, self, self._ask)

    def hideEvent(self, event: QHideEvent) -> None:
        """Wait for no more pictures; those that are missing are asked for again when the page is back."""
        self._background.close()
        self._asked = set(self.previews)
        super().hideEvent(event)

    def _ask(self) -> None:
        for folder in shipped_projects():
            if self.isVisible() and folder not in self._asked:
                self._asked.add(folder)
                self._background.do(partial(preview, folder), self._drawn, self._undrawn)

    def _setting_changed(self, name: str) -> None:
        if name == "recent":
            self.fill()

    def _drawn(self, found: Preview) -> None:
        self.previews[found.folder] = found
        if found.folder in self.shipped:
            self._dress(found.folder)

    def _undrawn(self, error: UnderstudyError) -> None:
        self._studio.warn(str(error))

    # ------------------------------------------------------------------------------------------------ filling

    def fill(self) -> None:
        """Build the page anew."""
        if not self.isVisible():
            return
        self.shipped, self.recent, self.removers = {}, {}, {}
        page = QWidget()
        column = QVBoxLayout()
        column.setSpacing(10)
        column.addWidget(self._heading())
        column.addLayout(self._ways_to_begin())
        column.addSpacing(14)
        column.addWidget(_caption("Projects to look at"))
        column.addLayout(self._shipped())
        if self._studio.settings.recent:
            column.addSpacing(14)
            column.addWidget(_caption("Recent"))
            for folder in self._studio.settings.recent:
                column.addLayout(self._recent(folder))
        column.addStretch(1)
        middle = QHBoxLayout(page)
        middle.setContentsMargins(24, 40, 24, 24)
        middle.addStretch(1)
        frame = QWidget()
        frame.setLayout(column)
        frame.setFixedWidth(WIDTH)
        middle.addWidget(frame)
        middle.addStretch(1)
        self.setWidget(page)

    def _heading(self) -> QWidget:
        heading = QWidget()
        layout = QVBoxLayout(heading)
        layout.setContentsMargins(0, 0, 0, 14)
        layout.setSpacing(4)
        title = QLabel("Understudy")
        title.setFont(text_font(26, bold=True))
        what = QLabel("Teach behaviors to groups of simulated agents by showing them.")
        what.setProperty("role", "empty")
        layout.addWidget(title)
        layout.addWidget(what)
        return heading

    def _ways_to_begin(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(8)
        for action_id, text in (
            ("help.lesson", "Start the guided first lesson"),
            ("file.new", "New project…"),
            ("file.open", "Open…"),
        ):
            if action_id in self._studio.actions.rows:
                row.addWidget(self._way(action_id, text))
        row.addStretch(1)
        return row

    def _way(self, action_id: str, text: str) -> QPushButton:
        action = self._studio.actions[action_id]
        button = QPushButton(action.icon(), text)
        button.setObjectName(f"welcome-{action_id}")
        button.setToolTip(action.toolTip())
        button.setMinimumHeight(36)
        button.clicked.connect(action.trigger)
        return button

    def _shipped(self) -> QHBoxLayout:
        row = QHBoxLayout()
        row.setSpacing(16)
        for folder in shipped_projects():
            row.addWidget(self._card(folder))
        row.addStretch(1)
        return row

    def _card(self, folder: Path) -> QToolButton:
        button = self.shipped[folder] = QToolButton()
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
        button.setIconSize(PICTURE)
        button.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        button.setFixedSize(PICTURE.width() + 20, PICTURE.height() + 44)
        button.clicked.connect(lambda: self.chosen.emit(folder))
        self._dress(folder)
        return button

    def _dress(self, folder: Path) -> None:
        """Show on a card what is known of its project by now; the card itself stays under the mouse."""
        button, found = self.shipped[folder], self.previews.get(folder)
        name = found.name if found else folder.name
        button.setText(plain(name))
        button.setToolTip(f"{found.note}\n{folder}" if found and found.note else str(folder))
        button.setAccessibleName(f"Open {name}")
        if found is not None and found.view is not None:
            colors, ratio = self._studio.theme.palette, self.devicePixelRatioF()
            drawn = thumbnail(found.view, colors, PICTURE.width(), PICTURE.height(), ratio)
            button.setIcon(QIcon(drawn))
        else:
            button.setIcon(icon("image-outline", self._studio.theme, "hairline"))

    def _recent(self, folder: Path) -> QHBoxLayout:
        there = file_is_there(folder / "project.json")
        row = QHBoxLayout()
        row.setSpacing(8)
        button = QPushButton(folder.name)
        button.setEnabled(there)
        button.setMinimumWidth(180)
        button.setToolTip(f"Open {folder}")
        button.setStyleSheet("text-align: left;")
        button.clicked.connect(lambda: self.chosen.emit(folder))
        where = QLabel(str(folder.parent) if there else f"{folder.parent} – not there any more")
        where.setProperty("role", "caption")
        where.setTextFormat(Qt.TextFormat.PlainText)
        where.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        where.setToolTip(str(folder))
        when = QLabel(_when(self._studio.settings.recent_times.get(folder, "")))
        when.setProperty("role", "caption")
        remove = QToolButton()
        remove.setProperty("flat", "true")
        remove.setIcon(icon("close", self._studio.theme, "dim"))
        remove.setToolTip(f"Take {folder.name} out of this list; the project itself stays")
        remove.setAccessibleName(f"Forget {folder.name}")
        remove.clicked.connect(lambda: self._studio.settings.forget(folder))
        row.addWidget(button)
        row.addWidget(where, 1)
        row.addWidget(when)
        row.addWidget(remove)
        self.recent[folder], self.removers[folder] = button, remove
        return row


def _caption(text: str) -> QLabel:
    label = QLabel(text)
    label.setProperty("role", "title")
    return label


def _when(text: str) -> str:
    try:
        return clock(datetime.fromisoformat(text))
    except ValueError:
        return ""
