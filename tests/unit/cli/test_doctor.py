"""`understudy doctor`: what is missing is named, with the command that mends it."""

import json
from pathlib import Path

import pytest

from app.cli import doctor, main, places, probes
from app.cli.doctor import (
    Finding,
    State,
    apt,
    folder_finding,
    library_finding,
    package_findings,
    python_finding,
)

PACKAGES = {"libEGL.so.1": "libegl1", "libxcb-cursor.so.0": "libxcb-cursor0"}


def test_here_everything_needed_is_there(capsys: pytest.CaptureFixture[str]) -> None:
    """Where tests run, the locked packages and Qt's libraries are installed."""
    code = main(["doctor", "--json"])
    document = json.loads(capsys.readouterr().out)
    assert [f for f in document["findings"] if f["state"] == "missing"] == []
    assert (code, document["ok"]) == (0, True)
    names = {finding["name"] for finding in document["findings"]}
    assert {"Python", "packages", "Qt", "fonts", "display", "Graphviz", "cores", "cache folder"} <= names


def test_something_missing_is_exit_code_1_and_comes_with_its_command(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    missing = Finding("fonts", "0 families", State.MISSING, "apt-get install fonts-dejavu-core")
    for look in ("_itself", "_packages", "_qt", "_libraries", "_graphviz"):
        monkeypatch.setattr(doctor, look, list)
    monkeypatch.setattr(doctor, "_machine", lambda: [missing])
    assert main(["doctor"]) == 1
    out = capsys.readouterr().out
    assert "MISSING   fonts   0 families" in out
    assert "fonts:\n    apt-get install fonts-dejavu-core" in out


@pytest.mark.parametrize(
    ("version", "state"),
    [((3, 10), State.MISSING), ((3, 11), State.OK), ((3, 14), State.OK), ((3, 15), State.NOTE)],
)
def test_pythons_without_locked_packages_are_told(version: tuple[int, int], state: State) -> None:
    assert python_finding(version, "x").state is state


def test_packages_are_compared_with_the_lock() -> None:
    wanted = {"numpy": "2.4.6", "rich": "15.0.0", "typer": "0.29.2", "other": "any"}
    there = {"numpy": "2.4.6", "rich": "14.0.0", "typer": "", "other": "1.0"}
    count, missing, other = package_findings(wanted, there)
    assert count.found == "2 of 4 as locked"
    assert (missing.name, missing.state, missing.found) == (
        "typer",
        State.MISSING,
        "not there; locked: 0.29.2",
    )
    assert "pip install -r" in missing.mend
    assert (other.name, other.state, other.found) == ("rich", State.NOTE, "14.0.0; locked: 15.0.0")


def test_missing_libraries_come_with_the_command_that_installs_them() -> None:
    finding = library_finding("libraries to draw", ["libEGL.so.1", "libodd.so.9"], PACKAGES, needed=True)
    assert finding.state is State.MISSING
    assert finding.found == "not there: libEGL.so.1, libodd.so.9"
    assert finding.mend.endswith("apt-get install -y --no-install-recommends libegl1")


def test_libraries_for_windows_are_not_needed_without_a_display() -> None:
    assert library_finding("x", ["libxcb-cursor.so.0"], PACKAGES, needed=False).state is State.NOTE


def test_libraries_that_are_there_need_no_command() -> None:
    assert library_finding("x", [], PACKAGES, needed=True) == Finding("x", "all there")


def test_a_package_is_installed_once() -> None:
    assert apt(["a", "b", "a"]).endswith(" a b")
    assert apt([]) == ""


def test_a_folder_that_cannot_be_written_to_is_told(tmp_path: Path) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("")
    assert folder_finding("cache", tmp_path / "new" / "folder").state is State.OK
    assert folder_finding("cache", blocked / "folder").state is State.NOTE


# -------------------------------------------------------------------------------------------------------- probes


def test_the_set_up_s_table_of_libraries_is_read(tmp_path: Path) -> None:
    assert probes.debian_packages(places.CLONE)["libEGL.so.1"] == "libegl1"
    assert probes.debian_packages(tmp_path) == {}


def test_the_lock_is_read() -> None:
    locked = probes.locked(places.CLONE)
    assert locked["networkx"] == probes.installed("networkx")


def test_what_does_not_start_says_why() -> None:
    assert probes.ended("raise SystemExit('no screen')") == ("", "no screen")
    assert probes.ended("import os; os.abort()")[1].startswith("it ended with code")
    assert probes.ended("print('fine')") == ("fine", "")


def test_a_package_that_is_not_installed_has_no_version() -> None:
    assert probes.installed("no-such-package-anywhere") == ""


def test_missing_libraries_are_found_by_what_a_file_loads(monkeypatch: pytest.MonkeyPatch) -> None:
    said = ["\tlibEGL.so.1 => not found", "\tlibc.so.6 => /lib/libc.so.6 (0x0)", "\tlibEGL.so.1 => not found"]
    monkeypatch.setattr(probes, "_ldd", lambda _: said)
    assert probes.missing_libraries(("a", "b")) == ["libEGL.so.1"]
