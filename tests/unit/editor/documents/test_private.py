"""What a window keeps for itself: locks, stamps, times; no Qt is needed for any of it."""

import os
from dataclasses import replace
from datetime import datetime
from pathlib import Path

import pytest

from app.editor.documents.claims import claim, holder_of, new_owner, release
from app.editor.documents.outside import changes, stamps_of
from app.editor.documents.private import clear, make, private_folder
from app.editor.documents.words import clock, whose
from app.engine.shipped import shipped_projects


def test_a_project_is_claimed_once_and_free_again_when_it_is_released(tmp_path: Path) -> None:
    first, second = new_owner(), new_owner()
    assert claim(tmp_path / "p", first) is None
    assert claim(tmp_path / "p", second) == first
    release(tmp_path / "p", second)
    assert holder_of(tmp_path / "p") == first
    release(tmp_path / "p", first)
    assert claim(tmp_path / "p", second) is None


def test_a_process_of_the_same_number_that_began_later_is_another_one(tmp_path: Path) -> None:
    gone = replace(new_owner(), started="1")
    assert not gone.lives
    claim(tmp_path, gone)
    assert claim(tmp_path, new_owner()) is None


def test_a_window_on_another_machine_counts_as_living(tmp_path: Path) -> None:
    far = replace(new_owner(), host="far-away", pid=1)
    claim(tmp_path, far)
    assert claim(tmp_path, new_owner()) == far
    assert "far-away" in whose(far)


@pytest.mark.parametrize("text", ["", "{", "[]", '{"pid": 1}'])
def test_a_lock_that_nobody_can_read_is_taken_over(tmp_path: Path, text: str) -> None:
    (tmp_path / "lock").write_text(text, encoding="utf-8")
    ours = new_owner()
    assert claim(tmp_path, ours) is None
    assert holder_of(tmp_path) == ours


def test_git_never_sees_what_a_window_keeps_and_nothing_stays(tmp_path: Path) -> None:
    private = private_folder(tmp_path, tmp_path / "state")
    make(private)
    assert (private / ".gitignore").read_text(encoding="utf-8") == "*\n"
    clear(private)
    assert list(tmp_path.iterdir()) == []


def test_of_projects_that_ship_everything_private_is_in_the_users_own_state(tmp_path: Path) -> None:
    for folder in shipped_projects():
        assert private_folder(folder, tmp_path).is_relative_to(tmp_path)


def test_a_file_that_was_only_touched_has_not_changed(tmp_path: Path) -> None:
    (tmp_path / "project.json").write_text("{}", encoding="utf-8")
    before = stamps_of(tmp_path)
    os.utime(tmp_path / "project.json", (1, 1))
    assert changes(before, stamps_of(tmp_path, before)) == ()
    (tmp_path / "project.json").write_text("[]", encoding="utf-8")
    (tmp_path / "scenario.py").write_text("", encoding="utf-8")
    assert changes(before, stamps_of(tmp_path, before)) == ("changed: project.json", "new: scenario.py")
    assert changes(before, {}) == ("removed: project.json",)


def test_times_are_said_shortly() -> None:
    now = datetime(2026, 5, 3, 21, 0)  # noqa: DTZ001 - only what it shows matters here
    assert clock(now.replace(hour=20, minute=41), now) == "20:41"
    assert clock(now.replace(day=1), now) == "1 May, 21:00"
    assert clock(now.replace(year=2025), now) == "3 May 2025, 21:00"
