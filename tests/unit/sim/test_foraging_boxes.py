"""Foraging: grabbing, letting go, depositing, and what a user's hand does to boxes."""

from math import dist
from typing import Any

import pytest

from app.core.chance import uniform
from app.sim.reference import ReferenceEngine
from tests.arena import Arena
from tests.foragers import start

FREE = -1


# ------------------------------------------------------------------------------------------------ grabbing


@pytest.mark.parametrize(("gap", "grabbed"), [(4.9, [0]), (5.0, [0]), (5.1, [])])
def test_a_box_is_grabbed_within_5_units_of_its_center(gap: float, grabbed: list[int]) -> None:
    arena = Arena()
    arena.place_box(0, 50.0, 50.0)
    arena.place(0, 50.0 - gap, 50.0)
    arena.do("GrabBox")
    assert arena.attached() == grabbed


def test_an_agent_grabs_the_nearest_box_that_needs_it() -> None:
    arena = Arena(3, boxes=3, pullers=2)
    arena.place(0, 50.0, 50.0)
    arena.place_box(0, 50.0, 54.0)
    arena.place_box(1, 50.0, 53.0)
    arena.place_box(2, 50.0, 51.0, 1, 2)
    arena.do("GrabBox", 0)
    assert arena.attached(1) == [0]


def test_a_full_box_cannot_be_grabbed() -> None:
    arena = Arena(3, pullers=2)
    arena.place_box(0, 50.0, 50.0, 1, 2)
    arena.place(0, 50.0, 50.0)
    arena.do("GrabBox", 0)
    assert arena.world.held[0] == FREE


def test_a_box_that_was_full_when_the_tick_began_is_not_grabbed_in_it() -> None:
    arena = Arena(3, pullers=2)
    arena.place_box(0, 50.0, 50.0, 1, 2)
    arena.place(0, 50.0, 50.0)
    arena.tell("ReleaseBox", 1)
    arena.do("GrabBox", 0)
    assert arena.attached() == [2]


def test_grabbing_with_a_box_in_hand_changes_nothing() -> None:
    arena = Arena(1, boxes=2)
    arena.place(0, 50.0, 50.0)
    arena.place_box(0, 53.0, 50.0, 0)
    arena.place_box(1, 51.0, 50.0)
    arena.do("GrabBox")
    assert (arena.attached(0), arena.attached(1)) == ([0], [])


def test_grabbing_is_tried_once() -> None:
    arena = Arena()
    arena.place(0, 50.0, 50.0)
    arena.do("GrabBox")
    arena.place_box(0, 52.0, 50.0)
    arena.tick(3)
    assert arena.attached() == []


def test_an_agent_that_has_grabbed_stays_where_it_was() -> None:
    arena = Arena()
    arena.place(0, 46.0, 50.0)
    arena.place_box(0, 50.0, 50.0)
    arena.do("GrabBox")
    assert arena.at(0) == (46.0, 50.0)


def crowd(seed: int, held: int = 0) -> Arena:
    """Seven agents around a box that needs four, some of them already attached."""
    arena = Arena(7, seed=seed, pullers=4)
    for agent in range(7):
        arena.place(agent, 49.0 + agent / 4, 50.0)
    arena.place_box(0, 50.0, 50.0, *range(held))
    return arena


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("held", [0, 2])
def test_where_more_grab_than_a_box_needs_the_lowest_draws_win(seed: int, held: int) -> None:
    arena = crowd(seed, held)
    claims = sorted(range(held, 7), key=lambda agent: uniform(arena.world.clock, agent, 3))
    arena.do("GrabBox")
    assert arena.attached() == sorted([*range(held), *claims[: 4 - held]])
    assert arena.world.pulling[arena.box()] == 4


def test_who_wins_a_box_is_chance() -> None:
    winners = set()
    for seed in range(8):
        arena = crowd(seed)
        arena.do("GrabBox")
        winners.add(tuple(arena.attached()))
    assert len(winners) > 3


def test_a_box_that_needs_all_takes_all_at_once() -> None:
    arena = crowd(seed=1, held=1)
    arena.do("GrabBox", 3, 4, 5)
    assert arena.attached() == [0, 3, 4, 5]


# ---------------------------------------------------------------------------------------------- letting go


@pytest.mark.parametrize("behavior", ["ReleaseBox", "ReleaseBoxAndFinish"])
def test_releasing_detaches_the_agent_alone(behavior: str) -> None:
    arena = Arena(2, pullers=3)
    arena.place_box(0, 50.0, 50.0, 0, 1)
    arena.do(behavior, 0)
    assert arena.attached() == [1]
    assert arena.world.pulling[arena.box()] == 1


def test_releasing_without_a_box_does_nothing() -> None:
    arena = Arena(1)
    arena.do("ReleaseBox")
    assert arena.world.held[0] == FREE


def test_a_box_that_loses_an_agent_stops_and_can_be_grabbed_again() -> None:
    arena = Arena(3, pullers=2)
    arena.place_box(0, 50.0, 50.0, 0, 1)
    arena.tell("Forward", 0)
    arena.do("ReleaseBox", 1)
    assert arena.at(arena.box()) == (50.0, 50.0)
    arena.place(2, 50.0, 50.0)
    arena.do("GrabBox", 2)
    assert arena.attached() == [0, 2]


def test_who_may_let_go_is_a_parameter() -> None:
    arena = Arena(1, pullers=2, release="full")
    arena.place_box(0, 50.0, 50.0, 0)
    arena.do("ReleaseBox")
    assert arena.attached() == [0]


def test_all_agents_of_a_full_box_may_let_go_in_one_tick() -> None:
    arena = Arena(3, pullers=3, release="full")
    arena.place_box(0, 50.0, 50.0, 0, 1, 2)
    arena.do("ReleaseBox")
    assert arena.attached() == []
    assert arena.world.pulling[arena.box()] == 0


# ---------------------------------------------------------------------------------------------- depositing


def homeward(gap: float, seed: int = 1, **parameters: Any) -> Arena:
    """A full box to the left of the deposit, whose agents pull it there."""
    arena = Arena(2, seed, pullers=2, **parameters)
    arena.place_box(0, 100.0 - gap, 100.0, 0, 1)
    for agent in (0, 1):
        arena.place(agent, 100.0 - gap, 98.0)
    arena.tell("Forward", 0, 1)
    return arena


def test_a_box_is_deposited_within_5_units_of_the_deposit() -> None:
    arena = homeward(5.15)
    arena.tick()
    assert arena.counts()["boxes"] == 0
    arena.tick()
    assert arena.counts()["boxes"] == 1


def test_depositing_releases_all_agents_where_they_are() -> None:
    arena = homeward(5.05)
    arena.tick()
    assert arena.attached() == []
    assert list(arena.world.held[:2]) == [FREE, FREE]
    assert arena.world.pulling[arena.box()] == 0
    assert arena.at(0) == pytest.approx((95.05, 98.0))


def test_a_deposited_box_is_placed_anew_at_random() -> None:
    places = set()
    for seed in range(6):
        arena = homeward(5.05, seed=seed)
        arena.tick()
        places.add(arena.at(arena.box()))
    assert len(places) == 6


def test_a_box_placed_anew_needs_as_many_agents_as_before() -> None:
    arena = homeward(5.05)
    arena.tick()
    assert arena.world.needed[arena.box()] == 2


def test_deliveries_count_boxes_and_the_agents_that_they_needed() -> None:
    arena = homeward(5.05, boxes=2, big_boxes=1, big_pullers=2)
    arena.world.needed[arena.box()] = 7
    for agent in range(2):
        arena.world.held[agent] = arena.box()
    arena.world.pulling[arena.box()] = 7
    arena.tick()
    assert arena.counts() == {"boxes": 1.0, "weight": 7.0}


def test_a_delivery_is_progress_in_its_tick() -> None:
    arena = homeward(5.25)
    assert arena.engine.progressed == -1
    arena.tick(5)
    assert arena.engine.progressed == 2


def test_a_box_near_the_deposit_with_too_few_agents_is_not_deposited() -> None:
    arena = Arena(1, pullers=2)
    arena.place_box(0, 100.0, 100.0, 0)
    arena.tick()
    assert arena.counts()["boxes"] == 0


def test_two_boxes_can_be_deposited_in_one_tick() -> None:
    arena = Arena(2, boxes=2, pullers=1)
    arena.place_box(0, 100.0, 100.0, 0)
    arena.place_box(1, 101.0, 100.0, 1)
    arena.tick()
    assert arena.counts() == {"boxes": 2.0, "weight": 2.0}
    assert arena.at(arena.box(0)) != arena.at(arena.box(1))


def test_a_box_delivered_in_the_very_first_tick_is_not_put_where_it_began() -> None:
    arena = Arena(1, seed=4, pullers=1)
    arena.place_box(0, 100.0, 100.0, 0)
    arena.tick()
    assert arena.counts()["boxes"] == 1
    assert arena.at(arena.box()) not in box_places(seed=4, boxes=1)


# ------------------------------------------------------------------------------------------------ placing


def box_places(seed: int = 1, **parameters: Any) -> list[tuple[float, float]]:
    """Where the boxes of a new world are."""
    world = ReferenceEngine(start(seed=seed, **parameters)).world
    return [(world.x[box], world.y[box]) for box in range(world.first_box, world.end_box)]


@pytest.mark.parametrize("seed", range(20))
def test_no_box_is_placed_within_the_range_of_the_deposit(seed: int) -> None:
    places = box_places(seed, boxes=30, deposit_range=80.0, width=150.0, height=150.0)
    assert all(dist(place, (100.0, 100.0)) > 80.0 for place in places)
    assert len(set(places)) > 20


def test_a_box_without_room_elsewhere_is_put_into_the_corner_farthest_from_the_deposit() -> None:
    places = box_places(boxes=3, deposit_range=139.9, deposit_x=99.0, deposit_y=101.0)
    assert places == [(200.0, 0.0)] * 3


def test_boxes_can_be_placed_on_a_ring_around_the_deposit() -> None:
    places = box_places(boxes=20, placement="ring", ring_radius=40.0)
    assert [dist(place, (100.0, 100.0)) for place in places] == pytest.approx([40.0] * 20)
    assert len(set(places)) == 20


def test_a_ring_beyond_the_walls_is_cut_by_them() -> None:
    places = box_places(boxes=20, placement="ring", ring_radius=120.0)
    assert all(0.0 <= x <= 200.0 and 0.0 <= y <= 200.0 for x, y in places)


def test_big_boxes_need_more_agents() -> None:
    arena = Arena(1, boxes=10, big_boxes=2)
    needed = [arena.world.needed[arena.box(k)] for k in range(10)]
    assert sorted(needed) == [5] * 8 + [25] * 2


# ----------------------------------------------------------------------------------------- a user's hand


def test_a_dragged_entity_stays_within_the_walls() -> None:
    arena = Arena()
    arena.engine.move(0, -5.0, 400.0)
    assert arena.at(0) == (0.0, 200.0)


def test_a_dragged_box_takes_its_agents_along() -> None:
    arena = Arena(2, pullers=3)
    arena.place(0, 48.0, 50.0)
    arena.place_box(0, 50.0, 50.0, 0)
    arena.engine.move(arena.box(), 60.0, 70.0)
    assert arena.at(0) == (58.0, 70.0)
    assert arena.at(1) == (21.0, 20.0)


@pytest.mark.parametrize(("x", "attached"), [(54.0, [0]), (56.0, [])])
def test_a_dragged_agent_loses_a_box_out_of_its_reach(x: float, attached: list[int]) -> None:
    arena = Arena(1, pullers=3)
    arena.place(0, 48.0, 50.0)
    arena.place_box(0, 50.0, 50.0, 0)
    arena.engine.move(0, x, 50.0)
    assert arena.attached() == attached
    assert arena.world.pulling[arena.box()] == len(attached)


def test_the_deposit_can_be_dragged() -> None:
    arena = homeward(30.0)
    arena.engine.move(arena.world.first_deposit, 70.0, 100.0)
    arena.tick()
    assert arena.counts()["boxes"] == 1
