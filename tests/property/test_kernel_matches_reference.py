"""The kernel and the reference engine give the same run, to the bit, whatever is run.

``UNDERSTUDY_EXAMPLES=2000 pytest tests/property/test_kernel_matches_reference.py`` looks harder.
"""

import os

from hypothesis import given, settings
from hypothesis import strategies as st

from app.core.machine_state import freeze
from app.sim.kernel import KernelEngine
from app.sim.reference import ReferenceEngine
from tests.random_runs import Witness, compare, difference, direct_roots, everything, random_start, two_owners

EXAMPLES = int(os.environ.get("UNDERSTUDY_EXAMPLES", "90"))
TICKS = 40
SEEDS = st.integers(0, 1 << 32)


def pair(seed: int) -> tuple[KernelEngine, ReferenceEngine]:
    """The same random run in both engines."""
    start = random_start(seed)
    found, wanted = KernelEngine(start), ReferenceEngine(start)
    for engine in (found, wanted):
        direct_roots(engine, seed)
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
