"""Experiments that take no time: a few agents, a few ticks, the reference engine, nothing to compile."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from app.core.project import Arm, LevelTable, Project, Value
from app.engine.experiments.fingerprint import fingerprint_of
from app.engine.experiments.plan import Experiment, Factor, Level, Treated
from app.engine.experiments.store import Results, Row
from app.sim.scenarios.foraging import scenario
from tests.samples import AGENT, GROUP
from tests.unit.cli.foraging import project

ARMS = (
    Arm("independent", LevelTable((4,), (AGENT,)), "Forage"),
    Arm("one level", LevelTable((2, 2), (GROUP, AGENT)), "ControlForage"),
)
#: Boxes that one agent can pull, wherever it stands: something is delivered within a few ticks.
EASY: dict[str, Value] = {
    "engine": "reference",
    "world.width": 20.0,
    "world.height": 20.0,
    "world.deposit_x": 10.0,
}
EASY |= {"world.deposit_y": 10.0, "world.deposit_range": 3.0, "world.pullers": 1}


def boxes() -> Project:
    """Four agents, alone and in two groups."""
    return project(ARMS)


def experiment(**changed: Any) -> Experiment:
    """Two arms, three runs of sixty ticks."""
    given: dict[str, Any] = {
        "name": "small",
        "title": "Small",
        "arms": (Treated("alone", "independent", EASY), Treated("grouped", "one level", EASY)),
        "ticks": 60,
        "runs": 3,
        "points": 6,
    }
    return Experiment(**{**given, **changed})


def factor(name: str, setting: str, *values: Any) -> Factor:
    return Factor(name, tuple(Level(str(value), {setting: value}) for value in values))


def opened(path: Path, of: Experiment) -> Results:
    return Results.open(path, fingerprint_of(boxes(), scenario, of))


def numbers(results: Results, of: Experiment) -> list[tuple[Any, ...]]:
    """Everything in the results but how long it took."""
    return [
        (row.cell, row.run, row.seed, dict(row.measures), row.stalled, row.curves.tolist(), row.agent_ticks)
        for cell in of.cells()
        for row in results.rows(cell.number, of.runs)
    ]


def row(cell: int, run: int, measures: Mapping[str, float], *, stalled: bool = False) -> Row:
    """A result made up: curves that rise from 0 to the measures."""
    curves = np.array([[0.0, value] for value in measures.values()])
    return Row(cell, run, run, measures, stalled, curves, 100, 0.5)


def document(**changed: Any) -> dict[str, Any]:
    """An experiment as its file holds it."""
    made = {
        "title": "Small",
        "ticks": 60,
        "runs": 2,
        "points": 3,
        "arms": [
            {"name": "alone", "arm": "independent", "settings": EASY},
            {"name": "grouped", "arm": "one level", "settings": EASY},
        ],
        "claims": [{"text": "Groups collect more", "greater": "grouped", "less": "alone"}],
    }
    return {**made, **changed}


def written(folder: Path, made: Mapping[str, Any] | str, name: str = "small") -> Path:
    """*folder* of a project, with an experiment in it."""
    file = folder / "experiments" / f"{name}.json"
    file.parent.mkdir(exist_ok=True)
    file.write_text(made if isinstance(made, str) else json.dumps(made))
    return folder
