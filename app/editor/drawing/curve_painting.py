"""Drawing charts of experiments with Qt."""

from collections.abc import Sequence
from math import ceil

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPen, QPolygonF

from .brush import Brush, text_width
from .curves import Band, Chart, Dot, Key, Plot, Row
from .painting import apart, steps
from .sheet import Canvas

WIDTH, MARGIN, GAP, BETWEEN = 1200.0, 32.0, 40.0, 36.0
HEADER, KEY, HEAD, LABELS = 68.0, 24.0, 30.0, 46.0
LINES, ROW = 320.0, 30.0
#: Room for numbers left of lines, for names left of rows, and at most for names right of lines.
NUMBERS, NAMES, LINE_NAMES = 52.0, 300.0, 250.0
#: Up to so many plots of lines stand below each other, each line with its name beside it.
MOST_NAMED = 2
BAND_ALPHA = 0.2
DASHES = (
    Qt.PenStyle.SolidLine,
    Qt.PenStyle.DashLine,
    Qt.PenStyle.DotLine,
    Qt.PenStyle.DashDotLine,
)


def painted(chart: Chart, ending: str, *, dark: bool = False) -> bytes:
    """*chart* as the content of a file with this ending: ".png", ".svg" or ".pdf"."""
    canvas = Canvas(chart.title, WIDTH, lambda: height_of(chart), lambda brush: paint_chart(brush, chart))
    return canvas.content(ending, dark=dark)


# -------------------------------------------------------------------------------------------------------- layout


def abreast(chart: Chart) -> int:
    """How many plots stand beside each other."""
    return 1 if len(chart.plots) <= MOST_NAMED or any(plot.rows for plot in chart.plots) else 2


def names_lines(chart: Chart) -> bool:
    """Whether lines have their names beside them."""
    return abreast(chart) == 1


def names_room(chart: Chart) -> float:
    """Room for names right of lines, the same in all plots; none if they do not stand there."""
    labels = [band.label for plot in chart.plots for band in plot.bands] if names_lines(chart) else []
    return min(LINE_NAMES, 34 + max(text_width(label, 13) for label in labels)) if labels else 0.0


def shown_keys(chart: Chart) -> tuple[Key, ...]:
    """The keys above the plots."""
    return () if names_lines(chart) and not any(plot.rows for plot in chart.plots) else chart.keys


def key_lines(chart: Chart) -> list[list[Key]]:
    """The keys, as many on a line as there is room for."""
    lines: list[list[Key]] = []
    room = 0.0
    for key in shown_keys(chart):
        width = 36 + text_width(key.label, 13) + 28
        if not lines or width > room:
            lines.append([])
            room = WIDTH - 2 * MARGIN
        lines[-1].append(key)
        room -= width
    return lines


def plot_height(plot: Plot) -> float:
    """With its title and the numbers below."""
    return HEAD + LABELS + (ROW * len(plot.rows) if plot.rows else LINES)


def height_of(chart: Chart) -> float:
    """The height of the whole chart, in units of layout."""
    columns = abreast(chart)
    lines = [chart.plots[at : at + columns] for at in range(0, len(chart.plots), columns)]
    plots = sum(max(map(plot_height, line)) + BETWEEN for line in lines)
    return ceil(MARGIN + HEADER + KEY * len(key_lines(chart)) + plots - BETWEEN + MARGIN)


# ------------------------------------------------------------------------------------------------------ painting


def paint_chart(brush: Brush, chart: Chart) -> None:
    """All of it, from the top down."""
    room = WIDTH - 2 * MARGIN
    brush.text(MARGIN, MARGIN + 18, chart.title, size=21, bold=True, room=room)
    brush.text(MARGIN, MARGIN + 44, chart.subtitle, size=13, color=brush.colors.dim, room=room)
    top = MARGIN + HEADER
    for line in key_lines(chart):
        _paint_keys(brush, line, top + 4)
        top += KEY
    columns = abreast(chart)
    width = (room - (columns - 1) * GAP) / columns
    for at in range(0, len(chart.plots), columns):
        line_of_plots = chart.plots[at : at + columns]
        for column, plot in enumerate(line_of_plots):
            height = plot_height(plot)
            area = QRectF(MARGIN + column * (width + GAP), top, width, height)
            _paint_plot(brush, plot, area, names_room(chart))
        top += max(map(plot_height, line_of_plots)) + BETWEEN


def _paint_keys(brush: Brush, keys: Sequence[Key], middle: float) -> None:
    x = MARGIN
    for key in keys:
        brush.painter.setPen(_pen(brush, key.color, key.dash, 2.4))
        brush.painter.drawLine(QPointF(x, middle), QPointF(x + 26, middle))
        _paint_mark(brush, QPointF(x + 13, middle), key.color)
        brush.text(x + 36, middle + 4.5, key.label, size=13)
        x += 36 + text_width(key.label, 13) + 28


def _pen(brush: Brush, color: int, dash: int, width: float) -> QPen:
    pen = QPen(QColor(brush.line_color(color)), width, DASHES[dash % len(DASHES)])
    pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
    return pen


def _paint_mark(brush: Brush, center: QPointF, color: int) -> None:
    brush.fill(brush.line_color(color))
    brush.painter.drawEllipse(center, 3.5, 3.5)


def _paint_plot(brush: Brush, plot: Plot, area: QRectF, names: float) -> None:
    brush.text(area.left(), area.top() + 14, plot.title, size=14, bold=True, room=area.width())
    inner = area.adjusted(0, HEAD, 0, -LABELS)
    if plot.rows:
        _paint_rows(brush, plot, inner)
    else:
        _paint_lines(brush, plot, inner, names)


# --------------------------------------------------------------------------------------------------------- lines


def _paint_lines(brush: Brush, plot: Plot, room: QRectF, names: float) -> None:
    longest = max((x for band in plot.bands for x in band.x), default=0.0) or 1.0
    highest = max((y for band in plot.bands for y in band.high), default=0.0)
    area = room.adjusted(NUMBERS, 0, -(names or 12.0), 0)
    ys = steps(highest)
    scale = _Scale(area, longest, ys[-1])
    _paint_axes(brush, scale, ys, longest)
    brush.text(area.right(), area.bottom() + 40, plot.x_title, color=brush.colors.dim, align="right")
    for band in plot.bands:
        _paint_band(brush, band, scale)
    for band in plot.bands:
        _paint_line(brush, band, scale)
    if names:
        _paint_names(brush, [band for band in plot.bands if band.y], scale, names - 34)


class _Scale:
    """From numbers to places."""

    def __init__(self, area: QRectF, longest: float, highest: float) -> None:
        self.area = area
        self._longest = longest
        self._highest = highest

    def at(self, x: float, y: float) -> QPointF:
        return QPointF(self.x(x), self.y(y))

    def x(self, x: float) -> float:
        return self.area.left() + x / self._longest * self.area.width()

    def y(self, y: float) -> float:
        return self.area.bottom() - max(y, 0.0) / self._highest * self.area.height()


def _paint_axes(brush: Brush, scale: _Scale, ys: Sequence[float], longest: float) -> None:
    for y in ys:
        brush.pen(brush.colors.hairline)
        brush.painter.drawLine(scale.at(0, y), QPointF(scale.area.right(), scale.y(y)))
        brush.text(scale.area.left() - 8, scale.y(y) + 4, f"{y:,g}", color=brush.colors.dim, align="right")
    for x in steps(longest, 6):
        if x <= longest:
            where = scale.x(x)
            brush.text(where, scale.area.bottom() + 20, f"{x:,.0f}", color=brush.colors.dim, align="center")


def _paint_band(brush: Brush, band: Band, scale: _Scale) -> None:
    there = [scale.at(x, y) for x, y in zip(band.x, band.high, strict=True)]
    back = [scale.at(x, y) for x, y in zip(band.x, band.low, strict=True)]
    color = QColor(brush.line_color(band.color))
    color.setAlphaF(BAND_ALPHA)
    brush.painter.setPen(Qt.PenStyle.NoPen)
    brush.painter.setBrush(color)
    brush.painter.drawPolygon(QPolygonF([*there, *reversed(back)]))


def _paint_line(brush: Brush, band: Band, scale: _Scale) -> None:
    points = [scale.at(x, y) for x, y in zip(band.x, band.y, strict=True)]
    brush.painter.setPen(_pen(brush, band.color, band.dash, 2.2))
    brush.painter.setBrush(Qt.BrushStyle.NoBrush)
    brush.painter.drawPolyline(QPolygonF(points))
    for point in points if band.marks else ():
        _paint_mark(brush, point, band.color)


def _paint_names(brush: Brush, bands: Sequence[Band], scale: _Scale, room: float) -> None:
    """Names at the ends of the lines, kept apart."""
    ordered = sorted(bands, key=lambda band: -band.y[-1])
    ends = [scale.y(band.y[-1]) for band in ordered]
    for band, middle in zip(ordered, apart(ends, 20.0), strict=True):
        brush.swatch(scale.area.right() + 12, middle, band.color)
        brush.text(scale.area.right() + 28, middle + 4.5, band.label, size=13, room=room + 1)


# ---------------------------------------------------------------------------------------------------------- rows


def _paint_rows(brush: Brush, plot: Plot, room: QRectF) -> None:
    longest = max((dot.high for row in plot.rows for dot in row.dots), default=0.0) or 1.0
    area = room.adjusted(NAMES, 0, -12.0, 0)
    ticks = steps(longest, 8)
    scale = _Scale(area, ticks[-1], 1.0)
    for x in ticks:
        brush.pen(brush.colors.hairline)
        brush.painter.drawLine(scale.at(x, 0), scale.at(x, 1))
        where = scale.x(x)
        brush.text(where, area.bottom() + 20, f"{x:,g}", color=brush.colors.dim, align="center")
    brush.text(area.right(), area.bottom() + 40, plot.x_title, color=brush.colors.dim, align="right")
    for number, row in enumerate(plot.rows):
        _paint_row(brush, row, area.top() + (number + 0.5) * ROW, room.left(), scale)


def _paint_row(brush: Brush, row: Row, middle: float, left: float, scale: _Scale) -> None:
    brush.text(left, middle + 4.5, row.label, size=13, room=NAMES - 20)
    spread = min(5.0, (ROW - 8) / max(len(row.dots), 1))
    first = middle - spread * (len(row.dots) - 1) / 2
    for number, dot in enumerate(row.dots):
        _paint_dot(brush, dot, first + spread * number, scale)


def _paint_dot(brush: Brush, dot: Dot, at: float, scale: _Scale) -> None:
    brush.painter.setPen(_pen(brush, dot.color, 0, 1.8))
    brush.painter.drawLine(QPointF(scale.x(dot.low), at), QPointF(scale.x(dot.high), at))
    _paint_mark(brush, QPointF(scale.x(dot.mean), at), dot.color)
