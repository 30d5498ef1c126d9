"""What results depend on, and what they do not."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from app.core.library import Library
from app.core.project import Project
from app.engine.experiments.fingerprint import fingerprint_of, fingerprint_of_scenario
from app.engine.experiments.plan import Claim, Experiment, Kind, Panel, Treated
from app.engine.scenarios import OWN_CODE, open_scenario
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


OWN = '''
from dataclasses import dataclass
from understudy.sim.scenario import FeatureKind, Scenario, quantity

@dataclass(frozen=True, slots=True)
class Parameters:
    size: float = quantity(1.0, "units", doc="how large")

scenario = Scenario("mine", "Mine", Parameters)

@scenario.feature("Seen", FeatureKind.CONTINUOUS, ("what",), default=3.0)
def seen(world, me, what):
    """How far it is."""
    return world.x[what]

@scenario.reset
def reset(world):
    """Begin."""
    world.x[0] = 1.0
'''


@pytest.mark.parametrize(
    ("before", "after", "matters"),
    [
        ("world.x[0] = 1.0", "world.x[0] = 2.0", True),
        ("world.x[what]", "world.y[what]", True),
        ("default=3.0", "default=4.0", True),
        ('"Mine"', '"Another title"', False),
    ],
)
def test_a_scenario_matters_with_how_its_worlds_begin_but_not_its_words(
    before: str, after: str, matters: bool, tmp_path: Path
) -> None:
    marks = []
    for number, code in enumerate((OWN, OWN.replace(before, after))):
        folder = tmp_path / str(number)
        folder.mkdir()
        (folder / OWN_CODE).write_text(code)
        marks.append(fingerprint_of_scenario(open_scenario(Project("Mine", OWN_CODE), folder, trust=True)))
    assert (marks[0] != marks[1]) is matters
