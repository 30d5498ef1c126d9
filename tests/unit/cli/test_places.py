"""Places that the user names and the system refuses, or whose names are no text, in every verb."""

import errno
import os
import sys
from pathlib import Path

import pytest

from app.cli import main
from app.core.storage import load, readable
from app.engine.scenarios import open_scenario

TOO_LONG = "n" * 300
#: What takes a place, with {} where that stands.
VERBS = [
    ["check", "{}"],
    ["run", "{}"],
    ["train", "{}"],
    ["demonstrate", "{}"],
    ["experiment", "{}"],
    ["export", "{}"],
    ["new", "{}", "--scenario", "foraging"],
    ["new", "mine", "--scenario={}.py"],
    ["--headless", "{}"],
    ["{}"],
]


@pytest.mark.parametrize("verb", VERBS, ids=lambda verb: verb[0])
@pytest.mark.parametrize("place", [TOO_LONG, f"{TOO_LONG}/within"], ids=["itself", "within"])
def test_a_name_that_is_too_long_is_wrong_input(
    verb: list[str],
    place: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main([word.format(place) for word in verb]) == 2
    told = capsys.readouterr().err
    assert f"{place}" in told
    assert told.endswith(": the name is too long for this file system\n")


@pytest.mark.parametrize("verb", VERBS, ids=lambda verb: verb[0])
def test_a_folder_that_nobody_may_look_into_is_wrong_input(
    verb: list[str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    place = tmp_path / "locked" / "mine"
    looks = os.stat

    def locked(path: str | Path, *_: object, **given: bool) -> os.stat_result:
        if str(path).startswith(str(place)):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(path))
        return looks(path, **given)

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("os.stat", locked)
    assert main([word.format(place) for word in verb]) == 2
    assert "permission denied" in capsys.readouterr().err


def test_what_the_system_refuses_elsewhere_is_a_failure_of_the_program(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise PermissionError(errno.EACCES, "no", "/somewhere/else")

    monkeypatch.setattr("app.cli.check.check_project", fail)
    monkeypatch.setattr("platformdirs.user_log_path", lambda *_, **__: tmp_path / "log")
    assert main(["check", str(tmp_path)]) == 1
    assert "the program failed: PermissionError" in capsys.readouterr().err


def test_a_name_that_is_no_text_is_kept_readably() -> None:
    assert readable("größe") == "größe"
    assert readable("caf\udce9") == "caf�"


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere every name is text")
def test_a_project_lives_in_a_folder_whose_name_is_no_text(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / os.fsdecode(b"caf\xe9")
    assert main(["new", str(folder), "--scenario", "foraging"]) == 0
    assert main(["check", str(folder)]) == 0
    capsys.readouterr()
    project = load(folder)
    assert project.name == "caf�"
    assert open_scenario(project).name == "foraging"
