"""What is kept from one frame to the next, since it takes long to make: drawn agents and laid-out words."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import QPointF, QSizeF, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPixmap, QStaticText, QTransform

from ..theme import text_font
from .atlas import LARGEST, Atlas, Look, Style

#: Words, pixmaps and atlases kept; more than any world has of different ones, and few enough to forget what is out of use.
MOST_WORDS, MOST_PIXMAPS, MOST_ATLASES = 2000, 400, 3


class Ink:
    """Atlases by style and words by size."""

    def __init__(self) -> None:
        self._atlases: list[Atlas] = []
        self._words: dict[tuple[str, int, bool], QStaticText] = {}
        self._pixmaps: dict[tuple[object, ...], QPixmap] = {}
        self._fonts: dict[tuple[int, bool], QFont] = {}

    def atlas(self, looks: Sequence[Look], style: Style) -> Atlas:
        """An atlas of these looks, a bit larger or smaller than asked for, so that few are ever made."""
        size = min(style.size, LARGEST)
        size = round(size) if size >= 8 else round(size * 2) / 2
        style = Style(size, style.ratio, style.ground, style.text)
        wanted = tuple(looks)
        for atlas in self._atlases:
            if atlas.style == style and atlas.looks == wanted:
                return atlas
        made = Atlas(wanted, style)
        self._atlases = [made, *self._atlases[: MOST_ATLASES - 1]]
        return made

    def pixmap(self, key: tuple[object, ...], draw: Callable[[], QPixmap]) -> QPixmap:
        """What was drawn under this key, or is now."""
        if key not in self._pixmaps:
            if len(self._pixmaps) >= MOST_PIXMAPS:
                self._pixmaps.clear()
            self._pixmaps[key] = draw()
        return self._pixmaps[key]

    def size(self, words: str, pixels: int, *, bold: bool = False) -> QSizeF:
        """How much room words take."""
        return self._text(words, pixels, bold).size()

    def write(
        self,
        painter: QPainter,
        at: QPointF,
        words: str,
        color: QColor,
        pixels: int = 11,
        *,
        bold: bool = False,
        centered: bool = False,
    ) -> None:
        """Write words at their left, or around their middle."""
        text = self._text(words, pixels, bold)
        size = text.size()
        left = at.x() - size.width() / 2 if centered else at.x()
        painter.setFont(self._font(pixels, bold))
        painter.setPen(color)
        painter.drawStaticText(QPointF(left, at.y() - size.height() / 2), text)

    def _text(self, words: str, pixels: int, bold: bool) -> QStaticText:  # noqa: FBT001 - a key's part
        key = (words, pixels, bold)
        if key not in self._words:
            if len(self._words) >= MOST_WORDS:
                self._words.clear()
            text = QStaticText(words)
            text.setTextFormat(Qt.TextFormat.PlainText)
            text.prepare(QTransform(), self._font(pixels, bold))
            self._words[key] = text
        return self._words[key]

    def _font(self, pixels: int, bold: bool) -> QFont:  # noqa: FBT001 - a key's part
        key = (pixels, bold)
        if key not in self._fonts:
            self._fonts[key] = text_font(pixels, bold=bold)
        return self._fonts[key]
