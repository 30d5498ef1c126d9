"""What every drawing of ours is made of: text, swatches and lines in the colors of the palette."""

from collections.abc import Iterator
from contextlib import contextmanager

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPen

from ..palette import Palette


class Brush:
    """A painter that knows the palette.

    Attributes:
        painter: Qt's.
        colors: Where to take colors from.
    """

    def __init__(self, painter: QPainter, colors: Palette) -> None:
        self.painter = painter
        self.colors = colors

    def pen(self, color: str, width: float = 1.0, style: Qt.PenStyle = Qt.PenStyle.SolidLine) -> None:
        """Draw outlines like this, and fill nothing."""
        self.painter.setPen(QPen(QColor(color), width, style))
        self.painter.setBrush(Qt.BrushStyle.NoBrush)

    def fill(self, color: str) -> None:
        """Fill with this color, without an outline."""
        self.painter.setPen(Qt.PenStyle.NoPen)
        self.painter.setBrush(QColor(color))

    def line_color(self, number: int) -> str:
        """The color of the *number*-th line; they come round again."""
        return self.colors.lines[number % len(self.colors.lines)]

    def swatch(self, x: float, middle: float, color: int) -> None:
        """The small square that says which line is meant."""
        self.fill(self.line_color(color))
        self.painter.drawRoundedRect(QRectF(x, middle - 5, 10, 10), 3, 3)

    def text(
        self,
        x: float,
        baseline: float,
        text: str,
        *,
        size: int = 12,
        color: str = "",
        bold: bool = False,
        align: str = "left",
        room: float = 0.0,
    ) -> None:
        """One line of text that begins, has its middle, or ends at *x*; cut off where it needs more than *room*."""
        font = _font(size, bold=bold)
        metrics = QFontMetricsF(font)
        if room > 0.0:
            text = metrics.elidedText(text, Qt.TextElideMode.ElideRight, room)
        shift = {"left": 0.0, "center": 0.5, "right": 1.0}[align] * metrics.horizontalAdvance(text)
        self.painter.setFont(font)
        self.painter.setPen(QColor(color or self.colors.text))
        self.painter.drawText(QPointF(x - shift, baseline), text)

    @contextmanager
    def clipped(self, area: QRectF) -> Iterator[None]:
        """Draw nothing outside *area*."""
        self.painter.save()
        self.painter.setClipRect(area)
        yield
        self.painter.restore()


def text_width(text: str, size: int = 12) -> float:
    """How wide a line of text is."""
    return QFontMetricsF(_font(size)).horizontalAdvance(text)


def _font(size: int, *, bold: bool = False) -> QFont:
    font = QFont("sans-serif")
    font.setPixelSize(size)
    font.setWeight(QFont.Weight.DemiBold if bold else QFont.Weight.Normal)
    return font
