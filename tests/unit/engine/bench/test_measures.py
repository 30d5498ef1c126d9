"""Every measure gives a figure; what they compare is what they say."""

import sys
import time
from dataclasses import replace
from math import isfinite
from pathlib import Path

import pytest

from app.engine.bench import commands, lessons, memory, rates
from app.engine.bench.commands import CommandError
from app.engine.bench.figures import Better, Figure, Measure, document
from app.engine.bench.machine import machine
from app.engine.bench.subject import Program, Subject, UnmeasurableError, subject
from app.engine.bench.table import MEASURES
from app.engine.runs import run
from app.learner.trainer import learn

ROOT = Path(__file__).parents[4]
#: Ends at once, whatever it is asked; keeps something where compiled kernels are kept.
DUMMY = "import os, pathlib; pathlib.Path(os.environ.get('XDG_CACHE_HOME', '.'), 'here').mkdir(exist_ok=True)"


@pytest.fixture(scope="module")
def tiny(tmp_path_factory: pytest.TempPathFactory) -> Subject:
    """Everything there is to measure, in a thousandth of its size."""
    program = Program(
        (sys.executable, "-c", DUMMY), {"XDG_CACHE_HOME": str(tmp_path_factory.mktemp("cache"))}
    )
    folders = ROOT / "projects" / "foraging", ROOT / "resources" / "bench" / "forager"
    return replace(subject(*folders, program, 2, time.perf_counter), shrink=1_000)


@pytest.mark.parametrize("one", MEASURES, ids=lambda one: one.name)
def test_every_measure_gives_a_figure(one: Measure, tiny: Subject) -> None:
    value = one.take(tiny)
    assert isfinite(value)
    assert value > 0.0 or one.take is memory.growth_with_runs


def test_names_are_unique_and_goals_are_numbers_above_nothing() -> None:
    assert len({one.name for one in MEASURES}) == len(MEASURES)
    assert all(one.unit and one.goal > 0.0 for one in MEASURES)


def test_rates_are_to_be_high_and_all_else_low_but_for_threads() -> None:
    high = {one.name for one in MEASURES if one.better is Better.HIGHER}
    assert high == {one.name for one in MEASURES if one.unit.endswith("/s")} | {"two threads against one"}


@pytest.mark.parametrize(
    ("better", "value", "holds"),
    [
        (Better.HIGHER, 2.0, True),
        (Better.HIGHER, 1.9, False),
        (Better.LOWER, 2.0, True),
        (Better.LOWER, 2.1, False),
    ],
)
def test_a_goal_holds_when_it_is_reached_just_so(better: Better, value: float, holds: bool) -> None:
    one = Measure("speed", lambda _: value, "times", 2.0, better)
    assert Figure(one, value).holds is holds
    assert document(Figure(one, value)) == {
        "name": "speed",
        "value": value,
        "unit": "times",
        "goal": 2.0,
        "better": better.value,
        "holds": holds,
    }


# ------------------------------------------------------------------------------------------------ what they compare


def test_unused_behaviors_change_no_run(tiny: Subject) -> None:
    few, many = tiny.forager, rates.with_unused(tiny.forager, 40)
    results = [run(tiny.arm("independent", project), 1, 2_000) for project in (few, many)]
    assert results[0] == results[1]
    assert len(many.library("agent").automata) == len(few.library("agent").automata) + 40


def test_unused_behaviors_are_in_the_program_that_runs(tiny: Subject) -> None:
    from app.core.machine import Machine, stored_classifiers
    from app.sim.program import Needs, lower

    many = rates.with_unused(tiny.forager, 40)
    start = rates.start_of(tiny.arm("independent", many), 1)
    machine = Machine(start.hierarchy, start.types, 1)
    needs = Needs(automata=frozenset({("agent", "forage")}))
    program = lower(machine.actors.values(), machine.types, start.scenario, stored_classifiers, needs)
    assert sum(row.automaton.name.startswith("Unused") for row in program.automata) == 40


def test_a_lesson_has_six_features_two_of_them_angles(tiny: Subject) -> None:
    project = lessons.taught(tiny.project, 200)
    learned = learn(project, tiny.scenario.vocabulary)
    kinds = [tiny.scenario.vocabulary.feature(source.feature).kind for source in lessons.FEATURES.values()]
    assert len(kinds) == 6
    assert [kind.value for kind in kinds].count("toroidal") == 2
    assert learned.reports[0].examples == 200


def test_the_paper_s_evaluation_has_six_arms_and_their_claims(tiny: Subject, tmp_path: Path) -> None:
    asked = tmp_path / "asked"
    asked.mkdir()
    # Copies the experiments that it is asked to make.
    script = (
        "import shutil, sys; verb, folder, name = sys.argv[1:4];"
        f"shutil.copy(f'{{folder}}/experiments/{{name}}.json', {str(asked)!r})"
    )
    of = replace(tiny, program=Program((sys.executable, "-c", script)))
    commands.seconds_of_evaluation(of)
    import json

    made = {path.stem: json.loads(path.read_text()) for path in asked.iterdir()}
    assert sum(len(record["arms"]) for record in made.values()) == 6
    for record in made.values():
        names = {arm["name"] for arm in record["arms"]}
        assert record["claims"]
        assert all({claim["greater"], claim["less"]} <= names for claim in record["claims"])


# --------------------------------------------------------------------------------------------- what cannot be had


def test_threads_are_left_out_on_a_single_core(tiny: Subject) -> None:
    with pytest.raises(UnmeasurableError, match="single core"):
        rates.threads_ratio(replace(tiny, cores=1))


def test_memory_is_left_out_where_the_system_does_not_tell_it(
    tiny: Subject, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(memory, "PAGES", Path("/nowhere"))
    with pytest.raises(UnmeasurableError, match="memory"):
        memory.growth_with_runs(tiny)


def test_compiling_is_left_out_where_the_cache_cannot_be_put_elsewhere(tiny: Subject) -> None:
    with pytest.raises(UnmeasurableError, match="compiled kernels"):
        commands.seconds_to_compile(replace(tiny, program=Program((sys.executable, "-c", ""))))


def test_a_program_that_fails_is_no_figure_and_says_with_which_words(tiny: Subject) -> None:
    script = "import sys; sys.exit('no such luck')"
    with pytest.raises(CommandError, match=r"--help: it ended with exit code 1: no such luck"):
        commands.seconds_of_help(replace(tiny, program=Program((sys.executable, "-c", script))))


# ------------------------------------------------------------------------------------------------------- the machine


def test_memory_grows_by_what_is_never_given_back_once_it_has_settled() -> None:
    assert memory.growth([(0.1, 50.0), (0.3, 104.0), (0.4, 100.0), (0.6, 109.0), (1.0, 103.0)]) == 3.0
    assert memory.growth([(0.1, 50.0), (0.3, 100.0), (1.0, 99.0)]) == 0.0
    assert memory.growth([(1.0, 99.0)]) == 0.0


def test_the_machine_is_told_in_words_and_numbers() -> None:
    told = machine(2)
    assert told["cores"] == 2
    assert {"processor", "load", "system", "python", "numba", "numpy"} <= told.keys()
