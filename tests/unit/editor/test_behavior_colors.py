"""Colors of behaviors are seen on every ground, and told apart."""

import pytest
from PySide6.QtGui import QColor

from app.editor.behavior_colors import luminance, nth_color
from app.editor.palette import DARK, LIGHT, OKABE_ITO, Palette

#: Generated colors that are looked at, and how much they stand out at least: all are as good as those of Okabe and Ito that are
#: dark on dark ground, and better than those that are light on light ground.
MANY, ENOUGH = 60, 2.0


@pytest.mark.parametrize("colors", [DARK, LIGHT], ids=["dark", "light"])
@pytest.mark.parametrize("ground", ["panel", "raised", "canvas"])
def test_generated_colors_stand_out_from_every_ground(colors: Palette, ground: str) -> None:
    behind = luminance(QColor(getattr(colors, ground)))
    for place in range(len(OKABE_ITO), MANY):
        dark, bright = sorted((behind, luminance(nth_color(place))))
        assert (bright + 0.05) / (dark + 0.05) >= ENOUGH, nth_color(place).name()


def test_no_two_behaviors_have_the_same_color() -> None:
    names = {nth_color(place).name() for place in range(MANY)}
    assert len(names) == MANY
