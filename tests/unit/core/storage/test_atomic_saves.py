"""Never half of a save: whatever fails, wherever the machine stops, and whoever comes in between."""

import contextlib
import errno
import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from threading import Thread
from typing import Any

import pytest

from app.core.examples import Example
from app.core.library import Library, NodeType
from app.core.project import Project
from app.core.storage import FilesError, load, moment_hash, save
from app.core.storage.atomic import locked
from tests.unit.core.storage import every_kind
from tests.unit.core.storage.folders import AGENT, changed, files, without

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

    def refuse(path: Path, mode: str = "r", **keywords: Any) -> object:
        if "x" in mode:
            raise OSError(error, "refused")
        return original(path, mode, **keywords)

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
