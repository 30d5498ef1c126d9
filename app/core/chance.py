"""Chance without state: every draw is a hash of where and when it happens.

A draw depends only on (seed, world, who, tick, number), so the result of a run depends on neither the engine, the
thread, the order in which agents are visited, nor how ticks are cut into slices.
"""

from collections.abc import Sequence

MASK = (1 << 64) - 1
GOLDEN = 0x9E3779B97F4A7C15
MIX_1 = 0xBF58476D1CE4E5B9
MIX_2 = 0x94D049BB133111EB
WHO = 0xD6E8FEB86659FD93
TICK = 0xA5A3564E27F8862B
UNIT = 2.0**-53

#: Who draws when no agent does: the world itself. Controller number c draws as ``FIRST_CONTROLLER + c``.
THE_WORLD = 1 << 32
FIRST_CONTROLLER = 1 << 33
#: Draw numbers below this belong to the automata (number = depth); a scenario's own numbers are added to it.
FIRST_SCENARIO_DRAW = 1 << 16


def mix(value: int) -> int:
    """Spread the bits of a 64-bit *value* (the finalizer of SplitMix64; Steele, Lea and Flood 2014)."""
    value = ((value ^ (value >> 30)) * MIX_1) & MASK
    value = ((value ^ (value >> 27)) * MIX_2) & MASK
    return value ^ (value >> 31)


def world_key(seed: int, world: int) -> int:
    """The part of a draw's key that stays the same through a run: 63 bits, so that it fits a signed column."""
    return mix((seed * GOLDEN + world + 1) & MASK) >> 1


def draw(key: int, tick: int, who: int, number: int) -> float:
    """A number in [0, 1) with 53 random bits, from a world's *key*, *tick*, drawer and draw number."""
    first = mix((key + tick * TICK + who * WHO) & MASK)
    return (mix((first + number * GOLDEN) & MASK) >> 11) * UNIT


def uniform(clock: Sequence[int], who: int, number: int) -> float:
    """What a scenario's functions draw: a number in [0, 1).

    Args:
        clock: The world's clock: (seed, world, tick, key), the last being the `world_key` of the first two.
        who: The agent that draws, or ``THE_WORLD``.
        number: Tells several draws of the same drawer in one tick apart.
    """
    return draw(clock[3], clock[2], who, FIRST_SCENARIO_DRAW + number)
