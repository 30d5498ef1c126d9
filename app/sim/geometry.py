"""Geometry that scenarios share, in functions that engines can compile."""

from math import pi, sqrt, tau
from typing import Any


def distance(world: Any, a: int, b: int) -> float:
    """Between the centers of two entities, in world units."""
    dx = world.x[b] - world.x[a]
    dy = world.y[b] - world.y[a]
    return sqrt(dx * dx + dy * dy)


def wrapped(angle: float) -> float:
    """The same angle in [-pi, pi), in radians."""
    turned = (angle + pi) % tau
    return turned - pi if turned < tau else -pi  # the remainder of a tiny negative number rounds up to tau


def clamped(value: float, high: float) -> float:
    """*value* put into [0, high]."""
    if value < 0.0:
        return 0.0
    return min(value, high)
