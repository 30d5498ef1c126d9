"""The colors of the program can be read."""

import pytest
from PySide6.QtGui import QColor

from app.editor.palette import DARK, LIGHT, Palette
from app.editor.theme import chosen_ground, hovered_ground

#: What the Web Content Accessibility Guidelines ask of text.
ENOUGH = 4.5
PALETTES = pytest.mark.parametrize("colors", [DARK, LIGHT], ids=["dark", "light"])


def luminance(color: QColor) -> float:
    parts = [
        part / 12.92 if part <= 0.03928 else ((part + 0.055) / 1.055) ** 2.4
        for part in (color.redF(), color.greenF(), color.blueF())
    ]
    return sum(weight * part for weight, part in zip((0.2126, 0.7152, 0.0722), parts, strict=True))


def contrast(one: QColor, other: QColor) -> float:
    dark, bright = sorted((luminance(one), luminance(other)))
    return (bright + 0.05) / (dark + 0.05)


@PALETTES
@pytest.mark.parametrize("text", ["text", "dim"])
@pytest.mark.parametrize("ground", ["background", "panel", "raised", "canvas"])
def test_words_stand_out_from_every_ground(colors: Palette, text: str, ground: str) -> None:
    assert contrast(QColor(getattr(colors, text)), QColor(getattr(colors, ground))) >= ENOUGH


@PALETTES
@pytest.mark.parametrize("text", ["accent", "good", "teach"])
@pytest.mark.parametrize("ground", ["panel", "raised"])
def test_colored_words_stand_out_from_panels(colors: Palette, text: str, ground: str) -> None:
    assert contrast(QColor(getattr(colors, text)), QColor(getattr(colors, ground))) >= ENOUGH


@PALETTES
@pytest.mark.parametrize("text", ["text", "dim"])
def test_words_stand_out_from_rows_that_are_chosen_or_under_the_mouse(colors: Palette, text: str) -> None:
    for ground in (chosen_ground(colors), hovered_ground(colors)):
        assert contrast(QColor(getattr(colors, text)), ground) >= ENOUGH
