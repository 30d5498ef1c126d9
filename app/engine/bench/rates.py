"""How fast worlds pass: in the kernel, on threads, beside a loop written by hand, uncompiled, and with rigid bodies."""

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor, wait
from dataclasses import replace
from functools import partial
from itertools import pairwise

from ...core.automaton import START, Nested, Rule, State
from ...core.conditions import Condition, Equals
from ...core.features import Ground
from ...core.library import Library
from ...core.project import Project
from ...sim.engine import Engine, Start
from ...sim.engines import COMPILED, REFERENCE
from ...sim.kernel.yardstick import Yardstick
from ..interrupts import noted_interrupts
from ..runs import Treatment, start_engine
from .subject import Subject, UnmeasurableError
from .timing import Prepare, Work, least, ratio, side_by_side

#: Ticks that pass before any are timed: by then agents are in all of their states.
WARM_UP = 5_000
#: Ticks in one timing, and timings on end: see `timing.taking_turns`.
TICKS, PIECES = 500, 10
SEEDS, ROUNDS = 4, 6
#: Timings of two worlds side by side.
PAIRS = 101
AGENT, FORAGE = "agent", "Forage"


def kernel_rate(of: Subject, arm: str) -> float:
    """Agent-ticks a second of an arm in the kernel, on one thread."""
    return _rate(of, of.arm(arm, engine=COMPILED)) * len(of.project.arm(arm).forest().agents())


def reference_rate(of: Subject) -> float:
    """Ticks a second of fifty agents on their own in the reference engine."""
    return _rate(of, of.arm("independent", engine=REFERENCE), ticks=2, pieces=30, warm_up=60, seeds=1)


def rigid_rate(of: Subject) -> float:
    """Ticks a second of fifty agents and ten boxes as rigid bodies, sensing and deciding included."""
    return _rate(of, of.arm("independent", engine=COMPILED, physics="rigid"), ticks=20, pieces=50, seeds=1)


def _rate(
    of: Subject,
    arm: Treatment,
    ticks: int = TICKS,
    pieces: int = PIECES,
    warm_up: int = WARM_UP,
    seeds: int = SEEDS,
) -> float:
    """Ticks a second."""
    ticks, pieces = of.much(ticks), of.much(pieces)
    runs = [_run(arm, seed, of.much(warm_up), ticks) for seed in _seeds(of, seeds)]
    seconds = sum(least(run, of.much(ROUNDS), of.clock, pieces) for run in runs)
    return len(runs) * pieces * ticks / seconds


def threads_ratio(of: Subject) -> float:
    """How many times as fast two worlds pass on two threads as one after the other."""
    if of.cores < 2:
        raise UnmeasurableError("two threads cannot be compared with one on a single core")
    arm = of.arm("independent", engine=COMPILED)
    # The same seed twice: of unequal runs the longer one would be waited for alone, which says nothing of threads. And
    # long pieces, beside which handing them out takes no time.
    runs = [_run(arm, 1, of.much(WARM_UP), of.much(40 * TICKS)) for _ in range(2)]
    with ThreadPoolExecutor(2, thread_name_prefix="bench") as pool:
        one, two = [partial(_in_turn, runs)], [partial(_at_once, runs, pool)]
        return ratio(one, two, of.much(ROUNDS), of.clock, of.much(PIECES))


def _in_turn(runs: Sequence[Prepare]) -> Work:
    works = [run() for run in runs]
    return lambda: [work() for work in works]


def _at_once(runs: Sequence[Prepare], pool: ThreadPoolExecutor) -> Work:
    works = [run() for run in runs]
    return lambda: _together(works, pool)


def _together(works: Sequence[Work], pool: ThreadPoolExecutor) -> None:
    """Do all works at once; Ctrl-C is heeded when they are done."""
    with noted_interrupts() as interrupts:
        futures = [pool.submit(work) for work in works]
        wait(futures)
    if interrupts.came:
        raise KeyboardInterrupt
    for future in futures:
        future.result()


def yardstick_ratio(of: Subject) -> float:
    """How many times as long the kernel takes as a loop written by hand for the same behavior."""
    arm = of.arm("independent", of.forager, engine=COMPILED)
    ticks, warm_up = of.much(TICKS), of.much(WARM_UP)
    kernel = [_run(arm, seed, warm_up, ticks) for seed in _seeds(of)]
    by_hand = [partial(_started, partial(Yardstick, start_of(arm, s)), warm_up, ticks) for s in _seeds(of)]
    return ratio(kernel, by_hand, of.much(ROUNDS), of.clock, of.much(PIECES))


def unused_ratio(of: Subject) -> float:
    """How many times as long a tick takes with a thousand more behaviors that are never entered."""
    few = of.arm("independent", of.forager, engine=COMPILED)
    many = of.arm("independent", with_unused(of.forager, of.much(1_000)), engine=COMPILED)
    crowded, plain = (
        _started(partial(start_engine, arm, 1), of.much(WARM_UP), of.much(2 * TICKS)) for arm in (many, few)
    )
    return side_by_side(crowded, plain, of.much(PAIRS), of.clock)


def with_unused(forager: Project, count: int) -> Project:
    """The forager with *count* more behaviors, which its top behavior could enter for all that anyone can tell."""
    library = forager.library(AGENT)
    forage, goto = library.by_name(FORAGE), library.by_name("Goto")
    assert forage is not None
    assert goto is not None
    copies = [replace(goto, id=f"unused-{k}", name=f"Unused{k}") for k in range(count)]
    states = [State(copy.id, Nested(copy.id, {"X": Ground("deposit")})) for copy in copies]
    # In Start nothing has said that it is done; from there on one leads to the next.
    guard = (Condition(Equals("done", 1.0)),)
    rules = [Rule("first", START, guard, states[0].id)] + [
        Rule(after.id, before.id, (), after.id) for before, after in pairwise(states)
    ]
    crowded = replace(forage, states=(*forage.states, *states), rules=tuple(rules))
    automata = {**library.automata, crowded.id: crowded, **{copy.id: copy for copy in copies}}
    return replace(forager, libraries={AGENT: Library(automata)})


def start_of(arm: Treatment, seed: int) -> Start:
    """What a run of an arm begins with."""
    types = arm.project.types_with(arm.scenario.vocabulary)
    return Start(arm.scenario, arm.parameters, arm.arm.forest(), types, seed, top=arm.arm.top)


def _seeds(of: Subject, count: int = SEEDS) -> range:
    return range(1, 1 + of.much(count))


def _run(arm: Treatment, seed: int, warm_up: int, ticks: int) -> Prepare:
    return partial(_started, partial(start_engine, arm, seed), warm_up, ticks)


def _started(make: Callable[[], Engine | Yardstick], warm_up: int, ticks: int) -> Work:
    world = make()
    world.step(warm_up)
    return partial(world.step, ticks)
