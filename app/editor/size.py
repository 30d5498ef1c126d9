"""How large text and controls are: by Qt's own factor, which it reads once, before there is an application."""

import os

from .settings import SIZES

FACTOR = "QT_SCALE_FACTOR"
#: Pixels of the window's own that it needs from left to right.
LEAST = 1080


def use_size(percent: int) -> None:
    """Let everything be so large; only before there is an application, and only where the user's shell is silent."""
    if percent != 100:
        os.environ.setdefault(FACTOR, f"{percent / 100:g}")


def size_in_force() -> int:
    """In percent, as it was when the program started."""
    try:
        return round(100 * float(os.environ.get(FACTOR, "1")))
    except ValueError:
        return 100


def sizes_that_fit(width: int, now: int, chosen: int) -> tuple[int, ...]:
    """The sizes at which the window fits on a screen, and the one that is chosen.

    Args:
        width: The screen's in pixels of the window's own, which are larger the larger everything is.
        now: The size in force.
    """
    return tuple(p for p in SIZES if p in (100, chosen) or width * now / p >= LEAST)
