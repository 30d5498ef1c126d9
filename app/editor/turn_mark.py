"""The number of who is taught by turns: filled for the one whose turn it is, so that it does not depend on a color."""

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen

from .palette import Palette
from .theme import text_font

#: Pixels: height of a mark, of its number, and beside the number.
HEIGHT, DIGITS, BESIDE = 15.0, 10, 4.0


def mark_width(number: int) -> float:
    """Pixels: a circle, or longer for more digits."""
    words = QFontMetricsF(text_font(DIGITS, bold=True)).horizontalAdvance(str(number))
    return max(HEIGHT, words + 2 * BESIDE)


def paint_mark(painter: QPainter, number: int, palette: Palette, *, its_turn: bool) -> None:
    """Paint a mark around the origin."""
    color, ground = QColor(palette.teach), QColor(palette.canvas)
    width = mark_width(number)
    box = QRectF(-width / 2, -HEIGHT / 2, width, HEIGHT).adjusted(0.5, 0.5, -0.5, -0.5)
    painter.setPen(QPen(color, 1.0))
    painter.setBrush(color if its_turn else ground)
    painter.drawRoundedRect(box, HEIGHT / 2, HEIGHT / 2)
    painter.setFont(text_font(DIGITS, bold=its_turn))
    painter.setPen(ground if its_turn else color)
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, str(number))
