"""Geometry that scenarios share, in functions that engines can compile."""

from math import cos, pi, sin, sqrt, tau
from typing import Any


def distance(world: Any, a: int, b: int) -> float:
    """Between the centers of two entities, in world units."""
    return sqrt(square_distance(world, a, b))


def square_distance(world: Any, a: int, b: int) -> float:
    """The square of `distance`: comparing squares spares the roots."""
    dx: float = world.x[b] - world.x[a]
    dy: float = world.y[b] - world.y[a]
    return dx * dx + dy * dy


def heading_cos(world: Any, entity: int) -> float:
    """The cosine of an entity's heading. Compiled, it is remembered until the entity turns."""
    return cos(world.heading[entity])


def heading_sin(world: Any, entity: int) -> float:
    """The sine of an entity's heading. Compiled, it is remembered until the entity turns."""
    return sin(world.heading[entity])


def wrapped(angle: float) -> float:
    """The same angle in [-pi, pi), in radians."""
    turned = (angle + pi) % tau
    return turned - pi if turned < tau else -pi  # the remainder of a tiny negative number rounds up to tau


def clamped(value: float, high: float) -> float:
    """*value* put into [0, high]."""
    if value < 0.0:
        return 0.0
    return min(value, high)
