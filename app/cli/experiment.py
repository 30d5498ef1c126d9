"""``understudy experiment``: run what a project's experiment compares, and say what came of it."""

import shlex
from dataclasses import dataclass, replace
from pathlib import Path

from ..core.check import refuse
from ..core.errors import ParameterError
from ..core.storage import FilesError, readable
from ..core.storage.atomic import WriteError, change_files
from ..editor.drawing.experiment_chart import chart_of
from ..editor.drawing.figures import FigureError, draw
from ..engine.cores import cores
from ..engine.experiments.findings import Findings, findings
from ..engine.experiments.fingerprint import fingerprint_of
from ..engine.experiments.lengths import ENDING, results_stem
from ..engine.experiments.load import FOLDER, experiments_in, load_experiment
from ..engine.experiments.plan import SEEDS_A_CELL, Experiment
from ..engine.experiments.report import (
    Files,
    arm_columns,
    arm_rows,
    claim_columns,
    claim_rows,
    document,
    markdown,
    words_in_arms,
)
from ..engine.experiments.runner import Controls, carry_out
from ..engine.experiments.store import Results, ResultsError
from ..engine.interrupts import noted_interrupts
from .console import PROGRAM, progress, say, show, show_json, show_table
from .exits import DONE, FELL_SHORT, INTERRUPTED, WRONG_INPUT
from .opening import Opened, open_project
from .staleness import warn_of_stale
from .wording import counted

#: Where results go if nothing else is said, within the project's folder.
RESULTS = "results"


@dataclass(frozen=True, slots=True)
class Request:
    """What was asked for on the command line."""

    folder: Path
    name: str | None
    runs: int | None
    ticks: int | None
    jobs: int | None
    out: Path | None
    dark: bool
    trust: bool


def run_experiment(request: Request, *, as_json: bool) -> int:
    """Make the runs that are missing, and print and write what all of them say."""
    opened = open_project(request.folder, trust=request.trust)
    if request.name is None:
        return _show_experiments(opened, as_json=as_json)
    experiment = _asked_for(request, opened, request.name)
    refuse_unsound(opened, experiment)
    warn_of_stale(opened)
    files = _files(request, experiment)
    with Results.open(files.results, fingerprint_of(opened.project, opened.scenario, experiment)) as results:
        finished = _make_runs(request, opened, experiment, results)
        found = findings(experiment, list(opened.scenario.measures), results)
    files, drawn = _written(request, found, files) if finished else (files, True)
    if as_json:
        show_json(document(found, files))
    else:
        _show(found, files)
    if not finished:
        done = sum(summary.runs for summary in found.summaries)
        say(
            f"{counted(done, 'run')} of {len(found.summaries) * experiment.runs} are kept; the same command goes on"
        )
        return INTERRUPTED
    return DONE if drawn else FELL_SHORT


def _show_experiments(opened: Opened, *, as_json: bool) -> int:
    """List what can be run, and say what is wrong with the others."""
    names = experiments_in(opened.folder)
    if as_json:
        show_json({"project": opened.project.name, "experiments": names})
        return DONE
    if not names:
        raise ParameterError(f"{opened.folder / FOLDER} holds no experiments; each is a file NAME.json there")
    rows, wrong = [], []
    for name in names:
        try:
            found = load_experiment(opened.folder, name, opened.project, opened.scenario)
            rows.append([name, found.title])
        except FilesError as error:
            wrong.append(str(error))
    show_table(["experiment", "what it compares"], rows, words=2)
    for message in wrong:
        say(message)
    return WRONG_INPUT if wrong else DONE


def _asked_for(request: Request, opened: Opened, name: str) -> Experiment:
    experiment = load_experiment(opened.folder, name, opened.project, opened.scenario)
    if request.runs is not None and request.runs > SEEDS_A_CELL:
        raise ParameterError(f"--runs {request.runs}: an experiment has at most {SEEDS_A_CELL:,} runs an arm")
    return replace(
        experiment,
        runs=request.runs or experiment.runs,
        ticks=request.ticks or experiment.ticks,
        points=min(experiment.points, request.ticks or experiment.ticks),
    )


def refuse_unsound(opened: Opened, experiment: Experiment) -> None:
    """Raise an error if an arm of the project that takes part cannot run as it is."""
    for name in dict.fromkeys(arm.arm for arm in experiment.arms):
        refuse(opened.project, opened.scenario.vocabulary, name)


def _files(request: Request, experiment: Experiment) -> Files:
    """Where results go; runs of another length get files of their own."""
    folder = request.out or request.folder / RESULTS
    stem = results_stem(experiment.name, request.ticks)
    return Files(folder / f"{stem}{ENDING}", folder / f"{stem}.md")


def _make_runs(request: Request, opened: Opened, experiment: Experiment, results: Results) -> bool:
    """Make what is missing; false if the user stopped it."""
    cells = len(experiment.cells())
    total = cells * experiment.runs
    if there := results.count(cells, experiment.runs):
        say(f"{counted(there, 'run')} of {total} are there already, in {results.path}")
    if there == total:
        return True
    with noted_interrupts() as interrupts, progress(f"Running {experiment.name}", total) as advance:
        return carry_out(
            opened.project,
            opened.scenario,
            experiment,
            results,
            request.jobs or cores(),
            tell=lambda now: advance(now.share * total),
            controls=Controls(stopped=lambda: interrupts.came),
            notice=say,
        )


# --------------------------------------------------------------------------------------------------------- output


def _written(request: Request, found: Findings, files: Files) -> tuple[Files, bool]:
    """The figure and the report on disk; false if the figure could not be drawn."""
    figures = [files.report.with_suffix(ending) for ending in (".svg", ".png")]
    drawn = True
    try:
        for path in figures:
            draw(chart_of(found), path, dark=request.dark)
    except FigureError as error:
        say(str(error))
        figures, drawn = [], False
    files = Files(files.results, files.report, tuple(figures))
    _write(files.report, markdown(found, files, _command(request, found.experiment)))
    return files, drawn


def _write(path: Path, text: str) -> None:
    try:
        change_files({path: text.encode()}, ())
    except WriteError as error:
        raise ResultsError(f"{path}: cannot be written: {error.error.strerror or error.error}") from error


def _command(request: Request, experiment: Experiment) -> str:
    """What was typed, as far as it matters for the numbers."""
    words = [PROGRAM, "experiment", str(request.folder), experiment.name]
    options: dict[str, object] = {"--runs": request.runs, "--ticks": request.ticks, "--out": request.out}
    for option, value in options.items():
        words += [] if value is None else [option, str(value)]
    return shlex.join(map(readable, words))


def _show(found: Findings, files: Files) -> None:
    show(f"{found.experiment.title}\n")
    show_table(arm_columns(found), arm_rows(found), words_in_arms(found.experiment))
    if found.claims:
        show()
        show_table(claim_columns(found), claim_rows(found), words=len(claim_columns(found)))
    show(f"\n{counted(found.experiment.ticks, 'tick')} a run; means ± half of their 95% confidence intervals")
    for path in (files.results, files.report, *files.figures):
        if path.exists():
            show(str(path))
