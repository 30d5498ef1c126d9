"""Saving changes as little as possible."""

from dataclasses import replace
from pathlib import Path

import pytest

from app.core.edits import remove_state
from app.core.examples import Example
from app.core.library import NodeType
from app.core.project import Pick, Project
from app.core.storage import load, save
from app.core.storage.saving import _Saving
from tests.unit.core.storage.folders import AGENT, changed, files, without


def stamps(folder: Path) -> dict[str, int]:
    """Which file, not only what is in it: a file that is written anew is another one."""
    return {
        path.relative_to(folder).as_posix(): path.stat().st_ino
        for path in folder.rglob("*")
        if path.is_file()
    }


# ------------------------------------------------------------------------------------------------ only what changed


@pytest.mark.parametrize("knows_previous", [True, False])
def test_saving_the_same_again_writes_nothing(folder: Path, project: Project, knows_previous: bool) -> None:
    before = stamps(folder)
    save(project, folder, project if knows_previous else None)
    assert stamps(folder) == before


def test_what_is_known_to_be_there_is_not_put_into_words_again(
    folder: Path, project: Project, monkeypatch: pytest.MonkeyPatch
) -> None:
    made: list[str] = []
    monkeypatch.setattr(_Saving, "_text", lambda _self, path, _document: made.append(path))
    save(project, folder, project)
    assert made == ["project.json"]


@pytest.mark.parametrize("knows_previous", [True, False])
def test_a_rename_changes_one_line_of_one_file(folder: Path, project: Project, knows_previous: bool) -> None:
    before, texts = stamps(folder), files(folder)
    renamed = changed(project, replace(project.library(AGENT).get("goto"), name="Approach"))
    save(renamed, folder, project if knows_previous else None)
    after = stamps(folder)
    assert after.keys() == before.keys()
    assert [path for path in after if after[path] != before[path]] == ["libraries/agent/goto.json"]
    old = texts["libraries/agent/goto.json"].splitlines()
    new = (folder / "libraries/agent/goto.json").read_bytes().splitlines()
    assert [pair for pair in zip(old, new, strict=True) if pair[0] != pair[1]] == [
        (b'  "name": "goto",', b'  "name": "Approach",')
    ]


def test_one_more_example_is_one_more_line(folder: Path, project: Project) -> None:
    path = folder / "examples/agent/mixed.json"
    old = path.read_text().splitlines()
    recorded = (*project.examples_of(AGENT, "mixed"), Example("5", "s1", "s2", {"f1": 1.0}))
    save(replace(project, examples={AGENT: {"mixed": recorded}}), folder, project)
    new = path.read_text().splitlines()
    assert len(new) == len(old) + 1
    assert '    {"id": "5", "label": "s2", "source": "s1", "values": {"f1": 1.0}}' in new


def test_states_that_only_demonstrations_remember_are_kept_with_them(folder: Path, project: Project) -> None:
    before = stamps(folder)
    without_left = remove_state(project, AGENT, "mixed", "s1")
    assert without_left.demonstrations[0].removed == (project.library(AGENT).get("mixed").state("s1"),)
    save(without_left, folder, project)
    assert load(folder).demonstrations == without_left.demonstrations
    save(project, folder, without_left)
    assert stamps(folder).keys() == before.keys()
    assert load(folder).demonstrations == project.demonstrations


def test_what_a_demonstration_moves_is_kept(folder: Path, project: Project) -> None:
    demonstration, *others = project.demonstrations
    moves = Pick(0, "", act="move", entity=3, x=10.5, y=-2.0)
    moved = replace(demonstration, picks=(moves, *demonstration.picks))
    project = replace(project, demonstrations=(moved, *others))
    save(project, folder)
    assert load(folder) == project


def test_what_was_changed_by_hand_meanwhile_stays_where_the_project_did_not_change(
    folder: Path, project: Project
) -> None:
    path = folder / "libraries/agent/wander.json"
    by_hand = path.read_text().replace('"name": "wander"', '"name": "stroll"')
    path.write_text(by_hand)
    save(replace(project, note="another"), folder, project)
    assert path.read_text() == by_hand
    assert load(folder).note == "another"


def test_a_file_that_vanished_is_written_again(folder: Path, project: Project) -> None:
    (folder / "libraries/agent/wander.json").unlink()
    save(project, folder, project)
    assert load(folder) == project


def test_a_damaged_project_file_is_replaced(folder: Path, project: Project) -> None:
    (folder / "project.json").write_text("{")
    save(project, folder, project)
    assert load(folder) == project


def test_a_kind_of_number_that_changes_is_a_change(folder: Path, project: Project) -> None:
    as_fraction = replace(project, worlds={"": {"boxes": 10.0}})
    save(replace(project, worlds={"": {"boxes": 10}}), folder)
    save(as_fraction, folder, replace(project, worlds={"": {"boxes": 10}}))
    assert '{"boxes": 10.0}' in (folder / "project.json").read_text()


def test_numbers_come_out_as_floats_where_floats_are_meant(tmp_path: Path, project: Project) -> None:
    save(replace(project, examples={AGENT: {"mixed": (Example("1", "s1", "s2", {"f1": 1}),)}}), tmp_path)
    assert '{"f1": 1.0}' in (tmp_path / "examples/agent/mixed.json").read_text()


# ---------------------------------------------------------------------------------------------------- what is gone


@pytest.mark.parametrize("knows_previous", [True, False])
def test_files_of_what_is_gone_go_and_no_others(folder: Path, project: Project, knows_previous: bool) -> None:
    others = ("notes.md", "pictures/agent/mixed.json", "experiments/e.json", "examples/moments/notes.npz")
    for name in others:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text("mine")
    left = replace(without(project, "mixed"), examples={}, moments={}, demonstrations=())
    left = replace(left, libraries={AGENT: left.libraries[AGENT]})
    save(left, folder, project if knows_previous else None)
    assert load(folder) == left
    assert {path for path in files(folder) if (folder / path).is_file()} == {
        *others,
        "project.json",
        *(f"libraries/agent/{name}.json" for name in ("fetch", "forage", "goto", "wander")),
    }
    assert not (folder / "libraries/group").exists()


def test_a_moment_goes_with_the_last_example_that_refers_to_it(folder: Path, project: Project) -> None:
    first, second = project.moments
    kept = project.examples_of(AGENT, "mixed")[1:2]
    save(replace(project, examples={AGENT: {"mixed": kept}}), folder, project)
    assert (folder / f"examples/moments/{first}.npz").exists()
    assert not (folder / f"examples/moments/{second}.npz").exists()


def test_another_project_replaces_the_one_that_a_folder_holds(folder: Path) -> None:
    other = Project("Other", "sample", types=(NodeType("scout"),))
    save(other, folder)
    assert load(folder) == other


def test_a_new_folder_is_made_with_those_above_it(tmp_path: Path, project: Project) -> None:
    save(project, tmp_path / "a/b/c")
    assert load(tmp_path / "a/b/c") == project


def test_a_file_keeps_its_permissions(folder: Path, project: Project) -> None:
    (folder / "project.json").chmod(0o640)
    save(replace(project, note="more"), folder, project)
    assert (folder / "project.json").stat().st_mode & 0o777 == 0o640


def test_a_link_is_replaced_and_what_it_leads_to_is_left_alone(
    folder: Path, tmp_path: Path, project: Project
) -> None:
    outside = tmp_path / "outside"
    outside.write_text("mine")
    (folder / "project.json").unlink()
    (folder / "project.json").symlink_to(outside)
    save(project, folder)
    assert outside.read_text() == "mine"
    assert load(folder) == project
