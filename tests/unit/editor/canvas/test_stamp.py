"""Pixmaps that are put in many places are drawn around their middle, as sharp as the screen is."""

import pytest
from PySide6.QtCore import QRectF, QSizeF
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QApplication

from app.editor.canvas.stamp import stamp


@pytest.mark.parametrize("ratio", [1.0, 1.5, 2.0])
def test_what_is_drawn_around_the_origin_is_in_the_middle_and_all_else_is_transparent(
    qapp: QApplication, ratio: float
) -> None:
    def draw(painter: QPainter) -> None:
        painter.fillRect(QRectF(-2.0, -2.0, 4.0, 4.0), QColor("#102030"))

    pixmap = stamp(QSizeF(8.0, 8.0), ratio, draw)
    image = pixmap.toImage()
    side = round(8 * ratio)
    assert (image.width(), image.height(), pixmap.devicePixelRatio()) == (side, side, ratio)
    inside = [image.pixelColor(k, side // 2).alpha() == 255 for k in range(side)]
    assert inside == inside[::-1]
    assert sum(inside) == round(4 * ratio)
    assert image.pixelColor(0, 0).alpha() == 0
