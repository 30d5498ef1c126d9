"""Properties of worlds over random automata, forests, parameters and seeds."""

import json
from collections.abc import Mapping
from math import atan2, dist, pi
from random import Random
from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st

from app.core.hierarchy import Hierarchy
from app.core.library import Library, Types
from app.core.machine import Action, Argument
from app.core.machine_state import freeze
from app.sim.engine import Start
from app.sim.geometry import wrapped
from app.sim.reference import ReferenceEngine
from app.sim.scenarios.foraging import scenario as foraging
from app.sim.world import FrozenWorld
from tests.foragers import BUSY, libraries
from tests.random_automata import random_forest, random_types
from tests.samples import SQUAD

SEEDS = st.integers(0, 1 << 32)
TICKS = st.integers(0, 50)
EXAMPLES = settings(max_examples=120)


def busy_types(random: Random) -> Types:
    """Random automata beside, and made from, those of a forager that works."""
    working = {**libraries(), SQUAD: Library()}  # squads here hold agents too, who cannot do what groups do
    return random_types(random, foraging.vocabulary, reach=40.0, beside=working)


def random_parameters(random: Random) -> Mapping[str, Any]:
    """A small arena; now and then all that can be set otherwise is."""
    return foraging.settle(
        {
            **BUSY,
            "step": random.choice((0.1, 0.4, 3.0)),
            "turn_degrees": random.choice((2.0, 45.0, 180.0)),
            "boxes": random.randrange(1, 8),
            "pullers": random.randrange(1, 4),
            "sight": random.choice((2.0, 10.0, 40.0)),
            "grab_range": random.choice((1.0, 5.0, 20.0)),
            "deposit_x": random.choice((0.0, 20.0)),
            "placement": random.choice(("anywhere", "ring")),
            "ring_radius": random.choice((8.0, 30.0)),
            "release": random.choice(("anyone", "full")),
        }
    )


def random_start(seed: int) -> Start:
    random = Random(seed)
    types, forest = busy_types(random), random_forest(random)
    return Start(foraging, random_parameters(random), forest, types, seed)


def begin(start: Start, make: type[ReferenceEngine] = ReferenceEngine) -> ReferenceEngine:
    """A world in which every root does something, and some agents are already at a box; the same each time."""
    engine, random = make(start), Random(start.seed + 1)
    for root in start.hierarchy.roots:
        repertoire = start.types.repertoire(root.type)
        name = random.choice(sorted(name for name in repertoire if name not in foraging.behaviors))
        given_ = {slot: Argument("deposit", root.id) for slot in repertoire[name].parameters}
        engine.machine.direct(root.id, name, given_)
    for agent in engine.spans()["agent"]:
        if random.random() < 0.5:
            gather(engine, agent, random.choice(engine.spans()["box"]), random)
    return engine


def gather(engine: ReferenceEngine, agent: int, box: int, random: Random) -> None:
    """Put an agent beside a box, attached to it if that needs it, and looking to the deposit."""
    world = engine.world
    engine.move(agent, world.x[box] + random.uniform(-1.0, 1.0), world.y[box] + random.uniform(-1.0, 1.0))
    toward = atan2(world.y[world.first_deposit] - world.y[box], world.x[world.first_deposit] - world.x[box])
    world.heading[agent] = wrapped(toward)
    if world.pulling[box] < world.needed[box] and random.random() < 0.7:
        world.held[agent] = box
        world.pulling[box] += 1


def state(engine: ReferenceEngine) -> tuple[FrozenWorld, Any]:
    return engine.frozen_world(), freeze(engine.machine)


@given(SEEDS, TICKS, TICKS)
@EXAMPLES
def test_going_on_from_a_stored_state_is_never_having_stopped(seed: int, before: int, after: int) -> None:
    start = random_start(seed)
    engine, other = begin(start), ReferenceEngine(start)
    engine.step(before)
    world, machine = json.loads(json.dumps(state(engine)))
    engine.step(after)
    other.restore(world, machine)
    other.step(after)
    assert state(other) == state(engine)


@given(SEEDS, st.lists(st.integers(0, 12), max_size=6))
@EXAMPLES
def test_a_run_does_not_depend_on_how_it_is_cut(seed: int, parts: list[int]) -> None:
    start = random_start(seed)
    whole, cut = begin(start), begin(start)
    whole.step(sum(parts))
    for part in parts:
        cut.step(part)
    assert state(whole) == state(cut)


@given(SEEDS, st.integers(1, 60))
@EXAMPLES
def test_the_order_of_acting_does_not_matter(seed: int, ticks: int) -> None:
    order = Random(seed)

    class Shuffled(ReferenceEngine):
        def _act(self, actions: list[Action]) -> None:
            super()._act(order.sample(actions, len(actions)))

    start = random_start(seed)
    engine, shuffled = begin(start), begin(start, Shuffled)
    engine.step(ticks)
    shuffled.step(ticks)
    assert state(engine) == state(shuffled)


@given(SEEDS)
@EXAMPLES
def test_every_tick_leaves_a_world_that_can_be(seed: int) -> None:
    start = random_start(seed)
    engine = begin(start)
    last = engine.frozen_world()
    for _ in range(60):
        engine.step()
        world = engine.frozen_world()
        assert_possible(engine, start.hierarchy, world)
        assert_possible_step(engine, last, world)
        last = world


def assert_possible(engine: ReferenceEngine, forest: Hierarchy, world: FrozenWorld) -> None:
    params, spans = engine.world.params, engine.spans()
    agents, boxes = spans["agent"], spans["box"]
    assert len(agents) == len(forest.agents())
    assert all(0.0 <= x <= params.width for x in world["x"])
    assert all(0.0 <= y <= params.height for y in world["y"])
    assert all(-pi <= heading < pi for heading in world["heading"])
    assert {world["held"][agent] for agent in agents} <= {-1, *boxes}
    for box in boxes:
        assert world["pulling"][box] == world["held"].count(box) <= world["needed"][box]
    assert set(world["wants"]) == {-1}
    assert set(world["lets_go"]) == {0}
    assert -1 <= engine.progressed < engine.tick


def assert_possible_step(engine: ReferenceEngine, last: FrozenWorld, world: FrozenWorld) -> None:
    """Nobody jumps but boxes that were delivered, and each of those counts."""
    params = engine.world.params
    spans = engine.spans()
    jumped = [e for e in range(len(world["x"])) if _way(last, world, e) > params.step * (1 + 1e-9)]
    assert set(jumped) <= set(spans["box"])
    delivered = world["boxes_delivered"][0] - last["boxes_delivered"][0]
    assert len(jumped) <= delivered <= len(spans["box"])
    assert world["weight_delivered"][0] >= last["weight_delivered"][0] + delivered
    assert (engine.progressed == engine.tick - 1) == (delivered > 0)
    for box in jumped:
        home = spans["deposit"].start
        assert (
            dist((world["x"][box], world["y"][box]), (world["x"][home], world["y"][home]))
            > params.deposit_range
        )


def _way(last: FrozenWorld, world: FrozenWorld, entity: int) -> float:
    return dist((last["x"][entity], last["y"][entity]), (world["x"][entity], world["y"][entity]))


def test_these_worlds_are_ones_in_which_things_happen() -> None:
    happened = {"attached": 0, "full": 0, "delivered": 0}
    for seed in range(120):
        engine = begin(random_start(seed))
        engine.step(60)
        world = engine.world
        happened["attached"] += max(world.held) >= 0
        happened["full"] += any(
            got >= needed > 0 for got, needed in zip(world.pulling, world.needed, strict=True)
        )
        happened["delivered"] += engine.progressed >= 0
    assert happened["attached"] > 40
    assert happened["full"] > 5
    assert happened["delivered"] > 5
