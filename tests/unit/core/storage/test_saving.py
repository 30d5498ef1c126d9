"""Saving changes as little as possible, and never half of it."""

import contextlib
import errno
import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from threading import Thread

import pytest

from app.core.edits import remove_state
from app.core.examples import Example
from app.core.library import Library, NodeType
from app.core.project import Pick, Project
from app.core.storage import FilesError, load, moment_hash, save
from app.core.storage.atomic import locked
from tests.unit.core.storage import every_kind
from tests.unit.core.storage.folders import AGENT, changed, files


def stamps(folder: Path) -> dict[str, int]:
    """Which file, not only what is in it: a file that is written anew is another one."""
    return {
        path.relative_to(folder).as_posix(): path.stat().st_ino
        for path in folder.rglob("*")
        if path.is_file()
    }


def without(project: Project, automaton_id: str) -> Project:
    automata = {key: a for key, a in project.library(AGENT).automata.items() if key != automaton_id}
    return replace(project, libraries={**project.libraries, AGENT: Library(automata)})


# ------------------------------------------------------------------------------------------------ only what changed


@pytest.mark.parametrize("knows_previous", [True, False])
def test_saving_the_same_again_writes_nothing(folder: Path, project: Project, knows_previous: bool) -> None:
    before = stamps(folder)
    save(project, folder, project if knows_previous else None)
    assert stamps(folder) == before


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


# --------------------------------------------------------------------------------------------------- all or nothing


SYSTEM_CALLS = ("open", "fsync", "mkdir", "link", "rename", "replace", "unlink")


class Failing:
    """Lets the n-th call of any of the system's functions that change something fail."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, error: Callable[[], BaseException]) -> None:
        self.calls = 0
        self.fails_at = -1
        self.failed = ""
        self._error = error
        for name in SYSTEM_CALLS:
            monkeypatch.setattr(os, name, self._counted(name, getattr(os, name)))

    def _counted(self, name: str, original: Callable[..., object]) -> Callable[..., object]:
        def called(*arguments: object, **keywords: object) -> object:
            self.calls += 1
            if self.calls == self.fails_at:
                self.failed = name
                raise self._error()
            return original(*arguments, **keywords)

        return called


def big_change(project: Project) -> Project:
    """One that writes, replaces and removes files of every kind."""
    moment = every_kind.moment(99)
    name = moment_hash(moment)
    added = replace(project.library(AGENT).get("wander"), id="added", name="Added")
    after = changed(without(project, "forage"), replace(added, note="new"))
    after = changed(after, replace(project.library(AGENT).get("goto"), name="Approach"))
    return replace(
        after,
        types=(*project.types, NodeType("scout")),
        libraries={AGENT: after.libraries[AGENT], "scout": Library({"added": added})},
        examples={AGENT: {"goto": (Example("1", "s1", "s2", {}, snapshot=name),)}},
        moments={name: moment},
        demonstrations=(replace(project.demonstrations[0], id="d3"), project.demonstrations[1]),
    )


def full_disk() -> OSError:
    return OSError(errno.ENOSPC, "No space left on device")


@pytest.mark.parametrize("error", [full_disk, KeyboardInterrupt])
def test_wherever_a_save_fails_the_folder_stays_as_it_was(
    folder: Path, project: Project, monkeypatch: pytest.MonkeyPatch, error: Callable[[], BaseException]
) -> None:
    before, after = files(folder), big_change(project)
    failing, failed = Failing(monkeypatch, error), set()
    for call in range(1, 1000):
        failing.calls, failing.fails_at = 0, call
        try:
            save(after, folder, project)
            done = failing.calls < call
        except (FilesError, KeyboardInterrupt):
            failed.add(failing.failed)
            done = failing.failed == "unlink" and files(folder) != before  # interrupted while it tidied up
        failing.fails_at = -1
        if done:
            break
        if load(folder) == after:  # it went on without what failed
            save(project, folder)
        assert files(folder) == before, f"call {call} ({failing.failed})"
    assert {"open", "fsync", "mkdir"} <= failed
    assert {"rename", "replace"} & failed
    save(after, folder)
    assert load(folder) == after
    assert not [path for path in files(folder) if path.endswith("~")]


def test_everything_new_reaches_the_disk_before_anything_is_renamed(
    folder: Path, project: Project, monkeypatch: pytest.MonkeyPatch
) -> None:
    events: list[str] = []
    originals = {name: getattr(os, name) for name in ("rename", "replace")}

    def synced(handle: int) -> None:
        events.append("sync " + Path(f"/proc/self/fd/{handle}").readlink().name.split(".json")[0].lstrip("."))

    def renamed(name: str) -> Callable[[Path, Path], None]:
        def rename(source: Path, target: Path) -> None:
            events.append("rename " + Path(target).stem)
            originals[name](source, target)

        return rename

    monkeypatch.setattr(os, "fsync", synced)
    for name in originals:
        monkeypatch.setattr(os, name, renamed(name))
    after = changed(project, replace(project.library(AGENT).get("goto"), name="Approach"))
    save(replace(after, note="more"), folder, project)
    assert events == [
        *("sync goto", "sync project"),
        *("rename goto", "rename project"),  # project.json is the last
        *("sync project", "sync agent"),  # the folders: project/ and project/libraries/agent/
    ]


def test_a_full_disk_is_named_with_the_file(
    folder: Path, project: Project, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(_handle: int) -> None:
        raise full_disk()

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(FilesError) as caught:
        save(replace(project, note="more"), folder, project)
    assert str(caught.value) == (
        f"{folder}/project.json: cannot be written: the disk is full; nothing has been changed"
    )


def test_a_folder_that_could_not_be_filled_is_not_left_behind(
    tmp_path: Path, project: Project, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(_handle: int) -> None:
        raise full_disk()

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(FilesError):
        save(project, tmp_path / "a/b")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("error", [errno.EACCES, errno.EROFS])
def test_no_permission_to_write(
    folder: Path, project: Project, monkeypatch: pytest.MonkeyPatch, error: int
) -> None:
    """Root may write everywhere, so a permission that is taken away would not do."""
    before = files(folder)
    original = Path.open

    def refuse(path: Path, mode: str = "r", **keywords: object) -> object:
        if "x" in mode:
            raise OSError(error, "refused")
        return original(path, mode, **keywords)  # type: ignore[call-overload]

    monkeypatch.setattr(Path, "open", refuse)
    with pytest.raises(
        FilesError, match=r"project\.json: cannot be written: (permission denied|.*read-only)"
    ):
        save(replace(project, note="more"), folder, project)
    assert files(folder) == before


def test_a_file_where_the_folder_should_be(tmp_path: Path, project: Project) -> None:
    file = tmp_path / "taken"
    file.write_text("mine")
    with pytest.raises(FilesError, match=r"taken: cannot be written"):
        save(project, file)
    assert file.read_text() == "mine"


def test_a_folder_where_a_file_should_be(folder: Path, project: Project) -> None:
    taken = folder / "libraries/agent/added.json"
    taken.mkdir()
    before = files(folder)
    added = changed(project, replace(project.library(AGENT).get("wander"), id="added"))
    with pytest.raises(FilesError, match=r"libraries/agent/added.json: cannot be written"):
        save(added, folder, project)
    assert files(folder) == before


class StoppedError(BaseException):
    """The machine stops: nothing more is done, not even tidying up."""


class Stopping:
    """Lets the system's functions that rename and remove files do *left* of them, and then nothing more."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, left: int) -> None:
        self.left = left
        for name in ("rename", "replace", "unlink", "rmdir"):
            monkeypatch.setattr(os, name, self._counted(getattr(os, name)))

    def _counted(self, original: Callable[..., object]) -> Callable[..., object]:
        def called(*arguments: object, **keywords: object) -> object:
            self.left -= 1
            if self.left < 0:
                raise StoppedError
            return original(*arguments, **keywords)

        return called


def test_wherever_the_machine_stops_the_folder_still_loads(
    tmp_path: Path, project: Project, monkeypatch: pytest.MonkeyPatch
) -> None:
    after = big_change(project)
    for done in range(1000):
        copy = tmp_path / f"copy-{done}"
        save(project, copy)
        with monkeypatch.context() as patched:
            stopping = Stopping(patched, done)
            with contextlib.suppress(StoppedError):
                save(after, copy, project)
        load(copy)
        save(after, copy)
        assert load(copy) == after
        assert not [path for path in files(copy) if path.endswith("~")]
        if stopping.left >= 0:
            return
    pytest.fail("a save never ends")


def test_two_programs_do_not_save_at_once(folder: Path, project: Project) -> None:
    saving = Thread(target=save, args=(replace(project, note="second"), folder))
    with locked(folder, for_writing=True):
        saving.start()
        saving.join(0.05)
        assert saving.is_alive()
    saving.join()
    assert load(folder).note == "second"


def test_nobody_loads_what_is_half_saved(folder: Path) -> None:
    loading = Thread(target=load, args=(folder,))
    with locked(folder, for_writing=True):
        loading.start()
        loading.join(0.05)
        assert loading.is_alive()
    loading.join()


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
