"""The studio's figures come from processes of their own, each group once; what fails there is told with its reason."""

import json
import sys
import time
from dataclasses import replace
from pathlib import Path

import pytest

from app.cli import studio_figures
from app.cli.studio_figures import Groups, measured, seconds_to_window, studio_measures
from app.engine.bench.commands import CommandError
from app.engine.bench.subject import Program, Subject, subject

ROOT = Path(__file__).parents[3]


@pytest.fixture(scope="module")
def tiny() -> Subject:
    """Everything in a small size."""
    folders = ROOT / "projects" / "foraging", ROOT / "resources" / "bench" / "forager"
    program = Program((sys.executable,), {"PYTHONPATH": str(ROOT)})
    return replace(subject(*folders, program, 2, time.perf_counter), shrink=1_000)


def instead(monkeypatch: pytest.MonkeyPatch, script: str) -> None:
    """Run *script* where a window would be measured; it leaves its arguments alone."""
    monkeypatch.setattr(studio_figures, "PYTHON", (sys.executable, "-c", script))


def test_a_group_is_measured_in_a_process_off_the_screen(tiny: Subject) -> None:
    assert set(measured(tiny, "frames")) == {"frames 3,125", "frames 10,000"}


def test_one_process_gives_all_figures_of_a_group(
    tiny: Subject, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    log = tmp_path / "log"
    found = json.dumps({"a": 1.0, "b": 2.0})
    instead(monkeypatch, f"open({str(log)!r}, 'a').write('x'); print({found!r})")
    groups = Groups()
    assert [groups.take(tiny, "any", figure) for figure in "abab"] == [1.0, 2.0, 1.0, 2.0]
    assert log.read_text() == "x"


def test_in_full_it_is_measured_again_for_longer(tiny: Subject, monkeypatch: pytest.MonkeyPatch) -> None:
    instead(monkeypatch, "import sys, json; print(json.dumps({'full': float(sys.argv[4] == 'full')}))")
    groups = Groups()
    assert [groups.take(replace(tiny, full=full), "any", "full") for full in (True, False)] == [1.0, 0.0]


def test_a_window_that_fails_is_no_figure_and_says_why(
    tiny: Subject, monkeypatch: pytest.MonkeyPatch
) -> None:
    instead(monkeypatch, "import sys; sys.exit('the screen is gone')")
    with pytest.raises(CommandError, match="frames: measuring ended with exit code 1: the screen is gone"):
        measured(tiny, "frames")
    with pytest.raises(CommandError, match="ended with exit code 1 before its window"):
        seconds_to_window(tiny)


def test_the_start_of_the_real_studio_is_timed_until_its_window_is_painted(tiny: Subject) -> None:
    assert seconds_to_window(tiny) > 0.0


def test_only_what_is_short_is_measured_without_being_asked_for() -> None:
    short = {one.name for one in studio_measures() if not one.long}
    assert short == {"window on screen", "canvas, 3,125 agents", "canvas, 10,000 agents"}
