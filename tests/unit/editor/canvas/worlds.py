"""Scenes of running worlds, without a window."""

from __future__ import annotations

from app.core.project import Project
from app.editor.canvas.scene import Scene
from app.engine.place import place_of
from app.engine.runs import start_engine, treatment
from app.sim.scenario import Scenario


def scene(project: Project, scenario: Scenario, arm: str, ticks: int = 0) -> Scene:
    """The world of an arm after some ticks."""
    of = treatment(project, scenario, project.arm(arm), {"engine": "reference"})
    engine = start_engine(of, 1)
    engine.step(ticks) if ticks else None
    return Scene(place_of(engine, arm), engine.columns(), engine.doing(), engine.tick)
