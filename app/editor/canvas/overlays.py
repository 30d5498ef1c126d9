"""What lies on the canvas: the badge of the mode, banners, the card under the mouse, and the buttons of the camera."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint, QSize, Qt
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ...engine.snapshots import Mode
from ..icons import icon
from ..letters import plain
from .words import badge_words

if TYPE_CHECKING:
    from ..studio import Studio

#: The buttons of the camera, from top to bottom.
CAMERA = ("canvas.zoom_in", "canvas.zoom_out", "canvas.fit", "canvas.follow")
SIDE = 28


class CameraButtons(QWidget):
    """Zoom in, zoom out, fit, follow: one below the other."""

    def __init__(self, studio: Studio, parent: QWidget) -> None:
        super().__init__(parent)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(6)
        for name in CAMERA:
            button = QToolButton()
            button.setDefaultAction(studio.actions[name])
            button.setAccessibleName(studio.actions.text_of(name))
            button.setFixedSize(SIDE, SIDE)
            button.setIconSize(QSize(16, 16))
            button.setStyleSheet("QToolButton { padding: 0; }")
            layout.addWidget(button)
        self.adjustSize()


class Badge(QLabel):
    """Says what the session is for: red while somebody is taught, in the accent color during a test.

    Attributes:
        words: What it says; empty where nobody is taught.
    """

    def __init__(self, studio: Studio, parent: QWidget) -> None:
        super().__init__(parent)
        self._studio = studio
        self.words = ""
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.refresh()

    def refresh(self) -> None:
        """As things are now."""
        studio = self._studio
        self.words = words = badge_words(studio)
        colors = studio.theme.palette
        ground = colors.teach if studio.mode is Mode.TEACHING else colors.accent
        text = "#ffffff" if not studio.theme.is_dark else "#10131a"
        mark = "●" if studio.mode is Mode.TEACHING else "▷"
        self.setText(f"{mark} {words}" if words else "")
        self.setAccessibleName(words or "Nobody is taught")
        style = (
            f"QLabel {{ background: {ground}; color: {text}; border-radius: 6px; padding: 4px 10px;"
            " font-weight: 600; }"
        )
        if style != self.styleSheet():  # Qt would go through it again all the same
            self.setStyleSheet(style)
        self.setVisible(bool(words))
        self.adjustSize()


@dataclass(frozen=True, slots=True)
class Notice:
    """What a banner says.

    Attributes:
        grave: Something has failed.
        button: What its button says; empty if there is none.
        act: What the button does.
    """

    words: str
    grave: bool = False
    button: str = ""
    act: Callable[[], object] | None = None


class Banner(QFrame):
    """One line, or a few, across the top of the canvas, with a button where something can be done."""

    def __init__(self, studio: Studio, parent: QWidget, name: str) -> None:
        super().__init__(parent)
        self._studio = studio
        self.setObjectName(name)
        self.notice: Notice | None = None
        self._icon = QLabel()
        self.words = QLabel()
        self.words.setTextFormat(Qt.TextFormat.PlainText)
        self.words.setWordWrap(True)
        self.words.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.button = QPushButton()
        self.button.clicked.connect(self._act)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(12, 6, 8, 6)
        layout.setSpacing(10)
        for widget in (self._icon, self.words, self.button):
            layout.addWidget(widget, 1 if widget is self.words else 0)
        self.hide()

    def show_notice(self, notice: Notice | None) -> None:
        """Say this, or nothing."""
        if notice == self.notice:
            return
        self.notice = notice
        self.setVisible(notice is not None)
        if notice is not None:
            self.words.setText(notice.words)
            self.button.setText(plain(notice.button))
            self.button.setAccessibleName(notice.button)
            self.button.setVisible(bool(notice.button))
            self.dress()

    def dress(self) -> None:
        """In the colors of the palette."""
        grave = self.notice is not None and self.notice.grave
        colors = self._studio.theme.palette
        name = "alert-circle-outline" if grave else "information-outline"
        tone = "teach" if grave else "accent"
        self._icon.setPixmap(icon(name, self._studio.theme, tone).pixmap(QSize(18, 18)))
        self.setStyleSheet(
            f"#{self.objectName()} {{ background: {colors.raised}; border: 1px solid {colors.hairline};"
            f" border-left: 3px solid {getattr(colors, tone)}; border-radius: 7px; }}"
        )

    def fit_into(self, width: int) -> None:
        """As wide as the words ask for, but no wider than this; as high as they need then."""
        asked = self.words.fontMetrics().horizontalAdvance(self.words.text()) + 90
        if self.button.isVisibleTo(self):
            asked += self.button.sizeHint().width() + 10
        wide = min(width, asked)
        self.resize(wide, max(38, self.heightForWidth(wide)))

    def _act(self) -> None:
        if self.notice is not None and self.notice.act is not None:
            self.notice.act()


class Card(QLabel):
    """Who is under the mouse, what it does, and what it sees; above whatever else lies over the canvas."""

    def __init__(self, studio: Studio, parent: QWidget) -> None:
        super().__init__(parent)
        self._studio = studio
        self._room = parent
        self.lines: tuple[str, ...] = ()
        self.setObjectName("card")
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.dress()
        self.hide()

    def tell(self, lines: Sequence[str], x: float, y: float) -> None:
        """Say this beside a pixel, within the canvas."""
        if tuple(lines) != self.lines:
            self.lines = tuple(lines)
            first, *rest = (escape(line).replace("    ", "&nbsp;&nbsp;&nbsp;") for line in lines)
            dim = self._studio.theme.palette.dim
            self.setText(
                "<br>".join(
                    [f"<b>{first}</b>", *(f"<span style='color:{dim}'>{line}</span>" for line in rest)]
                )
            )
            self.adjustSize()
        room = self._room.rect()
        left = x + 18 if x + 18 + self.width() < room.width() - 4 else x - 14 - self.width()
        top = min(max(y - self.height() / 2, 4.0), room.height() - self.height() - 4.0)
        over = self._room.parentWidget() or self._room
        if self.parentWidget() is not over:  # the canvas has found its place only after it was made
            self.setParent(over)
        self.move(self._room.mapTo(over, QPoint(int(max(left, 4.0)), int(top))))
        self.show()
        self.raise_()

    def dress(self) -> None:
        """In the colors of the palette."""
        colors = self._studio.theme.palette
        self.lines = ()
        self.setStyleSheet(
            f"#card {{ background: {colors.raised}; border: 1px solid {colors.hairline}; border-radius: 7px;"
            " padding: 6px 9px; font-size: 12px; }"
        )
