"""Finding the scenario of a project; code that came with a project runs only after the user trusts it."""

import sys
from collections.abc import Sequence
from importlib import import_module
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec, SourceFileLoader
from importlib.util import module_from_spec, spec_from_file_location, spec_from_loader
from pathlib import Path
from types import ModuleType

from ..core.errors import ScenarioError
from ..core.project import Project
from ..sim.failure import place_in
from ..sim.scenario import Scenario
from ..sim.scenarios import shipped

#: What a project's ``scenario`` says when it brings its own code, and the name of that file in its folder.
OWN_CODE = "scenario.py"
#: The name of such a module once it runs.
OWN_MODULE = "understudy_project_scenario"
#: The name of this package where it is installed, by which projects import from it, and the one it runs as.
PUBLIC_NAME, RUNS_AS = "understudy", __name__.split(".", maxsplit=1)[0]


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


def whereabouts(scenario: Scenario) -> tuple[str, str, str]:
    """The name, module and file of a scenario, by which another process finds it, see `found_again`."""
    reset = scenario.stages["reset"]
    return scenario.name, reset.__module__, reset.__code__.co_filename


def found_again(name: str, module: str, path: str) -> Scenario:
    """The scenario of this name, module and file, which runs already in the process that asks for it.

    Raises:
        ScenarioError: It is not there any more, or its module fails.
    """
    if module == OWN_MODULE:
        return _own(Path(path))
    found = [value for value in vars(import_module(module)).values() if isinstance(value, Scenario)]
    for scenario in found:
        if scenario.name == name:
            return scenario
    raise ScenarioError(f"{path}: no scenario {name!r} is declared there")


def scenario_at(path: Path) -> Scenario:
    """The scenario that a file declares as ``scenario``; the file is run for it, as its author wants.

    Raises:
        ScenarioError: There is no such file, it fails, or it declares none.
    """
    if not path.is_file():
        raise ScenarioError(f"{path}: there is no such file to take the scenario from")
    return _own(path)


def _own(path: Path) -> Scenario:
    """The scenario that the module at *path* declares as ``scenario``."""
    module = _executed(path)
    found = getattr(module, "scenario", None)
    if not isinstance(found, Scenario):
        raise ScenarioError(
            f"{path}: it must assign a Scenario to the name 'scenario'; found {type(found).__name__}"
        )
    if "reset" not in found.stages:
        raise ScenarioError(f"{path}: it declares no reset, which says how a world begins")
    return found


def _executed(path: Path) -> ModuleType:
    """The module at *path*, run anew."""
    _refuse_missing(path)
    _offer_contract()
    spec = spec_from_file_location(OWN_MODULE, path, loader=_Unstored(path))
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    sys.modules[spec.name] = module  # dataclasses look their module up
    try:
        spec.loader.exec_module(module)
    except (Exception, SystemExit) as error:
        del sys.modules[spec.name]
        raise ScenarioError(f"{path}{_line(path, error)}: {type(error).__name__}: {error}") from error
    return module


def _refuse_missing(path: Path) -> None:
    try:
        there = path.is_file()
    except OSError as error:
        raise ScenarioError(f"{path}: it cannot be read: {error.strerror}") from error
    if not there:
        raise ScenarioError(f"{path}: the project says that its scenario is here, but there is no such file")


def _line(path: Path, error: BaseException) -> str:
    """The line of the file that was running; a syntax error names it by itself."""
    line = place_in(str(path), error)[1]
    return f", line {line}" if line else ""


class _Unstored(SourceFileLoader):
    """Compiles a file each time: nothing is written into the user's project, and no edit is missed."""

    def __init__(self, path: Path) -> None:
        super().__init__(OWN_MODULE, str(path))

    def path_stats(self, path: str) -> dict[str, float]:
        """Refuse to tell a file's age, so that no bytecode is looked for or kept."""
        raise OSError(path)


# ------------------------------------------------------------------------------------------- the public name


class _Alias(MetaPathFinder, Loader):
    """Imports of ``understudy.X`` give the very module that runs here, whatever name this package runs as."""

    def find_spec(
        self, name: str, _path: Sequence[str] | None = None, _target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Take on the public name and all below it."""
        ours = name == PUBLIC_NAME or name.startswith(PUBLIC_NAME + ".")
        return spec_from_loader(name, self) if ours else None

    def exec_module(self, module: ModuleType) -> None:
        """Put the module that runs in the place of the empty one just made."""
        name = module.__name__
        sys.modules[name] = import_module(RUNS_AS + name.removeprefix(PUBLIC_NAME))


def _offer_contract() -> None:
    """Let ``from understudy.sim.scenario import ...`` find the contract that runs, not another copy of it."""
    if RUNS_AS != PUBLIC_NAME and not any(isinstance(finder, _Alias) for finder in sys.meta_path):
        sys.meta_path.insert(0, _Alias())
