"""``understudy import``: what was exported runs in another project as it did, and the user hears what it is called there."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from app.cli import main
from app.core.edits import add_automaton
from app.core.project import Project
from app.core.storage import load, save
from tests.unit.cli.foraging import ARMS, project, stored


@pytest.fixture
def exported(tmp_path: Path) -> Path:
    """The arm with one level of controllers, exported."""
    out = tmp_path / "one-level.json"
    assert main(["export", str(stored(tmp_path / "boxes")), "--arm", "one level", "-o", str(out)]) == 0
    return out


@pytest.fixture
def empty(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Path:
    folder = tmp_path / "mine"
    save(Project("mine", "foraging"), folder)
    capsys.readouterr()
    return folder


def told(capsys: pytest.CaptureFixture[str]) -> tuple[str, str]:
    out, err = capsys.readouterr()
    return out, err


def runs(where: Path, capsys: pytest.CaptureFixture[str]) -> object:
    assert main(["run", str(where), "--arm", "one level", "--ticks", "200", "--runs", "2", "--json"]) == 0
    return json.loads(told(capsys)[0])["runs"]


def test_an_arm_runs_in_the_other_project_to_the_same_results(
    exported: Path, empty: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["import", str(exported), str(empty), "--arm"]) == 0
    out, _ = told(capsys)
    assert "agent/Forage" in out
    assert "the arm 'one level'; kept" in out
    assert main(["check", str(empty)]) == 0
    told(capsys)
    assert runs(empty, capsys) == runs(exported, capsys)


def test_without_arm_only_the_behaviors_come(
    exported: Path, empty: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["import", str(exported), str(empty)]) == 0
    after = load(empty)
    assert after.arms == ()
    assert after.library("group").by_name("ControlForage") is not None


def test_what_is_there_already_is_used(
    exported: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = load(tmp_path / "boxes")
    assert main(["import", str(exported), str(tmp_path / "boxes"), "--arm"]) == 0
    assert "all of it was here" in told(capsys)[0]
    assert load(tmp_path / "boxes") == before


def test_json_says_what_each_is_called(
    exported: Path, empty: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    other, _ = add_automaton(load(empty), "agent", "Wander", ["whither"])
    save(other, empty)
    assert main(["import", str(exported), str(empty), "--json"]) == 0
    document = json.loads(told(capsys)[0])
    names = {f"{b['type']}/{b['name']}": b["known_as"] for b in document["behaviors"]}
    assert (names["agent/Wander"], names["agent/Forage"], names["agent/Goto"]) == (
        "Wander 2",
        "Forage",
        "Goto",
    )
    assert document["types"] == ["group"]
    assert document["arm"] is None


def test_dry_run_changes_nothing(exported: Path, empty: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = load(empty)
    assert main(["import", str(exported), str(empty), "--dry-run"]) == 0
    assert "without --dry-run" in told(capsys)[0]
    assert load(empty) == before


def test_an_arm_that_the_file_lacks_is_said(
    tmp_path: Path, empty: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "goto.json"
    assert main(["export", str(stored(tmp_path / "boxes")), "agent/Goto", "-o", str(out)]) == 0
    assert main(["import", str(out), str(empty), "--arm"]) == 0
    assert "brings no arm" in told(capsys)[1]


def test_what_is_wrong_is_named(
    exported: Path, empty: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bad = tmp_path / "bad.json"
    bad.write_text('{"format": "something else"}')
    before = load(empty)
    for words, message in (
        ([str(bad), str(empty)], "this is no export of Understudy"),
        (
            [str(tmp_path / "nowhere.json"), str(empty)],
            "nowhere.json: there is no such file; `understudy export",
        ),
        ([str(empty), str(empty)], "is a directory"),
        ([str(exported), str(exported)], "this is a file; a project is a folder"),
        ([str(exported)], "Missing argument 'PROJECT'"),
    ):
        assert main(["import", *words]) == 2
        assert message in told(capsys)[1]
    assert load(empty) == before


def test_examples_come_along_where_they_were_exported(
    tmp_path: Path, empty: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    foraging = Path(__file__).parents[3] / "projects" / "foraging"
    for more, count in (([], 0), (["--examples"], len(load(foraging).examples_of("agent", "wander")))):
        out, folder = tmp_path / "wander.json", tmp_path / f"with-{count}"
        save(load(empty), folder)
        assert main(["export", str(foraging), "agent/Wander", "-o", str(out), *more]) == 0
        told(capsys)
        assert main(["import", str(out), str(folder)]) == 0
        assert ("without examples" in told(capsys)[1]) is (count == 0)
        assert len(load(folder).examples_of("agent", "wander")) == count


def test_the_projects_arms_stay_the_first(
    exported: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = stored(tmp_path / "two", replace(project(), arms=ARMS[:1]))
    assert main(["import", str(exported), str(folder), "--arm"]) == 0
    assert [arm.name for arm in load(folder).arms] == ["independent", "one level"]
