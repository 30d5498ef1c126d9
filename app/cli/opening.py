"""Opening what the user named: a project's folder, or a file that was exported from one, and its scenario."""

import atexit
import shutil
import tempfile
from dataclasses import dataclass
from pathlib import Path

from ..core.errors import StorageError
from ..core.project import Project
from ..core.storage import load
from ..engine.scenarios import OWN_CODE, TrustError, brings_code, open_scenario
from ..export.library_file import Exported, is_export, names_export, read
from ..sim.scenario import Scenario


@dataclass(frozen=True, slots=True)
class Opened:
    """A project with the scenario that it lives in.

    Attributes:
        file: Where it was exported to; None for a project in its own folder.
    """

    folder: Path
    project: Project
    scenario: Scenario
    file: Path | None = None


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
    if is_export(folder):
        raise StorageError(
            f"{folder}: this is a file; a project is a folder. If it was exported, `understudy run {folder}` runs it, and "
            f"`understudy import {folder} PROJECT` brings it into a project"
        )
    if folder.is_file():
        raise StorageError(f"{folder}: this is a file; a project is a folder that holds a project.json")
    return load(folder)


def open_runnable(path: Path, *, trust: bool = False) -> Opened:
    """The project in a folder, or in a file that was exported from one.

    Raises:
        UnderstudyError: It cannot be read, or brings code that is not trusted.
    """
    if not names_export(path):
        return open_project(path, trust=trust)
    exported = read(path)
    if not brings_code(exported.project):
        return Opened(path.parent, exported.project, open_scenario(exported.project), path)
    if not trust:
        raise TrustError(
            f"{path}: this file carries code (its scenario_code); read it, then allow it to run with --trust"
        )
    folder = _unpacked(exported)
    return Opened(folder, exported.project, open_scenario(exported.project, folder, trust=True), path)


def _unpacked(exported: Exported) -> Path:
    """A folder with the scenario's code, there until the program ends."""
    folder = Path(tempfile.mkdtemp(prefix="understudy-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    (folder / OWN_CODE).write_text(exported.scenario_code, encoding="utf-8")
    return folder
