"""From what is typed to an exit code and a message."""

import os
import signal
import sys
import tomllib
from contextlib import suppress
from io import TextIOWrapper
from pathlib import Path

import pytest

from app.cli import application, main
from app.cli.application import with_verb
from app.cli.places import CLONE
from app.cli.verbs import NAMES, STUDIO
from app.core.errors import ParameterError
from app.core.wholes import as_a_whole
from tests.unit.cli.foraging import stored

VERBS = ("run", "train", "studio")


@pytest.mark.parametrize("given", [[], ["--picture", "x.png"], ["some/project"], ["."], ["graph.json"]])
def test_without_a_verb_the_studio_is_meant(given: list[str]) -> None:
    assert with_verb(given, VERBS) == ["studio", *given]


@pytest.mark.parametrize("given", [["run", "x"], ["--help"], ["-h"], ["--version"]])
def test_verbs_and_options_of_the_program_stay(given: list[str]) -> None:
    assert with_verb(given, VERBS) == given


def test_an_unknown_verb_is_answered_with_a_near_one() -> None:
    with pytest.raises(
        ParameterError, match=r"no verb 'trian' \(did you mean 'train'\?\); there are: run, train"
    ):
        with_verb(["trian", "x"], VERBS)


def test_a_folder_of_the_current_folder_is_a_project_even_without_a_slash(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "mine").mkdir()
    monkeypatch.chdir(tmp_path)
    assert with_verb(["mine"], VERBS) == ["studio", "mine"]


@pytest.mark.parametrize(
    "arguments", [["--help"], ["-h"], ["--version"], ["run", "--help"], ["new", "--list"]]
)
def test_asking_is_no_failure(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(arguments) == 0
    out, err = capsys.readouterr()
    assert out
    assert err == ""


@pytest.mark.parametrize("verb", [name for name in NAMES if name != STUDIO])
def test_every_verb_has_help_with_examples_and_json(verb: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([verb, "--help"]) == 0
    out = capsys.readouterr().out
    assert f"understudy {verb}" in out.split("Examples:")[1]
    assert "--json" in out


def test_the_version_is_that_of_the_package(capsys: pytest.CaptureFixture[str]) -> None:
    pyproject = tomllib.loads((CLONE / "pyproject.toml").read_text())
    main(["--version"])
    assert capsys.readouterr().out == f"understudy {pyproject['project']['version']}\n"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["rum"], "did you mean 'run'?"),
        (["run"], "Missing argument 'PROJECT|FILE.json'"),
        (["run", "x", "--runs", "0"], "'--runs': it must be 1 or more, but it is 0"),
        (["run", "x", "--ticks", "-1"], "'--ticks': it must be 1 or more, but it is -1"),
        (["run", "x", "--jobs", "0"], "'--jobs': it must be 1 or more, but it is 0"),
        (["run", "x", "--seed", "-1"], "'--seed': it must be 0 or more, but it is -1"),
        (["run", "x", "--ticks", "1,00"], "'--ticks': it must be a whole number, but it is '1,00'"),
        (["run", "x", "--ticks", "many"], "'--ticks': it must be a whole number, but it is 'many'"),
        (["experiment", "x", "--runs", "1e3"], "'--runs': it must be a whole number, but it is '1e3'"),
        (["run", "x", "--tocks", "3"], "--tocks"),
        (["run", "x", "--picture", "x.gif"], "pictures end in .png, .svg, .pdf"),
        (["run", "x", "--picture", "nowhere/x.png"], "there is no folder nowhere"),
        (["run", "not-there"], "not-there: there is no such folder"),
        (
            ["run", "not-there.json"],
            "not-there.json: there is no such file; `understudy export PROJECT -o FILE",
        ),
        (["train", "not-there"], "not-there: there is no such folder"),
        (["demonstrate", "not-there"], "not-there: there is no such folder"),
        (["new", "somewhere"], "understudy: name the world that its agents live in: --scenario foraging"),
        (["new", "somewhere", "--scenario", "foragin"], "did you mean 'foraging'?"),
        (["--foo"], "No such option: --foo"),
    ],
)
def test_wrong_input_gets_a_message_and_exit_code_2(
    arguments: list[str],
    said: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(arguments) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("understudy: ")
    assert said in err
    assert "Traceback" not in err


def test_usage_errors_say_where_to_read_on(capsys: pytest.CaptureFixture[str]) -> None:
    main(["run"])
    assert "understudy run --help says what can be given" in capsys.readouterr().err


@pytest.fixture
def failing(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """A program that fails in `check`; the folder that its logs go to."""

    def fail(*_: object, **__: object) -> None:
        raise ZeroDivisionError("by design")

    monkeypatch.setattr("app.cli.check.check_project", fail)
    monkeypatch.setattr("platformdirs.user_log_path", lambda *_, **__: tmp_path / "log")
    return tmp_path / "log"


def test_a_failure_of_the_program_is_kept_in_a_file_to_be_reported(
    failing: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["check", "some/project"]) == 1
    err = capsys.readouterr().err
    (kept,) = failing.iterdir()
    assert str(kept) in err
    assert "please report it" in err
    assert "Traceback" not in err
    text = kept.read_text()
    assert "ZeroDivisionError: by design" in text
    assert "['check', 'some/project']" in text


def test_debug_shows_where_the_program_failed(failing: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", "x", "--debug"]) == 1
    assert "Traceback" in capsys.readouterr().err


def test_a_failure_is_shown_where_no_file_can_be_written(
    failing: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(Path, "write_text", lambda *_, **__: (_ for _ in ()).throw(PermissionError(13, "no")))
    assert main(["check", "x"]) == 1
    assert "Traceback" in capsys.readouterr().err


def test_an_interrupt_is_exit_code_130(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("app.cli.check.check_project", interrupted)
    assert main(["check", "x"]) == 130
    assert capsys.readouterr().err == "understudy: interrupted\n"


def test_a_name_that_the_terminal_cannot_show_is_no_failure(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = stored(tmp_path / "Käfer-🐞")
    assert isinstance(sys.stdout, TextIOWrapper)
    sys.stdout.reconfigure(encoding="ascii")
    assert main(["check", str(folder)]) == 0
    assert "\\U0001f41e" in capsys.readouterr().out


def test_a_second_ctrl_c_ends_at_once_but_not_in_the_middle_of_changing_files(
    monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    codes: list[int] = []

    def stubborn(_given: list[str]) -> int:
        for _ in range(2):
            with suppress(KeyboardInterrupt), as_a_whole():
                signal.raise_signal(signal.SIGINT)
        assert codes == []
        signal.raise_signal(signal.SIGINT)
        return 0

    monkeypatch.setattr(os, "_exit", codes.append)
    monkeypatch.setattr(application, "_obey", stubborn)
    application.main(["check"])
    assert codes == [130]
    assert capfd.readouterr().err == "understudy: interrupted\n"
