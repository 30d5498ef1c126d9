"""Experiments as a user starts them: Ctrl-C, killing, and going on, on the compiled engine of this machine or without."""

import json
import os
import re
import signal
import subprocess
from pathlib import Path

import pytest

from app.cli import main
from tests.e2e.test_command_line import command, environment, read_until, understudy
from tests.unit.cli.foraging import stored
from tests.unit.engine.experiments.small import boxes, document, written

UNDER_WAY = re.compile(rb"\d:\d\d:\d\d")
#: Runs of each arm: more than any machine has made by the time somebody presses Ctrl-C.
ENDLESS = 100_000


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return written(stored(tmp_path / "boxes", boxes()), document())


def test_an_experiment_ends_with_a_report_and_figures(folder: Path) -> None:
    done = understudy("experiment", folder, "small", "--runs", "2", "--json")
    assert done.returncode == 0
    found = json.loads(done.stdout)
    svg, png = (Path(path) for path in found["figures"])
    assert svg.read_bytes().startswith(b"<?xml")
    assert png.read_bytes().startswith(b"\x89PNG")
    assert "Groups collect more" in Path(found["report"]).read_text()


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL])
def test_stopped_at_any_moment_it_goes_on_to_the_same_numbers(
    folder: Path, how: signal.Signals, capsys: pytest.CaptureFixture[str]
) -> None:
    written(folder, document(runs=ENDLESS, ticks=200))
    ours, theirs = os.openpty()
    started = subprocess.Popen(
        command("experiment", folder, "small", "--jobs", "2"),
        stdout=subprocess.DEVNULL,
        stderr=theirs,
        env=environment(TERM="xterm", COLUMNS="80"),
        start_new_session=True,
    )
    os.close(theirs)
    with os.fdopen(ours, "rb", buffering=0) as terminal:
        read_until(terminal, UNDER_WAY)
        os.killpg(started.pid, how)
        said = read_until(terminal)
    assert started.wait(timeout=300) == (130 if how is signal.SIGINT else -how)
    assert b"Traceback" not in said

    few = ("--runs", "12", "--out")
    assert told(capsys, folder, *few, str(folder / "results")) == told(
        capsys, folder, *few, str(folder / "new")
    )


def told(capsys: pytest.CaptureFixture[str], folder: Path, *more: str) -> list[object]:
    """All that an experiment says about its runs, but how fast they were."""
    assert main(["experiment", str(folder), "small", "--json", *more]) == 0
    found = json.loads(capsys.readouterr().out)
    keys = ("name", "runs", "measures", "stalled_share")
    return [found["claims"], *([arm[key] for key in keys] for arm in found["arms"])]


def test_a_damaged_file_of_results_is_refused_without_a_traceback(folder: Path) -> None:
    file = folder / "results" / "small.sqlite"
    file.parent.mkdir()
    file.write_bytes(b"SQLite format 3" + b"x" * 5000)
    done = understudy("experiment", folder, "small")
    assert done.returncode == 2
    assert "small.sqlite: the file is damaged" in done.stderr
    assert "Traceback" not in done.stderr
