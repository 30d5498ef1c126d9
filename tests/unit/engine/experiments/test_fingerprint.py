"""What results depend on, and what they do not."""

from dataclasses import replace
from typing import Any

import pytest

from app.core.library import Library
from app.core.project import Project
from app.engine.experiments.fingerprint import fingerprint_of
from app.engine.experiments.plan import Claim, Experiment, Kind, Panel, Treated
from app.sim.scenarios.foraging import scenario
from tests.samples import AGENT
from tests.unit.engine.experiments.small import EASY, boxes, experiment


def differing(of: Experiment | None = None, project: Project | None = None) -> set[str]:
    """Which parts are no longer those of the usual experiment."""
    usual = fingerprint_of(boxes(), scenario, experiment())
    now = fingerprint_of(project or boxes(), scenario, of or experiment())
    return {part for part in usual if usual[part] != now[part]}


def edited(name: str, **changes: Any) -> Project:
    """The project with something changed about one behavior of its agents."""
    project = boxes()
    library = dict(project.library(AGENT).automata)
    library[name] = replace(library[name], **changes)
    return replace(project, libraries={**project.libraries, AGENT: Library(library)})


@pytest.mark.parametrize(
    ("changed", "parts"),
    [
        ({"ticks": 70}, {"ticks"}),
        ({"points": 5}, {"points"}),
        ({"seed": 2}, {"seed"}),
        ({"arms": (Treated("alone", "independent", EASY),)}, {"arms and factors", "behaviors", "worlds"}),
    ],
)
def test_what_changes_the_numbers_is_told_by_name(changed: dict[str, Any], parts: set[str]) -> None:
    assert differing(experiment(**changed)) == parts


def test_a_behavior_that_runs_matters() -> None:
    assert differing(project=edited("Wander", rules=())) == {"behaviors"}


def test_words_runs_claims_and_figures_do_not_matter() -> None:
    claim = Claim("t", Kind.NEVER_STALLS, "boxes", "alone")
    changed = experiment(title="T", note="n", runs=9, claims=(claim,), panels=(Panel("weight"),))
    assert differing(changed, edited("Wander", note="n", learned_from="x")) == set()
