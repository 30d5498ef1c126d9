"""Commands that the window tells of can be pasted into a terminal as they are."""

from pathlib import Path

from app.editor.exporting.command import command


def test_a_clone_is_started_by_its_own_script_wherever_the_terminal_is(tmp_path: Path) -> None:
    run = tmp_path / "run"
    run.touch()
    assert command("run", "a.json", run=run) == f"{run} run a.json"


def test_what_was_installed_is_called_by_its_name(tmp_path: Path) -> None:
    assert command("run", "a.json", run=tmp_path / "run") == "understudy run a.json"


def test_names_that_a_shell_would_take_apart_are_quoted(tmp_path: Path) -> None:
    assert command("run", "my arm's.json", run=tmp_path / "run") == """understudy run 'my arm'"'"'s.json'"""
