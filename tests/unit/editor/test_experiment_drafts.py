"""From what the dialog of experiments holds to an experiment, and what is refused."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from app.core.errors import ParameterError
from app.core.storage import load
from app.editor.experiments.draft import Draft, drafted, shown_claim, shown_factor
from app.engine.experiments.load import experiments_in, load_experiment
from app.engine.experiments.plan import Design, Experiment, Kind, Treated
from app.sim.scenarios.foraging import scenario

FOLDER = Path(__file__).parents[3] / "projects" / "foraging"
PROJECT = load(FOLDER)
DRAFT = Draft(
    "mine",
    "Mine",
    "",
    "20,000",
    "20",
    "1",
    (Treated("independent", "independent"), Treated("one level", "one level")),
    (("world.boxes", "5, 10"),),
    Design.FACTORIAL,
    (("one level", Kind.GREATER, "independent", "boxes"),),
    ("boxes",),
)


def made(**changed: Any) -> Experiment:
    return drafted(replace(DRAFT, **changed), None, PROJECT, scenario)


def test_a_grid_of_parameters_gives_a_cell_for_every_arm_and_value() -> None:
    cells = made().cells()
    assert [(cell.arm, cell.settings["world.boxes"]) for cell in cells] == [
        ("independent", 5),
        ("one level", 5),
        ("independent", 10),
        ("one level", 10),
    ]


def test_values_are_read_as_what_they_are() -> None:
    factors = (("world.sight", "2.5"), ("world.contact", "true, false"), ("physics", "kinematic, rigid"))
    levels = [level.settings for factor in made(factors=factors).factors for level in factor.levels]
    assert levels == [
        {"world.sight": 2.5},
        {"world.contact": True},
        {"world.contact": False},
        {"physics": "kinematic"},
        {"physics": "rigid"},
    ]


def test_sizes_of_levels_can_be_varied() -> None:
    of = made(arms=DRAFT.arms[1:], factors=(("sizes", "10 x 5, 5 x 10"),), claims=())
    assert [level.settings["sizes"] for level in of.factors[0].levels] == [(10, 5), (5, 10)]


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"arms": ()}, "at least one arm"),
        ({"ticks": "many"}, "ticks a run: a whole number from 1"),
        ({"runs": "0"}, "runs an arm: a whole number from 1"),
        ({"factors": (("world.boxes", " "),)}, "give the values to try"),
        ({"factors": (("world.boxes", "5, 5"),)}, "given twice"),
        ({"factors": (("world.boxes", "5"), ("world.boxes", "6"))}, "varied twice"),
        ({"factors": (("world.nothing", "5"),)}, "nothing"),
        ({"factors": (("world.boxes", "-3"),)}, "boxes"),
        ({"claims": (("one level", Kind.GREATER, "one level", "boxes"),)}, "with itself"),
        ({"claims": (("two levels", Kind.GREATER, "independent", "boxes"),)}, "arms that are ticked"),
    ],
)
def test_what_is_not_possible_is_refused_in_words(changed: dict[str, object], message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        made(**changed)


@pytest.mark.parametrize("name", experiments_in(FOLDER))
def test_a_shipped_experiment_that_is_edited_without_a_change_stays_the_same(name: str) -> None:
    before = load_experiment(FOLDER, name, PROJECT, scenario)
    rows = tuple(row for claim in before.claims if (row := shown_claim(claim)) is not None)
    draft = Draft(
        before.name,
        before.title,
        before.note,
        f"{before.ticks:,}",
        str(before.runs),
        str(before.seed),
        before.arms,
        tuple(shown_factor(factor) for factor in before.factors),
        before.design,
        rows,
        tuple(panel.measure for panel in before.panels),
    )
    after = drafted(draft, before, PROJECT, scenario)
    assert len(after.claims) == len(before.claims)
    assert all(claim in before.claims for claim in after.claims)
    assert replace(after, claims=before.claims) == before
