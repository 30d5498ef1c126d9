"""Foraging: walking, turning, walls, and pulling."""

from math import cos, pi, radians, sin
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.sim.geometry import clamped, wrapped
from tests.arena import Arena


def test_the_world_is_200_by_200_with_the_deposit_in_the_middle() -> None:
    arena = Arena()
    params = arena.world.params
    assert (params.width, params.height) == (200.0, 200.0)
    assert arena.at(arena.world.first_deposit) == (100.0, 100.0)


def test_forward_walks_a_tenth_of_a_unit_a_tick() -> None:
    arena = Arena()
    arena.place(0, 50.0, 50.0, heading=30.0)
    arena.tell("Forward")
    arena.tick(10)
    assert arena.at(0) == pytest.approx((50.0 + cos(radians(30.0)), 50.0 + sin(radians(30.0))))


@pytest.mark.parametrize(("behavior", "turned"), [("RotateLeft", 2.0), ("RotateRight", -2.0)])
def test_a_rotation_turns_by_two_degrees_a_tick_on_the_spot(behavior: str, turned: float) -> None:
    arena = Arena()
    arena.place(0, 50.0, 50.0, heading=10.0)
    arena.tell(behavior)
    arena.tick(3)
    assert arena.heading() == pytest.approx(10.0 + 3 * turned)
    assert arena.at(0) == (50.0, 50.0)


def test_an_idle_agent_stays_where_it_is() -> None:
    arena = Arena()
    arena.place(0, 50.0, 50.0)
    arena.tick(5)
    assert arena.at(0) == (50.0, 50.0)


def test_headings_run_through_the_seam() -> None:
    arena = Arena()
    arena.place(0, 50.0, 50.0, heading=179.5)
    arena.do("RotateLeft")
    assert arena.heading() == pytest.approx(-178.5)


@pytest.mark.parametrize(
    ("x", "y", "heading", "end"),
    [
        (199.95, 50.0, 0.0, (200.0, 50.0)),
        (0.05, 50.0, 180.0, (0.0, 50.0)),
        (50.0, 199.95, 90.0, (50.0, 200.0)),
        (50.0, 0.05, -90.0, (50.0, 0.0)),
    ],
)
def test_walls_clamp(x: float, y: float, heading: float, end: tuple[float, float]) -> None:
    arena = Arena()
    arena.place(0, x, y, heading)
    arena.tell("Forward")
    arena.tick(3)
    assert arena.at(0) == pytest.approx(end)


def test_an_agent_at_a_wall_slides_along_it() -> None:
    arena = Arena()
    arena.place(0, 200.0, 50.0, heading=45.0)
    arena.do("Forward")
    assert arena.at(0) == pytest.approx((200.0, 50.0 + 0.1 * sin(pi / 4)))


def test_steps_and_turns_are_parameters() -> None:
    arena = Arena(step=2.0, turn_degrees=90.0)
    arena.place(0, 50.0, 50.0)
    arena.do("RotateLeft")
    arena.do("Forward")
    assert arena.at(0) == pytest.approx((50.0, 52.0))


# ------------------------------------------------------------------------------------------------ pulling


def full_box(heading: float = 0.0, **parameters: Any) -> Arena:
    """A box that needs two agents and has them, at (50, 50)."""
    arena = Arena(3, pullers=2, **parameters)
    arena.place(0, 48.0, 50.0, heading)
    arena.place(1, 52.0, 50.0, heading)
    arena.place_box(0, 50.0, 50.0, 0, 1)
    return arena


def test_an_attached_agent_turns_but_does_not_walk() -> None:
    arena = Arena(1, pullers=2)
    arena.place(0, 48.0, 50.0)
    arena.place_box(0, 50.0, 50.0, 0)
    arena.do("Forward")
    assert arena.at(0) == (48.0, 50.0)
    arena.do("RotateLeft")
    assert arena.heading() == pytest.approx(2.0)


def test_a_box_with_too_few_agents_does_not_move() -> None:
    arena = Arena(2, pullers=3)
    arena.place_box(0, 50.0, 50.0, 0, 1)
    arena.tell("Forward")
    arena.tick(5)
    assert arena.at(arena.box()) == (50.0, 50.0)


def test_a_full_box_moves_a_tenth_along_the_sum_of_the_headings_and_carries_all() -> None:
    arena = full_box()
    arena.place(0, 48.0, 50.0, heading=0.0)
    arena.place(1, 52.0, 50.0, heading=90.0)
    arena.do("Forward", 0, 1)
    d = 0.1 * sin(pi / 4)
    assert arena.at(arena.box()) == pytest.approx((50.0 + d, 50.0 + d))
    assert arena.at(0) == pytest.approx((48.0 + d, 50.0 + d))
    assert arena.at(1) == pytest.approx((52.0 + d, 50.0 + d))


def test_a_box_moves_no_faster_with_more_agents_that_pull() -> None:
    arena = full_box()
    arena.do("Forward", 0)
    arena.do("Forward", 0, 1)
    assert arena.at(arena.box()) == pytest.approx((50.2, 50.0))


def test_only_agents_that_go_forward_pull_but_all_are_carried() -> None:
    arena = full_box()
    arena.place(1, 52.0, 50.0, heading=90.0)
    arena.tell("Forward", 0)
    arena.tell("RotateLeft", 1)
    arena.tick()
    assert arena.at(arena.box()) == pytest.approx((50.1, 50.0))
    assert arena.at(1) == pytest.approx((52.1, 50.0))


def test_agents_that_pull_against_each_other_keep_the_box_in_place() -> None:
    arena = full_box()
    arena.place(1, 52.0, 50.0, heading=180.0)
    arena.do("Forward", 0, 1)
    assert arena.at(arena.box()) == (50.0, 50.0)


def test_a_full_box_that_nobody_pulls_stays() -> None:
    arena = full_box()
    arena.tick(3)
    assert arena.at(arena.box()) == (50.0, 50.0)


def test_an_agent_that_is_not_attached_neither_pulls_nor_is_carried() -> None:
    arena = full_box()
    arena.place(2, 50.0, 50.0, heading=90.0)
    arena.do("Forward")
    assert arena.at(arena.box()) == pytest.approx((50.1, 50.0))
    assert arena.at(2) == pytest.approx((50.0, 50.1))


def test_walls_clamp_boxes_and_those_whom_they_carry() -> None:
    arena = full_box()
    arena.place_box(0, 199.95, 50.0, 0, 1)
    arena.place(0, 198.0, 50.0)
    arena.place(1, 200.0, 50.0)
    arena.do("Forward", 0, 1)
    assert arena.at(arena.box()) == pytest.approx((200.0, 50.0))
    assert arena.at(0) == pytest.approx((198.05, 50.0))
    assert arena.at(1) == (200.0, 50.0)


# ----------------------------------------------------------------------------------------------- geometry


@given(st.floats(-100.0, 100.0))
def test_a_wrapped_angle_is_the_same_angle_from_minus_pi_up_to_pi(angle: float) -> None:
    result = wrapped(angle)
    assert -pi <= result < pi
    assert cos(result) == pytest.approx(cos(angle), abs=1e-9)
    assert sin(result) == pytest.approx(sin(angle), abs=1e-9)


@pytest.mark.parametrize("angle", [pi, -pi, 3 * pi, -3.1415926535897936, 3.1415926535897936, -3 * pi])
def test_an_angle_at_the_seam_is_minus_pi_or_just_inside(angle: float) -> None:
    assert -pi <= wrapped(angle) < pi


@given(st.floats(-1e6, 1e6), st.floats(0.0, 1e6))
def test_a_clamped_value_is_the_nearest_one_in_the_range(value: float, high: float) -> None:
    assert clamped(value, high) == sorted((0.0, value, high))[1]
