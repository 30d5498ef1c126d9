"""Icons of one family, Material Design from qtawesome, in the colors of the palette."""

import qtawesome
from PySide6.QtCore import QRect, QSize
from PySide6.QtGui import QColor, QIcon, QIconEngine, QPainter, QPalette, QPixmap

from .theme import Theme, off_words


def icon(name: str, theme: Theme, color: str = "text") -> QIcon:
    """The icon *name* of the family, such as ``play``, in a color of the palette by its name."""
    return QIcon(_Kept(name, theme.color(color), off_words(theme.palette)))


def icon_in(name: str, palette: QPalette) -> QIcon:
    """The same in the colors that words have in a palette of Qt's."""
    role = QPalette.ColorRole.WindowText
    return QIcon(_Kept(name, palette.color(role), palette.color(QPalette.ColorGroup.Disabled, role)))


class _Kept(QIconEngine):
    """Draws an icon once for each size and mode: the window is painted over and over, and a glyph takes ten calls.

    The family is asked for it only then: most icons are in menus that nobody opens before the theme changes again.
    """

    def __init__(self, name: str, color: QColor, off: QColor) -> None:
        super().__init__()
        self._name, self._color, self._off = name, color, off
        self._pixmaps: dict[tuple[int, int, QIcon.Mode, QIcon.State], QPixmap] = {}

    def pixmap(self, size: QSize, mode: QIcon.Mode, state: QIcon.State) -> QPixmap:
        """The icon in pixels of the screen."""
        key = size.width(), size.height(), mode, state
        if key not in self._pixmaps:
            drawn = qtawesome.icon(f"mdi6.{self._name}", color=self._color, color_disabled=self._off)
            self._pixmaps[key] = drawn.pixmap(size, 1.0, mode, state)
        return self._pixmaps[key]

    def paint(self, painter: QPainter, rect: QRect, mode: QIcon.Mode, state: QIcon.State) -> None:
        """Paint it into a part of what is being painted."""
        ratio = painter.device().devicePixelRatio()
        painter.drawPixmap(rect, self.pixmap(rect.size() * ratio, mode, state))
