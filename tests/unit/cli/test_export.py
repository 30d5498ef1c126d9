"""``understudy export``, and ``run`` of what it wrote."""

import json
from pathlib import Path

import pytest

from app.cli import main
from tests.unit.cli.foraging import ARMS, stored, taught


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return stored(tmp_path / "boxes")


def told(capsys: pytest.CaptureFixture[str]) -> tuple[str, str]:
    out, err = capsys.readouterr()
    return out, err


def runs(where: Path, capsys: pytest.CaptureFixture[str], *more: str) -> object:
    assert main(["run", str(where), "--ticks", "200", "--runs", "2", "--json", *more]) == 0
    return json.loads(told(capsys)[0])["runs"]


@pytest.mark.parametrize("arm", [arm.name for arm in ARMS])
def test_what_was_exported_runs_to_the_same_results(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], arm: str
) -> None:
    out = tmp_path / "out.json"
    assert main(["export", str(folder), "--arm", arm, "-o", str(out)]) == 0
    assert f"run {out} runs it" in told(capsys)[1]
    assert runs(out, capsys) == runs(folder, capsys, "--arm", arm)


def test_without_a_file_it_goes_to_stdout(folder: Path, capfdbinary: pytest.CaptureFixture[bytes]) -> None:
    assert main(["export", str(folder)]) == 0
    document = json.loads(capfdbinary.readouterr().out)
    assert document["format"] == "understudy export"


def test_json_says_what_was_written(folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "out.json"
    assert main(["export", str(folder), "-o", str(out), "--json"]) == 0
    document = json.loads(told(capsys)[0])
    assert document["file"] == str(out)
    assert document["arm"] == ARMS[0].name


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--format", "yaml"], "there is no format 'yaml'"),
        (["--arm", "nobody"], "there is no arm 'nobody'"),
        (["Nothing"], "Nothing"),
        (["Forage", "--arm", "x"], "not both"),
        (["--json"], "needs -o FILE"),
    ],
)
def test_what_is_wrong_is_named(
    folder: Path, capsys: pytest.CaptureFixture[str], words: list[str], message: str
) -> None:
    assert main(["export", str(folder), *words]) == 2
    assert message in told(capsys)[1]


def test_a_file_that_is_no_export_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "x.json"
    path.write_text("{}")
    assert main(["run", str(path)]) == 2
    assert "this is no export of Understudy" in told(capsys)[1]


def test_what_is_wrong_in_an_exported_file_is_told_with_its_name(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out.json"
    assert main(["export", str(folder), "-o", str(out)]) == 0
    out.write_text(out.read_text().replace('"feature": "ICanSeeABox"', '"feature": "Telepathy"'))
    told(capsys)
    assert main(["run", str(out)]) == 2
    said = told(capsys)[1]
    assert f"understudy: {out}: " in said
    assert "looks at 'Telepathy', which is no feature of the scenario" in said


def test_what_was_changed_in_an_exported_file_cannot_be_trained_there(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out, homing = tmp_path / "out.json", stored(tmp_path / "homing", taught())
    assert main(["demonstrate", str(homing)]) == 0
    assert main(["export", str(homing), "--examples", "-o", str(out)]) == 0
    document = json.loads(out.read_text())
    (goto,) = (one for one in document["libraries"]["agent"] if one["name"] == "Goto")
    goto["settings"] = {"pruning_confidence": 0.25}
    out.write_text(json.dumps(document))
    told(capsys)
    assert main(["run", str(out), "--ticks", "1"]) == 0
    said = told(capsys)[1]
    assert f"agent/Goto was changed since last learned; learn again where {out} was exported from" in said


def test_a_project_with_its_own_scenario_takes_it_along_and_runs_only_when_trusted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = stored(tmp_path / "own")
    code = "from understudy.sim.scenarios.foraging import scenario\n"
    (folder / "scenario.py").write_text(code)
    project = json.loads((folder / "project.json").read_text())
    (folder / "project.json").write_text(json.dumps({**project, "scenario": "scenario.py"}))
    out = tmp_path / "own.json"
    assert main(["export", str(folder), "-o", str(out), "--trust"]) == 0
    assert json.loads(out.read_text())["scenario_code"] == code
    told(capsys)
    assert main(["run", str(out), "--ticks", "20"]) == 2
    assert "carries code" in told(capsys)[1]
    assert runs(out, capsys, "--trust") == runs(folder, capsys, "--trust")
