"""How fast the window draws, measured without one: frames are painted into a picture in memory."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from statistics import median
from time import perf_counter

import numpy as np
from PySide6.QtGui import QColor, QGuiApplication, QImage, QPainter
from PySide6.QtWidgets import QApplication

from ...core.library import Library
from ...core.project import Arm, LevelTable, Project
from ...engine.place import place_of
from ...engine.runs import start_engine, treatment
from ...engine.scenarios import open_scenario
from ..behavior_colors import BehaviorColors
from ..canvas.camera import Camera
from ..canvas.coloring import ColorBy, color_agents
from ..canvas.frame import Frame, Options
from ..canvas.group_painting import controller_colors
from ..canvas.ink import Ink
from ..canvas.painting import paint
from ..canvas.scene import Scene
from ..canvas.trails import Trails
from ..palette import DARK

#: Pixels of the picture, and how many frames are painted; the first ones, in which all is made anew, do not count.
SIZE, FRAMES, WARM = (1200, 900), 40, 5


def canvas_frames(agents: int, options: Options = Options(), levels: int = 1) -> float:  # noqa: B008 - frozen
    """Frames per second of the canvas with *agents* foragers, everything a snapshot asks of it included: the median.

    Args:
        options: What is shown besides the agents.
        levels: 1 for agents alone, 2 for agents in groups of five.
    """
    _application()
    colors, ink, trails = BehaviorColors(), Ink(), Trails()
    image, window = (QImage(*SIZE, QImage.Format.Format_ARGB32_Premultiplied) for _ in range(2))
    seconds = []
    for scene in _scenes(agents, levels):
        began = perf_counter()
        trails.add(scene)
        extent = scene.extent()
        camera = Camera().resized(*SIZE).fitted(extent)
        coloring = color_agents(scene, ColorBy.CURRENT, colors)
        node = scene.place.agents[:1]
        frame = Frame(scene, camera, extent, coloring, DARK, trails, options, nodes=node)
        painter = QPainter(image)
        paint(painter, frame, ink, controller_colors(frame, ColorBy.CURRENT, colors) or [QColor(DARK.dim)])
        painter.end()
        onto = QPainter(window)
        onto.drawImage(0, 0, image)
        onto.end()
        seconds.append(perf_counter() - began)
    return 1.0 / median(seconds[WARM:])


def _application() -> QGuiApplication:
    found = QGuiApplication.instance()
    return (
        found
        if isinstance(found, QGuiApplication)
        else QApplication(["understudy", "-platform", "offscreen"])
    )


def _scenes(agents: int, levels: int) -> Iterator[Scene]:
    """A world of foragers, each of which moves and turns a bit from one frame to the next."""
    project = foragers(agents, levels)
    arm = project.arms[0]
    engine = start_engine(treatment(project, open_scenario(project), arm), 1)
    first = Scene(place_of(engine, arm.name), engine.columns(), engine.doing(), 0)
    for number in range(WARM + FRAMES):
        turned = np.asarray(first.columns["heading"]) + 0.05 * number
        columns = {
            **first.columns,
            "x": first.x + 0.1 * number * np.cos(turned),
            "y": first.y + 0.1 * number * np.sin(turned),
            "heading": turned,
        }
        yield replace(first, columns=columns, tick=number)


def foragers(agents: int, levels: int = 1) -> Project:
    """A project with one arm of *agents*, and a box for every five of them."""
    group = 5
    sizes, types = ((agents,), ("agent",)) if levels == 1 else ((agents // group, group), ("group", "agent"))
    side = 200.0 * max(1.0, (agents / 500) ** 0.5)
    world = {"boxes": agents // group, "width": side, "height": side}
    base = Project("bench", "foraging")
    kinds = tuple(base.types)
    if levels > 1:
        kinds = (*kinds, replace(kinds[0], name="group", level=1, subsidiaries=("agent",)))
    return replace(
        base,
        types=kinds,
        libraries={name: Library({}) for name in types},
        worlds={"": world},
        arms=(Arm("all", LevelTable(sizes, types), ""),),
    )
