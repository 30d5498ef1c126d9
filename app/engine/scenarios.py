"""Finding the scenario of a project; code that came with a project runs only after the user trusts it."""

import sys
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

from ..core.errors import ScenarioError
from ..core.project import Project
from ..sim.scenario import Scenario
from ..sim.scenarios import shipped

#: What a project's ``scenario`` says when it brings its own code, and the name of that file in its folder.
OWN_CODE = "scenario.py"


class TrustError(ScenarioError):
    """A project carries code that nobody has trusted yet."""


def brings_code(project: Project) -> bool:
    """Whether opening the project means to run code from its folder."""
    return project.scenario == OWN_CODE


def open_scenario(project: Project, folder: Path | None = None, *, trust: bool = False) -> Scenario:
    """The scenario of *project*.

    Args:
        folder: The project's folder; needed only where it brings its own code.
        trust: Whether the user trusts that code.

    Raises:
        TrustError: The project brings code and is not trusted.
        ScenarioError: There is no such scenario, or its module fails.
    """
    if not brings_code(project):
        return shipped(project.scenario)
    path = (folder or Path()) / OWN_CODE
    if not trust:
        raise TrustError(
            f"{path}: this project carries code; read it, then allow it to run with --trust (in the window: Trust)"
        )
    return _own(path)


def _offer_contract() -> None:
    """Let ``from understudy.sim.scenario import ...`` find the loaded contract, whatever name this package runs as."""
    root = __name__.split(".", maxsplit=1)[0]
    for name in ("", ".sim", ".sim.scenario"):
        sys.modules.setdefault("understudy" + name, sys.modules[root + name])


def _own(path: Path) -> Scenario:
    """The scenario that the module at *path* declares as ``scenario``."""
    if not path.is_file():
        raise ScenarioError(f"{path}: the project says that its scenario is here, but there is no such file")
    _offer_contract()
    spec = spec_from_file_location("understudy_project_scenario", path)
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    sys.modules[spec.name] = module
    try:
        spec.loader.exec_module(module)
    except Exception as error:
        raise ScenarioError(f"{path}: {type(error).__name__}: {error}") from error
    found = getattr(module, "scenario", None)
    if not isinstance(found, Scenario):
        raise ScenarioError(
            f"{path}: it must assign a Scenario to the name 'scenario'; found {type(found).__name__}"
        )
    return found
