"""``understudy experiment`` in this process: what it prints, writes and refuses."""

import json
import os
import shlex
import signal
import sys
from pathlib import Path
from typing import Any

import pytest

from app.cli import experiment as verb
from app.cli import main
from app.editor.drawing.curves import Chart
from app.editor.drawing.experiment_chart import chart_of
from app.editor.drawing.figures import FigureError
from app.engine.experiments.findings import Findings, findings
from app.engine.experiments.plan import Design, Experiment, Panel
from app.engine.experiments.runner import Progress, carry_out
from app.engine.experiments.store import Results
from tests.unit.cli.foraging import stored
from tests.unit.engine.experiments.small import boxes, document, experiment, factor, row, written


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A project with an experiment; figures are not drawn, only written."""
    monkeypatch.setattr(verb, "draw", lambda _chart, path, **_: path.write_text("a figure"))
    return written(stored(tmp_path / "boxes", boxes()), document())


def test_without_a_name_the_experiments_are_listed(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["experiment", str(folder)]) == 0
    assert "small        Small" in capsys.readouterr().out
    assert main(["experiment", str(folder), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["experiments"] == ["small"]


def test_a_damaged_experiment_does_not_hide_the_others(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "experiments" / "broken.json").write_text("{", encoding="utf-8")
    assert main(["experiment", str(folder)]) == 2
    said, told = capsys.readouterr()
    assert "small        Small" in said
    assert "broken.json: line 1, column 2: the file ends too early" in told


def test_one_json_document_tells_all_and_where_the_files_are(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    assert main(["experiment", str(folder), "small", "--jobs", "2", "--out", str(out), "--json"]) == 0
    said, told = capsys.readouterr()
    assert told == ""
    found = json.loads(said)
    assert [(arm["name"], arm["runs"]) for arm in found["arms"]] == [("alone", 2), ("grouped", 2)]
    assert found["claims"][0]["verdict"] in ("holds", "does not hold", "not significant")
    assert [Path(path).name for path in found["figures"]] == ["small.svg", "small.png"]
    assert {path.name for path in out.iterdir()} == {"small.sqlite", "small.md", "small.svg", "small.png"}
    report = (out / "small.md").read_text()
    assert "# Small" in report
    assert f"understudy experiment {folder} small --out {out}" in report


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere every name is text")
def test_a_report_can_lie_in_a_folder_whose_name_is_no_text(folder: Path, tmp_path: Path) -> None:
    out = tmp_path / os.fsdecode(b"caf\xe9")
    assert main(["experiment", str(folder), "small", "--out", str(out)]) == 0
    assert f"--out {shlex.quote(f'{tmp_path}/caf�')}" in (out / "small.md").read_text(encoding="utf-8")


def test_a_table_of_arms_and_one_of_claims_is_printed(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["experiment", str(folder), "small"]) == 0
    said = capsys.readouterr().out
    assert "arm       runs" in said
    assert "Groups collect more" in said
    assert str(folder / "results" / "small.sqlite") in said


def test_what_is_there_is_not_run_again(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["experiment", str(folder), "small", "--runs", "1", "--json"]) == 0
    first = capsys.readouterr().out
    assert main(["experiment", str(folder), "small", "--runs", "1", "--json"]) == 0
    said, told = capsys.readouterr()
    assert json.loads(said) == json.loads(first)
    assert "2 runs of 2 are there already" in told


def test_runs_of_another_length_get_files_of_their_own(folder: Path) -> None:
    assert main(["experiment", str(folder), "small"]) == 0
    assert main(["experiment", str(folder), "small", "--ticks", "2"]) == 0
    names = {path.name for path in (folder / "results").glob("*.sqlite")}
    assert names == {"small.sqlite", "small-2-ticks.sqlite"}


def test_interrupted_it_says_how_to_go_on_and_does(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*arguments: Any, **more: Any) -> bool:
        def tell_and_press(now: Progress) -> None:
            if now.done:
                signal.raise_signal(signal.SIGINT)
                said.append("is not torn out of what it is doing")
            more["tell"](now)

        return carry_out(*arguments, **more | {"tell": tell_and_press})

    said: list[str] = []

    monkeypatch.setattr(verb, "carry_out", interrupted)
    assert main(["experiment", str(folder), "small", "--jobs", "1"]) == 130
    assert said == ["is not torn out of what it is doing"]
    assert "1 run of 4 are kept; the same command goes on" in capsys.readouterr().err
    monkeypatch.undo()
    monkeypatch.setattr(verb, "draw", lambda *_, **__: None)
    assert main(["experiment", str(folder), "small", "--json"]) == 0
    out, told = capsys.readouterr()
    assert "1 run of 4 are there already" in told
    assert [arm["runs"] for arm in json.loads(out)["arms"]] == [2, 2]


def test_ctrl_c_while_it_compiles_is_heeded_and_said(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def compiling(*arguments: Any) -> None:
        signal.raise_signal(signal.SIGINT)
        assert arguments[3]()

    monkeypatch.setattr("app.engine.experiments.runner.compile_ahead", compiling)
    written(folder, document(arms=[{"name": "alone", "arm": "independent"}], claims=[]))
    assert main(["experiment", str(folder), "small"]) == 130
    said = capsys.readouterr().err
    assert "0 runs of 2 are kept; the same command goes on" in said
    assert said.endswith("understudy: interrupted\n")


def test_a_figure_that_cannot_be_drawn_costs_nothing_else(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(*_: Any, **__: Any) -> None:
        raise FigureError("no picture: Qt cannot be loaded")

    monkeypatch.setattr(verb, "draw", broken)
    assert main(["experiment", str(folder), "small", "--json"]) == 1
    said, told = capsys.readouterr()
    assert "no picture: Qt cannot be loaded" in told
    assert json.loads(said)["figures"] == []
    assert "![" not in (folder / "results" / "small.md").read_text()


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (["smll"], "there is no experiment 'smll'"),
        (["small", "--runs", "0"], "it must be 1 or more, but it is 0"),
        (["small", "--runs", "1000001"], "at most 1,000,000 runs an arm"),
        (["small", "--jobs", "0"], "it must be 1 or more, but it is 0"),
        (["small", "--out", "FILE"], "is a file"),
    ],
)
def test_bad_input_is_refused_before_anything_runs(
    more: list[str], said: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = str(folder / "project.json")
    assert main(["experiment", str(folder), *(file if word == "FILE" else word for word in more)]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert said in err


def test_results_of_another_experiment_are_refused(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["experiment", str(folder), "small"]) == 0
    written(folder, document(points=2))
    assert main(["experiment", str(folder), "small"]) == 2
    assert (
        "small.sqlite: these are results of another experiment; what differs: points"
        in capsys.readouterr().err
    )


# ----------------------------------------------------------------------------------------------------- charts


def chart(tmp_path: Path, of: Experiment) -> tuple[Findings, Chart]:
    """The figure of two runs a cell, which collected as many boxes as their numbers say."""
    with Results.open(tmp_path / "r.sqlite", {}) as results:
        for cell in of.cells():
            for number in range(2):
                measures = {"boxes": 10.0 * cell.number + number, "weight": 1.0, "picks": 3.0 * cell.number}
                made = row(cell.number, number, measures)
                results.add(type(made)(*(made.cell, made.run, 0, measures, False, made.curves[:2], 1, 1.0)))
        found = findings(of, ["boxes", "weight"], results)
    return found, chart_of(found)


def test_curves_stand_in_their_confidence_and_end_at_the_mean(tmp_path: Path) -> None:
    _, drawn = chart(tmp_path, experiment(panels=(Panel("boxes", title="Boxes"),)))
    (plot,) = drawn.plots
    assert [band.label for band in plot.bands] == ["alone: 0.5", "grouped: 10.5"]
    band = plot.bands[1]
    assert (band.x, band.y) == ((0.0, 60.0), (0.0, 10.5))
    assert band.low[1] < band.y[1] < band.high[1]
    assert len({(band.color, band.dash) for band in plot.bands}) == 2


def test_over_a_factor_lines_go_through_its_levels_at_their_own_number_or_a_measures(tmp_path: Path) -> None:
    ranges = factor("range", "world.deposit_range", 2.0, 7.0)
    panels = (Panel("boxes", "range"), Panel("boxes", "range", by="picks"))
    _, drawn = chart(tmp_path, experiment(factors=(ranges,), panels=panels))
    assert [(band.label, band.x, band.y) for band in drawn.plots[0].bands] == [
        ("alone", (2.0, 7.0), (0.5, 20.5)),
        ("grouped", (2.0, 7.0), (10.5, 30.5)),
    ]
    assert [band.x for band in drawn.plots[1].bands] == [(0.0, 6.0), (3.0, 9.0)]


def test_in_rows_the_arms_stand_beside_each_other_under_what_was_changed(tmp_path: Path) -> None:
    ranges = factor("range", "world.deposit_range", 2.0, 7.0)
    plan = experiment(factors=(ranges,), design=Design.ONE_AT_A_TIME, panels=(Panel("boxes", "rows"),))
    _, drawn = chart(tmp_path, plan)
    assert [(each.label, [dot.mean for dot in each.dots]) for each in drawn.plots[0].rows] == [
        ("as usual", [0.5, 10.5]),
        ("range: 7.0", [20.5, 30.5]),
    ]
    assert [key.label for key in drawn.keys] == ["alone", "grouped"]


def test_a_panel_shows_only_its_levels(tmp_path: Path) -> None:
    ranges = factor("range", "world.deposit_range", 2.0, 7.0)
    panels = (Panel("boxes", where={"range": "7.0"}),)
    _, drawn = chart(tmp_path, experiment(factors=(ranges,), panels=panels))
    assert [band.label for band in drawn.plots[0].bands] == ["alone: 20.5", "grouped: 30.5"]
