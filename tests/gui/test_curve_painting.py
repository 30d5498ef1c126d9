"""Charts of experiments as they are painted: in every format, with their bands, named one way or another."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtGui import QColor, QImage
from pytestqt.qtbot import QtBot

from app.editor.drawing.curve_painting import (
    BAND_ALPHA,
    WIDTH,
    abreast,
    height_of,
    key_lines,
    names_room,
    painted,
    shown_keys,
)
from app.editor.drawing.curves import Band, Chart, Dot, Key, Plot, Row
from app.editor.drawing.sheet import SCALE
from app.editor.palette import DARK, LIGHT

WIDE = Band("one level", 0, 0, (0.0, 10.0), (0.0, 8.0), (0.0, 5.0), (0.0, 11.0))
NARROW = Band("alone", 1, 1, (0.0, 10.0), (0.0, 3.0), (0.0, 3.0), (0.0, 3.0), marks=True)
LINES = Plot("Boxes", "ticks", (WIDE, NARROW))
ROWS = Plot("Boxes", "boxes", rows=(Row("as usual", (Dot(0, 3.0, 2.0, 4.0), Dot(1, 5.0, 5.0, 5.0))),))
KEYS = (Key("one level", 0), Key("alone", 1, 1))
CHART = Chart("Title", "subtitle", (LINES,), KEYS)


def image(chart: Chart, *, dark: bool = False) -> QImage:
    return QImage.fromData(painted(chart, ".png", dark=dark))


def count(picture: QImage, color: QColor) -> int:
    pixels = np.frombuffer(picture.convertToFormat(QImage.Format.Format_RGB32).constBits(), np.uint32)
    return int((pixels == color.rgb()).sum())


def in_band(line: str, ground: str) -> QColor:
    """The color of a band where nothing else is drawn."""
    over, under = QColor(line), QColor(ground)
    red, green, blue = (
        round(BAND_ALPHA * a + (1 - BAND_ALPHA) * b)
        for a, b in (
            (over.red(), under.red()),
            (over.green(), under.green()),
            (over.blue(), under.blue()),
        )
    )
    return QColor(red, green, blue)


@pytest.mark.parametrize(
    "plots", [(), (LINES,), (LINES,) * 2, (LINES,) * 3, (LINES,) * 4, (ROWS, LINES), (ROWS,) * 3]
)
def test_a_chart_is_as_high_as_its_plots_ask_for(qtbot: QtBot, plots: tuple[Plot, ...]) -> None:
    chart = replace(CHART, plots=plots)
    picture = image(chart)
    assert (picture.width(), picture.height()) == (WIDTH * SCALE, height_of(chart) * SCALE)


@pytest.mark.parametrize(
    ("ending", "beginning"), [(".png", b"\x89PNG"), (".svg", b"<?xml"), (".pdf", b"%PDF")]
)
def test_every_format_is_what_its_ending_says(qtbot: QtBot, ending: str, beginning: bytes) -> None:
    assert painted(CHART, ending).startswith(beginning)


@pytest.mark.parametrize("dark", [False, True])
def test_the_band_of_confidence_shows_around_its_line(qtbot: QtBot, *, dark: bool) -> None:
    colors = DARK if dark else LIGHT
    picture = image(CHART, dark=dark)
    band = in_band(colors.lines[0], colors.panel)
    near = sum(
        count(picture, QColor(band.red() + r, band.green() + g, band.blue() + b))
        for r in (-1, 0, 1)
        for g in (-1, 0, 1)
        for b in (-1, 0, 1)
    )
    assert near > 10_000
    assert count(picture, QColor(colors.lines[0])) > 500


def test_few_lines_are_named_beside_them_and_many_plots_share_a_key(qtbot: QtBot) -> None:
    many = replace(CHART, plots=(LINES,) * 4)
    assert (abreast(CHART), shown_keys(CHART)) == (1, ())
    assert names_room(CHART) > 60
    assert (abreast(many), shown_keys(many), names_room(many)) == (2, KEYS, 0.0)
    assert shown_keys(replace(CHART, plots=(ROWS,))) == KEYS


def test_keys_go_on_the_next_line_where_there_is_no_room(qtbot: QtBot) -> None:
    keys = tuple(Key("a name of some length, as arms have them", number) for number in range(9))
    lines = key_lines(replace(CHART, plots=(ROWS,), keys=keys))
    assert len(lines) > 1
    assert [key for line in lines for key in line] == list(keys)


def test_a_chart_without_numbers_is_drawn_all_the_same(qtbot: QtBot) -> None:
    empty = Band("none", 0, 0, (), (), (), ())
    assert not image(replace(CHART, plots=(Plot("Boxes", "ticks", (empty,)), Plot("x", "y")))).isNull()
