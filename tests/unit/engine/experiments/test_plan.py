"""Which runs an experiment consists of."""

from app.engine.experiments.plan import Design
from tests.unit.engine.experiments.small import experiment, factor

RANGE = factor("range", "world.deposit_range", 5.0, 10.0)
RELEASE = factor("release", "world.release", "anyone", "full", "nobody")


def test_without_factors_there_is_a_cell_an_arm() -> None:
    assert [(cell.number, cell.name) for cell in experiment().cells()] == [(0, "alone"), (1, "grouped")]


def test_factorial_is_every_combination_of_levels_in_every_arm() -> None:
    cells = experiment(factors=(RANGE, RELEASE)).cells()
    assert len(cells) == 2 * 2 * 3
    assert len({(cell.arm, *cell.levels.items()) for cell in cells}) == len(cells)
    assert [cell.number for cell in cells] == list(range(12))


def test_one_at_a_time_changes_one_factor_and_leaves_the_others_at_their_first_level() -> None:
    cells = experiment(factors=(RANGE, RELEASE), design=Design.ONE_AT_A_TIME).cells()
    assert [tuple(cell.levels.values()) for cell in cells[::2]] == [
        ("5.0", "anyone"),
        ("10.0", "anyone"),
        ("5.0", "full"),
        ("5.0", "nobody"),
    ]


def test_levels_change_what_the_arm_says() -> None:
    (alone, *_) = experiment(factors=(factor("pull", "world.pullers", 3),)).cells()
    assert alone.settings["world.pullers"] == 3
    assert alone.settings["engine"] == "reference"


def test_no_two_runs_share_a_seed() -> None:
    plan = experiment(seed=7)
    seeds = [plan.seed_of(cell.number, run) for cell in plan.cells() for run in range(1000)]
    assert len(set(seeds)) == len(seeds)
    assert min(seeds) == 7
