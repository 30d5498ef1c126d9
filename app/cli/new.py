"""``understudy new``: a project to begin with."""

from pathlib import Path
from typing import Any

from ..core.errors import ParameterError, ScenarioError
from ..core.project import Project
from ..core.storage import save
from ..engine.fresh import AGENTS, fresh_project, refuse_folder
from ..sim.scenarios import names, shipped
from .console import PROGRAM, show, show_json, show_table
from .exits import DONE
from .wording import unknown


def make_project(folder: Path, scenario_name: str, *, as_json: bool) -> int:
    """Make a project in *folder* and say where it is."""
    refuse_folder(folder)
    if scenario_name not in names():
        raise ScenarioError(unknown("scenario", scenario_name, names()))
    scenario = shipped(scenario_name)
    project = fresh_project(folder.resolve().name, scenario)
    save(project, folder)
    if as_json:
        show_json(document(project, folder))
    else:
        show(f"{folder}: {AGENTS} agents in {scenario.title.lower()}, which all do {project.arms[0].top}")
        show(f"next: {PROGRAM} run {folder}")
    return DONE


def document(project: Project, folder: Path) -> dict[str, Any]:
    """The result for programs."""
    arm = project.arms[0]
    return {
        "project": project.name,
        "folder": str(folder),
        "scenario": project.scenario,
        "arm": arm.name,
        "top": arm.top,
    }


def refuse_incomplete(folder: Path | None, scenario_name: str | None) -> tuple[Path, str]:
    """What was asked for, where both were.

    Raises:
        ParameterError: The folder or the scenario was not named.
    """
    if folder is None:
        raise ParameterError(f"{PROGRAM} new: name the folder, DIR, that the project is to be in")
    if scenario_name is None:
        raise ParameterError(
            f"{PROGRAM} new: name the world that its agents live in: --scenario {' or '.join(names())}"
        )
    return folder, scenario_name


def show_scenarios(*, as_json: bool) -> int:
    """What `--scenario` can be."""
    if as_json:
        show_json({"scenarios": [{"name": name, "doc": shipped(name).doc} for name in names()]})
    else:
        show_table(("scenario", "what it is"), [(name, shipped(name).doc) for name in names()], words=2)
    return DONE
