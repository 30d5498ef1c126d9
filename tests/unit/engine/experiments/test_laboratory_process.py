"""Experiments in a process of their own: the same results, whatever happens to either side."""

import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import IO, Any

import pytest

from app.core.errors import ScenarioError
from app.core.project import Project
from app.core.storage import load
from app.engine.experiments import process
from app.engine.experiments.laboratory import Laboratory, Look, Stage
from app.engine.experiments.order import Order, Word
from app.engine.experiments.plan import Experiment, Treated
from app.engine.experiments.process import LaboratoryProcess
from app.engine.scenarios import OWN_CODE, open_scenario
from app.sim.scenarios.foraging import scenario
from tests.unit.engine.experiments.laboratories import PATIENCE, until
from tests.unit.engine.experiments.small import boxes, experiment, numbers, opened

FORAGING = Path(__file__).parents[4] / "projects" / "foraging"
#: More runs than anything here waits for.
MANY = 100_000

Begin = Callable[..., LaboratoryProcess]


@pytest.fixture
def begin(tmp_path: Path) -> Iterator[Begin]:
    begun: list[LaboratoryProcess] = []

    def make(of: Experiment, project: Project | None = None, scenario: Any = scenario) -> LaboratoryProcess:
        path = tmp_path / "results.sqlite"
        begun.append(LaboratoryProcess(project or boxes(), scenario, of, path, 2))
        return begun[-1]

    yield make
    for laboratory in begun:
        laboratory.close()


def stage(laboratory: LaboratoryProcess) -> Stage:
    return laboratory.newest.stage


def some_are_made(look: Look) -> bool:
    return look.progress is not None and look.progress.done > 0


def test_its_results_are_those_of_threads_of_this_process_to_the_bit(begin: Begin, tmp_path: Path) -> None:
    of = experiment(runs=5)
    look = until(begin(of), lambda look: look.is_over)
    assert (look.stage, look.notice) == (Stage.FINISHED, "")
    here = Laboratory(boxes(), scenario, of, tmp_path / "here.sqlite", 1)
    here._thread.join()
    with opened(tmp_path / "results.sqlite", of) as there, opened(tmp_path / "here.sqlite", of) as results:
        assert numbers(there, of) == numbers(results, of)
    assert look.found is not None
    assert here.newest.found is not None
    for ours, theirs in zip(here.newest.found.summaries, look.found.summaries, strict=True):
        assert ours.measures == theirs.measures
        assert ours.curve.tobytes() == theirs.curve.tobytes()


def test_it_is_paused_and_resumed_and_cancelled_and_gone_on_with(begin: Begin, tmp_path: Path) -> None:
    laboratory = begin(experiment(runs=MANY))
    until(laboratory, some_are_made)
    laboratory.pause()
    assert stage(laboratory) is Stage.PAUSED
    laboratory.resume()
    assert stage(laboratory) is Stage.RUNNING
    laboratory.cancel()
    look = until(laboratory, lambda look: look.is_over)
    assert look.stage is Stage.CANCELLED
    assert look.progress is not None
    done = look.progress.done
    again = begin(experiment(runs=MANY))
    found = until(again, lambda look: look.progress is not None).progress
    assert found is not None
    assert found.found >= done > 0


def test_what_is_said_before_it_can_listen_is_heard_later(begin: Begin) -> None:
    laboratory = begin(experiment(runs=MANY))
    laboratory.pause()
    assert laboratory.newest.stage is Stage.PAUSED
    laboratory.cancel()
    look = until(laboratory, lambda look: look.is_over)
    assert look.stage is Stage.CANCELLED


def test_a_process_that_is_killed_is_told_and_its_finished_runs_are_kept(
    begin: Begin, tmp_path: Path
) -> None:
    laboratory = begin(experiment(runs=MANY))
    done = until(laboratory, some_are_made).progress
    assert done is not None
    assert laboratory._process is not None
    laboratory._process.kill()
    look = until(laboratory, lambda look: look.is_over)
    assert look.stage is Stage.FAILED
    assert "ended all of a sudden" in look.notice
    with opened(tmp_path / "results.sqlite", experiment(runs=MANY)) as results:
        assert results.count(2, MANY) >= done.done


def test_it_ends_with_the_program_that_began_it(begin: Begin, tmp_path: Path) -> None:
    """A program that is killed closes its end of the pipe, and can do nothing more than that."""
    laboratory = begin(experiment(runs=MANY))
    until(laboratory, some_are_made)
    child = laboratory._process
    assert child is not None
    assert child.stdin is not None
    child.stdin.close()
    child.wait(PATIENCE)
    until(laboratory, lambda look: look.is_over)
    with opened(tmp_path / "results.sqlite", experiment(runs=MANY)) as results:
        assert results.count(2, MANY) > 0


def test_a_word_that_comes_too_late_changes_nothing(begin: Begin, monkeypatch: pytest.MonkeyPatch) -> None:
    follow = LaboratoryProcess._follow

    def and_speak(self: LaboratoryProcess, looks: IO[bytes]) -> None:
        follow(self, looks)
        assert self._process is not None
        self._process.wait(PATIENCE)
        self._say(Word.PAUSE)

    monkeypatch.setattr(LaboratoryProcess, "_follow", and_speak)
    laboratory = begin(experiment())
    laboratory._thread.join(PATIENCE)
    assert (laboratory.newest.stage, laboratory.newest.notice) == (Stage.FINISHED, "")


def test_a_process_that_ends_before_it_has_its_order_is_told_in_words(
    begin: Begin, monkeypatch: pytest.MonkeyPatch
) -> None:
    give = LaboratoryProcess._give

    def too_late(self: LaboratoryProcess, orders: IO[bytes]) -> None:
        assert self._process is not None
        self._process.wait(PATIENCE)
        give(self, orders)

    monkeypatch.setattr(LaboratoryProcess, "_give", too_late)
    monkeypatch.setattr(process, "python", lambda _: [sys.executable, "-c", "raise SystemExit(3)"])
    look = until(begin(experiment()), lambda look: look.is_over)
    assert look.stage is Stage.FAILED
    assert "ended all of a sudden (exit code 3)" in look.notice


def test_closing_waits_for_no_run(begin: Begin) -> None:
    laboratory = begin(experiment(ticks=10**9, runs=1))
    until(laboratory, lambda look: look.progress is not None)
    laboratory.close()
    assert laboratory._process is not None
    assert laboratory._process.returncode is not None


def test_what_cannot_run_is_said_in_words(begin: Begin) -> None:
    look = until(begin(experiment(arms=(Treated("x", "nobody"),))), lambda look: look.is_over)
    assert look.stage is Stage.FAILED
    assert "nobody" in look.notice


CODE = '''
from dataclasses import dataclass
from understudy.sim.scenario import Scenario, quantity

@dataclass(frozen=True, slots=True)
class Parameters:
    size: float = quantity(1.0, "units", doc="how large")

scenario = Scenario("mine", "Mine", Parameters)

@scenario.reset
def reset(world):
    """Begin."""
    world.x[0] = PLACE
'''


def test_a_scenario_that_changed_since_it_was_opened_is_not_run(tmp_path: Path) -> None:
    (tmp_path / OWN_CODE).write_text(CODE.replace("PLACE", "1.0"))
    opened = open_scenario(Project("Mine", OWN_CODE), tmp_path, trust=True)
    order = Order.of(boxes(), opened, experiment(), tmp_path / "results.sqlite", 1)
    (tmp_path / OWN_CODE).write_text(CODE.replace("PLACE", "2.0"))
    with pytest.raises(ScenarioError, match="has changed since it was opened"):
        order.begin()


def test_what_runs_have_no_use_for_is_not_sent(tmp_path: Path) -> None:
    project = load(FORAGING)
    order = Order.of(project, scenario, experiment(), tmp_path / "results.sqlite", 1)
    assert not order.project.moments
    assert replace(order.project, moments=project.moments) == project
