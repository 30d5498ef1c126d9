"""What drawings are made on: pixels, SVG and PDF, all of the same layout."""

from collections.abc import Callable

from PySide6.QtCore import QBuffer, QIODevice, QMarginsF, QPointF, QRectF, QSizeF
from PySide6.QtGui import QColor, QGuiApplication, QImage, QPageSize, QPaintDevice, QPainter, QPdfWriter
from PySide6.QtSvg import QSvgGenerator

from ..palette import DARK, LIGHT, Palette
from .brush import Brush

#: A unit of layout is a pixel of CSS.
PIXELS_PER_INCH = 96
#: Pixels of a PNG to a unit of layout: sharp on dense screens.
SCALE = 2

#: Draws everything, in units of layout.
Draw = Callable[[Brush], None]


class Canvas:
    """A sheet of paper of a certain size that a drawing goes on."""

    def __init__(self, title: str, width: float, height: Callable[[], float], draw: Draw) -> None:
        self._title = title
        self._width = width
        self._height = height
        self._draw = draw

    def content(self, ending: str, *, dark: bool = False) -> bytes:
        """The drawing as the content of a file with this ending: ".png", ".svg" or ".pdf"."""
        application = QGuiApplication.instance() or QGuiApplication(["understudy"])
        # The height may measure text, so it is not asked for before there is an application.
        size = QSizeF(self._width, self._height())
        buffer = QBuffer()
        buffer.open(QIODevice.OpenModeFlag.WriteOnly)
        palette = DARK if dark else LIGHT
        {".png": self._png, ".svg": self._svg, ".pdf": self._pdf}[ending](size, buffer, palette)
        del application  # Qt needs it to exist until here
        return bytes(buffer.data().data())

    def _png(self, size: QSizeF, buffer: QBuffer, palette: Palette) -> None:
        image = QImage((size * SCALE).toSize(), QImage.Format.Format_RGB32)
        image.setDevicePixelRatio(SCALE)
        self._paint(image, size, palette)
        image.save(buffer, "PNG")  # type: ignore[call-overload] # the stubs ask for bytes, Qt for text

    def _svg(self, size: QSizeF, buffer: QBuffer, palette: Palette) -> None:
        generator = QSvgGenerator()
        generator.setOutputDevice(buffer)
        generator.setSize(size.toSize())
        generator.setViewBox(QRectF(QPointF(), size))
        generator.setResolution(PIXELS_PER_INCH)
        generator.setTitle(self._title)
        self._paint(generator, size, palette)

    def _pdf(self, size: QSizeF, buffer: QBuffer, palette: Palette) -> None:
        writer = QPdfWriter(buffer)
        writer.setResolution(PIXELS_PER_INCH)
        writer.setPageSize(QPageSize(size * (72 / PIXELS_PER_INCH), QPageSize.Unit.Point))
        writer.setPageMargins(QMarginsF())
        writer.setTitle(self._title)
        self._paint(writer, size, palette)

    def _paint(self, device: QPaintDevice, size: QSizeF, palette: Palette) -> None:
        painter = QPainter(device)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(QRectF(QPointF(), size), QColor(palette.panel))
        self._draw(Brush(painter, palette))
        painter.end()
