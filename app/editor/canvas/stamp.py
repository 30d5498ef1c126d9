"""Pixmaps that are drawn once and put in many places."""

from collections.abc import Callable
from math import ceil

from PySide6.QtCore import QSizeF, Qt
from PySide6.QtGui import QPainter, QPixmap


def stamp(size: QSizeF, ratio: float, draw: Callable[[QPainter], object]) -> QPixmap:
    """A pixmap, transparent but for what *draw* paints around the origin, which is its middle.

    Args:
        size: Pixels of the view.
        ratio: Pixels of the screen to one of the view.
    """
    pixmap = QPixmap(ceil(size.width() * ratio), ceil(size.height() * ratio))
    pixmap.setDevicePixelRatio(ratio)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.translate(pixmap.width() / ratio / 2, pixmap.height() / ratio / 2)
    draw(painter)
    painter.end()
    return pixmap
