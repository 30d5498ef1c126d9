"""``understudy run``: run an arm without a window, and count."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from ..core.check import refuse, refuse_top
from ..core.errors import ParameterError, StorageError, UnderstudyError
from ..core.project import Arm, Project, Value
from ..editor.drawing.figures import Figure, FigureError, draw, refuse_format
from ..engine.runs import RunResult, Treatment, treatment
from .console import progress, say, show, show_json, show_table
from .exits import DONE, FELL_SHORT, INTERRUPTED
from .opening import Opened, open_runnable
from .pictures import Shown, figure_of_runs, mean_of
from .plans import Bench, Plan
from .settings import parsed
from .staleness import warn_of_stale
from .wording import counted, number
from .worlds import run_plans

#: Chance is settled by 63 bits.
LARGEST_SEED = 2**63 - 1


@dataclass(frozen=True, slots=True)
class Request:
    """What was asked for on the command line."""

    folder: Path
    arm: str | None
    top: str | None
    ticks: int
    seed: int
    runs: int
    settings: tuple[str, ...]
    jobs: int | None
    trust: bool


@dataclass(frozen=True, slots=True)
class Outcome:
    """What came of it.

    Attributes:
        parameters: All of the scenario's, as the runs had them.
        settings: Those that the user set for these runs.
        results: Of the runs that got to their end.
        seconds: How long all of them together took.
    """

    project: Project
    arm: Arm
    parameters: Mapping[str, Value]
    settings: Mapping[str, Value]
    ticks: int
    results: tuple[RunResult, ...]
    seconds: float

    @property
    def agents(self) -> int:
        """How many agents a run has."""
        return len(self.arm.forest().agents())

    @property
    def rate(self) -> float:
        """Agents times ticks, of all runs together, in a second."""
        return self.agents * sum(result.ticks for result in self.results) / max(self.seconds, 1e-9)


def run_project(request: Request, picture: Path | None, *, dark: bool, as_json: bool) -> int:
    """Run, and print what came of it; a picture on top if one is wanted."""
    if picture is not None:
        refuse_picture(picture)
    opened = open_runnable(request.folder, trust=request.trust)
    warn_of_stale(opened)
    outcome, interrupted = carry_out(request, opened)
    if as_json:
        show_json(document(outcome))
    else:
        _show(outcome)
    if interrupted:
        say(f"{counted(len(outcome.results), 'run')} of {request.runs} had been finished")
        return INTERRUPTED
    drawn = (
        picture is None or not outcome.results or draw_picture(figure(outcome, opened), picture, dark=dark)
    )
    return DONE if drawn and len(outcome.results) == request.runs else FELL_SHORT


def carry_out(request: Request, opened: Opened) -> tuple[Outcome, bool]:
    """Make the runs; whether they were interrupted comes second.

    Raises:
        UnderstudyError: The request names something that does not exist, or is not allowed.
    """
    arm = chosen_arm(opened.project, request.arm)
    settings = parsed(request.settings, opened.scenario)
    settled = checked(request, opened, arm, settings)
    plans = [Plan(arm, seed, request.ticks, settings, request.top) for seed in seeds(request)]
    with progress(f"Running {arm.name}", request.ticks * request.runs) as advance:
        ran = run_plans(Bench(opened.project, opened.folder, request.trust), plans, request.jobs, advance)
    results = tuple(result for result in ran.results if result is not None)
    outcome = Outcome(
        opened.project, settled.arm, settled.parameters, settings, request.ticks, results, ran.seconds
    )
    return outcome, ran.interrupted


def seeds(request: Request) -> range:
    """A seed a run."""
    last = request.seed + request.runs - 1
    if last > LARGEST_SEED:
        raise ParameterError(f"seeds go up to {LARGEST_SEED:,}, but the last would be {last:,}")
    return range(request.seed, last + 1)


def checked(request: Request, opened: Opened, arm: Arm, settings: Mapping[str, Value]) -> Treatment:
    """What every run is; what is wrong with it is known before any of them is made."""
    settled = treatment(opened.project, opened.scenario, arm, settings, request.top)
    if request.top is not None:
        refuse_top(opened.project, opened.scenario.vocabulary, settled.arm, f"--top {request.top}")
    try:
        refuse(_with_arm(opened.project, settled.arm), opened.scenario.vocabulary, arm.name)
    except UnderstudyError as error:
        if opened.file is None:
            raise
        raise type(error)(
            f"{opened.file}: {error}"
        ) from error  # the files that it names are parts of that one
    return settled


def _with_arm(project: Project, changed: Arm) -> Project:
    return replace(project, arms=tuple(changed if arm.name == changed.name else arm for arm in project.arms))


def chosen_arm(project: Project, name: str | None) -> Arm:
    """The arm called *name*, or the first."""
    if name is not None:
        return project.arm(name)
    if not project.arms:
        raise ParameterError(f"project {project.name!r} has no arms, so there is nothing to run")
    return project.arms[0]


# ------------------------------------------------------------------------------------------------------- shaping


def document(outcome: Outcome) -> dict[str, Any]:
    """The result for programs."""
    return {
        "project": outcome.project.name,
        "arm": outcome.arm.name,
        "top": outcome.arm.top,
        "agents": outcome.agents,
        "ticks": outcome.ticks,
        "settings": dict(outcome.settings),
        "runs": [
            {"seed": result.seed, "measures": dict(result.measures), "stalled": result.stalled}
            for result in outcome.results
        ],
        "mean": means(outcome.results),
        "agent_ticks_per_second": round(outcome.rate),
    }


def means(results: Sequence[RunResult]) -> dict[str, float]:
    """The mean of each measure; nothing where nothing ran."""
    names = results[0].measures if results else ()
    return {name: mean_of([result.measures[name] for result in results]) for name in names}


def columns(results: Sequence[RunResult]) -> list[str]:
    """The head of the table of runs."""
    return ["seed", *(results[0].measures if results else ()), "stalled"]


def rows(results: Sequence[RunResult]) -> list[list[str]]:
    """A row a run, and their mean below if there are several."""
    table = [
        [str(r.seed), *(number(value) for value in r.measures.values()), "yes" if r.stalled else ""]
        for r in results
    ]
    if len(results) > 1:
        stalled = f"{sum(r.stalled for r in results)} of {len(results)}"
        table.append(["mean", *(number(value) for value in means(results).values()), stalled])
    return table


def _show(outcome: Outcome) -> None:
    show(f"{outcome.project.name}: {outcome.arm.name}, where every root does {outcome.arm.top}\n")
    show_table(columns(outcome.results), rows(outcome.results))
    each = f"{counted(outcome.agents, 'agent')}, {counted(outcome.ticks, 'tick')} a run"
    show(f"\n{each}; {outcome.seconds:.1f} s, {outcome.rate:,.0f} agent ticks a second")


# ------------------------------------------------------------------------------------------------------- picture


def figure(outcome: Outcome, opened: Opened) -> Figure:
    """The runs as a figure."""
    seeds = [result.seed for result in outcome.results]
    which = f"seed {seeds[0]}" if len(seeds) == 1 else f"{len(seeds)} runs, seeds {seeds[0]} to {seeds[-1]}"
    changed = "".join(f", {name.removeprefix('world.')} {value}" for name, value in outcome.settings.items())
    subtitle = f"{counted(outcome.ticks, 'tick')}, {which}{changed}"
    title = f"{outcome.project.name}: {outcome.arm.name}"
    return figure_of_runs(
        title, subtitle, opened.scenario, [Shown(outcome.arm, outcome.parameters, outcome.results)]
    )


def refuse_picture(path: Path) -> None:
    """Raise an error if no picture can be put there, before any work is done."""
    refuse_format(path)
    if not path.parent.is_dir():
        raise StorageError(f"{path}: there is no folder {path.parent}")


def draw_picture(content: Figure, path: Path, *, dark: bool) -> bool:
    """Draw, and say where; false, and why, if that failed."""
    try:
        draw(content, path, dark=dark)
    except FigureError as error:
        say(str(error))
        return False
    say(f"picture: {path}")
    return True
