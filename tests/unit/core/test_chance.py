from collections.abc import Callable
from random import Random
from statistics import correlation

import pytest

from app.core.chance import (
    FIRST_CONTROLLER,
    FIRST_SCENARIO_DRAW,
    GOLDEN,
    MASK,
    THE_WORLD,
    draw,
    mix,
    uniform,
    world_key,
)

DRAWS = 20_000
#: What chi-square with so many degrees of freedom exceeds once in a thousand times.
RARE = {49: 85.4, 99: 148.2}
KEY = world_key(1, 0)

#: Draws along one coordinate while the others stay.
ALONG: dict[str, Callable[[int], float]] = {
    "ticks": lambda k: draw(KEY, k, 0, 0),
    "agents": lambda k: draw(KEY, 100, k, 0),
    "controllers": lambda k: draw(KEY, 100, FIRST_CONTROLLER + k, 0),
    "numbers": lambda k: draw(KEY, 100, 7, k),
    "seeds": lambda k: draw(world_key(k, 0), 0, 0, 0),
    "worlds": lambda k: draw(world_key(1, k), 0, 0, 0),
    "the world's own": lambda k: draw(KEY, k, THE_WORLD, FIRST_SCENARIO_DRAW),
}


def chi_square(counts: list[int]) -> float:
    """How far counts that should be equal are from that."""
    expected = sum(counts) / len(counts)
    return sum((count - expected) ** 2 / expected for count in counts)


def test_mixing_is_that_of_the_published_generator() -> None:
    # SplitMix64 from 1234567: the first five numbers that its authors' reference implementation gives
    assert [mix((1234567 + GOLDEN * k) & MASK) for k in range(1, 6)] == [
        6457827717110365317,
        3203168211198807973,
        9817491932198370423,
        4593380528125082431,
        16408922859458223821,
    ]


def test_world_keys_are_pinned() -> None:
    assert [world_key(*world) for world in ((0, 0), (1, 0), (0, 1), (2**40, 7))] == [
        3119036373970289394,
        5225608189600411232,
        7919892530791287365,
        3852263876809089143,
    ]


@pytest.mark.parametrize(
    ("where", "expected"),
    [
        ((0, 0, 0), 0.5219237047907438),
        ((1, 0, 0), 0.9476164134502032),
        ((0, 1, 0), 0.3253226537435647),
        ((0, 0, 1), 0.9409862106768974),
        ((123456, 49, 3), 0.3445675381928517),
        ((20000, THE_WORLD, FIRST_SCENARIO_DRAW + 2), 0.6916523550263529),
        ((7, FIRST_CONTROLLER + 11, 0), 0.8886759064062608),
    ],
)
def test_draws_are_pinned_so_that_no_engine_changes_them_unnoticed(
    where: tuple[int, int, int], expected: float
) -> None:
    assert draw(KEY, *where) == expected


def test_a_world_key_fits_a_signed_column() -> None:
    assert all(0 <= world_key(seed, world) < 1 << 63 for seed in range(200) for world in range(20))


@pytest.mark.parametrize("along", ALONG)
def test_draws_are_uniform_on_0_to_1(along: str) -> None:
    drawn = [ALONG[along](k) for k in range(DRAWS)]
    assert all(0.0 <= u < 1.0 for u in drawn)
    bins = [0] * 50
    for u in drawn:
        bins[int(50 * u)] += 1
    assert chi_square(bins) < RARE[49]


@pytest.mark.parametrize("along", ALONG)
@pytest.mark.parametrize("lag", [1, 2, 50])
def test_neighboring_draws_do_not_go_together(along: str, lag: int) -> None:
    drawn = [ALONG[along](k) for k in range(DRAWS)]
    assert abs(correlation(drawn[:-lag], drawn[lag:])) < 0.025


def test_pairs_of_agents_fill_the_square_evenly() -> None:
    cells = [0] * 100
    for tick in range(DRAWS):
        cells[10 * int(10 * draw(KEY, tick, 3, 0)) + int(10 * draw(KEY, tick, 4, 0))] += 1
    assert chi_square(cells) < RARE[99]


def test_no_draw_comes_up_twice_where_agents_ticks_and_numbers_meet() -> None:
    drawn = {draw(KEY, tick, who, number) for tick in range(60) for who in range(60) for number in range(6)}
    assert len(drawn) == 60 * 60 * 6


def test_draws_do_not_depend_on_their_order() -> None:
    places = [(tick, who, number) for tick in range(5) for who in range(5) for number in range(3)]
    shuffled = list(places)
    Random(0).shuffle(shuffled)
    assert {place: draw(KEY, *place) for place in places} == {place: draw(KEY, *place) for place in shuffled}


def test_a_scenarios_draws_are_those_of_its_clock_and_apart_from_the_automatas() -> None:
    clock = (1, 0, 5, KEY)
    assert uniform(clock, 3, 2) == draw(KEY, 5, 3, FIRST_SCENARIO_DRAW + 2)
    assert uniform(clock, 3, 0) not in {draw(KEY, 5, 3, number) for number in range(100)}
