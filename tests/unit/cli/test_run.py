"""`understudy run`: what it prints, and what it refuses."""

import json
import signal
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from app.cli import main
from app.cli.console import Advance
from app.cli.pictures import Shown, figure_of_runs, structure
from app.cli.plans import Bench, Plan
from app.cli.run import columns, means, rows
from app.cli.worlds import WORTH_A_PROCESS, Ran, run_plans, worthwhile
from app.core.errors import ScenarioError
from app.editor.drawing.figures import FORMATS, FigureError
from app.engine.runs import Curve, RunResult
from app.sim.scenarios.foraging import scenario as foraging
from tests.unit.cli.foraging import ARMS, project, stored, taught


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return stored(tmp_path / "boxes")


def result(seed: int, boxes: float, stalled: bool = False) -> RunResult:
    measures = {"boxes": boxes, "weight": 5 * boxes}
    curve = Curve((0, 10), {name: (0.0, value) for name, value in measures.items()})
    return RunResult(seed, 10, measures, stalled, curve, {"x": (), "y": (), "heading": ()})


# ----------------------------------------------------------------------------------------------- what it prints


def test_json_has_the_keys_that_others_rely_on(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", str(folder), "--ticks", "20", "--seed", "7", "--runs", "2", "--json"]) == 0
    out, err = capsys.readouterr()
    document = json.loads(out)
    # With a cold cache the kernel is compiled first, which is told where progress goes.
    assert all(line.startswith("understudy: ") for line in err.splitlines())
    assert (document["project"], document["top"], document["ticks"]) == ("Boxes", "Forage", 20)
    assert [run["seed"] for run in document["runs"]] == [7, 8]
    assert set(document["runs"][0]) == {"seed", "measures", "stalled"}
    assert set(document["runs"][0]["measures"]) == {"boxes", "weight"}
    assert document["agent_ticks_per_second"] > 0


def test_the_first_arm_runs_by_default(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    main(["run", str(folder), "--ticks", "1", "--json"])
    assert json.loads(capsys.readouterr().out)["arm"] == "independent"


@pytest.mark.parametrize("arm", [arm.name for arm in ARMS])
def test_every_arm_runs(arm: str, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", str(folder), "--arm", arm, "--ticks", "30"]) == 0
    assert arm in capsys.readouterr().out


def test_numbers_may_be_typed_as_messages_write_them(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["run", str(folder), "--ticks", "1,000", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["ticks"] == 1000


def test_another_top_behavior_replaces_the_arm_s(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", str(folder), "--top", "Wander", "--ticks", "5", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["top"] == "Wander"


def test_settings_reach_the_world(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """With one puller a box, within reach of everywhere, every box moves; with none there, nothing is delivered."""
    base = ["run", str(folder), "--ticks", "150", "--json", "--set", "world.step=2"]
    many = ["--set", "world.pullers=1", "--set", "world.width=20", "--set", "world.height=20"]
    near = ["--set", "world.deposit_x=10", "--set", "world.deposit_y=10"]
    counts = []
    for more in (["--set", "world.boxes=0"], ["--set", "world.boxes=20"]):
        main([*base, *many, *near, *more])
        counts.append(json.loads(capsys.readouterr().out)["runs"][0]["measures"]["boxes"])
    assert counts[0] == 0
    assert counts[1] > 0


def test_the_same_seed_gives_the_same_numbers_in_turn_on_threads_and_in_processes(folder: Path) -> None:
    def results(engine: str, jobs: int) -> tuple[RunResult | None, ...]:
        plans = [Plan(ARMS[1], seed, 60, {"engine": engine}) for seed in (1, 2, 3)]
        return run_plans(Bench(project(), folder), plans, jobs, lambda _: None).results

    in_turn = results("reference", 1)
    assert None not in in_turn
    assert in_turn == results("compiled", 2) == results("reference", 2)


def test_runs_are_a_table_with_their_mean(folder: Path) -> None:
    results = (result(1, 12.0), result(2, 9.0, stalled=True))
    assert columns(results) == ["seed", "boxes", "weight", "stalled"]
    assert rows(results) == [
        ["1", "12", "60", ""],
        ["2", "9", "45", "yes"],
        ["mean", "10.5", "52.5", "1 of 2"],
    ]


def test_a_single_run_needs_no_mean() -> None:
    assert rows([result(1, 3.0)]) == [["1", "3", "15", ""]]


def test_where_nothing_ran_there_is_no_mean() -> None:
    assert (means([]), rows([]), columns([])) == ({}, [], ["seed", "stalled"])


@pytest.mark.parametrize(
    ("agent_ticks", "compiled", "jobs"),
    [(1, True, 4), (1, False, 1), (WORTH_A_PROCESS, True, 4), (WORTH_A_PROCESS, False, 4)],
)
def test_processes_are_started_only_where_they_pay(*, agent_ticks: int, compiled: bool, jobs: int) -> None:
    plans = [Plan(ARMS[0], seed, agent_ticks // 20 + 1) for seed in (1, 2)]  # of ten agents
    assert worthwhile(plans, 4, compiled=compiled) == jobs


def test_a_stale_behavior_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made = taught()
    folder = stored(tmp_path / "homing", made)
    assert main(["demonstrate", str(folder)]) == 0
    (library,) = (folder / "libraries" / "agent" / "Goto.json",)
    document = json.loads(library.read_text())
    document["settings"] = {"pruning_confidence": 0.25}
    library.write_text(json.dumps(document))
    capsys.readouterr()
    assert main(["run", str(folder), "--ticks", "1"]) == 0
    assert "agent/Goto was changed since last learned" in capsys.readouterr().err


# ---------------------------------------------------------------------------------------------- what it refuses


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (["--arm", "one levl"], "there is no arm 'one levl'"),
        (["--top", "Forrage"], "understudy: --top Forrage: arm 'independent' starts with 'Forrage', which"),
        (["--top", "Forrage"], "did you mean 'Forage'?"),
        (["--top", "Goto"], "understudy: --top Goto: 'target' of Goto is open"),
        (["--ticks", "1000000001"], "'--ticks': it must be 1,000,000,000 or less, but it is 1,000,000,001"),
        (["--runs", "1000001"], "'--runs': it must be 1,000,000 or less, but it is 1,000,001"),
        (["--set", "world.bxes=3"], "did you mean 'world.boxes'?"),
        (["--set", "world.boxes=-1"], "boxes must be 0 or more, but it is -1"),
        (["--set", "world.boxes=many"], "boxes takes a whole number, but it is 'many'"),
        (["--set", "world.placement=here"], "placement is one of"),
        (["--set", "physics=magic"], "magic"),
        (["--set", "world.boxes"], "NAME=VALUE"),
        (["--seed", str(2**63 - 1), "--runs", "2"], "seeds go up to 9,223,372,036,854,775,807"),
    ],
)
def test_bad_input_is_refused_by_name_before_anything_runs(
    more: list[str], said: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["run", str(folder), "--runs", "2", *more]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert said in err


def test_a_project_without_arms_has_nothing_to_run(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["run", str(stored(tmp_path / "p", project(())))]) == 2
    assert "has no arms" in capsys.readouterr().err


def test_a_file_is_no_project(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "notes.txt"
    file.write_text("{}")
    assert main(["run", str(file)]) == 2
    assert f"{file}: this is a file; a project is a folder" in capsys.readouterr().err


def test_a_file_that_may_be_an_export_is_answered_with_how_to_run_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "arm.json"
    file.write_text("{}")
    assert main(["check", str(file)]) == 2
    assert f"If it was exported, `understudy run {file}` runs it" in capsys.readouterr().err


def test_the_file_in_a_project_s_folder_is_answered_with_the_folder(
    folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["run", str(folder / "project.json")]) == 2
    assert f"name the project's folder instead: {folder}" in capsys.readouterr().err


def test_an_error_in_another_arm_does_not_keep_this_one_from_running(tmp_path: Path) -> None:
    broken = replace(ARMS[1], top="NoSuchBehavior")
    folder = stored(tmp_path / "p", project((ARMS[0], broken)))
    assert main(["run", str(folder), "--ticks", "1"]) == 0
    assert main(["run", str(folder), "--ticks", "1", "--arm", broken.name]) == 2


def test_an_error_in_a_process_is_the_error_of_the_whole(folder: Path) -> None:
    bench = Bench(replace(project(), scenario="not-there"), folder)
    with pytest.raises(ScenarioError, match="not-there"):
        run_plans(bench, [Plan(ARMS[0], seed, 5) for seed in (1, 2)], 2, lambda _: None)


# ------------------------------------------------------------------------------------------------- interrupting


#: Takes longer than anybody waits.
ENDLESS = 30_000_000


def interrupting(after: int) -> Advance:
    """Progress that, once *after* ticks are done, does what Ctrl-C does."""

    def advance(done: float) -> None:
        if done >= after:
            signal.raise_signal(signal.SIGINT)

    return advance


@pytest.mark.parametrize(
    ("engine", "jobs"), [("compiled", 1), ("compiled", 2), ("reference", 1), ("reference", 2)]
)
def test_ctrl_c_ends_all_runs_and_keeps_the_finished_ones(engine: str, jobs: int, folder: Path) -> None:
    lengths = (10, 10, ENDLESS, ENDLESS)
    plans = [Plan(ARMS[0], seed, ticks, {"engine": engine}) for seed, ticks in enumerate(lengths)]
    ran = run_plans(Bench(project(), folder), plans, jobs, interrupting(after=2_000))
    assert ran.interrupted
    assert ran.results[2:] == (None, None)
    # Runs begin in their order, so whoever works on an endless one has finished a short one.
    assert any(one is not None for one in ran.results[:2])


def test_ctrl_c_ends_compiling(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def compiling(*arguments: Any) -> None:
        asked.append(arguments[:2])
        signal.raise_signal(signal.SIGINT)
        assert arguments[3]()

    asked: list[tuple[Any, ...]] = []
    monkeypatch.setattr("app.cli.worlds.compile_ahead", compiling)
    with pytest.raises(KeyboardInterrupt):
        run_plans(Bench(project(), folder), [Plan(arm, 1, 5) for arm in ARMS], 1, lambda _: None)
    assert asked == [(foraging, "kinematic")]


def test_what_was_finished_is_shown_when_the_user_interrupts(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(
        "app.cli.run.run_plans", lambda *_: Ran((result(1, 4.0), None), 1.0, interrupted=True)
    )
    assert main(["run", str(folder), "--runs", "2", "--json"]) == 130
    out, err = capsys.readouterr()
    assert [run["seed"] for run in json.loads(out)["runs"]] == [1]
    assert "1 run of 2 had been finished" in err
    assert "interrupted" in err


def test_a_run_that_is_lost_falls_short(
    folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("app.cli.run.run_plans", lambda *_: Ran((result(1, 4.0), None), 1.0))
    assert main(["run", str(folder), "--runs", "2"]) == 1


# ------------------------------------------------------------------------------------------------------ pictures


def one_run(arm: int = 0, ticks: int = 30) -> RunResult:
    ran = run_plans(Bench(project(), Path()), [Plan(ARMS[arm], 1, ticks)], 1, lambda _: None)
    assert ran.results[0] is not None
    return ran.results[0]


def test_a_figure_shows_every_agent_box_and_place_where_it_is() -> None:
    outcome = one_run()
    shown = Shown(ARMS[0], foraging.settle({}), (outcome,))
    (world,) = figure_of_runs("t", "s", foraging, [shown]).worlds
    assert [(w.x, w.y) for w in world.walkers] == list(
        zip(outcome.world["x"], outcome.world["y"], strict=True)
    )[:10]
    boxes, places = [b for b in world.bodies if not b.place], [b for b in world.bodies if b.place]
    assert (len(boxes), {b.radius for b in boxes}, {b.needed for b in boxes}) == (10, {2.5}, {5})
    assert [(p.x, p.y, p.radius) for p in places] == [(100.0, 100.0, 5.0)]
    assert (world.width, world.height) == (200.0, 200.0)


def test_several_runs_are_faint_lines_behind_their_mean() -> None:
    runs = tuple(
        replace(one_run(), curve=Curve((0, 30), {"boxes": (0.0, y), "weight": (0.0, y)})) for y in (2.0, 5.0)
    )
    figure = figure_of_runs("t", "s", foraging, [Shown(ARMS[0], foraging.settle({}), runs)])
    assert [(s.faint, s.y) for s in figure.series] == [
        (True, (0.0, 2.0)),
        (True, (0.0, 5.0)),
        (False, (0.0, 3.5)),
    ]
    assert figure.series[-1].label == "mean: 3.5"


def test_a_figure_says_what_its_marks_mean() -> None:
    figure = figure_of_runs("t", "s", foraging, [Shown(ARMS[0], foraging.settle({}), (one_run(),))])
    assert set(figure.legend) == {"agent", "busy", "body", "full", "place"}
    assert figure.y_title == "boxes brought to the deposit"


def test_a_structure_is_told_in_words() -> None:
    assert [structure(arm) for arm in ARMS] == [
        "10 agents",
        "10 agents, 2 controllers",
        "10 agents, 3 controllers",
    ]
    assert structure(replace(ARMS[0], note="ten on their own")) == "ten on their own"


@pytest.mark.parametrize("ending", FORMATS)
def test_a_picture_is_drawn_where_the_user_wants_it(
    ending: str, folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    picture = tmp_path / f"picture{ending}"
    assert main(["run", str(folder), "--ticks", "20", "--picture", str(picture)]) == 0
    assert f"picture: {picture}" in capsys.readouterr().err
    beginning = {".png": b"\x89PNG", ".svg": b"<?xml", ".pdf": b"%PDF"}[ending]
    assert picture.read_bytes().startswith(beginning)


def test_a_folder_in_a_picture_s_place_is_refused_before_anything_runs(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "taken.png").mkdir()
    assert main(["run", str(folder), "--picture", str(tmp_path / "taken.png")]) == 2
    assert "taken.png" in capsys.readouterr().err


def test_without_qt_the_numbers_still_come(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def draw(*_: object, **__: object) -> None:
        raise FigureError(
            "no picture: Qt cannot be loaded (libEGL.so.1); `understudy doctor` says how to mend it"
        )

    monkeypatch.setattr("app.cli.run.draw", draw)
    assert main(["run", str(folder), "--ticks", "5", "--picture", str(tmp_path / "x.png")]) == 1
    out, err = capsys.readouterr()
    assert "10 agents, 5 ticks a run" in out
    assert "libEGL.so.1" in err
