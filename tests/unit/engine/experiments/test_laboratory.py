"""Experiments in the background: progress, pause, cancel, failures, and going on where one ended."""

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

from app.core.storage import FilesError
from app.engine.experiments.data import curves_csv, runs_csv
from app.engine.experiments.findings import findings
from app.engine.experiments.keeping import delete_experiment, document_of, save_experiment
from app.engine.experiments.laboratory import Laboratory, Stage
from app.engine.experiments.load import experiments_in, load_experiment
from app.engine.experiments.plan import Claim, Experiment, Kind, Panel, Reference, Treated
from app.engine.experiments.store import Row
from app.sim.scenarios.foraging import scenario
from tests.unit.engine.experiments.laboratories import until
from tests.unit.engine.experiments.small import boxes, experiment, factor, numbers, opened

FORAGING = Path(__file__).parents[4] / "projects" / "foraging"


@pytest.fixture
def begin(tmp_path: Path) -> Iterator[Callable[..., Laboratory]]:
    begun: list[Laboratory] = []

    def make(of: Experiment | None = None) -> Laboratory:
        begun.append(Laboratory(boxes(), scenario, of or experiment(), tmp_path / "results.sqlite", 2))
        return begun[-1]

    yield make
    for laboratory in begun:
        laboratory.close()


def test_it_ends_with_what_the_command_line_would_find(
    begin: Callable[..., Laboratory], tmp_path: Path
) -> None:
    look = until(begin(), lambda look: look.is_over)
    assert look.stage is Stage.FINISHED
    assert look.found is not None
    with opened(tmp_path / "results.sqlite", experiment()) as results:
        again = findings(experiment(), list(scenario.measures), results)
    assert [s.measures for s in look.found.summaries] == [s.measures for s in again.summaries]
    assert [s.runs for s in look.found.summaries] == [3, 3]


def test_while_it_is_paused_nothing_is_added_and_resuming_goes_on(begin: Callable[..., Laboratory]) -> None:
    laboratory = begin(experiment(runs=40, ticks=400))
    until(laboratory, lambda look: look.progress is not None)
    laboratory.pause()
    assert laboratory.newest.stage is Stage.PAUSED
    laboratory.resume()
    assert until(laboratory, lambda look: look.is_over).stage is Stage.FINISHED


def test_what_was_cancelled_is_kept_and_gone_on_with_to_the_same_numbers(
    begin: Callable[..., Laboratory], tmp_path: Path
) -> None:
    of = experiment(runs=30, ticks=200)
    laboratory = begin(of)
    until(laboratory, lambda look: look.progress is not None and look.progress.done > 0)
    laboratory.cancel()
    assert until(laboratory, lambda look: look.is_over).stage in (Stage.CANCELLED, Stage.FINISHED)
    assert until(begin(of), lambda look: look.is_over).stage is Stage.FINISHED
    with opened(tmp_path / "results.sqlite", of) as results:
        found = numbers(results, of)
    whole = Laboratory(boxes(), scenario, of, tmp_path / "whole.sqlite", 1)
    until(whole, lambda look: look.is_over)
    with opened(tmp_path / "whole.sqlite", of) as results:
        assert numbers(results, of) == found


def test_what_cannot_run_is_said_in_words(begin: Callable[..., Laboratory]) -> None:
    look = until(begin(experiment(arms=(Treated("x", "nobody"),))), lambda look: look.is_over)
    assert look.stage is Stage.FAILED
    assert "nobody" in look.notice


def test_results_of_something_else_are_refused_in_words(
    begin: Callable[..., Laboratory], tmp_path: Path
) -> None:
    until(begin(), lambda look: look.is_over)
    look = until(begin(experiment(ticks=61)), lambda look: look.is_over)
    assert look.stage is Stage.FAILED
    assert "another experiment" in look.notice


# ------------------------------------------------------------------------------------------------- keeping


@pytest.mark.parametrize("name", experiments_in(FORAGING))
def test_every_shipped_experiment_is_kept_as_it_is_read(name: str, tmp_path: Path) -> None:
    from app.core.storage import load

    project = load(FORAGING)
    before = load_experiment(FORAGING, name, project, scenario)
    save_experiment(tmp_path, before)
    assert load_experiment(tmp_path, name, project, scenario) == before


def test_claims_of_every_kind_are_kept(tmp_path: Path) -> None:
    claims = (
        Claim("a", Kind.GREATER, "boxes", "alone", "grouped"),
        Claim("b", Kind.SAME, "weight", "alone", "grouped", {"n": "1"}),
        Claim("c", Kind.NO_LESS, "boxes", "alone", Reference("they", 3.0, 1.0, 9)),
        Claim("d", Kind.NEVER_STALLS, "boxes", "alone"),
    )
    of = experiment(
        claims=claims, factors=(factor("n", "world.boxes", 1, 2),), panels=(Panel("boxes", "n", "N"),)
    )
    save_experiment(tmp_path, of)
    assert load_experiment(tmp_path, "small", boxes(), scenario) == of
    assert "points" in document_of(of)


def test_an_experiment_can_be_deleted_and_a_missing_one_is_named(tmp_path: Path) -> None:
    save_experiment(tmp_path, experiment())
    delete_experiment(tmp_path, "small")
    assert experiments_in(tmp_path) == []
    with pytest.raises(FilesError, match=r"small\.json"):
        delete_experiment(tmp_path, "small")


# ---------------------------------------------------------------------------------------------------- data


def test_the_csv_of_runs_has_a_line_a_run_and_that_of_curves_one_a_sample(
    begin: Callable[..., Laboratory], tmp_path: Path
) -> None:
    of = experiment(factors=(factor("n", "world.boxes", 3, 6),))
    look = until(begin(of), lambda look: look.is_over)
    assert look.found is not None
    with opened(tmp_path / "results.sqlite", of) as results:
        lines = runs_csv(of, results.outlines(4, of.runs)).splitlines()
    assert lines[0].startswith("arm,n,run,seed,ticks,boxes,weight,stalled")
    assert len(lines) == 1 + 4 * of.runs
    curves = curves_csv(look.found).splitlines()
    assert len(curves) == 1 + 4 * 2 * 7
    assert curves[1].split(",")[:4] == ["alone", "3", "boxes", "0"]


def test_a_factor_that_is_called_like_a_measure_has_a_head_of_its_own() -> None:
    of = experiment(factors=(factor("boxes", "world.boxes", 3, 4),))
    row = Row(1, 0, 7, {"boxes": 2.0}, stalled=False, curves=np.zeros((1, 7)), agent_ticks=240, seconds=0.5)
    head, first = runs_csv(of, [row]).splitlines()
    assert head == "arm,boxes (factor),run,seed,ticks,boxes,stalled,agent_ticks,seconds"
    assert first == "grouped,3,1,7,60,2.0,0,240,0.500000"
