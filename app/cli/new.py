"""``understudy new``: a project to begin with."""

from pathlib import Path
from typing import Any

from ..core.errors import ScenarioError, StorageError
from ..core.library import NodeType
from ..core.project import Arm, LevelTable, Project
from ..core.storage import save
from ..core.vocabulary import Vocabulary
from ..sim.scenario import Scenario
from ..sim.scenarios import names, shipped
from .console import PROGRAM, show, show_json, show_table
from .exits import DONE
from .wording import unknown

#: As many as in the paper.
AGENTS = 50
AGENT = "agent"


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


def fresh_project(name: str, scenario: Scenario) -> Project:
    """A project without behaviors of its own: fifty independent agents."""
    arm = Arm("independent", LevelTable((AGENTS,), (AGENT,)), first_behavior(scenario.vocabulary))
    return Project(name, scenario.name, (NodeType(AGENT),), arms=(arm,))


def first_behavior(vocabulary: Vocabulary) -> str:
    """The first basic behavior that agents can go on with, all by itself."""
    for behavior in vocabulary.behaviors.values():
        if not behavior.runs_once and not behavior.parameters:
            return behavior.name
    raise ScenarioError("the scenario has no basic behavior that agents can go on with")


def refuse_folder(folder: Path) -> None:
    """Raise a `StorageError` if something is in *folder* already, or it is none."""
    if folder.exists() and not folder.is_dir():
        raise StorageError(
            f"{folder}: this is a file; a new project needs a folder that is not there yet, or is empty"
        )
    if folder.is_dir() and any(folder.iterdir()):
        raise StorageError(
            f"{folder}: something is in this folder; a new project needs one that is not there, or is empty"
        )


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


def show_scenarios() -> None:
    """What `--scenario` can be."""
    show_table(("scenario", "what it is"), [(name, shipped(name).doc) for name in names()], words=2)
