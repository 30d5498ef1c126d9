"""A behavior as a large button: swatch, name, how many examples, key."""

from __future__ import annotations

from enum import StrEnum
from functools import lru_cache

from PySide6.QtCore import QEvent, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QEnterEvent, QFontMetricsF, QKeySequence, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QWidget

from ..theme import CAPTION, Theme, mixed, text_font

HEIGHT, EDGE, SWATCH, KEY, GAP = 40, 8, 11, 18, 8
LONGEST_NAME = 190
RADIUS, RING = 8.0, 2.0


class Ring(StrEnum):
    """What the ring around a button says: the node does this, is about to, or neither."""

    NONE = "none"
    NEXT = "next"
    NOW = "now"


class BehaviorButton(QAbstractButton):
    """One behavior that can be picked.

    Attributes:
        color: Of its swatch.
        key: Shown on it.
        ring: Whether the node does this.
        ring_color: A color of the palette by its name: ``teach`` or ``accent``.
    """

    def __init__(
        self, theme: Theme, name: str, color: QColor, key: str, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._theme = theme
        self.color = color
        self._caption = ""
        self._ghost = False
        self._dimmed = False
        self.key = key
        self.ring = Ring.NONE
        self.ring_color = "teach"
        self.setText(name)
        self.setShortcut(
            QKeySequence()
        )  # Qt takes an ampersand in the name, which is painted as it is, for a mark
        self.setAccessibleName(name)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)

    def dress(self, *, caption: str = "", ghost: bool = False, dimmed: bool = False) -> None:
        """Say *caption* below the name; a *ghost* is no state yet; what is *dimmed* hardly makes sense now."""
        if (caption, ghost, dimmed) != (self._caption, self._ghost, self._dimmed):
            self._caption, self._ghost, self._dimmed = caption, ghost, dimmed
            self.updateGeometry()
            self.update()

    def show_ring(self, ring: Ring, color: str) -> None:
        """Say whether the node does this."""
        if (ring, color) != (self.ring, self.ring_color):
            self.ring, self.ring_color = ring, color
            said = {Ring.NOW: "it does this now", Ring.NEXT: "it does this from the next tick on"}
            self.setAccessibleDescription(said.get(ring, ""))
            self.update()

    def sizeHint(self) -> QSize:
        """As wide as its words."""
        words = min(LONGEST_NAME, _words_width(self.text(), self._caption)) + 6
        key = KEY + GAP if self.key else 0
        return QSize(round(EDGE + SWATCH + GAP + words + key + EDGE), HEIGHT)

    def minimumSizeHint(self) -> QSize:
        """Never smaller."""
        return self.sizeHint()

    def enterEvent(self, event: QEnterEvent) -> None:
        """Light up."""
        self.update()
        super().enterEvent(event)

    def leaveEvent(self, event: QEvent) -> None:
        """Go dark."""
        self.update()
        super().leaveEvent(event)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw it."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._paint_ground(painter)
        colors = self._theme.palette
        faint = self._dimmed or not self.isEnabled()
        left = EDGE
        swatch = QRectF(left, (self.height() - SWATCH) / 2, SWATCH, SWATCH)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(mixed(self.color.name(), colors.panel, 0.5 if faint else 0.0))
        painter.drawRoundedRect(swatch, 3, 3)
        left += SWATCH + GAP
        words = self.width() - left - EDGE - (KEY + GAP if self.key else 0)
        self._paint_words(painter, left, words, colors.dim if self._ghost or faint else colors.text)
        if self.key:
            self._paint_key(painter, faint=faint)

    def _paint_ground(self, painter: QPainter) -> None:
        colors = self._theme.palette
        inner = QRectF(self.rect()).adjusted(1.5, 1.5, -1.5, -1.5)
        ground = QColor(colors.panel if self._ghost else colors.raised)
        if self.underMouse() and self.isEnabled():
            ground = mixed(colors.accent, ground.name(), 0.88)
        if self.isDown():
            ground = mixed(colors.accent, ground.name(), 0.75)
        edge = QPen(
            QColor(colors.hairline), 1.0, Qt.PenStyle.DashLine if self._ghost else Qt.PenStyle.SolidLine
        )
        if self.hasFocus():
            edge = QPen(QColor(colors.accent), 1.0)
        if self.ring is not Ring.NONE:
            style = Qt.PenStyle.SolidLine if self.ring is Ring.NOW else Qt.PenStyle.DashLine
            edge = QPen(self._theme.color(self.ring_color), RING, style)
        painter.setPen(edge)
        painter.setBrush(ground)
        painter.drawRoundedRect(inner, RADIUS, RADIUS)

    def _paint_words(self, painter: QPainter, left: float, width: float, color: str) -> None:
        font = text_font()
        name = QFontMetricsF(font).elidedText(self.text(), Qt.TextElideMode.ElideRight, width)
        painter.setFont(font)
        painter.setPen(QColor(color))
        middle = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        if not self._caption:
            painter.drawText(QRectF(left, 0, width, self.height()), middle, name)
            return
        painter.drawText(QRectF(left, 4, width, 18), middle, name)
        painter.setFont(text_font(CAPTION - 1))
        painter.setPen(QColor(self._theme.palette.dim))
        painter.drawText(QRectF(left, 21, width, 14), middle, self._caption)

    def _paint_key(self, painter: QPainter, *, faint: bool) -> None:
        colors = self._theme.palette
        chip = QRectF(self.width() - EDGE - KEY, (self.height() - KEY) / 2, KEY, KEY)
        painter.setPen(QPen(QColor(colors.hairline), 1.0))
        painter.setBrush(QColor(colors.panel))
        painter.drawRoundedRect(chip, 4, 4)
        painter.setFont(text_font(CAPTION))
        painter.setPen(mixed(colors.dim, colors.panel, 0.45) if faint else QColor(colors.text))
        painter.drawText(chip, Qt.AlignmentFlag.AlignCenter, self.key)


@lru_cache(maxsize=1_000)  # asked for many times whenever buttons are placed
def _words_width(name: str, caption: str) -> float:
    """Pixels that the longer of the two lines takes."""
    return max(
        QFontMetricsF(text_font()).horizontalAdvance(name),
        QFontMetricsF(text_font(CAPTION - 1)).horizontalAdvance(caption),
    )
