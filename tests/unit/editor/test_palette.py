"""The colors of the program can be read."""

import pytest
from PySide6.QtGui import QColor, QPalette

from app.editor.palette import DARK, LIGHT, Palette
from app.editor.style_sheet import HOVERED_ROLE
from app.editor.theme import chosen_ground, hovered_ground, off_words, qt_palette

#: What the Web Content Accessibility Guidelines ask of text.
ENOUGH = 4.5
#: What they ask of what is no text, or large; of what is disabled they ask nothing.
LEGIBLE = 3.0
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
@pytest.mark.parametrize("ground", ["background", "panel", "raised"])
def test_colored_words_stand_out_from_panels(colors: Palette, text: str, ground: str) -> None:
    assert contrast(QColor(getattr(colors, text)), QColor(getattr(colors, ground))) >= ENOUGH


@PALETTES
@pytest.mark.parametrize("text", ["text", "dim", "accent", "good", "teach"])
def test_words_stand_out_from_rows_that_are_chosen_or_under_the_mouse(colors: Palette, text: str) -> None:
    for ground in (chosen_ground(colors), hovered_ground(colors)):
        assert contrast(QColor(getattr(colors, text)), ground) >= ENOUGH


@PALETTES
@pytest.mark.parametrize("text", ["text", "dim"])
def test_words_stand_out_from_buttons_under_the_mouse(colors: Palette, text: str) -> None:
    assert contrast(QColor(getattr(colors, text)), qt_palette(colors).color(HOVERED_ROLE)) >= ENOUGH


@PALETTES
@pytest.mark.parametrize("ground", ["accent", "teach"])
def test_words_on_what_tells_the_mode_stand_out(colors: Palette, ground: str) -> None:
    words = qt_palette(colors).color(QPalette.ColorRole.HighlightedText)
    assert contrast(words, QColor(getattr(colors, ground))) >= ENOUGH


@PALETTES
@pytest.mark.parametrize("ground", ["panel", "raised"])
def test_what_is_not_possible_now_can_still_be_read(colors: Palette, ground: str) -> None:
    off = off_words(colors)
    assert contrast(off, QColor(getattr(colors, ground))) >= LEGIBLE
    assert contrast(off, QColor(getattr(colors, ground))) < contrast(
        QColor(colors.dim), QColor(getattr(colors, ground))
    )
