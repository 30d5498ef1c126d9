# mypy: disable-error-code="no-untyped-def"
# numba finds out the types itself.
"""Compiled twins of what scenarios share: the same chance, to the bit, and the same angles, faster."""

from math import cos, pi, sin, tau

import numpy as np
from numba import njit

from ...core import chance
from .. import geometry

_GOLDEN, _WHO, _TICK = np.uint64(chance.GOLDEN), np.uint64(chance.WHO), np.uint64(chance.TICK)
_MIX_1, _MIX_2 = np.uint64(chance.MIX_1), np.uint64(chance.MIX_2)
_30, _27, _31, _11 = np.uint64(30), np.uint64(27), np.uint64(31), np.uint64(11)
_U = np.uint64
_UNIT, _PI, _TAU = chance.UNIT, pi, tau
_FIRST_SCENARIO_DRAW = chance.FIRST_SCENARIO_DRAW


@njit(forceinline=True)
def _mix(value):
    value = (value ^ (value >> _30)) * _MIX_1
    value = (value ^ (value >> _27)) * _MIX_2
    return value ^ (value >> _31)


@njit(forceinline=True)
def draw(key, tick, who, number):
    """`app.core.chance.draw`."""
    first = _mix(_U(key) + _U(tick) * _TICK + _U(who) * _WHO)
    return np.float64(_mix(first + _U(number) * _GOLDEN) >> _11) * _UNIT


@njit(forceinline=True)
def uniform(clock, who, number):
    """`app.core.chance.uniform`."""
    return draw(clock[3], clock[2], who, _FIRST_SCENARIO_DRAW + number)


@njit(forceinline=True)
def wrapped(angle):
    """`app.sim.geometry.wrapped` without dividing where one turn more or less is exact."""
    turned = angle + _PI
    if turned < 0.0 and turned >= -_TAU:
        turned = turned + _TAU
    elif turned >= _TAU and turned < 2.0 * _TAU:
        turned = turned - _TAU
    elif not (turned >= 0.0 and turned < _TAU):
        turned = turned % _TAU
    return turned - _PI if turned < _TAU else -_PI


@njit(forceinline=True)
def _know(world, entity):
    """Let the remembered cosine and sine be those of the heading; bits tell 0.0 from -0.0, whose sines differ."""
    bits = world.heading_bits[entity]
    if world.known_heading[entity] != bits:
        world.known_heading[entity] = bits
        world.known_cos[entity] = cos(world.heading[entity])
        world.known_sin[entity] = sin(world.heading[entity])


@njit(forceinline=True)
def heading_cos(world, entity):
    """`app.sim.geometry.heading_cos`, computed only where the entity has turned."""
    _know(world, entity)
    return world.known_cos[entity]


@njit(forceinline=True)
def heading_sin(world, entity):
    """`app.sim.geometry.heading_sin`, computed only where the entity has turned."""
    _know(world, entity)
    return world.known_sin[entity]


#: What stands in for the plain functions in compiled code.
TWINS = {
    chance.draw: draw,
    chance.uniform: uniform,
    geometry.wrapped: wrapped,
    geometry.heading_cos: heading_cos,
    geometry.heading_sin: heading_sin,
}
