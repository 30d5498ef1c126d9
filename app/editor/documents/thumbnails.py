"""Small pictures of projects: the world of their first arm as it begins."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter, QPixmap

from ...core.project import Project
from ...core.storage import load
from ...engine.scenarios import brings_code, open_scenario
from ...sim.look import SettledLook, settled
from ...sim.scenario import Scenario, World
from ...sim.world import new_world, spans
from ..drawing.brush import Brush
from ..drawing.figures import Body, Walker, WorldView
from ..drawing.world_painting import paint_ground
from ..palette import Palette

SEED = 1


@dataclass(frozen=True, slots=True)
class Preview:
    """What the welcome page shows of a project; *view* is None where nothing can be drawn."""

    folder: Path
    name: str
    note: str
    view: WorldView | None


def preview(folder: Path) -> Preview:
    """What can be said of a project without running any code that it carries."""
    project = load(folder)
    view = None if brings_code(project) or not project.arms else world_view(project, open_scenario(project))
    return Preview(folder, project.name, project.note, view)


def world_view(project: Project, scenario: Scenario) -> WorldView:
    """The world of a project's first arm as it begins."""
    arm = project.arms[0]
    parameters = scenario.settle(project.parameters_of(arm))
    world = new_world(scenario, parameters, arm.forest(), SEED)
    look = settled(scenario.look, scenario.kinds, parameters)
    found = spans(world, scenario)
    walkers = tuple(
        Walker(float(world.x[i]), float(world.y[i]), float(world.heading[i])) for i in found["agent"]
    )
    bodies = tuple(
        _body(world, i, kind, look) for kind, entities in found.items() if kind != "agent" for i in entities
    )
    width = look.width or max((walker.x for walker in walkers), default=1.0)
    height = look.height or max((walker.y for walker in walkers), default=1.0)
    return WorldView("", "", 0, 0.0, 0.0, width, height, walkers, bodies)


def _body(world: World, entity: int, kind: str, look: SettledLook) -> Body:
    place = kind in look.places
    ranges = look.ranges.get(kind, {})
    radius = next(iter(ranges.values()), 0.0) if place else look.diameters.get(kind, 0.0) / 2
    return Body(float(world.x[entity]), float(world.y[entity]), radius, place=place)


def thumbnail(view: WorldView, colors: Palette, width: int, height: int, ratio: float) -> QPixmap:
    """The middle of a world, as large as it fits across."""
    picture = QPixmap(int(width * ratio), int(height * ratio))
    picture.setDevicePixelRatio(ratio)
    picture.fill(colors.canvas)
    painter = QPainter(picture)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    side = width * view.height / max(view.width, 1e-9)
    paint_ground(Brush(painter, colors), view, QRectF(0.0, (height - side) / 2, width, side))
    painter.end()
    return picture
