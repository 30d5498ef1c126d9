"""`understudy train` and `understudy demonstrate`: what they report, keep and refuse."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from app.cli import main
from app.cli.demonstrate import differences, lines
from app.cli.train import remarks, rows, summary
from app.core.storage import load, save
from app.learner.dataset import LeftOut
from app.learner.evaluation import BehaviorReport, StateReport
from tests.unit.cli.foraging import project, stored, taught

STATE = StateReport("forward", "forward", 8, 3, 0.875, None, ("forward", "left"), ((7.0, 1.0), (0.0, 0.0)))
REPORT = BehaviorReport("agent", "goto", "Goto", 0, 8, (STATE, replace(STATE, name="left", cv_accuracy=0.5)))


@pytest.fixture
def untaught(tmp_path: Path) -> Path:
    """A project with a demonstration that has not been played."""
    return stored(tmp_path / "homing", taught())


@pytest.fixture
def homing(untaught: Path, capsys: pytest.CaptureFixture[str]) -> Path:
    """A project with examples that came from its demonstration."""
    assert main(["demonstrate", str(untaught)]) == 0
    capsys.readouterr()
    return untaught


def contents(folder: Path) -> dict[str, bytes]:
    return {str(file.relative_to(folder)): file.read_bytes() for file in folder.rglob("*") if file.is_file()}


# ------------------------------------------------------------------------------------------------------ reporting


def test_a_report_is_a_row_a_state() -> None:
    assert rows(REPORT) == [
        ["agent/Goto", "forward", "8", "3", "88%", "–"],
        ["", "left", "8", "3", "88%", "50%"],
    ]


def test_a_behavior_that_learned_nothing_still_has_its_row() -> None:
    assert rows(replace(REPORT, states=())) == [["agent/Goto"]]


@pytest.mark.parametrize(
    ("changed", "dry_run", "outcome"),
    [
        (True, False, "kept"),
        (False, False, "just as it was"),
        (False, True, "just as it was"),
        (True, True, "not kept"),
    ],
)
def test_a_summary_says_what_became_of_it(*, changed: bool, dry_run: bool, outcome: str) -> None:
    said = summary([REPORT], changed=changed, dry_run=dry_run)
    assert said.startswith(f"1 behavior from 8 examples; {outcome}")


def test_conflicts_and_examples_left_out_are_named() -> None:
    state = replace(STATE, conflicts=(("3", "7"),))
    report = replace(REPORT, states=(state,), left_out=(LeftOut("9", "its state is gone"),))
    assert remarks(report) == [
        "agent/Goto, state forward: examples 3 and 7 have equal features and different labels",
        "agent/Goto: example 9 is left out: its state is gone",
    ]


def test_train_json_has_the_keys_that_others_rely_on(
    homing: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["train", str(homing), "--json"]) == 0
    (behavior,) = json.loads(capsys.readouterr().out)["behaviors"]
    assert {"name", "level", "examples", "states"} <= set(behavior)
    assert {"state", "examples", "nodes", "accuracy", "cv_accuracy"} <= set(behavior["states"][0])


# -------------------------------------------------------------------------------------------------------- keeping


def test_training_again_changes_no_file(homing: Path) -> None:
    before = contents(homing)
    assert main(["train", str(homing)]) == 0
    assert contents(homing) == before


def forget(folder: Path) -> None:
    """Take what was learned out of a project, and keep its examples."""
    made = load(folder)
    library = made.library("agent")
    goto = replace(library.automata["Goto"], learned={}, learned_from="")
    automata = {**library.automata, "Goto": goto}
    save(replace(made, libraries={"agent": replace(library, automata=automata)}), folder, made)


def test_training_keeps_what_was_learned(homing: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = contents(homing)
    forget(homing)
    assert contents(homing) != before
    assert main(["train", str(homing), "Goto"]) == 0
    assert "; kept" in capsys.readouterr().out
    assert contents(homing) == before


def test_a_dry_run_reports_and_keeps_nothing(homing: Path, capsys: pytest.CaptureFixture[str]) -> None:
    forget(homing)
    before = contents(homing)
    assert main(["train", str(homing), "--dry-run"]) == 0
    assert "not kept" in capsys.readouterr().out
    assert contents(homing) == before


def test_a_project_without_examples_has_nothing_to_train(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["train", str(stored(tmp_path / "p", project()))]) == 0
    assert "nothing to learn" in capsys.readouterr().out


# -------------------------------------------------------------------------------------------------- demonstrating


def test_check_names_every_file_that_would_come_out_different(
    untaught: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = contents(untaught)
    assert main(["demonstrate", str(untaught), "--check"]) == 1
    out = capsys.readouterr().out
    assert "examples/agent/Goto.json" in out
    assert "libraries/agent/Goto.json" in out
    assert "project.json" not in out
    assert contents(untaught) == before


def test_what_was_demonstrated_comes_out_the_same_byte_for_byte(
    homing: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["demonstrate", str(homing), "--check", "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert (document["same"], document["differing"]) == (True, [])
    assert [(b["name"], b["demonstrations"]) for b in document["behaviors"]] == [("Goto", 1)]
    assert document["behaviors"][0]["examples"] > 0


def test_one_changed_byte_is_a_difference(homing: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = homing / "examples" / "agent" / "Goto.json"
    file.write_text(file.read_text() + "\n")
    assert main(["demonstrate", str(homing), "--check", "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["differing"] == ["examples/agent/Goto.json"]


def test_files_that_are_not_of_the_project_s_making_are_not_compared(homing: Path) -> None:
    (homing / "README.md").write_text("what this is")
    (homing / "results").mkdir()
    (homing / "results" / "notes.json").write_text("{}")
    assert differences(load(homing), homing) == ()


def test_of_many_differing_files_the_first_are_listed_and_the_rest_counted() -> None:
    said = lines(taught(), [], [f"file-{number}" for number in range(25)], only_check=True)
    assert said[1:] == [*(f"  file-{number}" for number in range(20)), "  and 5 more"]


def test_only_the_named_behaviors_are_demonstrated(homing: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["demonstrate", str(homing), "agent/Goto"]) == 0
    assert "agent/Goto: 1 demonstration" in capsys.readouterr().out


# ------------------------------------------------------------------------------------------------------- refusing


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["train", "Gto"], "no behavior 'Gto' (did you mean 'agent/Goto'?)"),
        (["train", "Home"], "'Home' has no examples to learn from"),
        (["demonstrate", "Gto"], "no behavior 'Gto'"),
        (["demonstrate", "Home"], "agent/Home has no demonstrations to play"),
    ],
)
def test_what_cannot_be_taught_is_refused_by_name(
    arguments: list[str], said: str, homing: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = contents(homing)
    assert main([arguments[0], str(homing), *arguments[1:]]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert said in err
    assert contents(homing) == before


def test_a_project_without_demonstrations_has_none_to_play(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["demonstrate", str(stored(tmp_path / "p", project()))]) == 2
    assert "no demonstrations to play" in capsys.readouterr().err


@pytest.mark.parametrize("verb", ["train", "demonstrate"])
def test_an_interrupt_changes_nothing(
    verb: str, homing: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("app.cli.train.learn", interrupted)
    monkeypatch.setattr("app.cli.demonstrate.recreate", interrupted)
    before = contents(homing)
    assert main([verb, str(homing)]) == 130
    assert "nothing was changed" in capsys.readouterr().err
    assert contents(homing) == before


@pytest.mark.parametrize(
    ("number", "said"),
    [(28, "the disk is full"), (13, "permission denied"), (30, "the file system is read-only")],
)
@pytest.mark.parametrize("verb", ["train", "demonstrate"])
def test_where_nothing_can_be_written_that_is_said_and_nothing_is_lost(
    verb: str,
    number: int,
    said: str,
    homing: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    forget(homing)
    before = contents(homing)

    def refuse(*_: object, **__: object) -> None:
        raise OSError(number, "so says the system")

    monkeypatch.setattr("os.fsync", refuse)
    assert main([verb, str(homing)]) == 2
    assert said in capsys.readouterr().err
    assert contents(homing) == before
