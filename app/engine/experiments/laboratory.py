"""An experiment in the background: begun, paused, resumed, cancelled, and looked at from another thread."""

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import StrEnum
from pathlib import Path
from threading import Lock, Thread

from ...core.check import refuse
from ...core.errors import UnderstudyError
from ...core.project import Project
from ...sim.scenario import Scenario
from .findings import Findings, findings
from .fingerprint import fingerprint_of
from .plan import Experiment
from .runner import Controls, Progress, carry_out
from .store import Results, Row

#: Seconds between two summings-up at least; and they take at most this share of the time.
BETWEEN, SHARE = 1.0, 0.1


class Stage(StrEnum):
    """How far an experiment is."""

    BEGINNING = "beginning"
    RUNNING = "running"
    PAUSED = "paused"
    FINISHED = "finished"
    CANCELLED = "cancelled"
    FAILED = "failed"


@dataclass(frozen=True, slots=True)
class Look:
    """An experiment at one moment.

    Attributes:
        found: What the runs so far say; None before anything was read.
        notice: What takes long besides the runs; or what went wrong.
    """

    stage: Stage
    progress: Progress | None = None
    found: Findings | None = None
    notice: str = ""

    @property
    def is_over(self) -> bool:
        """Whether nothing will come any more."""
        return self.stage in (Stage.FINISHED, Stage.CANCELLED, Stage.FAILED)

    def without_findings(self) -> "Look":
        """How far it is, and no more."""
        return replace(self, found=None)


class Laboratory:
    """Carries out one experiment in threads of its own. Finished runs are kept, however it ends.

    Attributes:
        experiment: What is carried out.
        path: Where its results are kept.
        rows: All runs that are kept, without their curves, as they came; only ever added to.
    """

    def __init__(
        self,
        project: Project,
        scenario: Scenario,
        experiment: Experiment,
        path: Path,
        jobs: int,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        """Begin, or go on where the results in *path* end."""
        self.experiment = experiment
        self.path = path
        self._project = project
        self._scenario = scenario
        self._jobs = jobs
        self._clock = clock
        self._controls = Controls()
        self._lock = Lock()
        self._newest = Look(Stage.BEGINNING)
        self.rows: list[Row] = []
        self._sum_up_at = clock()
        self._summed_up = 0  # rows
        self._thread = Thread(target=self._work, name="laboratory", daemon=True)
        self._thread.start()

    # ---------------------------------------------------------------------------- from any other thread

    @property
    def newest(self) -> Look:
        """How it stands."""
        return self._newest

    def pause(self) -> None:
        """Let all worlds stand still."""
        self._controls.pause()
        self._show(lambda look: look if look.is_over else replace(look, stage=Stage.PAUSED))

    def resume(self) -> None:
        """Go on."""
        self._show(lambda look: replace(look, stage=Stage.RUNNING) if look.stage is Stage.PAUSED else look)
        self._controls.resume()

    def cancel(self) -> None:
        """Give up the runs that are being made; finished ones are kept."""
        self._controls.cancel()

    def close(self) -> None:
        """Cancel, and wait for all threads to end."""
        self.cancel()
        self._thread.join()

    def wait(self, seconds: float) -> None:
        """Wait until it is over, but not longer than that."""
        self._thread.join(seconds)

    # ------------------------------------------------------------------------------------- in its thread

    def _work(self) -> None:
        try:
            stage = self._carry_out()
        except UnderstudyError as error:
            self._end(Stage.FAILED, str(error))
        except BaseException as error:  # noqa: BLE001 - whatever it is, whoever looks has to hear of it
            self._end(Stage.FAILED, f"{type(error).__name__}: {error}")
        else:
            self._end(stage, "")

    def _carry_out(self) -> Stage:
        for name in dict.fromkeys(arm.arm for arm in self.experiment.arms):
            refuse(self._project, self._scenario.vocabulary, name)
        mark = fingerprint_of(self._project, self._scenario, self.experiment)
        with Results.open(self.path, mark) as results:
            results.added = lambda row: self.rows.append(row.outline())
            self.rows += results.outlines(len(self.experiment.cells()), self.experiment.runs)
            self._sum_up(results)
            finished = carry_out(
                self._project,
                self._scenario,
                self.experiment,
                results,
                self._jobs,
                lambda progress: self._tell(progress, results),
                self._controls,
                self._notice,
            )
            self._sum_up(results)
        return Stage.FINISHED if finished else Stage.CANCELLED

    def _tell(self, progress: Progress, results: Results) -> None:
        def told(look: Look) -> Look:
            stage = look.stage if look.stage is Stage.PAUSED else Stage.RUNNING
            return replace(look, stage=stage, progress=progress, notice="")

        self._show(told)
        if len(self.rows) > self._summed_up and self._clock() >= self._sum_up_at:
            self._sum_up(results)

    def _sum_up(self, results: Results) -> None:
        began, self._summed_up = self._clock(), len(self.rows)
        found = findings(self.experiment, list(self._scenario.measures), results)
        ended = self._clock()
        self._sum_up_at = ended + max(BETWEEN, (ended - began) / SHARE)
        self._show(lambda look: replace(look, found=found))

    def _notice(self, words: str) -> None:
        self._show(lambda look: replace(look, notice=words))

    def _end(self, stage: Stage, notice: str) -> None:
        self._show(lambda look: replace(look, stage=stage, notice=notice))

    def _show(self, change: Callable[[Look], Look]) -> None:
        with self._lock:
            self._newest = change(self._newest)
