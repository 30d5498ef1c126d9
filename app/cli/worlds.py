"""Several worlds at a time; Ctrl-C ends them all and keeps what is finished.

Compiled worlds run on threads. Uncompiled ones hold Python's lock, so each gets a process of its own.
"""

import signal
import time
from collections.abc import Callable, MutableSequence, Sequence
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from functools import partial
from multiprocessing import get_context

from ..engine.children import clear_up_in_silence, end_with_parent
from ..engine.compiling import compile_ahead
from ..engine.cores import cores
from ..engine.interrupts import Interrupts, deaf_processes, noted_interrupts
from ..engine.runs import RunResult, Treatment, start_engine
from ..sim.engines import REFERENCE
from ..sim.reference import ReferenceEngine
from .console import Advance, say
from .plans import Bench, Plan, Workshop

#: Seconds between looks at how far the runs are.
GLANCE = 0.1
#: Agent ticks that take longer, uncompiled, than it takes to start a process.
WORTH_A_PROCESS = 50_000

#: How many ticks of each run are done, and in the last place whether all are to stop.
Board = MutableSequence[int]
#: A result for each plan, None where it did not get to its end; and whether the user stopped them.
Made = tuple[Sequence[RunResult | None], bool]


@dataclass(frozen=True, slots=True)
class Ran:
    """What came of the plans, in their order.

    Attributes:
        results: None for a run that did not get to its end.
        seconds: How long all of them together took, not counting what is done only once, such as compiling.
        interrupted: The user stopped them.
    """

    results: tuple[RunResult | None, ...]
    seconds: float
    interrupted: bool = False


def run_plans(bench: Bench, plans: Sequence[Plan], jobs: int | None, advance: Advance) -> Ran:
    """Make all runs.

    Args:
        jobs: How many runs at a time; None makes as many as pay.
        advance: Told how many ticks of all runs together are done.

    Raises:
        UnderstudyError: Something is wrong with an arm; nothing has run then.
    """
    shop = Workshop(bench)
    compiled = make_ready(shop, plans)
    wanted = min(jobs or worthwhile(plans, cores(), compiled=compiled), len(plans))
    began = time.perf_counter()
    if compiled or wanted <= 1:
        results, interrupted = _in_threads(shop, plans, wanted, advance)
    else:
        results, interrupted = _in_processes(bench.lightened(), plans, wanted, advance)
    return Ran(tuple(results), time.perf_counter() - began, interrupted)


def make_ready(shop: Workshop, plans: Sequence[Plan]) -> bool:
    """Start one world of each arm: what is wrong with it is known at once, and its kernel is compiled once, here.

    Returns:
        Whether all arms run compiled.
    """
    arms = {plan.arm.name: plan for plan in plans}.values()
    _compile([shop.settled(plan) for plan in arms])
    engines = [start_engine(shop.settled(plan), plan.seed, notice=say) for plan in arms]
    return not any(isinstance(engine, ReferenceEngine) for engine in engines)


def _compile(treatments: Sequence[Treatment]) -> None:
    """Have all kernels compiled in a process of its own: raised halfway into a compiler, Ctrl-C may get lost."""
    with noted_interrupts() as interrupts:
        for of in treatments:
            if of.engine != REFERENCE and not interrupts.came:
                compile_ahead(of.scenario, of.physics, say, lambda: interrupts.came)
    if interrupts.came:
        raise KeyboardInterrupt


def worthwhile(plans: Sequence[Plan], cores: int, *, compiled: bool) -> int:
    """How many runs at a time pay: threads always do, processes take a second or two to start."""
    agent_ticks = sum(len(plan.arm.forest().agents()) * plan.ticks for plan in plans)
    return cores if compiled or agent_ticks >= WORTH_A_PROCESS else 1


def _made(shop: Workshop, board: Board, index: int, plan: Plan) -> RunResult:
    """One run that tells the board how far it is, and stops when the board says so."""

    def progress(done: int) -> None:
        board[index] = done

    return shop.make(plan, progress, lambda: bool(board[-1]))


def _in_threads(shop: Workshop, plans: Sequence[Plan], count: int, advance: Advance) -> Made:
    board = [0] * (len(plans) + 1)
    pool = ThreadPoolExecutor(count, thread_name_prefix="world")
    return _gathered(pool, partial(_made, shop, board), plans, board, advance)


def _in_processes(bench: Bench, plans: Sequence[Plan], count: int, advance: Advance) -> Made:
    clear_up_in_silence()
    context = get_context("spawn")
    board: Board = context.Array("q", len(plans) + 1, lock=False)
    pool = ProcessPoolExecutor(count, context, _begin, (bench, board))
    return _gathered(pool, _made_in_worker, plans, board, advance)


# ------------------------------------------------------------------------------------------------------ gathering


def _gathered(
    pool: Executor,
    make: Callable[[int, Plan], RunResult],
    plans: Sequence[Plan],
    board: Board,
    advance: Advance,
) -> Made:
    """Wait for all runs, or stop them; when this returns or raises, nothing runs any more."""
    futures: list[Future[RunResult]] = []
    with noted_interrupts() as interrupts:
        try:
            with deaf_processes():
                futures += [pool.submit(make, index, plan) for index, plan in enumerate(plans)]
            _watch(futures, lambda: advance(sum(board[:-1])), interrupts)
        finally:
            board[-1] = 1
            pool.shutdown(wait=True, cancel_futures=True)
    made = [_result(future, plan) for future, plan in zip(futures, plans, strict=True)]
    return made, interrupts.came


def _watch(futures: Sequence[Future[RunResult]], glance: Callable[[], None], interrupts: Interrupts) -> None:
    """Wait for all, or until the user interrupts, looking now and then. The first error of a run is raised."""
    running = set(futures)
    while running and not interrupts.came:
        done, running = wait(running, GLANCE)
        for future in done:
            if not isinstance(future.exception(), BrokenProcessPool):
                future.result()
        glance()


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


# ------------------------------------------------------------------------------------------ other processes

#: In a worker process: what it works with.
_work: tuple[Workshop, Board]


def _begin(bench: Bench, board: Board) -> None:
    """Runs first in a worker process. Ctrl-C reaches it, too, but only its parent decides what that means."""
    global _work  # noqa: PLW0603 - an executor offers its workers no other place
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    end_with_parent()
    _work = Workshop(bench), board


def _made_in_worker(index: int, plan: Plan) -> RunResult:
    return _made(*_work, index, plan)
