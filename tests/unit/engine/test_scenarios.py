"""Where a project's scenario comes from, and that its own code runs only once it is trusted."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import app.core.vocabulary
import app.sim.scenario
from app.core.errors import ScenarioError
from app.core.project import Project
from app.engine.scenarios import OWN_CODE, TrustError, brings_code, open_scenario
from app.sim.scenario import Scenario
from app.sim.scenarios.foraging import scenario as foraging

OWN = Project("Mine", OWN_CODE)
CODE = '''"""Mine."""
from dataclasses import dataclass
from understudy.sim.scenario import FeatureKind, Scenario, quantity

@dataclass(frozen=True, slots=True)
class Parameters:
    size: float = quantity(1.0, "units", doc="how large")

scenario = Scenario("mine", "Mine", Parameters)

@scenario.feature("X", FeatureKind.CONTINUOUS)
def x(world, me):
    """Where the agent is."""
    return world.x[me]

@scenario.reset
def reset(world):
    """Begin."""
'''


def opened(folder: Path, code: str | bytes = CODE, *, trust: bool = True) -> Scenario:
    data = code if isinstance(code, bytes) else code.encode()
    (folder / OWN_CODE).write_bytes(data)
    return open_scenario(OWN, folder, trust=trust)


def refusal(folder: Path, code: str | bytes) -> str:
    with pytest.raises(ScenarioError) as error:
        opened(folder, code)
    message = str(error.value)
    assert message.startswith(f"{folder / OWN_CODE}")
    return message.removeprefix(f"{folder / OWN_CODE}")


# ----------------------------------------------------------------------------------------------- shipped


def test_a_shipped_scenario_is_found_by_name() -> None:
    project = Project("Forage", "foraging")
    assert open_scenario(project) is foraging
    assert not brings_code(project)


@pytest.mark.parametrize("name", ["flying", "", "__init__", "../foraging", "foraging.py"])
def test_an_unknown_scenario_is_refused_with_those_that_there_are(name: str) -> None:
    with pytest.raises(ScenarioError, match=rf"there is no scenario '{name}'; there are: .*foraging"):
        open_scenario(Project("", name))


# ------------------------------------------------------------------------------------------ a project's own


def test_a_trusted_projects_own_scenario_is_opened(tmp_path: Path) -> None:
    scenario = opened(tmp_path)
    assert (scenario.name, list(scenario.features)) == ("mine", ["X"])
    assert brings_code(OWN)


def test_code_that_is_not_trusted_does_not_run(tmp_path: Path) -> None:
    ran = tmp_path / "ran"
    with pytest.raises(
        TrustError, match="this project carries code; read it, then allow it to run with --trust"
    ):
        opened(tmp_path, f"open({str(ran)!r}, 'w')\n{CODE}", trust=False)
    assert not ran.exists()


def test_it_imports_the_contract_that_runs_and_no_copy(tmp_path: Path) -> None:
    code = "from understudy.core import vocabulary\nimport understudy.sim.scenario as contract\n" + CODE
    scenario = opened(tmp_path, code)
    module: Any = sys.modules[scenario.features["X"].__module__]
    assert module.contract is app.sim.scenario
    assert module.vocabulary is app.core.vocabulary
    spec = app.sim.scenario.__spec__
    assert spec is not None
    assert spec.name == "app.sim.scenario", "importing it by another name does not rename it"


def test_nothing_is_written_beside_it(tmp_path: Path) -> None:
    opened(tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == [OWN_CODE]


def test_an_edit_is_never_missed(tmp_path: Path) -> None:
    assert opened(tmp_path).title == "Mine"
    assert opened(tmp_path, CODE.replace('"Mine",', '"Ours",')).title == "Ours"


def test_two_projects_do_not_share_a_scenario(tmp_path: Path) -> None:
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
    first, second = opened(tmp_path / "a"), opened(tmp_path / "b", CODE.replace('"mine"', '"other"'))
    assert (first.name, second.name) == ("mine", "other")
    assert first.parameter_fields().keys() == second.parameter_fields().keys()


# ------------------------------------------------------------------------------------------------ failures


def test_a_file_that_is_missing(tmp_path: Path) -> None:
    with pytest.raises(ScenarioError, match="says that its scenario is here, but there is no such file"):
        open_scenario(OWN, tmp_path, trust=True)


def test_a_folder_in_its_place(tmp_path: Path) -> None:
    (tmp_path / OWN_CODE).mkdir()
    with pytest.raises(ScenarioError, match="there is no such file"):
        open_scenario(OWN, tmp_path, trust=True)


def test_a_syntax_error_is_told_with_its_line(tmp_path: Path) -> None:
    assert refusal(tmp_path, CODE + "def (:\n").endswith(f"(scenario.py, line {CODE.count(chr(10)) + 1})")


def test_what_is_no_text(tmp_path: Path) -> None:
    assert refusal(tmp_path, b"x = '\xff\xfe'\n").startswith(": SyntaxError: ")


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("1 / 0", "ZeroDivisionError: division by zero"),
        ("import no_such_module", "ModuleNotFoundError: No module named 'no_such_module'"),
        ("from understudy.sim import no_such_module", "ImportError: "),
        ("import understudy.no_such_module", "ModuleNotFoundError: "),
        ("raise SystemExit(3)", "SystemExit: 3"),
        (
            "scenario.behavior('B')(reset)",
            "ScenarioError: scenario 'mine': behavior 'B' is called with 2 arguments",
        ),
    ],
)
def test_what_the_module_raises_is_told_with_its_line(tmp_path: Path, line: str, found: str) -> None:
    assert refusal(tmp_path, CODE + line).startswith(f", line {CODE.count(chr(10)) + 1}: {found}")
    assert "understudy_project_scenario" not in sys.modules


@pytest.mark.parametrize(
    ("code", "found"), [("", "NoneType"), ("scenario = 3", "int"), (CODE + "scenario = Scenario", "type")]
)
def test_a_module_that_assigns_no_scenario(tmp_path: Path, code: str, found: str) -> None:
    assert refusal(tmp_path, code) == f": it must assign a Scenario to the name 'scenario'; found {found}"


def test_a_scenario_without_a_reset(tmp_path: Path) -> None:
    assert refusal(tmp_path, CODE.partition("@scenario.reset")[0]) == (
        ": it declares no reset, which says how a world begins"
    )


def test_it_can_be_opened_where_the_package_has_not_been_imported_by_its_public_name(tmp_path: Path) -> None:
    """In a process of its own, since other tests may have imported it."""
    (tmp_path / OWN_CODE).write_text(CODE)
    program = (
        "import sys; from pathlib import Path; from app.core.project import Project; "
        "from app.engine.scenarios import open_scenario; "
        "print(open_scenario(Project('', 'scenario.py'), Path(sys.argv[1]), trust=True).name)"
    )
    root = Path(__file__).parents[3]
    done = subprocess.run(
        [sys.executable, "-c", program, str(tmp_path)], cwd=root, capture_output=True, text=True, check=False
    )
    assert (done.stdout.strip(), done.stderr) == ("mine", "")
