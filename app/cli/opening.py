"""Opening what the user named: a project's folder, and its scenario."""

from dataclasses import dataclass
from pathlib import Path

from ..core.errors import StorageError
from ..core.project import Project
from ..core.storage import load
from ..engine.scenarios import open_scenario
from ..sim.scenario import Scenario


@dataclass(frozen=True, slots=True)
class Opened:
    """A project with the scenario that it lives in."""

    folder: Path
    project: Project
    scenario: Scenario


def open_project(folder: Path, *, trust: bool = False) -> Opened:
    """The project in *folder*.

    Raises:
        UnderstudyError: It cannot be read, or brings code that is not trusted.
    """
    project = load_folder(folder)
    return Opened(folder, project, open_scenario(project, folder, trust=trust))


def load_folder(folder: Path) -> Project:
    """The project in *folder*, unchecked; a file is refused in words of its own."""
    if folder.name == "project.json":
        raise StorageError(f"{folder}: name the project's folder instead: {folder.parent}")
    if folder.is_file():
        raise StorageError(f"{folder}: this is a file; a project is a folder that holds a project.json")
    return load(folder)
