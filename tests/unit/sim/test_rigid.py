"""Rigid worlds: what forces, contact, joints and walls make of what agents want."""

from copy import copy
from dataclasses import replace
from math import pi
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.core.errors import ScenarioError
from app.core.hierarchy import Hierarchy
from app.core.machine_state import freeze
from app.sim.engine import Start
from app.sim.motion import with_motion
from app.sim.reference import ReferenceEngine
from app.sim.rigid import KEYFRAME
from app.sim.scenario import Column, Scenario
from app.sim.scenarios.foraging import Parameters
from app.sim.scenarios.foraging import scenario as foraging
from tests.arena import Arena
from tests.foragers import alone, groups, start, types
from tests.rigid_arena import RigidArena

#: What the solver may leave of a thing that should not move, in units.
STILL = 0.02


def rigid(forest: Hierarchy, top: str = "", seed: int = 1, **parameters: Any) -> ReferenceEngine:
    plan: Start = start(forest, top, seed=seed, **parameters)
    return ReferenceEngine(replace(plan, physics="rigid"))


def between(arena: RigidArena, a: int, b: int) -> float:
    """The distance between two entities."""
    (ax, ay), (bx, by) = arena.at(a), arena.at(b)
    return float(((ax - bx) ** 2 + (ay - by) ** 2) ** 0.5)


# --------------------------------------------------------------------------------------------- how many it takes


@pytest.mark.parametrize("needed", [1, 2, 3, 5, 25])
def test_as_many_as_a_box_needs_pull_it_at_their_speed(needed: int) -> None:
    arena = RigidArena(needed, pullers=needed)
    arena.ring(0, 60.0, 60.0, *range(needed))
    arena.tell("Forward")
    arena.tick(300)
    before = arena.at(arena.box())[0]
    arena.tick()
    assert before > 60.0 + 20.0
    assert arena.at(arena.box())[0] - before == pytest.approx(0.1, rel=0.01)


@pytest.mark.parametrize("needed", [2, 3, 5, 25])
def test_one_fewer_than_a_box_needs_do_not_move_it(needed: int) -> None:
    arena = RigidArena(needed - 1, pullers=needed)
    arena.ring(0, 60.0, 60.0, *range(needed - 1))
    arena.tell("Forward")
    arena.tick(1000)
    assert arena.at(arena.box()) == pytest.approx((60.0, 60.0), abs=STILL)


@settings(max_examples=15, deadline=None)
@given(st.lists(st.floats(-pi, pi), min_size=4, max_size=4))
def test_too_few_do_not_move_a_box_wherever_they_look(headings: list[float]) -> None:
    arena = RigidArena(4, pullers=5)
    arena.ring(0, 60.0, 60.0, *range(4))
    arena.world.heading[:4] = headings
    arena.tell("Forward")
    arena.tick(200)
    assert arena.at(arena.box()) == pytest.approx((60.0, 60.0), abs=STILL)


def test_pullers_who_pull_apart_do_not_move_a_box() -> None:
    arena = RigidArena(2, pullers=2)
    arena.ring(0, 60.0, 60.0, 0, 1)
    arena.world.heading[0], arena.world.heading[1] = 0.0, -pi
    arena.tell("Forward")
    arena.tick(200)
    assert arena.at(arena.box()) == pytest.approx((60.0, 60.0), abs=STILL)


def test_a_larger_reserve_lets_more_crooked_pullers_move_a_box() -> None:
    def moved(reserve: float) -> float:
        arena = RigidArena(5, pullers=5, reserve=reserve)
        arena.ring(0, 60.0, 60.0, *range(5))
        arena.world.heading[:5] = [-0.6, -0.3, 0.0, 0.3, 0.6]
        arena.tell("Forward")
        arena.tick(300)
        return arena.at(arena.box())[0] - 60.0

    assert moved(0.9) > moved(0.5) + 1.0
    assert moved(0.5) > moved(0.2) + 1.0


def test_an_attached_agent_that_does_nothing_is_carried() -> None:
    arena = RigidArena(6, pullers=5)
    arena.ring(0, 60.0, 60.0, *range(6))
    arena.tell("Forward", 0, 1, 2, 3, 4)
    apart = [between(arena, agent, arena.box()) for agent in range(6)]
    arena.tick(300)
    assert arena.at(arena.box())[0] > 80.0
    assert [between(arena, agent, arena.box()) for agent in range(6)] == pytest.approx(apart, abs=0.05)


# --------------------------------------------------------------------------------------------- driving


def test_free_agents_drive_and_turn_as_in_kinematic_worlds() -> None:
    bodies, points = RigidArena(1), Arena(1)
    for arena in (bodies, points):
        arena.place(0, 50.0, 50.0, 30.0)
    for behavior in ("Forward", "RotateLeft", "RotateLeft", "Forward", "RotateRight", "Forward"):
        for arena in (bodies, points):
            arena.do(behavior)
    assert bodies.at(0) == pytest.approx(points.at(0), abs=1e-6)
    assert bodies.heading() == points.heading()


def test_attached_agents_turn_but_do_not_walk() -> None:
    arena = RigidArena(1, pullers=5)
    arena.ring(0, 60.0, 60.0, 0)
    arena.do("RotateLeft")
    assert arena.heading() == pytest.approx(2.0)
    arena.tell("Forward")
    arena.tick(500)
    assert arena.at(0) == pytest.approx((64.0, 60.0), abs=STILL)


def test_agents_stop_when_they_stop_driving() -> None:
    arena = RigidArena(1)
    arena.place(0, 50.0, 50.0)
    arena.tell("Forward")
    arena.tick(10)
    arena.tell("RotateLeft")
    arena.tick()
    before = arena.at(0)
    arena.tick(10)
    assert arena.at(0) == pytest.approx(before, abs=1e-9)


# --------------------------------------------------------------------------------------------- contact


def head_on(**parameters: Any) -> RigidArena:
    arena = RigidArena(2, **parameters)
    arena.place(0, 50.0, 50.0)
    arena.place(1, 56.0, 50.0, 180.0)
    arena.tell("Forward")
    arena.tick(100)
    return arena


def test_agents_bump_into_each_other() -> None:
    arena = head_on()
    assert between(arena, 0, 1) == pytest.approx(1.0, abs=0.05)
    assert arena.at(0)[0] < arena.at(1)[0]


def test_without_contact_agents_pass_through_each_other() -> None:
    arena = head_on(contact=False)
    assert arena.at(0)[0] == pytest.approx(60.0, abs=0.01)
    assert arena.at(1)[0] == pytest.approx(46.0, abs=0.01)


@pytest.mark.parametrize("contact", [True, False])
def test_boxes_stand_in_the_way_of_free_agents(*, contact: bool) -> None:
    arena = RigidArena(1, contact=contact)
    arena.place(0, 50.0, 50.0)
    arena.place_box(0, 60.0, 50.0)
    arena.tell("Forward")
    arena.tick(200)
    assert between(arena, 0, arena.box()) == pytest.approx(3.0, abs=0.05)
    assert arena.at(arena.box()) == pytest.approx((60.0, 50.0), abs=STILL)


def test_a_box_that_is_pulled_stops_at_another() -> None:
    arena = RigidArena(5, boxes=2)
    arena.place_box(1, 80.0, 60.0)
    arena.ring(0, 60.0, 60.0, *range(5), distance=2.9)
    arena.tell("Forward")
    arena.tick(600)
    assert arena.at(arena.box(1)) == pytest.approx((80.0, 60.0), abs=0.3)  # a jolt, when they meet
    assert between(arena, arena.box(0), arena.box(1)) > 4.9


def test_bodies_end_at_the_walls() -> None:
    arena = RigidArena(6)
    arena.ring(0, 180.0, 60.0, 0, 1, 2, 3, 4)
    arena.place(5, 2.0, 100.0, 180.0)
    arena.tell("Forward")
    arena.tick(500)
    assert arena.at(5)[0] == pytest.approx(0.5, abs=0.05)
    assert max(arena.at(agent)[0] for agent in range(5)) == pytest.approx(199.5, abs=0.05)


def test_a_box_in_a_corner_is_pushed_inside() -> None:
    arena = RigidArena(1)
    arena.place_box(0, 200.0, 0.0)
    arena.tick(100)
    x, y = arena.at(arena.box())
    assert 197.0 < x < 198.0
    assert 2.0 < y < 3.0


# --------------------------------------------------------------------------------------------- the rest of the tick


def test_a_delivered_box_lets_its_agents_go_and_lies_somewhere_else_at_rest() -> None:
    arena = RigidArena(5)
    arena.ring(0, 90.0, 100.0, *range(5))
    arena.tell("Forward")
    while arena.counts()["boxes"] == 0.0:
        arena.tick()
    assert arena.attached() == []
    placed = arena.at(arena.box())
    assert between(arena, arena.box(), arena.world.first_deposit) > 5.0
    arena.tick(5)
    assert arena.at(arena.box()) == pytest.approx(placed, abs=STILL)


def test_an_agent_that_lets_go_can_walk_away() -> None:
    arena = RigidArena(1)
    arena.ring(0, 60.0, 60.0, 0)
    arena.tick()
    arena.do("ReleaseBox")
    arena.tell("Forward")
    arena.tick(10)
    assert arena.at(0)[0] == pytest.approx(65.0, abs=0.01)


def test_what_is_dragged_stays_where_it_is_put() -> None:
    arena = RigidArena(5)
    arena.ring(0, 60.0, 60.0, *range(5))
    arena.tell("Forward")
    arena.tick(50)
    arena.tell("RotateLeft")
    arena.engine.move(arena.box(), 30.0, 30.0)
    arena.tick(50)
    assert arena.at(arena.box()) == pytest.approx((30.0, 30.0), abs=STILL)
    assert between(arena, 0, arena.box()) == pytest.approx(4.0, abs=0.05)


def test_worlds_without_agents_or_boxes_pass_their_ticks() -> None:
    engine = rigid(alone(1), boxes=0)
    engine.step(KEYFRAME + 1)
    assert engine.tick == KEYFRAME + 1


# --------------------------------------------------------------------------------------------- the same again


def test_the_same_seed_gives_the_same_run() -> None:
    first, second, third = (rigid(groups(2, 5), "ControlForage", seed=seed) for seed in (3, 3, 4))
    for engine in (first, second, third):
        engine.step(300)
    assert first.frozen_world() == second.frozen_world()
    assert first.frozen_world() != third.frozen_world()


@pytest.mark.parametrize("keyframes", [1, 3])
def test_a_run_restored_at_a_keyframe_goes_on_as_one_that_never_stopped(keyframes: int) -> None:
    gathered: dict[str, Any] = {
        "width": 30.0,
        "height": 30.0,
        "deposit_x": 15.0,
        "deposit_y": 15.0,
        "boxes": 3,
        "pullers": 2,
    }
    going = rigid(groups(2, 4), "ControlForage", **gathered)
    going.step(keyframes * KEYFRAME)
    world, machine = going.frozen_world(), freeze(going.machine)
    other = rigid(groups(2, 4), "ControlForage", seed=9, **gathered)
    other.step(77)
    other.restore(world, machine)
    for engine in (going, other):
        engine.step(KEYFRAME + 50)
    assert going.frozen_world() == other.frozen_world()


def test_going_back_to_any_moment_gives_the_same_each_time() -> None:
    engine = rigid(groups(2, 4), "ControlForage")
    engine.step(KEYFRAME + 33)
    world, machine = engine.frozen_world(), freeze(engine.machine)
    ends = []
    for _ in range(2):
        engine.restore(world, machine)
        engine.step(200)
        ends.append(engine.frozen_world())
    assert ends[0] == ends[1]


def test_a_kinematic_moment_can_be_gone_back_to_with_everything_at_rest() -> None:
    points = ReferenceEngine(start(alone(2), "Wander"))
    points.step(50)
    bodies = rigid(alone(2), "Wander")
    bodies.restore(points.frozen_world(), freeze(points.machine))
    assert bodies.world.velocity_x == [0.0] * len(bodies.world.x)
    assert bodies.world.x == points.world.x
    bodies.step()


def test_agents_without_speed_stay_where_they_are() -> None:
    arena = RigidArena(2, step=0.0)
    arena.ring(0, 60.0, 60.0, 0)
    arena.tell("Forward")
    arena.tick(10)
    assert arena.at(1) == (22.0, 20.0)
    assert arena.at(arena.box()) == pytest.approx((60.0, 60.0))


def test_how_ticks_are_cut_into_steps_does_not_matter() -> None:
    whole, cut = (rigid(groups(2, 5), "ControlForage", boxes=6, pullers=2) for _ in range(2))
    whole.step(KEYFRAME + 100)
    for _ in range(KEYFRAME + 100):
        cut.step()
    assert whole.frozen_world() == cut.frozen_world()


def test_loads_may_be_any_kind_of_entity() -> None:
    """The deposit comes before the boxes here."""
    turned = copy(foraging)
    turned.kinds = foraging.kinds[::-1]
    engine = ReferenceEngine(
        Start(turned, turned.settle({"boxes": 1}), alone(1), types(), 1, physics="rigid")
    )
    engine.move(0, 50.0, 50.0)
    engine.move(2, 52.0, 50.0)
    engine.step(50)
    assert engine.world.x[2] - engine.world.x[0] == pytest.approx(3.0, abs=0.1)
    assert (engine.world.x[1], engine.world.y[1]) == (100.0, 100.0)


# --------------------------------------------------------------------------------------------- refusals


def test_a_scenario_without_bodies_is_refused_by_name() -> None:
    bare = Scenario("bare", "Bare", Parameters)
    plan = Start(bare, bare.settle({}), alone(), types(), seed=1, physics="rigid")
    with pytest.raises(ScenarioError, match=r"scenario 'bare' declares no bodies.*allowed: kinematic"):
        ReferenceEngine(plan)


def test_a_scenario_that_has_a_column_for_motion_already_is_refused_by_name() -> None:
    taken = copy(foraging)
    taken.columns = (*foraging.columns, Column("spin"))
    plan = Start(taken, taken.settle({}), alone(), types(), seed=1, physics="rigid")
    with pytest.raises(ScenarioError, match="rigid worlds have a column 'spin' of their own"):
        ReferenceEngine(plan)


def test_motion_is_added_once() -> None:
    moving = with_motion(foraging)
    assert with_motion(moving) is moving
    assert "kinematics" in foraging.stages


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"loads": "crate"},
            "loads is 'crate', but there is no such kind of entity; there are: box, deposit",
        ),
        (
            {"held": "boxes_delivered"},
            "held is 'boxes_delivered', but there is no such column of whole numbers",
        ),
        ({"needed": "x"}, "needed is 'x', but there is no such column of whole numbers; there are: held, "),
        ({"speed": "pace"}, "speed is 'pace', but there is no such parameter that is a number"),
        ({"contact": "step"}, "contact is 'step', but there is no such parameter that is true or false"),
    ],
)
def test_bodies_that_name_what_is_not_there_are_refused(changes: dict[str, str], message: str) -> None:
    assert foraging.bodies is not None
    with pytest.raises(ScenarioError, match=message):
        Scenario(
            "wrong",
            "Wrong",
            Parameters,
            foraging.kinds,
            tuple(c for c in foraging.columns if c.name in {"held", "wants", "needed", "boxes_delivered"}),
            bodies=replace(foraging.bodies, **changes),
        )
