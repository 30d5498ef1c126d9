"""One experiment as the window sees it: what is asked for, where its results are, and how far it is."""

from __future__ import annotations

import os
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from ...core.project import Project
from ...engine.experiments.findings import Findings, findings
from ...engine.experiments.fingerprint import fingerprint_of
from ...engine.experiments.lengths import ENDING, results_stem
from ...engine.experiments.load import load_experiment
from ...engine.experiments.plan import Experiment
from ...engine.experiments.store import Results, Row
from ...sim.scenario import Scenario

#: Where results are kept within a project's folder, the same as on the command line.
RESULTS = "results"


@dataclass(frozen=True, slots=True)
class Study:
    """An experiment with what it takes to run it.

    Attributes:
        declared: As its file says it.
        experiment: As it is to be run: perhaps with other runs and ticks.
        folder: Where results go.
    """

    project: Project
    scenario: Scenario
    declared: Experiment
    experiment: Experiment
    folder: Path

    @property
    def path(self) -> Path:
        """The results file; runs of another length have one of their own, as on the command line."""
        ticks = self.experiment.ticks
        stem = results_stem(self.experiment.name, None if ticks == self.declared.ticks else ticks)
        return self.folder / f"{stem}{ENDING}"

    @property
    def total(self) -> int:
        """How many runs there are to be."""
        return len(self.experiment.cells()) * self.experiment.runs

    def asked_for(self, runs: int, ticks: int) -> Study:
        """The same with other runs and ticks."""
        points = min(self.declared.points, ticks)
        return replace(self, experiment=replace(self.declared, runs=runs, ticks=ticks, points=points))

    def asking_for_all(self, kept: Kept | None) -> Study | None:
        """The same with as many runs as its results hold, if more were asked for once than now."""
        runs, ticks = self.experiment.runs, self.experiment.ticks
        return self.asked_for(kept.most, ticks) if kept is not None and kept.most > runs else None


@dataclass(frozen=True, slots=True)
class Kept:
    """What the results of a study hold.

    Attributes:
        found: None if nothing has been summed up yet.
        rows: Every run, without its curves.
        most: How many runs an arm there are, also of those that are not asked for now.
    """

    found: Findings | None
    rows: Sequence[Row]
    most: int = 0


def study_of(project: Project, scenario: Scenario, folder: Path, name: str, results: Path) -> Study:
    """The experiment *name* of the project in *folder*.

    Raises:
        UnderstudyError: There is none, or its file is damaged or names what the project does not have.
    """
    declared = load_experiment(folder, name, project, scenario)
    return Study(project, scenario, declared, declared, results)


def results_folder(project_folder: Path, own: Path) -> Path:
    """Where results go: into the project's folder, or the user's *own* where that cannot be written to."""
    inside = project_folder / RESULTS
    there = inside if inside.exists() else project_folder
    return inside if os.access(there, os.W_OK) else own / RESULTS / project_folder.name


def kept_of(study: Study) -> Kept | None:
    """What has been found so far; None if nothing was ever run.

    Raises:
        ResultsError: The file is damaged, or holds results of something else, such as of the project as it was.
    """
    if not study.path.exists():
        return None
    mark = fingerprint_of(study.project, study.scenario, study.experiment)
    with Results.open(study.path, mark) as results:
        found = findings(study.experiment, list(study.scenario.measures), results)
        cells = len(study.experiment.cells())
        return Kept(found, results.outlines(cells, study.experiment.runs), results.most(cells))


def move_aside(study: Study) -> Path:
    """Give results of the project as it was another name, so that the experiment can begin anew."""
    stamp = time.strftime("%Y-%m-%d-%H%M%S", time.localtime(study.path.stat().st_mtime))
    aside = study.path.with_name(f"{study.path.stem}-until-{stamp}{ENDING}")
    study.path.rename(aside)
    return aside
