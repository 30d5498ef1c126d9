"""Drawing figures with Qt, the same into pixels, SVG and PDF."""

from collections.abc import Sequence
from math import ceil, floor, log10

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPen

from .brush import Brush, text_width
from .figures import Body, Figure, Series, Walker
from .sheet import Canvas
from .world_painting import CAPTION, paint_body, paint_cross, paint_walker, paint_world

WIDTH, MARGIN, GAP = 1200.0, 32.0, 24.0
HEADER, CHART, LEGEND = 82.0, 330.0, 34.0
#: Room for numbers left of the chart, for its titles above and below, and at most for names right of it.
NUMBERS, TITLE, LABELS, NAMES = 44.0, 16.0, 42.0, 230.0
WORLDS_ABREAST = 3


def painted(figure: Figure, ending: str, *, dark: bool = False) -> bytes:
    """*figure* as the content of a file with this ending: ".png", ".svg" or ".pdf"."""
    canvas = Canvas(figure.title, WIDTH, lambda: height_of(figure), lambda brush: paint_figure(brush, figure))
    return canvas.content(ending, dark=dark)


# -------------------------------------------------------------------------------------------------------- layout


def rows_of(figure: Figure) -> int:
    """How many rows of worlds stand below the chart; a single world stands beside it."""
    return 0 if len(figure.worlds) < 2 else ceil(len(figure.worlds) / WORLDS_ABREAST)


def world_side(figure: Figure) -> float:
    """The edge of the square that a world gets."""
    if len(figure.worlds) == 1:
        return CHART
    abreast = min(len(figure.worlds), WORLDS_ABREAST)
    return min(360.0, (WIDTH - 2 * MARGIN - (abreast - 1) * GAP) / max(abreast, 1))


def chart_height(figure: Figure) -> float:
    """As high as a single world beside it with its title, or the usual height."""
    return CHART + CAPTION if len(figure.worlds) == 1 else CHART


def height_of(figure: Figure) -> float:
    """The height of the whole figure, in units of layout."""
    below = rows_of(figure) * (world_side(figure) + CAPTION + GAP)
    legend = LEGEND if figure.legend else 0.0
    return ceil(MARGIN + HEADER + chart_height(figure) + GAP + below + legend + MARGIN / 2)


def steps(highest: float, most: int = 5, least: float = 0.0) -> tuple[float, ...]:
    """Round numbers from 0 up to *highest* or just above it: 0, 5, 10, 15.

    Args:
        most: How many steps at most.
        least: A step is at least this much; 1 where halves mean nothing.
    """
    if highest <= 0:
        return (0.0, 1.0)
    raw = max(highest / most, least)
    power = 10.0 ** floor(log10(raw))
    step = next(factor * power for factor in (1, 2, 5, 10) if factor * power >= raw * (1 - 1e-9))
    return tuple(step * k for k in range(ceil(highest / step - 1e-9) + 1))


def apart(wanted: Sequence[float], distance: float) -> list[float]:
    """Places near the *wanted* ones, which are sorted, with at least *distance* between neighbors.

    Who is too near to the one before moves on; then everyone moves back by half of what the last one moved.
    """
    places: list[float] = []
    for place in wanted:
        places.append(max(place, places[-1] + distance) if places else place)
    shift = (places[-1] - wanted[-1]) / 2 if places else 0.0
    return [place - shift for place in places]


# ------------------------------------------------------------------------------------------------------ painting


def paint_figure(brush: Brush, figure: Figure) -> None:
    """All of it, from the top down."""
    side, room = world_side(figure), WIDTH - 2 * MARGIN
    brush.text(MARGIN, MARGIN + 18, figure.title, size=21, bold=True, room=room)
    brush.text(MARGIN, MARGIN + 44, figure.subtitle, size=13, color=brush.colors.dim, room=room)
    top = MARGIN + HEADER
    if len(figure.worlds) == 1:
        room -= side + GAP
        paint_world(brush, figure.worlds[0], QRectF(WIDTH - MARGIN - side, top, side, side))
    _paint_chart(brush, figure, QRectF(MARGIN, top, room, chart_height(figure)))
    top += chart_height(figure) + GAP
    for index, world in enumerate(figure.worlds if len(figure.worlds) > 1 else ()):
        row, column = divmod(index, WORLDS_ABREAST)
        at = QPointF(MARGIN + column * (side + GAP), top + row * (side + CAPTION + GAP))
        paint_world(brush, world, QRectF(at.x(), at.y(), side, side))
    _paint_legend(brush, figure, height_of(figure) - MARGIN / 2 - LEGEND / 2)


def _paint_chart(brush: Brush, figure: Figure, room: QRectF) -> None:
    longest = max((x for series in figure.series for x in series.x), default=0.0) or 1.0
    numbers = [y for series in figure.series for y in series.y]
    whole = all(y == int(y) for y in numbers)
    ys = steps(max(numbers, default=0.0), least=1.0 if whole else 0.0)
    names = [s for s in figure.series if s.label and s.y]
    right = min(NAMES, 34 + max((text_width(s.label, 13) for s in names), default=0.0)) if names else 8.0
    plot = room.adjusted(NUMBERS, TITLE, -right, -LABELS)
    _paint_axes(brush, plot, [x for x in steps(longest, 6) if x <= longest], ys, longest)
    brush.text(plot.left(), room.top() + 2, figure.y_title, color=brush.colors.dim)
    brush.text(plot.right(), room.bottom() - 4, figure.x_title, color=brush.colors.dim, align="right")
    for series in sorted(figure.series, key=lambda s: not s.faint):
        _paint_line(brush, series, plot, longest, ys[-1])
    _paint_names(brush, names, plot, ys[-1], right - 34)


def _paint_axes(brush: Brush, plot: QRectF, xs: Sequence[float], ys: Sequence[float], longest: float) -> None:
    for y in ys:
        at = plot.bottom() - y / ys[-1] * plot.height()
        brush.pen(brush.colors.hairline)
        brush.painter.drawLine(QPointF(plot.left(), at), QPointF(plot.right(), at))
        brush.text(plot.left() - 8, at + 4, f"{y:,g}", color=brush.colors.dim, align="right")
    for x in xs:
        at = plot.left() + x / longest * plot.width()
        brush.text(at, plot.bottom() + 20, f"{x:,.0f}", color=brush.colors.dim, align="center")


def _paint_line(brush: Brush, series: Series, plot: QRectF, longest: float, highest: float) -> None:
    color = QColor(brush.line_color(series.color))
    color.setAlphaF(0.35 if series.faint else 1.0)
    # The later a line is drawn the thinner it is, so that one that runs on top of another does not hide it.
    pen = QPen(color, 1.0 if series.faint else max(4.8 - 1.3 * series.color, 2.2))
    pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
    brush.painter.setPen(pen)
    points = [
        QPointF(plot.left() + x / longest * plot.width(), plot.bottom() - y / highest * plot.height())
        for x, y in zip(series.x, series.y, strict=True)
    ]
    brush.painter.drawPolyline(points)


def _paint_names(brush: Brush, series: Sequence[Series], plot: QRectF, highest: float, room: float) -> None:
    """Names at the ends of the lines, kept apart."""
    ordered = sorted(series, key=lambda s: -s.y[-1])
    ends = [plot.bottom() - s.y[-1] / highest * plot.height() for s in ordered]
    for one, at in zip(ordered, apart(ends, 20.0), strict=True):
        brush.swatch(plot.right() + 12, at, one.color)
        brush.text(plot.right() + 28, at + 4.5, one.label, size=13, room=room + 1)


def _paint_legend(brush: Brush, figure: Figure, middle: float) -> None:
    x = MARGIN + 8
    for mark, words in figure.legend.items():
        _paint_mark(brush, mark, QPointF(x, middle))
        brush.text(x + 14, middle + 4, words, color=brush.colors.dim)
        x += 14 + text_width(words) + 28


def _paint_mark(brush: Brush, mark: str, center: QPointF) -> None:
    match mark:
        case "agent" | "busy":
            paint_walker(brush, Walker(0.0, 0.0, 0.0, busy=mark == "busy"), center)
        case "body" | "full":
            paint_body(brush, Body(0.0, 0.0, 1.0, got=int(mark == "full"), needed=1), center, 5.5)
        case "place":
            paint_cross(brush, center, 4.0)
