"""Making the runs of an experiment: worlds side by side on threads of this process, each result kept at once.

The compiled engine lets go of the interpreter while it steps, so threads are enough. Runs are handed out one by one, a
round of all cells at a time; at no moment are more of them in memory than are being made.
"""

import time
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from threading import Event

import numpy as np

from ...core.project import Project
from ...sim.engine import Engine
from ...sim.engines import REFERENCE, Notice
from ...sim.physics import KINEMATIC
from ...sim.scenario import Scenario
from ..compiling import compile_ahead
from ..runs import STALLED_PART, slices, start_engine
from ..spells import Spells
from .plan import Cell, Experiment
from .store import Results, Row
from .treatments import Ready, Treatments, sorted_settings

#: Seconds between looks at how far the threads are.
GLANCE = 0.2


@dataclass(frozen=True, slots=True)
class Progress:
    """How far an experiment is.

    Attributes:
        found: Runs that were there when it began.
        ticks: Ticks that have passed in unfinished runs.
        seconds_left: None before anything can be said.
    """

    runs: int
    done: int
    found: int
    ticks: float
    seconds_left: float | None

    @property
    def share(self) -> float:
        """From 0 to 1."""
        return min(1.0, (self.done + self.ticks) / self.runs)


#: Told now and then how far the experiment is.
Tell = Callable[[Progress], None]


class Controls:
    """What a user can do to an experiment from another thread: let it pause, go on, and stop."""

    def __init__(
        self, clock: Callable[[], float] = time.perf_counter, stopped: Callable[[], bool] = lambda: False
    ) -> None:
        """Going, not cancelled.

        Args:
            stopped: Asked now and then whether it is to stop for another reason than `cancel`, such as Ctrl-C.
        """
        self._clock = clock
        self._stopped = stopped
        self._going = Event()
        self._going.set()
        self._cancelled = Event()
        # When it was paused, while it is, and for how long it was before: one value, since other threads read the two.
        self._stood: tuple[float | None, float] = None, 0.0

    def worked(self) -> float:
        """Seconds by a clock that stands still while worlds do."""
        since, before = self._stood
        return (self._clock() if since is None else since) - before

    def pause(self) -> None:
        """Let all worlds stand still; what was cancelled goes on to its end."""
        since, before = self._stood
        if since is None:
            self._stood = self._clock(), before
        self._going.clear()
        if self.cancelled:
            self._going.set()

    def resume(self) -> None:
        """Go on."""
        since, before = self._stood
        if since is not None:
            self._stood = None, before + self._clock() - since
        self._going.set()

    def cancel(self) -> None:
        """Give up the runs that are being made; finished ones are kept."""
        self._cancelled.set()
        self._going.set()

    @property
    def cancelled(self) -> bool:
        """Whether the experiment is to stop."""
        return self._cancelled.is_set() or self._stopped()

    def heed(self) -> bool:
        """Wait while paused; false if the run is to be given up."""
        self._going.wait()
        return not self.cancelled


@dataclass(slots=True)
class _Underway:
    """A run that is being made, seen from the thread that waits for it."""

    cell: Cell
    run: int
    share: float = 0.0


def carry_out(
    project: Project,
    scenario: Scenario,
    experiment: Experiment,
    results: Results,
    jobs: int,
    tell: Tell = lambda _: None,
    controls: Controls | None = None,
    notice: Notice = lambda _: None,
) -> bool:
    """Make all runs that are missing in *results*; false if that was cancelled before the end.

    Args:
        jobs: Runs at a time.
        notice: Told in a few words what takes long besides the runs.

    Raises:
        UnderstudyError: A run could not be made, or not be kept. Whatever ends it, finished runs are kept.
    """
    crew = _Crew(project, scenario, experiment, results, controls or Controls(), notice)
    crew.compile_kernels()
    with ThreadPoolExecutor(jobs, thread_name_prefix="run") as pool:
        try:
            crew.work(pool, jobs, tell)
        except BaseException:  # Ctrl-C above all: the threads have to end before the program can
            crew.controls.cancel()
            raise
    return not crew.controls.cancelled


class _Crew:
    """The runs of an experiment while they are made."""

    def __init__(
        self,
        project: Project,
        scenario: Scenario,
        experiment: Experiment,
        results: Results,
        controls: Controls,
        notice: Notice,
    ) -> None:
        self.controls = controls
        self._notice = notice
        self._scenario = scenario
        self._experiment = experiment
        self._results = results
        self._treatments = Treatments(project, scenario, experiment)
        self._cells = experiment.cells()
        self._found = results.count(len(self._cells), experiment.runs)
        self._done = self._found
        self._began = self.controls.worked()
        self._underway: dict[Future[Row | None], _Underway] = {}

    def compile_kernels(self) -> None:
        """Have all kernels compiled that runs need: a run could not be given up while it compiles its own."""
        if self._found == len(self._cells) * self._experiment.runs:
            return
        wanted = (sorted_settings(cell.settings).scenario for cell in self._cells)
        compiled = (each for each in wanted if each.get("engine") != REFERENCE)
        for physics in dict.fromkeys(str(each.get("physics", KINEMATIC)) for each in compiled):
            compile_ahead(self._scenario, physics, self._notice, lambda: self.controls.cancelled)

    def work(self, pool: ThreadPoolExecutor, jobs: int, tell: Tell) -> None:
        """Keep *jobs* runs going until all are made, or the user has had enough."""
        missing = self._missing()
        while not self.controls.cancelled:
            for _, (cell, run) in zip(range(jobs - len(self._underway)), missing, strict=False):
                underway = _Underway(cell, run)
                self._underway[pool.submit(self._make, underway)] = underway
            if not self._underway:
                break
            done, _ = wait(self._underway, GLANCE, FIRST_COMPLETED)
            for future in done:
                del self._underway[future]
                self._keep(future.result())
            tell(self._progress())
        self._keep_rest()

    def _missing(self) -> Iterator[tuple[Cell, int]]:
        """Runs to be made, a round of all cells at a time."""
        for run in range(self._experiment.runs):
            for cell in self._cells:
                if not self._results.has(cell.number, run):
                    yield cell, run

    def _keep(self, row: Row | None) -> None:
        if row is not None:
            self._results.add(row)
            self._done += 1

    def _keep_rest(self) -> None:
        """After a cancel: what is finished in the same moment is kept as well."""
        for future in self._underway:
            self._keep(future.result())

    def _progress(self) -> Progress:
        ticks = sum(underway.share for underway in self._underway.values())
        total = len(self._cells) * self._experiment.runs
        made = self._done - self._found + ticks
        passed = self.controls.worked() - self._began
        left = passed / made * (total - self._done - ticks) if made > 0.0 else None
        return Progress(total, self._done, self._found, ticks, left)

    def _make(self, underway: _Underway) -> Row | None:
        """Make one run; None if it was given up. This runs in a thread of its own."""
        cell, run = underway.cell, underway.run
        ready = self._treatments.of(cell, run)
        seed = self._experiment.seed_of(cell.number, run)
        engine = start_engine(ready.treatment, seed, notice=self._notice)
        began = self.controls.worked()
        curves = self._curves(engine, underway)
        if curves is None:
            return None
        seconds = self.controls.worked() - began
        return _row(underway, ready, engine, curves, seed, seconds)

    def _curves(self, engine: Engine, underway: _Underway) -> list[list[float]] | None:
        """Pass all ticks, measuring now and then; None if the run was given up."""
        ticks = self._experiment.ticks

        def going() -> bool:
            underway.share = engine.tick / ticks
            return self.controls.heed()

        spells = Spells(engine, going)
        samples = [list(engine.measures().values())]
        for goal in slices(ticks, self._experiment.points):
            if not spells.until(goal):
                return None
            samples.append(list(engine.measures().values()))
        return samples


def _row(
    underway: _Underway, ready: Ready, engine: Engine, curves: list[list[float]], seed: int, seconds: float
) -> Row:
    stalled = engine.progressed < (1.0 - STALLED_PART) * engine.tick
    agents = len(ready.treatment.arm.forest().agents())
    measures = {**engine.measures(), **ready.counts}
    return Row(
        underway.cell.number,
        underway.run,
        seed,
        measures,
        stalled,
        np.array(curves, np.float64).T,
        agents * engine.tick,
        seconds,
    )
