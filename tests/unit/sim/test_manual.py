"""The manual of scenario authors is true."""

import re
from inspect import getdoc
from pathlib import Path
from textwrap import dedent

from app.core.project import Project
from app.engine.scenarios import OWN_CODE, open_scenario
from app.sim import portable, scenario, trial
from app.sim.engine import Start
from app.sim.reference import ReferenceEngine
from app.sim.scenario import STANDARD_COLUMNS, Scenario
from tests.foragers import alone, types

MANUAL = scenario.__doc__ or ""


def example() -> str:
    """The whole scenario in the manual."""
    indented = re.search(r"A whole one::\n\n(.*?)\n\n\*\*", MANUAL, re.DOTALL)
    assert indented is not None
    return dedent(indented[1])


def test_its_example_runs_as_a_projects_own_scenario(tmp_path: Path) -> None:
    (tmp_path / OWN_CODE).write_text(example())
    line = open_scenario(Project("", OWN_CODE), tmp_path, trust=True)
    assert (portable.faults(line), trial.faults(line)) == ([], [])
    engine = ReferenceEngine(
        Start(line, line.settle({"length": 20.0}), alone(3), types(line, {}), seed=1, top="Up")
    )
    engine.step(30)
    assert engine.senses.feature("Place", 0, ()) == 20.0


def test_it_tells_of_all_that_can_be_declared() -> None:
    told = set(re.findall(r"^``(\w+)``  ", MANUAL, re.MULTILINE))
    decorators = {
        name
        for name, method in vars(Scenario).items()
        if not name.startswith("_") and (getdoc(method) or "").startswith("Declare ")
    }
    assert told == decorators


def test_it_tells_of_all_columns_that_every_world_has() -> None:
    assert [column.name for column in STANDARD_COLUMNS if f"``{column.name}" not in MANUAL] == []


def test_all_that_an_author_imports_comes_from_one_module() -> None:
    assert [name for name in scenario.__all__ if not hasattr(scenario, name)] == []
