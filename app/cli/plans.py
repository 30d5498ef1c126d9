"""Runs to be made, and making one of them."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from ..core.project import Arm, Project, Value
from ..engine.runs import RunResult, Treatment, run, treatment
from ..engine.scenarios import open_scenario
from ..learner.trainer import classifiers

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
    """What the runs of a project need, in a form that can go to other processes."""

    project: Project
    folder: Path
    trust: bool = False

    def lightened(self) -> "Bench":
        """Without the snapshots, which no run looks at."""
        return replace(self, project=replace(self.project, moments={}))


class Workshop:
    """A bench with its scenario opened and its learned models at hand."""

    def __init__(self, bench: Bench) -> None:
        self._project = bench.project
        self._scenario = open_scenario(bench.project, bench.folder, trust=bench.trust)
        self._models = classifiers(bench.project, self._scenario.vocabulary)

    def settled(self, plan: Plan) -> Treatment:
        """What a plan says, with everything in it settled."""
        return treatment(self._project, self._scenario, plan.arm, plan.settings, plan.top, self._models)

    def make(self, plan: Plan, progress: Callable[[int], None], cancelled: Callable[[], bool]) -> RunResult:
        """Make one run, here and now."""
        points = min(max(FEWEST_POINTS, plan.ticks // SLICE), MOST_POINTS)
        return run(self.settled(plan), plan.seed, plan.ticks, points, progress, cancelled)
