"""`understudy new`."""

import json
from pathlib import Path

import pytest

from app.cli import main
from app.core.check import check
from app.core.errors import ScenarioError
from app.core.vocabulary import BasicBehavior, Vocabulary
from app.engine.fresh import first_behavior, fresh_project
from app.engine.scenarios import OWN_CODE
from app.sim.scenarios import names, shipped
from tests.unit.sim.test_manual import example


@pytest.mark.parametrize("scenario", names())
def test_a_new_project_of_every_scenario_is_sound_and_runs(
    scenario: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "mine"
    assert main(["new", str(folder), "--scenario", scenario]) == 0
    assert main(["check", str(folder)]) == 0
    assert main(["run", str(folder), "--ticks", "2"]) == 0
    assert f"understudy run {folder}" in capsys.readouterr().out


@pytest.mark.parametrize("scenario", names())
def test_a_new_project_has_nothing_to_complain_of(scenario: str) -> None:
    assert check(fresh_project("x", shipped(scenario)), shipped(scenario).vocabulary) == ()


def test_json_says_what_was_made(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    main(["new", str(tmp_path / "mine"), "--scenario", "foraging", "--json"])
    document = json.loads(capsys.readouterr().out)
    assert (document["project"], document["scenario"], document["arm"]) == ("mine", "foraging", "independent")


def test_a_world_of_ones_own_is_a_file_that_the_project_brings_along(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, folder = tmp_path / "line.py", tmp_path / "mine"
    code.write_text(example(), encoding="utf-8")
    assert main(["new", str(folder), "--scenario", str(code)]) == 0
    assert f"understudy run {folder} --trust" in capsys.readouterr().out
    assert (folder / OWN_CODE).read_bytes() == code.read_bytes()
    assert main(["check", str(folder), "--trust"]) == 0
    assert main(["run", str(folder), "--trust", "--ticks", "2"]) == 0


@pytest.mark.parametrize(
    ("text", "said"), [(None, "no such file"), ("x = 1", "must assign a Scenario"), ("1 / 0", "line 1")]
)
def test_a_file_that_declares_no_world_is_refused_and_nothing_is_made(
    text: str | None, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, folder = tmp_path / "line.py", tmp_path / "mine"
    if text is not None:
        code.write_text(text, encoding="utf-8")
    assert main(["new", str(folder), "--scenario", str(code)]) == 2
    assert said in capsys.readouterr().err
    assert not folder.exists()


def test_an_empty_folder_can_become_a_project(tmp_path: Path) -> None:
    assert main(["new", str(tmp_path), "--scenario", "foraging"]) == 0


def test_a_folder_that_holds_something_is_left_alone(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "diary.txt").write_text("dear diary")
    assert main(["new", str(tmp_path), "--scenario", "foraging"]) == 2
    assert f"{tmp_path}: something is in this folder" in capsys.readouterr().err
    assert [file.name for file in tmp_path.iterdir()] == ["diary.txt"]


def test_a_file_in_its_place_is_left_alone(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "diary.txt").write_text("dear diary")
    assert main(["new", str(tmp_path / "diary.txt"), "--scenario", "foraging"]) == 2
    assert "this is a file" in capsys.readouterr().err


def test_scenarios_are_listed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["new", "--list"]) == 0
    out = capsys.readouterr().out
    assert all(name in out for name in names())


def test_scenarios_are_listed_for_programs_too(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["new", "--list", "--json"]) == 0
    listed = json.loads(capsys.readouterr().out)["scenarios"]
    assert [one["name"] for one in listed] == list(names())


@pytest.mark.parametrize(
    ("typed", "said"),
    [([], "name the folder"), (["somewhere"], "--scenario foraging")],
)
def test_what_is_missing_is_asked_for(
    typed: list[str], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["new", *typed]) == 2
    assert said in capsys.readouterr().err


def test_agents_begin_with_a_behavior_that_goes_on() -> None:
    behaviors = (
        BasicBehavior("Grab", one_shot=True),
        BasicBehavior("Done", raises="done"),
        BasicBehavior("Face", ("target",)),
        BasicBehavior("Walk"),
    )
    assert first_behavior(Vocabulary(0, {b.name: b for b in behaviors})) == "Walk"


def test_a_scenario_where_nothing_goes_on_is_refused() -> None:
    with pytest.raises(ScenarioError, match="no basic behavior"):
        first_behavior(Vocabulary())
