"""Experiments from files: what they mean, and everything that can be wrong with them, by place."""

from pathlib import Path
from typing import Any

import pytest

from app.core.errors import ParameterError
from app.core.storage import load
from app.core.storage.problems import FilesError
from app.engine.experiments.load import experiments_in, load_experiment
from app.engine.experiments.plan import Claim, Experiment, Kind, Panel, Reference
from app.engine.scenarios import open_scenario
from app.sim.scenarios.foraging import scenario
from tests.unit.engine.experiments.small import EASY, boxes, document, written

SHIPPED = Path(__file__).parents[4] / "projects" / "foraging"


def loaded(folder: Path, made: Any) -> Experiment:
    return load_experiment(written(folder, made), "small", boxes(), scenario)


def refused(folder: Path, made: Any) -> str:
    with pytest.raises(FilesError) as caught:
        loaded(folder, made)
    return str(caught.value)


def test_a_file_says_all_that_an_experiment_is(tmp_path: Path) -> None:
    made = document(
        factors=[{"name": "range", "setting": "world.deposit_range", "values": [3.0, 5.0]}],
        figure=[{"measure": "weight", "x": "range", "where": {"range": "5"}}],
    )
    found = loaded(tmp_path, made)
    assert [arm.name for arm in found.arms] == ["alone", "grouped"]
    assert [level.name for level in found.factors[0].levels] == ["3", "5"]
    assert found.claims == (Claim("Groups collect more", Kind.GREATER, "boxes", "grouped", "alone"),)
    assert found.panels == (Panel("weight", "range", where={"range": "5"}),)


def test_every_form_of_claim_is_read(tmp_path: Path) -> None:
    claims = [
        {"text": "a", "same": ["alone", "grouped"], "measure": "weight"},
        {"text": "b", "no_less": "alone", "than": {"name": "theirs", "mean": 3, "sd": 1, "runs": 20}},
        {"text": "c", "never_stalls": "grouped"},
    ]
    found = loaded(tmp_path, document(claims=claims)).claims
    assert [claim.kind for claim in found] == [Kind.SAME, Kind.NO_LESS, Kind.NEVER_STALLS]
    assert found[0].measure == "weight"
    assert found[1].second == Reference("theirs", 3, 1, 20)


def test_without_a_figure_the_first_measure_is_drawn_over_time(tmp_path: Path) -> None:
    assert loaded(tmp_path, document()).panels == (Panel("boxes"),)


@pytest.mark.parametrize("name", experiments_in(SHIPPED))
def test_every_shipped_experiment_fits_its_project(name: str) -> None:
    project = load(SHIPPED)
    found = load_experiment(SHIPPED, name, project, open_scenario(project))
    assert found.cells()


def test_the_papers_two_experiments_ship_among_others() -> None:
    assert {"figure3", "figure4", "original", "open", "samples"} <= set(experiments_in(SHIPPED))


def test_an_unknown_experiment_is_refused_with_those_there_are(tmp_path: Path) -> None:
    with pytest.raises(ParameterError, match=r"no experiment 'smal'.*did you mean 'small'.*there are: small"):
        load_experiment(written(tmp_path, document()), "smal", boxes(), scenario)


def test_a_folder_without_experiments_holds_none(tmp_path: Path) -> None:
    assert experiments_in(tmp_path) == []


def arm(**settings: Any) -> dict[str, Any]:
    return document(
        arms=[{"name": "alone", "arm": "independent", "settings": {**EASY, **settings}}], claims=[]
    )


@pytest.mark.parametrize(
    ("made", "said"),
    [
        ("{", "experiments/small.json: line 1"),
        (document(tickz=3), "unknown key 'tickz'; did you mean 'ticks'?"),
        (document(runs=0), "small.json: runs: must be at least 1, but found 0"),
        (document(ticks=1.5), "ticks: must be a whole number, but found 1.5"),
        (document(arms=[]), "arms: must have at least 1 entry"),
        (document(arms=[{"name": "a", "arm": "nobody"}]), "arms[0].arm: there is no arm 'nobody'; there are: 'independent'"),
        (document(arms=[{"name": "a", "arm": "independent"}] * 2), "'a' stands here more than once"),
        (arm(**{"world.bxes": 3}), "arms[0].settings: scenario 'foraging' has no parameter 'bxes'"),
        (arm(**{"world.boxes": -1}), "arms[0].settings: boxes must be 0 or more"),
        (arm(wordl=3), "there is no setting 'wordl'; there are: world.NAME, world"),
        (arm(world="nowhere"), "names the world 'nowhere'"),
        (arm(top="Forrage"), "Forrage"),
        (arm(sizes=[2, 2]), "'sizes' must be an array of 1 whole number"),
        (arm(sizes="two"), "'sizes' must be an array of 1 whole number"),
        (arm(**{"rule.agent/Wander/nothing": 0.5}), "'Wander' has no rule 'nothing'; there are: 1, 2"),
        (arm(**{"rule.agent/Wander/1": 1.5}), "must be a probability from 0 to 1, but found 1.5"),
        (arm(**{"use.agent/Wander": "agent/Nothing"}), "there is no behavior 'agent/Nothing'; there are: agent/"),
        (arm(**{"use.agent/Wander": "agent/Goto"}), "its parameters have to be: none"),
        (arm(**{"learner.classifier": "c46"}), "there is no classifier 'c46'"),
        (arm(**{"learner.classifier": "forest", "learner.options.tres": 3}), "has no option 'tres'"),
        (arm(**{"learner.picks": 0}), "'learner.picks' cannot be 0"),
        (arm(**{"learner.flat": 1}), "'learner.flat' must be true or false, but found 1"),
        (
            document(arms=[{"name": "g", "arm": "one level", "settings": {"learner.flat": True}}], claims=[]),
            "arm 'one level' has controllers",
        ),
        (
            document(factors=[{"name": "f", "setting": "world.boxes", "values": [1, -1]}]),
            "factors[0].values[1]: boxes must be 0 or more",
        ),
        (document(factors=[{"name": "f"}]), "factors[0]: factor 'f' needs either 'setting' and 'values', or 'levels'"),
        (document(claims=[{"text": "t", "greater": "alone", "less": "x"}]), "claims[0].less: there is no arm of this"),
        (document(claims=[{"text": "t", "greater": "alone"}]), "claims[0]: a claim has the keys of one form"),
        (document(claims=[{"text": "t", "same": ["alone", "x"]}]), "claims[0].same[1]: there is no arm"),
        (
            document(claims=[{"text": "t", "never_stalls": "alone", "measure": "bxs"}]),
            "claims[0].measure: there is no measure 'bxs'; there are: 'boxes', 'weight', 'picks'",
        ),
        (
            document(claims=[{"text": "t", "never_stalls": "alone", "where": {"f": "1"}}]),
            "claims[0].where: there is no factor 'f'; there are: none",
        ),
        (document(figure=[{"x": "tix"}]), "figure[0].x: there is no factor 'tix'; there are: 'ticks', 'rows'"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_said_with_its_place(tmp_path: Path, made: Any, said: str) -> None:
    assert said in refused(tmp_path, made)


def test_all_arms_that_name_nothing_are_told_at_once(tmp_path: Path) -> None:
    told = refused(tmp_path, document(arms=[{"name": n, "arm": n} for n in "xy"], claims=[]))
    assert "2 problems" in told
    assert "arms[1].arm" in told
