"""Whether an experiment keeps more and more in memory."""

import gc
import os
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

from ..experiments.load import load_experiment
from ..experiments.runner import Controls, Progress, carry_out
from ..experiments.store import Results
from ..interrupts import noted_interrupts
from .subject import Subject, UnmeasurableError

#: Of each of four arms; results kept by mistake would add 2 KiB a run.
RUNS, TICKS = 400, 100
#: Where Linux says how many pages a process has in memory, as the second number.
PAGES = Path("/proc/self/statm")
#: Until this share of the runs is made, caches and pools still fill.
SETTLED = 0.25
SAMPLES = 64


def growth_with_runs(of: Subject) -> float:
    """By how many MiB the memory of an experiment of 1,600 runs grows from its second quarter to its second half."""
    if not PAGES.exists():
        raise UnmeasurableError("this system does not say how much memory a process uses")
    seen: list[tuple[float, float]] = []

    def tell(progress: Progress) -> None:
        if progress.share - (seen[-1][0] if seen else 0.0) >= 1.0 / SAMPLES:
            gc.collect()  # worlds that have been run wait for it in cycles; they are not kept
            seen.append((progress.share, megabytes()))

    experiment = load_experiment(of.folder, "figure3", of.project, of.scenario)
    experiment = replace(experiment, runs=of.much(RUNS), ticks=of.much(TICKS), points=of.much(TICKS))
    with (
        TemporaryDirectory() as place,
        Results.open(Path(place) / "results.sqlite", {}) as results,
        noted_interrupts() as interrupts,
    ):
        controls = Controls(stopped=lambda: interrupts.came)
        carry_out(of.project, of.scenario, experiment, results, of.cores, tell, controls)
    if interrupts.came:
        raise KeyboardInterrupt
    return growth(seen)


def growth(seen: list[tuple[float, float]]) -> float:
    """How much more there was at least in the second half than before, of (share of the work, memory).

    What is kept raises the least; what comes and goes does not.
    """
    before = [memory for share, memory in seen if SETTLED <= share <= 0.5]
    after = [memory for share, memory in seen if share > 0.5]
    if not before or not after:
        return 0.0
    return max(0.0, min(after) - min(before))


def megabytes() -> float:
    """What this process has in memory now, in MiB."""
    pages = int(PAGES.read_text(encoding="ascii").split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20
