"""Several worlds at a time, each in a process of its own; Ctrl-C ends them all and keeps what is finished."""

import os
import signal
import threading
from collections.abc import Callable, Iterator, Mapping, MutableSequence, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from multiprocessing import get_context, parent_process
from pathlib import Path

from ..core.project import Arm, Project, Value
from ..engine.runs import RunResult, Treatment, run, treatment
from ..engine.scenarios import open_scenario
from ..learner.trainer import classifiers
from .console import Advance, say
from .exits import FELL_SHORT

#: Seconds between looks at how far the processes are.
GLANCE = 0.1
#: A run tells how far it is, and heeds Ctrl-C, once in so many ticks.
SLICE = 500
#: Points of a run's curve, at least and at most.
FEWEST_POINTS, MOST_POINTS = 100, 100_000


@dataclass(frozen=True, slots=True)
class Plan:
    """One run to be made."""

    arm: Arm
    seed: int
    ticks: int
    settings: Mapping[str, Value] = field(default_factory=dict)
    top: str | None = None


@dataclass(frozen=True, slots=True)
class Bench:
    """What every run of a project needs; it goes to other processes, which open the scenario anew."""

    project: Project
    folder: Path
    trust: bool = False

    def lightened(self) -> "Bench":
        """Without the snapshots, which no run looks at."""
        return replace(self, project=replace(self.project, moments={}))


@dataclass(frozen=True, slots=True)
class Ran:
    """What came of the plans, in their order.

    Attributes:
        results: None for a run that did not get to its end.
        interrupted: The user stopped them.
    """

    results: tuple[RunResult | None, ...]
    interrupted: bool = False


def run_plans(bench: Bench, plans: Sequence[Plan], processes: int, advance: Advance) -> Ran:
    """Make all runs.

    Args:
        processes: How many runs at a time; with 1 they are made in this process.
        advance: Told how many ticks of all runs together are done.
    """
    if min(processes, len(plans)) <= 1:
        return _in_turn(bench, plans, advance)
    return _at_once(bench.lightened(), plans, min(processes, len(plans)), advance)


def _in_turn(bench: Bench, plans: Sequence[Plan], advance: Advance) -> Ran:
    results: list[RunResult | None] = [None] * len(plans)
    before = 0
    try:
        for index, plan in enumerate(plans):
            done = before
            results[index] = make_run(bench, plan, lambda ticks, done=done: advance(done + ticks))  # type: ignore[misc]
            before += plan.ticks
    except KeyboardInterrupt:
        return Ran(tuple(results), interrupted=True)
    return Ran(tuple(results))


def make_run(
    bench: Bench, plan: Plan, progress: Callable[[int], None], cancelled: Callable[[], bool] = lambda: False
) -> RunResult:
    """Make one run, here and now."""
    points = min(max(FEWEST_POINTS, plan.ticks // SLICE), MOST_POINTS)
    return run(_settled(bench, plan), plan.seed, plan.ticks, points, progress, cancelled)


def _settled(bench: Bench, plan: Plan) -> Treatment:
    scenario = open_scenario(bench.project, bench.folder, trust=bench.trust)
    models = classifiers(bench.project, scenario.vocabulary)
    return treatment(bench.project, scenario, plan.arm, plan.settings, plan.top, models)


# ------------------------------------------------------------------------------------------ other processes

#: In a worker process: what it works on, how far each run is, and in the last place whether to stop.
_work: tuple[Bench, MutableSequence[int]]


def _begin(bench: Bench, ticks: MutableSequence[int]) -> None:
    """Runs first in a worker process. Ctrl-C reaches it, too, but only its parent decides what that means."""
    global _work  # noqa: PLW0603 - an executor offers its workers no other place
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    _work = bench, ticks


def _end_with_parent() -> None:
    """An executor's worker outlives a parent that was killed; ours does not."""
    parent = parent_process()
    if parent is not None:
        parent.join()
    os._exit(FELL_SHORT)


def _make(index: int, plan: Plan) -> RunResult:
    bench, ticks = _work

    def progress(done: int) -> None:
        ticks[index] = done

    return make_run(bench, plan, progress, lambda: bool(ticks[-1]))


def _at_once(bench: Bench, plans: Sequence[Plan], processes: int, advance: Advance) -> Ran:
    context = get_context("spawn")
    ticks: MutableSequence[int] = context.Array("q", len(plans) + 1, lock=False)
    with ProcessPoolExecutor(processes, context, _begin, (bench, ticks)) as pool:
        with _deaf_to_interrupts():  # what is started meanwhile stays so
            futures = [pool.submit(_make, index, plan) for index, plan in enumerate(plans)]
        try:
            interrupted = _watched(futures, lambda: advance(sum(ticks[:-1])))
        finally:
            ticks[-1] = 1
            pool.shutdown(wait=True, cancel_futures=True)
    return Ran(tuple(_result(future, plan) for future, plan in zip(futures, plans, strict=True)), interrupted)


def _watched(futures: Sequence[Future[RunResult]], glance: Callable[[], None]) -> bool:
    """Wait for all, looking now and then; true if the user interrupted that. The first error of a run is raised."""
    try:
        running = set(futures)
        while running:
            done, running = wait(running, GLANCE)
            for future in done:
                if not isinstance(future.exception(), BrokenProcessPool):
                    future.result()
            glance()
    except KeyboardInterrupt:
        return True
    return False


def _result(future: Future[RunResult], plan: Plan) -> RunResult | None:
    """The result of a run that got to its end."""
    if future.cancelled():
        return None
    try:
        result = future.result()
    except BrokenProcessPool:
        say(f"the process that ran seed {plan.seed} ended all of a sudden; was there too little memory?")
        return None
    return result if result.ticks == plan.ticks else None


@contextmanager
def _deaf_to_interrupts() -> Iterator[None]:
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
