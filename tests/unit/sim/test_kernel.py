"""The compiled engine: the same runs as the reference's, whoever interferes, and what happens when something is wrong."""

import threading
from collections.abc import Mapping
from copy import copy
from dataclasses import replace
from math import inf, nan, pi
from pathlib import Path
from random import Random
from typing import Any

import pytest

from app.core.automaton import START
from app.core.errors import ScenarioError, UncompilableError
from app.core.hierarchy import from_table
from app.core.library import NodeType, Types
from app.core.machine import Actor
from app.core.machine_state import freeze, rebase
from app.sim import geometry
from app.sim.engine import Control, Past, Start
from app.sim.engines import COMPILED, REFERENCE, make_engine
from app.sim.kernel import KernelEngine, build, linking, twins
from app.sim.kernel import engine as kernel_engine
from app.sim.reference import ReferenceEngine
from app.sim.scenario import Scenario, World
from app.sim.scenarios.foraging import scenario as foraging
from tests import foragers, kernel_faults
from tests.playground import FAULTS
from tests.random_runs import compare, difference

CROWDED: Mapping[str, Any] = {
    "width": 40.0,
    "height": 40.0,
    "deposit_x": 20.0,
    "deposit_y": 20.0,
    "pullers": 3,
    "boxes": 6,
}
structures = pytest.mark.parametrize("name", foragers.STRUCTURES)


def forage(name: str, seed: int = 1) -> Start:
    """A crowded run of one of the paper's structures, so that boxes are delivered soon."""
    forest, top = foragers.STRUCTURES[name]
    return foragers.start(forest, top, seed, **CROWDED)


# ------------------------------------------------------------------------------------------- the same runs


@structures
def test_foraging_is_the_same_tick_by_tick(name: str) -> None:
    start = forage(name)
    compare(KernelEngine(start), ReferenceEngine(start), 150)


@structures
def test_foraging_is_the_same_after_many_ticks(name: str) -> None:
    start = forage(name, seed=2)
    found, wanted = KernelEngine(start), ReferenceEngine(start)
    found.step(1500)
    wanted.step(1500)
    assert difference(found, wanted) == ""
    assert found.measures() == wanted.measures()
    assert found.progressed == wanted.progressed
    assert found.measures()["boxes"] > 0


@structures
def test_rigid_worlds_are_the_same_too(name: str) -> None:
    start = replace(forage(name), physics="rigid")
    found, wanted = KernelEngine(start), ReferenceEngine(start)
    compare(found, wanted, 20)
    found.step(250)
    wanted.step(250)
    assert difference(found, wanted) == ""
    assert found.obstacle == ""


def test_worlds_side_by_side_do_not_disturb_each_other() -> None:
    engines = [KernelEngine(forage("one level", seed)) for seed in (1, 2)]
    alone = [KernelEngine(forage("one level", seed)) for seed in (1, 2)]
    threads = [threading.Thread(target=engine.step, args=(2000,)) for engine in engines]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for engine, twin in zip(engines, alone, strict=True):
        twin.step(2000)
        assert engine.frozen_world() == twin.frozen_world()


# ---------------------------------------------------------------------------------------- who interferes


def test_lessons_and_free_ticks_alternate_as_in_the_reference_engine() -> None:
    start = forage("one level")
    found, wanted = KernelEngine(start), ReferenceEngine(start)
    group = start.hierarchy.roots[0]
    pupil = group.children[0].id
    lessons = (
        Control(),
        Control({pupil: "return"}, frozenset({pupil}), frozenset({group.id})),
        Control(taught=frozenset({pupil}), still=frozenset({group.id})),
        Control(),
        Control(still=frozenset({group.id, pupil})),
        Control(),
    )
    for control in lessons:
        for engine in (found, wanted):
            if control.picks:
                engine.machine.direct(pupil, "Forage")
            engine.step(40, control)
        assert difference(found, wanted) == ""


@pytest.mark.parametrize("physics", ["kinematic", "rigid"])
@pytest.mark.parametrize("name", ["one level", "two levels"])
def test_who_stands_still_does_nothing_and_directs_nobody(name: str, physics: str) -> None:
    start = replace(forage(name), physics=physics)
    nodes, controllers = list(start.hierarchy.walk()), start.hierarchy.controllers()
    below = {node.id for node in controllers[-1].walk()}
    lone = start.hierarchy.agents()[0].id
    found, wanted = KernelEngine(start), ReferenceEngine(start)
    for still in (
        {node.id for node in controllers},
        {node.id for node in nodes if node.id not in below},  # all but one group
        set[str](),
        {lone},  # stands below one that ticks
        {"nobody"},
        {node.id for node in nodes},
    ):
        for engine in (found, wanted):
            engine.step(40, Control(still=frozenset(still)))
        assert difference(found, wanted) == ""


def test_a_tick_that_has_passed_can_be_looked_back_on() -> None:
    start, told, pasts = forage("one level"), list[tuple[int, str, str]](), list[Past]()
    groups = frozenset(node.id for node in start.hierarchy.controllers())

    def leaving(actor: Actor, _next: str) -> None:
        if actor.run is not None and actor.run.state != START and actor.parent in groups:
            told.append((wanted.tick, actor.node.id, actor.run.state))

    found, wanted = KernelEngine(start, lambda *_: None), ReferenceEngine(start, leaving)
    found.departed = pasts.append
    for engine in (found, wanted):
        engine.step(2, Control(listen=False))
        told.clear()
        engine.step(200, Control(still=groups))
    assert difference(found, wanted) == ""
    assert [(past.tick, node) for past in pasts for node, _ in past.left] == [(t, n) for t, n, _ in told]
    for past in pasts:
        replayed = list[str]()
        past.replay(lambda _machine, actor, said=replayed: said.append(actor.node.id))  # type: ignore[misc]  # mypy gives no type to lambdas with defaults
        assert {node for node, _ in past.left} <= set(replayed)
    states = {(tick, node): state for tick, node, state in told}
    for past, node, automaton in [(tick, *left) for tick in pasts for left in tick.left]:
        machine, senses = past.watch([node])
        run = machine.actors[node].run
        assert run is not None
        assert (run.behavior.name, run.state) == (automaton, states[past.tick, node])
        assert senses.target("deposit", range(1), 0) == 56
    assert len(pasts) > 10


def test_who_has_a_controller_that_ticks_is_not_said_to_have_left_anything() -> None:
    pasts = list[Past]()
    engine = KernelEngine(forage("one level"), lambda *_: None)
    engine.departed = pasts.append
    engine.step(150)
    assert {node.partition("-")[0] for past in pasts for node, _ in past.left} == {"group"}


def test_what_is_changed_between_ticks_counts() -> None:
    start = forage("two levels")
    found, wanted = KernelEngine(start), ReferenceEngine(start)
    agent = start.hierarchy.agents()[3].id
    for engine in (found, wanted):
        engine.step(100)
        engine.machine.direct(agent, "Wander")
        engine.move(50, 3.0, 4.0)
        engine.step(100)
    assert difference(found, wanted) == ""


def test_who_is_moved_in_a_compiled_run_leaves_the_nodes_in_columns(monkeypatch: pytest.MonkeyPatch) -> None:
    start = forage("two levels")
    found, wanted = KernelEngine(start), ReferenceEngine(start)
    monkeypatch.setattr(kernel_engine, "put_back", refused)
    for engine in (found, wanted):
        engine.step(100)
        before = {name: column.tolist() for name, column in engine.columns().items()}
        engine.move_all([(0, 3.0, 4.0), (50, 5.0, 6.0)])
        engine.restore(before, {"now": 100, "nodes": {}})
        engine.move(1, 3.0, 4.0)
        engine.step(100)
    monkeypatch.undo()
    assert difference(found, wanted) == ""


def refused(*_: object) -> None:
    """What must not be called."""
    raise AssertionError("the nodes are put into plain Python")


@pytest.mark.parametrize("place", [nan, inf])
def test_a_move_that_spoils_a_compiled_world_does_what_it_does_to_any(place: float) -> None:
    scenario = copy(foraging)
    scenario.stages = {
        **foraging.stages,
        "moved": lambda world, entity, x, _y: spoil(world, entity, x, place),
    }
    start = replace(forage("independent"), scenario=scenario)
    found, wanted = KernelEngine(start), ReferenceEngine(start)
    for engine in (found, wanted):
        engine.step(30)
        engine.move_all([(0, 1.0, 1.0), (1, 2.0, 2.0)])
        with pytest.raises(ScenarioError, match="column 'x' holds finite numbers, but entry 1 is"):
            engine.columns()
    assert freeze(found.machine) == freeze(wanted.machine)


def spoil(world: World, entity: int, x: float, place: float) -> None:
    """Put whoever is moved to 2.0 to a place that is none."""
    world.x[entity] = place if x == 2.0 else x


def test_of_moves_those_before_one_that_is_refused_have_been_made() -> None:
    start = forage("independent")
    found, wanted = KernelEngine(start), ReferenceEngine(start)
    for engine in (found, wanted):
        engine.step(30)
        with pytest.raises(ScenarioError, match="cannot be put at"):
            engine.move_all([(0, 1.0, 1.0), (1, inf, 2.0)])
        assert engine.columns()["x"][0] == 1.0
    assert difference(found, wanted) == ""
    compare(found, wanted, 20)


def test_agents_walk_where_they_head_even_if_something_else_has_turned_them() -> None:
    found, wanted = KernelEngine(forage("independent")), ReferenceEngine(forage("independent"))
    for heading in (0.0, -0.0, 1.0, -pi):
        for engine in (found, wanted):
            world, nodes = engine.frozen_world(), freeze(engine.machine)
            engine.restore({**world, "heading": [heading] * len(world["heading"])}, nodes)
        compare(found, wanted, 3)


def test_libraries_can_be_exchanged_in_the_middle_of_a_run() -> None:
    start = forage("one level")
    found, wanted = KernelEngine(start), ReferenceEngine(start)
    for engine in (found, wanted):
        engine.step(60)
        rebase(engine.machine, foragers.types(), engine.machine.classifiers)
        engine.step(60)
    assert difference(found, wanted) == ""


def test_an_observer_is_told_of_every_change_while_it_listens_and_costs_nothing_otherwise() -> None:
    start, told = forage("independent"), list[tuple[str, str]]()

    def leaving(actor: Actor, state: str) -> None:
        told.append((actor.node.id, state))

    engine = KernelEngine(start, leaving)
    engine.step(3)
    heard = len(told)
    assert heard >= 50
    engine.step(50, Control(listen=False))
    assert len(told) == heard


def test_senses_are_those_of_the_moment_of_asking() -> None:
    start = forage("independent")
    engine, twin = KernelEngine(start), ReferenceEngine(start)
    senses = engine.senses
    for _ in range(3):
        engine.step(100)
        twin.step(100)
        assert senses.target("deposit", range(1), 0) == twin.senses.target("deposit", range(1), 0)
        deposit = twin.world.first_deposit
        assert senses.feature("DistanceTo", 0, (deposit,)) == twin.senses.feature("DistanceTo", 0, (deposit,))
        assert senses.group_feature("SomeoneNeedsHelp", range(5)) == twin.senses.group_feature(
            "SomeoneNeedsHelp", range(5)
        )


def test_looking_at_nodes_shows_what_they_do() -> None:
    start = forage("one level")
    found, wanted = KernelEngine(start), ReferenceEngine(start)
    for _ in range(5):
        found.step(30)
        wanted.step(30)
        assert freeze(found.shown) == freeze(wanted.machine)


def test_a_behavior_that_no_table_can_hold_runs_uncompiled_with_a_reason() -> None:
    start = kernel_faults.undecided_start()
    found, wanted = (
        KernelEngine(start, classifiers=kernel_faults.fair_coin),
        ReferenceEngine(start, classifiers=kernel_faults.fair_coin),
    )
    found.step(20)
    wanted.step(20)
    assert difference(found, wanted) == ""
    assert "which cannot be compiled: ticks are slower" in found.obstacle


# -------------------------------------------------------------------------------------- what goes wrong


def bare_start(scenario: Scenario) -> Start:
    types = Types((NodeType("agent"),), {}, scenario.vocabulary)
    return Start(scenario, scenario.settle({}), from_table((2,), ("agent",)), types, 1, top="Go")


@pytest.mark.parametrize("fault", FAULTS[1:])
def test_a_function_that_fails_is_named_at_the_tick_where_it_fails(fault: str) -> None:
    start = kernel_faults.failing_start(fault)
    found, wanted = KernelEngine(start), ReferenceEngine(start)
    messages = []
    for engine in (found, wanted):
        with pytest.raises(ScenarioError) as raised:
            engine.step(50)
        messages.append((str(raised.value), engine.tick))
    assert messages[0] == messages[1]
    assert messages[0][1] == 7


def test_a_scenario_that_numba_refuses_runs_uncompiled_and_says_why() -> None:
    told: list[str] = []
    start = bare_start(kernel_faults.uncompilable())
    assert isinstance(make_engine(start, notice=told.append), ReferenceEngine)
    assert "kernel_faults.py, line" in told[-1]
    assert "uncompiled" in told[-1]
    with pytest.raises(UncompilableError, match="cannot be compiled"):
        make_engine(start, kind=COMPILED)


def test_a_scenario_that_would_compile_to_something_else_runs_uncompiled() -> None:
    told: list[str] = []
    start = bare_start(kernel_faults.unportable())
    assert isinstance(make_engine(start, notice=told.append), ReferenceEngine)
    assert "**" in told[-1]


def test_the_engine_can_be_chosen() -> None:
    start = forage("independent")
    assert isinstance(make_engine(start), KernelEngine)
    assert isinstance(make_engine(start, kind=REFERENCE), ReferenceEngine)
    with pytest.raises(ScenarioError, match="there are: auto, reference, compiled"):
        make_engine(start, kind="quick")


# ---------------------------------------------------------------------------------------- how it is made


def test_angles_wrap_as_in_plain_python_to_the_bit() -> None:
    random = Random(1)
    angles = [random.uniform(-20.0, 20.0) for _ in range(2000)]
    edges = [k * pi + d for k in range(-5, 6) for d in (0.0, 1e-16, -1e-16, 1e-9, -1e-9)]
    for angle in (*angles, *edges, -0.0, 1e300):
        assert repr(twins.wrapped(angle)) == repr(geometry.wrapped(angle))


def test_a_fingerprint_changes_with_what_a_function_calls_and_uses() -> None:
    def made(inner: float, times: int) -> str:
        space: dict[str, object] = {"LIMIT": inner}
        text = f"def inner(x):\n    return x * {times} + LIMIT\ndef outer(x):\n    return inner(x)\n"
        exec(text, space)  # noqa: S102 - our own text
        return linking.fingerprint({"f": space["outer"]})

    assert made(1.0, 2) == made(1.0, 2)
    assert len({made(1.0, 2), made(1.5, 2), made(1.0, 3)}) == 3


def test_kernels_are_kept_in_the_users_cache_folder() -> None:
    KernelEngine(forage("independent"))
    assert list(build.cache_folder().glob("kernel_*.py"))


def test_kernels_go_elsewhere_where_nothing_can_be_written(tmp_path: Path) -> None:
    assert build.writable(tmp_path / "new" / "kernels") == tmp_path / "new" / "kernels"
    (tmp_path / "file").write_text("in the way")
    elsewhere = build.writable(tmp_path / "file" / "kernels")
    assert elsewhere.is_dir()
    assert build.writable(tmp_path / "file" / "kernels") == elsewhere
