import json
import math

import pytest

from app.cli import console


def test_json_is_one_document_on_stdout(capsys: pytest.CaptureFixture[str]) -> None:
    console.show_json({"a": [1, 2.5], "b": "×"})
    out, err = capsys.readouterr()
    assert json.loads(out) == {"a": [1, 2.5], "b": "×"}
    assert err == ""


def test_json_never_holds_what_other_programs_cannot_read() -> None:
    with pytest.raises(ValueError, match="JSON"):
        console.show_json({"a": math.nan})


def test_words_to_the_user_go_to_stderr_with_the_program_s_name(capsys: pytest.CaptureFixture[str]) -> None:
    console.say("hello")
    assert capsys.readouterr() == ("", "understudy: hello\n")


def test_a_table_in_a_pipe_is_not_cut_off(capsys: pytest.CaptureFixture[str]) -> None:
    console.show_table(("a", "b"), [("x" * 300, "1")])
    assert "x" * 300 + "   1" in capsys.readouterr().out


def test_names_in_a_table_are_not_taken_for_markup(capsys: pytest.CaptureFixture[str]) -> None:
    console.show_table(("a",), [("[red]Goto[/red] :boom:",)])
    assert "[red]Goto[/red] :boom:" in capsys.readouterr().out


def test_progress_without_a_terminal_is_a_line_now_and_then(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(console, "QUIET", 10.0)
    times = iter([0.0, 5.0, 10.0, 10.0, 15.0])
    advance = console._lines("Running", 200, lambda: next(times))
    for done in (20, 100, 150):
        advance(done)
    assert capsys.readouterr() == ("", "understudy: Running: 50%\n")


def test_short_work_says_nothing_of_its_progress(capsys: pytest.CaptureFixture[str]) -> None:
    with console.progress("Running", 10) as advance:
        advance(10)
    assert capsys.readouterr() == ("", "")


def test_on_a_terminal_progress_is_a_bar_on_stderr(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.stderr.isatty", lambda: True)
    monkeypatch.setenv("TERM", "xterm")
    with console.progress("Running", 10) as advance:
        advance(5)
    out, err = capsys.readouterr()
    assert out == ""
    assert "Running" in err
