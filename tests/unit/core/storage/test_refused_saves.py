"""What cannot be stored is refused before anything is written, and named."""

import json
import math
from dataclasses import replace
from pathlib import Path

import pytest

from app.core.examples import Example
from app.core.library import Library, NodeType
from app.core.project import Project
from app.core.storage import FilesError, moment_hash, save
from tests.unit.core.storage import every_kind
from tests.unit.core.storage.folders import AGENT, changed, files


def problems_of(project: Project, folder: Path) -> list[str]:
    with pytest.raises(FilesError) as caught:
        save(project, folder)
    return [str(problem) for problem in caught.value.problems]


def test_not_a_number_is_refused_and_named(folder: Path, project: Project) -> None:
    before = files(folder)
    wrong = (Example("1", "s1", "s2", {"f1": math.nan}), Example("2", "s1", "s2", {"f1": math.inf}))
    assert problems_of(replace(project, examples={AGENT: {"mixed": wrong}}), folder) == [
        "examples/agent/mixed.json: examples[0].values.f1: must be a finite number, but found NaN",
        "examples/agent/mixed.json: examples[1].values.f1: must be a finite number, but found Infinity",
    ]
    assert files(folder) == before


def test_what_could_not_be_loaded_again_is_not_saved(tmp_path: Path, project: Project) -> None:
    wander = project.library(AGENT).get("wander")
    rules = (replace(wander.rules[0], probability=2.0), *wander.rules[1:])
    [found] = problems_of(changed(project, replace(wander, rules=rules)), tmp_path / "p")
    assert found == "libraries/agent/wander.json: rules[0].probability: must be at most 1, but found 2.0"
    assert not (tmp_path / "p").exists()


def test_half_a_character_is_refused(tmp_path: Path, project: Project) -> None:
    assert problems_of(replace(project, note="\ud800"), tmp_path) == [
        "project.json: note: the text holds half of a surrogate pair, which is no character"
    ]


@pytest.mark.parametrize("name", ["../up", "a/b", ".hidden", "con", "x:y", "tab\t", "end.", ""])
def test_ids_that_cannot_name_files_are_refused(tmp_path: Path, project: Project, name: str) -> None:
    wander = replace(project.library(AGENT).get("wander"), id=name)
    assert any(
        "cannot be the name of a file" in p for p in problems_of(changed(project, wander), tmp_path / "a")
    )
    scouts = replace(project, libraries={name: Library({"wander": project.library(AGENT).get("wander")})})
    assert any("a node type cannot be called" in p for p in problems_of(scouts, tmp_path / "b"))
    shown = (replace(project.demonstrations[0], id=name),)
    assert any(
        "cannot be the name of a file" in p
        for p in problems_of(replace(project, demonstrations=shown), tmp_path / "c")
    )
    assert list(tmp_path.iterdir()) == []


def test_a_type_cannot_be_called_moments(tmp_path: Path, project: Project) -> None:
    [found] = problems_of(replace(project, types=(NodeType("Moments"),)), tmp_path)
    assert found == (
        "project.json: types[0].name: 'Moments' cannot be the name of a type: the folder examples/moments is for snapshots"
    )


def test_names_that_some_systems_take_for_one_are_refused(tmp_path: Path, project: Project) -> None:
    twin = replace(project.library(AGENT).get("goto"), id="GoTo", name="Twin")
    assert problems_of(changed(project, twin), tmp_path) == [
        "libraries/agent/GoTo.json: its name and that of libraries/agent/goto.json are the same on systems that ignore case"
    ]


def test_types_that_some_systems_take_for_one_are_refused(tmp_path: Path, project: Project) -> None:
    libraries = {
        AGENT: project.libraries[AGENT],
        "AGENT": Library({"x": replace(every_kind.control(), id="x")}),
    }
    assert problems_of(replace(project, libraries=libraries), tmp_path) == [
        "libraries/AGENT: its name and that of libraries/agent are the same on systems that ignore case"
    ]


def test_an_automaton_under_another_id_is_refused(tmp_path: Path, project: Project) -> None:
    wrong = replace(project, libraries={AGENT: Library({"walk": project.library(AGENT).get("wander")})})
    assert (
        "libraries/agent/walk.json: id: the library lists it as 'walk', but its id is 'wander'"
        in problems_of(wrong, tmp_path)
    )


def test_an_example_of_a_moment_that_is_not_there_is_refused(tmp_path: Path, project: Project) -> None:
    found = problems_of(replace(project, moments={}), tmp_path)
    assert len(found) == 3
    assert found[0].startswith(
        "examples/agent/mixed.json: examples[0].snapshot: the project has no moment with the hash"
    )


def test_a_moment_under_a_wrong_hash_is_refused(tmp_path: Path, project: Project) -> None:
    name = moment_hash(every_kind.moment(0))
    swapped = {**project.moments, name: every_kind.moment(5)}
    [found] = problems_of(replace(project, moments=swapped), tmp_path)
    assert found.startswith(
        f"examples/moments/{name}.npz: the moment called {name!r} must be called by its hash"
    )


def test_a_folder_of_a_newer_understudy_is_not_overwritten(folder: Path, project: Project) -> None:
    document = json.loads((folder / "project.json").read_text())
    (folder / "project.json").write_text(json.dumps({**document, "schema_version": 2}))
    before = files(folder)
    [found] = problems_of(project, folder)
    assert "was written by a newer Understudy: its schema version is 2" in found
    assert files(folder) == before
