"""One tick of the world, chance, and going back: what every engine has to do."""

from collections.abc import Callable
from typing import Any

import pytest

from app.core.errors import ScenarioError, SessionError
from app.core.machine import Action
from app.core.machine_state import freeze
from app.sim.engine import Control, Start
from app.sim.reference import ReferenceEngine
from app.sim.scenario import Column, Scenario, World
from app.sim.scenarios.foraging import scenario as foraging
from tests.arena import Arena
from tests.bare_scenario import empty
from tests.foragers import SMALL, alone, busy, groups, start, types


def run(structure: str = "independent", seed: int = 1, **more: Any) -> ReferenceEngine:
    """Foragers in a busy world, before the first tick."""
    return ReferenceEngine(busy(structure, seed, **more))


def state(engine: ReferenceEngine) -> tuple[Any, Any]:
    return engine.frozen_world(), freeze(engine.machine)


# ---------------------------------------------------------------------------------------------- one tick


def test_a_tick_acts_resolves_moves_and_then_applies_the_after_tick_rules() -> None:
    scenario = empty(columns=(Column("seen"),))

    def behavior(world: World, me: int) -> None:
        world.seen[me] = 10.0 * world.seen[me] + 1.0

    def stage(digit: float) -> Callable[[World], None]:
        def write(world: World) -> None:
            world.seen[0] = 10.0 * world.seen[0] + digit

        return write

    scenario.behavior("Act")(behavior)
    scenario.after_tick(stage(4.0))
    scenario.kinematics(stage(3.0))
    scenario.resolve(stage(2.0))
    engine = ReferenceEngine(begun(scenario, "Act"))
    engine.step()
    assert engine.world.seen == [1234.0]


def begun(scenario: Scenario, top: str = "") -> Start:
    return Start(scenario, scenario.settle({}), alone(), types(scenario, {}), seed=1, top=top)


def test_features_read_the_world_as_it_was_when_the_tick_began() -> None:
    engine = run("two levels")
    engine.step(30)
    sensed, inner = [], engine.senses

    class Recording:
        def __getattr__(self, name: str) -> Any:
            sensed.append(engine.frozen_world())
            return getattr(inner, name)

    engine.senses = Recording()  # type: ignore[assignment]  # whatever they are asked
    before = engine.frozen_world()
    engine.step()
    assert len(sensed) > 20
    assert all(seen == before for seen in sensed)


@pytest.mark.parametrize("structure", SMALL)
def test_the_order_in_which_agents_act_does_not_matter(structure: str) -> None:
    """All that agents want of each other is settled after all have acted."""

    class Backward(ReferenceEngine):
        def _act(self, actions: list[Action]) -> None:
            super()._act(actions[::-1])

    plan = busy(structure)
    forward, backward = ReferenceEngine(plan), Backward(plan)
    for _ in range(40):
        forward.step(10)
        backward.step(10)
        assert forward.frozen_world() == backward.frozen_world()
    assert forward.measures()["boxes"] > 0


def test_what_agents_want_does_not_outlast_the_tick() -> None:
    arena = Arena()
    arena.do("Forward")
    arena.tell("Done")
    arena.tick()
    assert (arena.world.drive[0], arena.world.turn[0]) == (0.0, 0.0)


def test_all_roots_start_with_the_top_behavior() -> None:
    engine = ReferenceEngine(start(groups(2, 2), "ControlForage"))
    assert {actor.run.behavior.name for actor in engine.machine.actors.values() if actor.run} == {
        "ControlForage"
    }
    engine.step(2)
    assert {a.run.behavior.name for a in engine.machine.actors.values() if a.run and a.is_agent} == {"Forage"}


def test_without_a_top_behavior_all_idle() -> None:
    engine = ReferenceEngine(start(alone(3)))
    before = engine.frozen_world()
    engine.step(5)
    assert engine.frozen_world() == {**before, "clock": (*before["clock"][:2], 5, before["clock"][3])}


def test_a_top_behavior_that_is_not_there_is_refused_by_name() -> None:
    with pytest.raises(SessionError, match="has no 'Fly'; there are: "):
        ReferenceEngine(start(alone(), "Fly"))


def test_physics_that_is_not_there_is_refused_by_name() -> None:
    plan = Start(foraging, foraging.settle({}), alone(), types(), seed=1, physics="fluid")
    with pytest.raises(ScenarioError, match="there is no physics 'fluid'; there are: kinematic, rigid"):
        ReferenceEngine(plan)


def test_picks_take_effect_in_the_first_tick_of_a_step_alone() -> None:
    engine = ReferenceEngine(start(alone(), "Wander"))
    taught = frozenset({"agent-1"})
    engine.step(3, Control({"agent-1": "left"}, taught))
    assert state_of(engine) == "left"
    assert freeze(engine.machine)["nodes"]["agent-1"]["run"]["entered"] == 0


def test_nodes_that_are_still_do_not_tick() -> None:
    engine = ReferenceEngine(start(alone(2), "Wander"))
    engine.step(5, Control(still=frozenset({"agent-2"})))
    assert state_of(engine, "agent-2") == "start"
    assert state_of(engine, "agent-1") != "start"


def state_of(engine: ReferenceEngine, node: str = "agent-1") -> str:
    run = engine.machine.actors[node].run
    assert run is not None
    return run.state


# ------------------------------------------------------------------------------------------------ chance


@pytest.mark.parametrize("structure", SMALL)
def test_a_run_does_not_depend_on_how_its_ticks_are_cut(structure: str) -> None:
    whole, cut = run(structure), run(structure)
    whole.step(120)
    for part in (1, 59, 0, 7, 53):
        cut.step(part)
    assert state(whole) == state(cut)


@pytest.mark.parametrize("structure", SMALL)
def test_the_same_seed_gives_the_same_run(structure: str) -> None:
    one, other = run(structure), run(structure)
    one.step(150)
    other.step(150)
    assert state(one) == state(other)


@pytest.mark.parametrize("structure", SMALL)
def test_looking_does_not_change_a_run(structure: str) -> None:
    watched, alone_ = run(structure), run(structure)
    alone_.step(60)
    for _ in range(60):
        watched.step()
        state(watched)
        watched.measures()
        for agent in range(10):
            watched.senses.feature("ICanSeeABox", agent, ())
    assert state(watched) == state(alone_)


def test_another_seed_gives_another_run_from_the_same_world() -> None:
    one, other = run(seed=1), run(seed=1)
    other.world.clock[3] += 1
    other.machine.key += 1
    one.step(50)
    other.step(50)
    assert one.frozen_world()["x"] != other.frozen_world()["x"]


def test_agents_under_the_same_conditions_decide_apart() -> None:
    engine = ReferenceEngine(start(alone(20), "Wander"))
    engine.step(200)
    assert len({state_of(engine, f"agent-{k}") for k in range(1, 21)}) > 1


# -------------------------------------------------------------------------------------------- going back


@pytest.mark.parametrize("structure", SMALL)
def test_going_on_from_a_copy_is_going_on(structure: str) -> None:
    engine = run(structure)
    engine.step(70)
    world, machine = state(engine)
    engine.step(90)
    went_on = state(engine)
    engine.restore(world, machine)
    assert engine.tick == 70
    engine.step(90)
    assert state(engine) == went_on


@pytest.mark.parametrize("structure", SMALL)
def test_a_copy_goes_on_in_an_engine_of_another_seed_as_it_would_have(structure: str) -> None:
    engine, other = run(structure, seed=1), run(structure, seed=2)
    engine.step(70)
    other.step(33)
    other.restore(*state(engine))
    engine.step(90)
    other.step(90)
    assert state(engine) == state(other)


def test_progress_and_measures_go_back_too() -> None:
    engine = run()
    before = state(engine)
    engine.step(300)
    assert engine.progressed > 0
    engine.restore(*before)
    assert (engine.progressed, engine.measures()["boxes"]) == (-1, 0.0)


def test_an_entity_that_is_not_there_cannot_be_moved() -> None:
    engine = ReferenceEngine(start(alone(2), boxes=0))
    with pytest.raises(ScenarioError, match=r"there is no entity 3; there are: agent 0 to 1, deposit 2 to 2"):
        engine.move(3, 0.0, 0.0)
