"""`understudy check`: every problem by file, place and message."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from app.cli import main
from app.cli.places import shipped_project
from app.core.project import Project
from tests.unit.cli.foraging import ARMS, project, stored


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return stored(tmp_path / "boxes")


def problems(folder: Path, capsys: pytest.CaptureFixture[str], *more: str) -> list[dict[str, str]]:
    code = main(["check", str(folder), "--json", *more])
    document = json.loads(capsys.readouterr().out)
    assert code == (0 if document["ok"] else 2)
    found: list[dict[str, str]] = document["problems"]
    return found


def test_a_sound_project_has_no_problems(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", str(folder)]) == 0
    assert capsys.readouterr().out == f"{folder}: no problems\n"


def test_json_names_file_place_and_message(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    stored(folder, project((replace(ARMS[0], top="Forrage"),)))
    (problem,) = problems(folder, capsys)
    assert (problem["file"], problem["where"]) == ("project.json", "arms[0].top")
    assert "did you mean 'Forage'?" in problem["message"]


def test_a_problem_is_a_line_with_file_place_and_message(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    stored(folder, project((replace(ARMS[0], top="Forrage"),)))
    assert main(["check", str(folder)]) == 2
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("project.json: arms[0].top: arm 'independent' starts with 'Forrage'")
    assert lines[-1] == f"{folder}: 1 error"


def test_warnings_are_no_errors(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made = project()
    agents = made.library("agent").automata
    idle = replace(agents["Wander"], rules=())
    libraries = {
        **made.libraries,
        "agent": replace(made.library("agent"), automata={**agents, "Wander": idle}),
    }
    folder = stored(tmp_path / "idle", replace(made, libraries=libraries))
    assert main(["check", str(folder)]) == 0
    out = capsys.readouterr().out
    assert out.startswith("warning: libraries/agent/Wander.json: ")
    assert out.endswith(("warnings\n", "warning\n"))


def test_parameters_out_of_range_are_found(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    stored(
        folder,
        project((replace(ARMS[0], parameters={"boxes": -3}), replace(ARMS[1], parameters={"bxes": 3}))),
    )
    first, second = problems(folder, capsys)
    assert "boxes must be 0 or more, but it is -3" in first["message"]
    assert second["where"] == "arms[1].parameters"


def damaged(folder: Path, file: str, text: str) -> Path:
    (folder / file).write_text(text)
    return folder


@pytest.mark.parametrize(
    ("file", "text", "where"),
    [
        ("project.json", '{"name": "Boxes', ""),
        ("libraries/agent/Goto.json", "{}", ""),
        ("libraries/agent/Goto.json", "not json", ""),
    ],
)
def test_damaged_files_are_named(
    file: str, text: str, where: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    found = problems(damaged(folder, file, text), capsys)
    assert {problem["file"] for problem in found} == {file}
    assert main(["check", str(folder)]) == 2
    assert "not checked: names, bindings and experiments" in capsys.readouterr().out


def test_a_project_of_a_newer_schema_is_refused_with_what_to_do(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    document = json.loads((folder / "project.json").read_text())
    key = next(key for key in document if "schema" in key)
    (folder / "project.json").write_text(json.dumps({**document, key: 10_000}))
    (problem,) = problems(folder, capsys)
    assert problem["file"] == "project.json"
    assert "10000" in problem["message"]


def test_a_folder_that_is_no_project_is_told_so(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (problem,) = problems(tmp_path, capsys)
    assert "this is no project" in problem["message"]


def with_code(tmp_path: Path) -> Path:
    carrying: Project = replace(project(), scenario="scenario.py")
    folder = stored(tmp_path / "carrying", carrying)
    (folder / "scenario.py").write_text("from app.sim.scenarios.foraging import scenario\n")
    return folder


def test_untrusted_code_is_not_run_and_what_could_not_be_checked_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = with_code(tmp_path)
    (folder / "scenario.py").write_text("raise SystemExit('it ran')\n")
    assert main(["check", str(folder)]) == 0
    out = capsys.readouterr().out
    assert "not checked: names, bindings and parameters against scenario.py" in out
    assert "--trust" in out


def test_trusted_code_is_run_and_all_is_checked(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = with_code(tmp_path)
    assert main(["check", str(folder), "--trust", "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == {"ok": True, "problems": [], "unchecked": ""}


def test_code_that_fails_is_a_problem_of_the_project(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = with_code(tmp_path)
    (folder / "scenario.py").write_text("1 / 0\n")
    (problem,) = problems(folder, capsys, "--trust")
    assert "ZeroDivisionError" in problem["message"]


def test_a_scenario_that_is_not_there_is_answered_with_those_there_are(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = stored(tmp_path / "p", replace(project(), scenario="foragin"))
    (problem,) = problems(folder, capsys)
    assert "foraging" in problem["message"]


def test_what_is_wrong_with_an_experiment_is_found(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "experiments").mkdir()
    figure3 = json.loads((shipped_project("foraging") / "experiments" / "figure3.json").read_text())
    experiment = {**figure3, "arms": [{**arm, "arm": "nobody"} for arm in figure3["arms"]]}
    (folder / "experiments" / "none.json").write_text(json.dumps(experiment))
    (folder / "experiments" / "torn.json").write_text("{")
    found = problems(folder, capsys)
    assert {problem["file"] for problem in found} == {"experiments/none.json", "experiments/torn.json"}
    assert any("'nobody'" in problem["message"] for problem in found)


def own_scenario(tmp_path: Path, body: str) -> Path:
    """A project whose own scenario is the shipped one with one more behavior."""
    folder = with_code(tmp_path)
    code = f"""
from math import hypot
from app.sim.scenarios.foraging import scenario as shipped
from copy import copy
scenario = copy(shipped)
scenario.behaviors, scenario._behaviors = dict(shipped.behaviors), dict(shipped._behaviors)

@scenario.behavior("Jump")
def jump(world, me):
    '''Jump.'''
    {body}
"""
    (folder / "scenario.py").write_text(code)
    return folder


def test_code_that_cannot_be_compiled_is_warned_of(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (problem,) = problems(own_scenario(tmp_path, "world.drive[me] = hypot(0.0, 1.0)"), capsys, "--trust")
    assert (problem["file"], problem["severity"]) == ("scenario.py", "warning")
    assert "hypot" in problem["message"]


def test_code_that_breaks_the_contract_is_a_problem(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (problem,) = problems(own_scenario(tmp_path, "world.drive[0] = 1.0"), capsys, "--trust")
    assert (problem["file"], problem["severity"]) == ("scenario.py", "error")
    assert "Jump" in problem["message"]
