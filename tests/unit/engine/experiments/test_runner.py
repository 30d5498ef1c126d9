"""Making runs: stopped and gone on with, paused, on any number of threads, in constant memory."""

import gc
import tracemalloc
from collections.abc import Callable
from pathlib import Path
from threading import Thread
from typing import Any

import pytest

from app.core.errors import ScenarioError
from app.engine.experiments import runner
from app.engine.experiments.plan import Experiment, Treated
from app.engine.experiments.runner import Controls, Progress, carry_out
from app.engine.experiments.store import Results, ResultsError, Row
from app.engine.runs import run, treatment
from app.sim.engines import Notice
from app.sim.scenario import Scenario
from app.sim.scenarios.foraging import scenario
from tests.unit.engine.experiments.small import EASY, boxes, experiment, factor, numbers, opened


def made(path: Path, of: Experiment, jobs: int = 1, **more: Any) -> list[tuple[Any, ...]]:
    with opened(path, of) as results:
        carry_out(boxes(), scenario, of, results, jobs, **more)
        return numbers(results, of)


class Killed(BaseException):
    """What ends a program at any moment."""


def test_every_cell_gets_all_its_runs(tmp_path: Path) -> None:
    found = made(tmp_path / "r.sqlite", experiment())
    assert [(cell, number) for cell, number, *_ in found] == [(c, r) for c in (0, 1) for r in range(3)]
    assert any(measures["boxes"] > 0 for _, _, _, measures, *_ in found)


def test_a_run_is_the_same_as_one_of_its_own(tmp_path: Path) -> None:
    plan = experiment()
    (first, *_) = made(tmp_path / "r.sqlite", plan)
    project = boxes()
    alone = treatment(project, scenario, project.arm("independent"), EASY)
    ran = run(alone, first[2], plan.ticks, plan.points)
    assert first[3] == dict(ran.measures)
    assert first[4] == ran.stalled
    assert first[5] == [curve for values in ran.curve.values.values() for curve in values]


def test_the_number_of_threads_changes_nothing(tmp_path: Path) -> None:
    plan = experiment(factors=(factor("range", "world.deposit_range", 2.0, 4.0),))
    assert made(tmp_path / "1.sqlite", plan) == made(tmp_path / "3.sqlite", plan, jobs=3)


@pytest.mark.parametrize("moment", [1, 2, 4])
def test_a_killed_experiment_goes_on_and_gives_the_same_numbers(tmp_path: Path, moment: int) -> None:
    plan = experiment()

    def kill(now: Progress) -> None:
        if now.done == moment:
            raise Killed

    with pytest.raises(Killed):
        made(tmp_path / "r.sqlite", plan, tell=kill)
    with opened(tmp_path / "r.sqlite", plan) as results:
        before = numbers(results, plan)
    after = made(tmp_path / "r.sqlite", plan)
    assert 0 < len(before) < len(after)
    assert set(map(repr, before)) <= set(map(repr, after))
    assert after == made(tmp_path / "never-killed.sqlite", plan)


def test_nothing_is_run_twice(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made(tmp_path / "r.sqlite", experiment())
    monkeypatch.setattr(runner, "start_engine", lambda *_, **__: pytest.fail("a run was made again"))
    made(tmp_path / "r.sqlite", experiment())


def test_more_runs_can_be_asked_for_later(tmp_path: Path) -> None:
    few = made(tmp_path / "r.sqlite", experiment(runs=2))
    more = made(tmp_path / "r.sqlite", experiment(runs=4))
    assert len(more) == 8
    assert set(map(repr, few)) <= set(map(repr, more))


def test_a_cancelled_experiment_keeps_what_is_finished(tmp_path: Path) -> None:
    controls = Controls()

    def tell(now: Progress) -> None:
        if now.done == 2:
            controls.cancel()

    plan = experiment()
    with opened(tmp_path / "r.sqlite", plan) as results:
        assert not carry_out(boxes(), scenario, plan, results, 1, tell, controls)
        assert results.count(2, 3) in (2, 3)


def test_a_cancel_does_not_wait_for_long_runs_to_end(tmp_path: Path) -> None:
    controls = Controls()
    plan = experiment(ticks=10**8, points=1)
    with opened(tmp_path / "r.sqlite", plan) as results:
        assert not carry_out(boxes(), scenario, plan, results, 2, lambda _: controls.cancel(), controls)
        assert results.count(2, 3) == 0


def test_a_paused_experiment_waits_and_then_goes_on(tmp_path: Path) -> None:
    controls, seen = Controls(), list[float]()
    controls.pause()

    def tell(now: Progress) -> None:
        seen.append(now.share)
        if len(seen) == 2:
            controls.resume()

    made(tmp_path / "r.sqlite", experiment(), tell=tell, controls=controls)
    assert seen[:2] == [0.0, 0.0]
    assert seen[-1] == 1.0


def test_a_paused_experiment_can_be_cancelled(tmp_path: Path) -> None:
    controls = Controls()
    controls.pause()
    thread = Thread(target=made, args=(tmp_path / "r.sqlite", experiment()), kwargs={"controls": controls})
    thread.start()
    controls.cancel()
    thread.join(300.0)
    assert not thread.is_alive()


def test_what_was_cancelled_cannot_be_paused_any_more(tmp_path: Path) -> None:
    controls = Controls()
    controls.cancel()
    controls.pause()
    assert not controls.heed()


def test_a_cancel_ends_compiling_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def compiling(of: Scenario, physics: str, _: Notice, cancelled: Callable[[], bool]) -> None:
        asked.append((of.name, physics))
        controls.cancel()
        assert cancelled()

    asked: list[tuple[str, str]] = []
    controls = Controls()
    monkeypatch.setattr(runner, "compile_ahead", compiling)
    monkeypatch.setattr(runner, "start_engine", lambda *_, **__: pytest.fail("a run was begun"))
    plan = experiment(arms=(Treated("alone", "independent", {"physics": "rigid"}),))
    with opened(tmp_path / "r.sqlite", plan) as results:
        assert not carry_out(boxes(), scenario, plan, results, 2, controls=controls)
    assert asked == [("foraging", "rigid")]


def test_what_runs_uncompiled_or_was_made_before_compiles_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plan = experiment(arms=(Treated("alone", "independent"),), ticks=1, points=1)
    made(tmp_path / "compiled.sqlite", plan)
    monkeypatch.setattr(runner, "compile_ahead", lambda *_: pytest.fail("something was compiled"))
    made(tmp_path / "compiled.sqlite", plan)
    made(tmp_path / "reference.sqlite", experiment())


def test_progress_tells_what_is_done_and_how_long_the_rest_takes(tmp_path: Path) -> None:
    told: list[Progress] = []
    made(tmp_path / "r.sqlite", experiment(runs=1))
    made(tmp_path / "r.sqlite", experiment(), tell=told.append)
    assert (told[-1].runs, told[-1].done, told[-1].found, told[-1].share) == (6, 6, 2, 1.0)
    assert told[-1].seconds_left == 0.0
    assert [now.share for now in told] == sorted(now.share for now in told)


def test_a_scenario_that_fails_is_told_and_ends_all_threads(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(world: Any) -> None:
        raise ZeroDivisionError("a division by zero")

    monkeypatch.setitem(scenario.stages, "after_tick", broken)
    with pytest.raises(ScenarioError, match="broken"):
        made(tmp_path / "r.sqlite", experiment(), jobs=2)


def test_a_disk_that_fills_up_ends_it_with_all_finished_runs_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    add, full = Results.add, [False]

    def add_two(self: Results, row: Row) -> None:
        if row.run == 1:
            full[0] = True
            raise ResultsError("the disk is full")
        add(self, row)

    monkeypatch.setattr(Results, "add", add_two)
    with pytest.raises(ResultsError):
        made(tmp_path / "r.sqlite", experiment(), jobs=2)
    monkeypatch.undo()
    assert full[0]
    assert len(made(tmp_path / "r.sqlite", experiment())) == 6


def test_memory_does_not_grow_with_the_number_of_runs(tmp_path: Path) -> None:
    arms = (Treated("alone", "independent", EASY),)

    def held_at_the_end(runs: int) -> int:
        plan = experiment(arms=arms, ticks=1, points=1, runs=runs)
        held = [0]

        def tell(now: Progress) -> None:
            if now.done == runs:
                gc.collect()
                held[0] = tracemalloc.get_traced_memory()[0]

        tracemalloc.start()
        with opened(tmp_path / f"{runs}.sqlite", plan) as results:
            carry_out(boxes(), scenario, plan, results, 1, tell)
        tracemalloc.stop()
        return held[0]

    held_at_the_end(3)  # what is made once and kept
    assert held_at_the_end(110) < held_at_the_end(10) + 50_000


class Held(Controls):
    """Paused for a thousand seconds wherever a run heeds it; no time passes otherwise."""

    def __init__(self) -> None:
        self.now = 0.0
        super().__init__(lambda: self.now)

    def heed(self) -> bool:
        self.pause()
        self.now += 1_000.0
        self.resume()
        return super().heed()


def test_no_time_passes_for_a_run_while_it_is_paused(tmp_path: Path) -> None:
    plan = experiment()
    told: list[Progress] = []
    with opened(tmp_path / "r.sqlite", plan) as results:
        carry_out(boxes(), scenario, plan, results, 1, told.append, Held())
        assert {row.seconds for row in results.rows(0, plan.runs)} == {0.0}
    assert {progress.seconds_left for progress in told} <= {0.0, None}


def test_its_clock_goes_on_where_it_stood_still() -> None:
    now = 10.0
    controls = Controls(lambda: now)
    controls.pause()
    now = 15.0
    assert controls.worked() == 10.0
    controls.resume()
    now = 17.0
    assert controls.worked() == 12.0
