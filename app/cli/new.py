"""``understudy new``: a project to begin with."""

from pathlib import Path
from typing import Any

from ..core.errors import ParameterError, ScenarioError
from ..core.project import Project
from ..core.storage import readable, save
from ..engine.fresh import AGENTS, fresh_project, refuse_folder, save_with_code
from ..engine.scenarios import scenario_at
from ..sim.scenarios import names, shipped
from .console import PROGRAM, show, show_json, show_table
from .exits import DONE
from .wording import unknown


def make_project(folder: Path, scenario_name: str, *, as_json: bool) -> int:
    """Make a project in *folder* and say where it is.

    Args:
        scenario_name: A shipped scenario, or a Python file that declares one, which the project then brings along.
    """
    refuse_folder(folder)
    code = Path(scenario_name) if scenario_name.endswith(".py") else None
    if code is None and scenario_name not in names():
        there = unknown("scenario", scenario_name, names())
        raise ScenarioError(f"{there}; one of your own is a file: --scenario FILE.py")
    scenario = shipped(scenario_name) if code is None else scenario_at(code)
    project = fresh_project(readable(folder.resolve().name), scenario)
    if code is None:
        save(project, folder)
    else:
        project = save_with_code(project, code, folder)
    if as_json:
        show_json(document(project, folder))
    else:
        show(
            f"{folder}: {AGENTS} agents in the scenario {scenario.title!r}, which all do {project.arms[0].top}"
        )
        trust = "" if code is None else " --trust"
        show(f"next: {PROGRAM} run {folder}{trust}")
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
        raise ParameterError("name the folder, DIR, that the project is to be in")
    if scenario_name is None:
        raise ParameterError(
            f"name the world that its agents live in: --scenario {' or '.join(names())}, or a FILE.py of "
            "your own"
        )
    return folder, scenario_name


def show_scenarios(*, as_json: bool) -> int:
    """What `--scenario` can be."""
    if as_json:
        show_json({"scenarios": [{"name": name, "doc": shipped(name).doc} for name in names()]})
    else:
        show_table(("scenario", "what it is"), [(name, shipped(name).doc) for name in names()], words=2)
    return DONE
