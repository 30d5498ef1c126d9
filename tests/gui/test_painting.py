"""Figures as they are painted: laid out, in every format, on light and dark ground."""

from dataclasses import replace
from itertools import pairwise
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtGui import QColor, QImage
from pytestqt.qtbot import QtBot

from app.editor.drawing.figures import Body, Figure, Series, Walker, WorldView
from app.editor.drawing.painting import WIDTH, apart, height_of, painted, steps
from app.editor.drawing.sheet import SCALE
from app.editor.palette import DARK, LIGHT

WORLD = WorldView(
    "alone",
    "2 agents",
    0,
    0.0,
    0.0,
    10.0,
    10.0,
    (Walker(2.0, 2.0, 0.0), Walker(8.0, 2.0, 1.0, busy=True)),
    (
        Body(5.0, 8.0, 1.0, got=5, needed=5),
        Body(9.9, 5.0, 1.0, got=1, needed=5),
        Body(5.0, 5.0, 1.0, place=True),
    ),
)
LEGEND = {"agent": "agent", "busy": "busy", "body": "box", "full": "full box", "place": "deposit"}
SERIES = (
    Series("alone: 3", 0, (0.0, 10.0), (0.0, 3.0)),
    Series("", 1, (0.0, 10.0), (0.0, 2.0), faint=True),
    Series(
        "a name that is much too long to stand at the end of a line, so it is cut", 1, (0.0, 10.0), (0.0, 3.0)
    ),
)
FIGURE = Figure("Title", "subtitle", "ticks", "boxes", SERIES, (WORLD, WORLD, WORLD), LEGEND)


def image(figure: Figure, *, dark: bool = False) -> QImage:
    return QImage.fromData(painted(figure, ".png", dark=dark))


def has(picture: QImage, color: str) -> bool:
    pixels = np.frombuffer(picture.convertToFormat(QImage.Format.Format_RGB32).constBits(), np.uint32)
    return bool((pixels == QColor(color).rgb()).any())


@pytest.mark.parametrize("worlds", [0, 1, 2, 3, 4])
def test_a_figure_is_as_high_as_its_worlds_ask_for(qtbot: QtBot, worlds: int) -> None:
    figure = replace(FIGURE, worlds=(WORLD,) * worlds)
    picture = image(figure)
    assert (picture.width(), picture.height()) == (WIDTH * SCALE, height_of(figure) * SCALE)


@pytest.mark.parametrize("dark", [False, True])
def test_what_is_full_busy_and_drawn_shows_in_its_color(qtbot: QtBot, *, dark: bool) -> None:
    colors = DARK if dark else LIGHT
    picture = image(FIGURE, dark=dark)
    assert picture.pixelColor(1, 1) == QColor(colors.panel)
    assert all(
        has(picture, color) for color in (colors.good, colors.accent, colors.canvas, *colors.lines[:1])
    )


@pytest.mark.parametrize(
    ("ending", "beginning"), [(".png", b"\x89PNG"), (".svg", b"<?xml"), (".pdf", b"%PDF")]
)
def test_every_format_is_what_its_ending_says(qtbot: QtBot, ending: str, beginning: bytes) -> None:
    assert painted(FIGURE, ending).startswith(beginning)


def test_an_svg_is_shown_at_the_size_of_its_layout(qtbot: QtBot) -> None:
    root = ET.fromstring(painted(FIGURE, ".svg"))
    assert root.get("viewBox") == f"0 0 {WIDTH:g} {height_of(FIGURE):g}"
    # A millimeter is 96 / 25.4 pixels of CSS.
    assert float(root.get("width", "").removesuffix("mm")) * 96 / 25.4 == pytest.approx(WIDTH, abs=1)


def test_the_same_figure_gives_the_same_pixels(qtbot: QtBot) -> None:
    assert painted(FIGURE, ".png") == painted(FIGURE, ".png")


@pytest.mark.parametrize(
    "series",
    [(), (Series("a", 0, (), ()),), (Series("a", 0, (0.0,), (0.0,)),)],
    ids=["none", "empty", "one point"],
)
def test_where_there_is_little_to_show_a_figure_is_drawn_all_the_same(
    qtbot: QtBot, series: tuple[Series, ...]
) -> None:
    assert not image(replace(FIGURE, series=series, worlds=())).isNull()


@given(st.floats(1e-6, 1e9), st.integers(2, 8))
def test_steps_reach_the_highest_value_in_few_even_round_steps(highest: float, most: int) -> None:
    marks = steps(highest, most)
    assert marks[0] == 0.0
    assert marks[-1] >= highest * (1 - 1e-6)
    assert len(marks) - 1 <= most
    assert f"{marks[1]:e}"[0] in "125"


@pytest.mark.parametrize(
    ("highest", "marks"), [(0.0, (0.0, 1.0)), (3.0, (0.0, 1.0, 2.0, 3.0)), (12.0, (0.0, 5.0, 10.0, 15.0))]
)
def test_counts_are_marked_by_whole_numbers(highest: float, marks: tuple[float, ...]) -> None:
    assert steps(highest, least=1.0) == marks


@given(st.lists(st.floats(0, 1000), max_size=6).map(sorted))
def test_names_keep_apart_and_in_order(wanted: list[float]) -> None:
    places = apart(wanted, 20.0)
    assert all(b - a >= 20.0 - 1e-6 for a, b in pairwise(places))
    if all(b - a >= 20.0 for a, b in pairwise(wanted)):
        assert places == wanted
