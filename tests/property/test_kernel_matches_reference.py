"""The kernel and the reference engine give the same run, to the bit, whatever is run.

``UNDERSTUDY_EXAMPLES=2000 pytest tests/property/test_kernel_matches_reference.py`` looks harder.
"""

import os
from collections.abc import Mapping
from random import Random

from hypothesis import given, settings
from hypothesis import strategies as st

from app.core.machine_state import freeze
from app.engine.snapshots import views_of
from app.engine.watching import watched
from app.sim.doing import Doing
from app.sim.kernel import KernelEngine
from app.sim.reference import ReferenceEngine
from tests.random_runs import Witness, begin, compare, difference, everything, random_start, two_owners

EXAMPLES = int(os.environ.get("UNDERSTUDY_EXAMPLES", "90"))
TICKS = 40
SEEDS = st.integers(0, 1 << 32)


def pair(seed: int) -> tuple[KernelEngine, ReferenceEngine]:
    """The same random run in both engines."""
    start = random_start(seed)
    found, wanted = KernelEngine(start), ReferenceEngine(start)
    for engine in (found, wanted):
        begin(engine, seed)
    return found, wanted


@settings(max_examples=EXAMPLES)
@given(SEEDS)
def test_every_tick_of_every_run_is_the_same(seed: int) -> None:
    found, wanted = pair(seed)
    compare(found, wanted, TICKS)
    assert found.obstacle == ""


@settings(max_examples=EXAMPLES // 3)
@given(SEEDS, st.lists(st.integers(1, 30), min_size=1, max_size=5))
def test_slices_of_any_length_add_up(seed: int, slices: list[int]) -> None:
    found, wanted = pair(seed)
    for ticks in slices:
        found.step(ticks)
    wanted.step(sum(slices))
    assert difference(found, wanted) == ""


@settings(max_examples=EXAMPLES // 3)
@given(SEEDS, st.integers(0, 30))
def test_a_run_that_is_gone_back_to_goes_on_as_before(seed: int, ticks: int) -> None:
    found, _ = pair(seed)
    found.step(ticks)
    world, nodes = found.frozen_world(), freeze(found.machine)
    found.step(20)
    after, does = found.frozen_world(), freeze(found.machine)
    found.step(7)
    found.restore(world, nodes)
    found.step(20)
    assert (found.frozen_world(), freeze(found.machine)) == (after, does)


@settings(max_examples=EXAMPLES // 3)
@given(SEEDS, st.integers(0, 30))
def test_what_was_kept_of_nodes_says_later_what_they_did_then(seed: int, ticks: int) -> None:
    found, wanted = pair(seed)
    found.step(ticks)
    wanted.step(ticks)
    world, kept, right = found.columns(), found.frozen_nodes(), wanted.frozen_nodes()
    compare(found, wanted, 10)
    assert dict(kept) == right
    compare(found, wanted, 5)  # looking has changed nothing
    found.restore({name: column.tolist() for name, column in world.items()}, kept)
    assert freeze(found.machine) == right


@settings(max_examples=EXAMPLES // 3)
@given(SEEDS, st.integers(0, 20))
def test_a_run_that_moves_to_the_compiled_engine_goes_on_as_if_it_had_not(seed: int, ticks: int) -> None:
    start = random_start(seed)
    reference, wanted = ReferenceEngine(start), ReferenceEngine(start)
    for engine in (reference, wanted):
        begin(engine, seed)
        engine.step(ticks)
    found = KernelEngine(start, over=reference)
    compare(found, wanted, 20)
    assert found.obstacle == ""


@settings(max_examples=EXAMPLES // 3)
@given(SEEDS, st.integers(0, 20), st.randoms(use_true_random=False))
def test_moving_many_at_once_is_moving_one_after_the_other(seed: int, ticks: int, random: Random) -> None:
    found, wanted = pair(seed)
    for engine in (found, wanted):
        engine.step(ticks)
    before = found.columns()
    extent = float(max(before["x"].max(), before["y"].max()))
    entities = random.sample(range(len(before["x"])), k=random.randint(1, len(before["x"])))
    moves = [(entity, random.uniform(-9, extent + 9), random.uniform(-9, extent + 9)) for entity in entities]
    found.move_all(moves)
    for move in moves:
        wanted.move(*move)
    assert difference(found, wanted) == ""
    compare(found, wanted, 5)


@settings(max_examples=EXAMPLES // 3)
@given(SEEDS, st.integers(0, 20), st.integers(0, 3))
def test_a_world_is_put_back_though_the_nodes_go_on(seed: int, ticks: int, more: int) -> None:
    found, wanted = pair(seed)
    for engine in (found, wanted):
        engine.step(ticks)
        world = {name: column.tolist() for name, column in engine.columns().items()}
        engine.move(0, 1.0, 2.0)
        engine.step(more)
        engine.restore(world, {"now": ticks, "nodes": {}})
    assert difference(found, wanted) == ""
    compare(found, wanted, 5)


@settings(max_examples=EXAMPLES // 3)
@given(SEEDS, st.integers(0, 40))
def test_what_is_shown_is_the_same(seed: int, ticks: int) -> None:
    found, wanted = pair(seed)
    for engine in (found, wanted):
        engine.step(ticks)
    assert views_of(found.doing()) == views_of(wanted.doing())
    assert shown(found.doing()) == shown(wanted.doing())
    columns, rightly = found.columns(), wanted.columns()
    assert {n: (c.dtype, c.tolist()) for n, c in columns.items()} == {
        n: (c.dtype, c.tolist()) for n, c in rightly.items()
    }
    ids = [node.id for node in found.start.hierarchy.walk()]
    for watched_nodes in (ids[:1], ids[-1:], ids):
        assert watched(found, watched_nodes) == watched(wanted, watched_nodes)
    compare(found, wanted, 5)  # looking has changed nothing


def shown(doing: Doing) -> Mapping[str, object]:
    """What can be counted, and what colors each node."""
    automata = {(ref.type, ref.automaton) for ref in doing.states}
    counts = {automaton: doing.in_states(*automaton) for automaton in automata}
    colors = [None if what < 0 else doing.behaviors[what] for what in doing.shown.tolist()]
    return {
        "counts": dict(doing.counts()),
        "states": {k: v for k, v in counts.items() if v},
        "colors": colors,
    }


def test_the_same_target_can_mean_two_entities_by_who_bound_it() -> None:
    start = two_owners()
    compare(KernelEngine(start), ReferenceEngine(start), TICKS)


def test_random_runs_reach_everything() -> None:
    """Agreement means little where nothing happens: the runs compared here see every sort of event."""
    witness = Witness()
    for seed in range(300):
        found, wanted = pair(seed)
        witness.watch(wanted)
        for _ in range(TICKS):
            found.step()
            wanted.step()
            witness.look(wanted)
        differs = difference(found, wanted)
        assert not differs, f"seed {seed}, after {TICKS} ticks: {differs}"
    assert sorted(everything() - witness.reached) == []
