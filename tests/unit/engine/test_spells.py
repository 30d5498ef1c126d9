"""Runs that nobody looks at: they end within a spell, and spells are short, whatever a tick takes."""

import pytest

from app.engine.spells import FIRST, GROWTH, MOST, SPELL, Spells


class World:
    """A world whose ticks take so many seconds by its own clock."""

    def __init__(self, cost: float) -> None:
        self.cost = cost
        self.tick, self.now = 0, 0.0
        self.spells: list[int] = []

    def step(self, ticks: int) -> None:
        self.spells.append(ticks)
        self.tick += ticks
        self.now += ticks * self.cost


def passed(world: World, *goals: int, stop: int = 10**9) -> list[bool]:
    spells = Spells(world, lambda: world.tick < stop, lambda: world.now)  # type: ignore[arg-type]  # all of a session that is asked for
    return [spells.until(goal) for goal in goals]


@pytest.mark.parametrize("cost", [0.0, 1e-7, 1e-3, 0.05, 3.0])
def test_all_ticks_pass_in_spells_that_are_short_after_the_first(cost: float) -> None:
    world = World(cost)
    assert passed(world, 7, 2_000, 5_000) == [True] * 3
    assert world.tick == 5_000
    assert world.spells[0] <= FIRST
    assert all(spell * cost <= max(SPELL, cost) * 1.01 for spell in world.spells[1:])


def test_of_a_fast_world_they_soon_are_as_long_as_they_get() -> None:
    world = World(1e-6)
    assert passed(world, 100_000) == [True]
    assert max(world.spells) == MOST
    assert len(world.spells) <= 100_000 / MOST + GROWTH


def test_a_run_that_is_to_end_ends_before_the_next_spell() -> None:
    world = World(0.1)
    assert passed(world, 500, stop=40) == [False]
    assert 40 <= world.tick < 40 + FIRST


def test_where_nothing_is_left_nobody_is_asked() -> None:
    assert passed(World(0.1), 0, stop=0) == [True]
