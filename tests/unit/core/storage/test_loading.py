"""Opening what is no project, or only partly one; leaving alone what is none of ours."""

import json
import os
from collections.abc import Callable
from pathlib import Path

import pytest

from app.core.project import Project
from app.core.storage import FilesError, load, save


def message(folder: Path) -> str:
    with pytest.raises(FilesError) as caught:
        load(folder)
    return str(caught.value)


def deny(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    """Let nobody read files and folders called *name*; root may read everything, so permissions would not do."""

    def guarded(original: Callable[[Path], object]) -> Callable[[Path], object]:
        def read(path: Path) -> object:
            if path.name == name:
                raise PermissionError(13, "Permission denied", str(path))
            return original(path)

        return read

    monkeypatch.setattr(Path, "read_bytes", guarded(Path.read_bytes))
    monkeypatch.setattr(Path, "iterdir", guarded(Path.iterdir))


def test_a_folder_that_is_not_there(tmp_path: Path) -> None:
    assert message(tmp_path / "none") == (
        f"{tmp_path}/none: there is no such folder; "
        "`understudy new DIR --scenario NAME`, or New project in the window, makes a project"
    )


def test_a_folder_that_is_no_project(tmp_path: Path) -> None:
    assert message(tmp_path) == (
        f"{tmp_path}: this is no project: the folder holds no project.json; "
        "`understudy new DIR --scenario NAME`, or New project in the window, makes a project"
    )


def test_a_file_where_a_folder_is_expected(tmp_path: Path, folder: Path) -> None:
    file = tmp_path / "notes.txt"
    file.touch()
    assert "a project is a folder, but this is a file; `understudy new" in message(file)
    assert message(folder / "project.json") == (
        f"{folder}/project.json: a project is a folder, but this is a file; name the folder that holds it: {folder}"
    )
    assert "a folder is expected, but a file is in its place" in message(file / "inner")


@pytest.mark.parametrize(
    ("name", "file"),
    [
        ("goto.json", "libraries/agent/goto.json"),
        ("d1.json", "demonstrations/d1.json"),
        ("project.json", "project.json"),
        ("8866191d021cee12.npz", "examples/moments/8866191d021cee12.npz"),
        ("libraries", "libraries"),
        ("group", "libraries/group"),
    ],
)
def test_no_permission_to_read(folder: Path, monkeypatch: pytest.MonkeyPatch, name: str, file: str) -> None:
    deny(monkeypatch, name)
    assert message(folder) == f"{folder}/{file}: cannot be read: permission denied"


def test_no_permission_to_enter_the_folder(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object, **__: object) -> int:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(os, "open", refuse)
    assert message(folder) == f"{folder}: cannot be read: permission denied"


def test_a_folder_where_a_file_is_expected(folder: Path) -> None:
    (folder / "libraries/agent/extra.json").mkdir()
    assert "libraries/agent/extra.json: a file is expected, but this is something else" in message(folder)


def test_a_pipe_where_a_file_is_expected_is_not_waited_for(folder: Path) -> None:
    os.mkfifo(folder / "libraries/agent/extra.json")
    assert "a file is expected, but this is something else" in message(folder)


def test_a_behavior_that_lies_in_no_types_folder(folder: Path) -> None:
    (folder / "libraries/agent/goto.json").rename(folder / "libraries/goto.json")
    assert (
        "libraries/goto.json: it belongs into the folder of a node type: libraries/TYPE/goto.json"
        in message(folder)
    )


def test_a_library_of_a_type_with_an_impossible_name(folder: Path) -> None:
    (folder / "libraries/group").rename(folder / "libraries/con")
    assert "libraries/con/control.json: a node type cannot be called 'con'" in message(folder)


def test_a_copied_behavior_needs_an_id_of_its_own(folder: Path) -> None:
    goto = folder / "libraries/agent/goto.json"
    (folder / "libraries/agent/goto-2.json").write_bytes(goto.read_bytes())
    assert message(folder) == (
        f"{folder}/libraries/agent/goto-2.json: id: 'goto' is the id of two files, this one and "
        "libraries/agent/goto.json; the other is called so"
    )


def test_a_demonstration_that_the_project_does_not_list_comes_last(folder: Path, project: Project) -> None:
    document = json.loads((folder / "project.json").read_text())
    document["demonstrations"] = ["d1"]
    (folder / "project.json").write_text(json.dumps(document))
    assert [demonstration.id for demonstration in load(folder).demonstrations] == ["d1", "d2"]


def test_files_of_others_are_not_looked_at(folder: Path, project: Project) -> None:
    for name in (
        "notes.md",
        "pictures/agent.json",
        "experiments/e.json",
        "libraries/agent/.hidden.json",
        "scenario.py",
    ):
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text("raise SystemExit")
    (folder / "libraries/agent/README.md").write_text("Behaviors.")
    (folder / "examples/moments/0000000000000000.npz").write_text("damaged, and nobody needs it")
    assert load(folder) == project


def test_what_refers_to_nothing_is_loaded_for_the_check_to_name(folder: Path) -> None:
    path = folder / "libraries/agent/mixed.json"
    document = json.loads(path.read_text())
    document["rules"][0]["target"] = "nowhere"
    document["states"][2]["content"]["automaton"] = "nothing"
    document["prunes"][0]["source"] = "nowhere"
    document["learned"]["nowhere"] = {"kind": "refit", "classifier": "unheard of"}
    path.write_text(json.dumps(document))
    automaton = load(folder).library("agent").get("mixed")
    assert automaton.rules[0].target == automaton.prunes[0].source == "nowhere"
    assert automaton.nested() == ("nothing",)


def test_an_empty_library_or_set_of_examples_is_as_if_it_were_not_there(
    tmp_path: Path, project: Project
) -> None:
    (tmp_path / "libraries/squad").mkdir(parents=True)
    save(project, tmp_path)
    (tmp_path / "examples/agent/goto.json").write_text('{"automaton": "goto", "examples": []}')
    assert load(tmp_path) == project


def test_a_damaged_moment_is_refused(folder: Path) -> None:
    path = folder / "examples/moments/8866191d021cee12.npz"
    data = bytearray(path.read_bytes())
    data[100] ^= 1
    path.write_bytes(data)
    assert message(folder).startswith(
        f"{folder}/examples/moments/8866191d021cee12.npz: the file is damaged: it should have the hash 8866191d021cee12"
    )


def test_all_missing_moments_are_named(folder: Path) -> None:
    for path in (folder / "examples/moments").iterdir():
        path.unlink()
    with pytest.raises(FilesError) as caught:
        load(folder)
    assert [problem.where for problem in caught.value.problems] == [
        "examples[0].snapshot",
        "examples[2].snapshot",
    ]
