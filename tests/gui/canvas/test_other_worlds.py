"""Worlds of other shapes than foraging's, rigid ones, and how fast frames are painted."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtGui import QColor, QImage, QPainter
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.core.library import Library
from app.core.project import Arm, LevelTable, Project
from app.editor.behavior_colors import BehaviorColors
from app.editor.bench.canvas import canvas_frames
from app.editor.canvas.camera import Camera
from app.editor.canvas.coloring import ColorBy, color_agents
from app.editor.canvas.frame import Frame, Options
from app.editor.canvas.group_painting import controller_colors
from app.editor.canvas.hits import entity_at
from app.editor.canvas.ink import Ink
from app.editor.canvas.painting import paint
from app.editor.canvas.scene import Scene
from app.editor.canvas.view import WorldCanvas
from app.editor.palette import DARK
from app.editor.studio import Studio
from app.engine.commands import Step
from tests import chase, corridor, playground
from tests.gui.conftest import PATIENCE
from tests.unit.editor.canvas.worlds import scene


def hares() -> Scene:
    project = Project("Hares", "chase", libraries={"agent": Library({})})
    arm = Arm("all", LevelTable((3,), ("agent",)), "")
    return scene(replace(project, arms=(arm,)), chase.scenario, "all", 3)


def yard() -> Scene:
    project = Project("Yard", "playground", libraries={"agent": Library({})})
    arm = Arm("all", LevelTable((5,), ("agent",)), "")
    return scene(replace(project, arms=(arm,)), playground.scenario, "all", 3)


def hall() -> Scene:
    return scene(corridor.project(), corridor.corridor, "squads", 3)


@pytest.mark.parametrize("world", [hares, yard, hall])
def test_a_world_that_does_not_say_how_it_looks_is_painted_from_what_is_in_it(
    qapp: QApplication, world: Callable[[], Scene]
) -> None:
    shown = world()
    extent = shown.extent()
    camera = Camera().resized(600, 400).fitted(extent)
    colors = BehaviorColors()
    coloring = color_agents(shown, ColorBy.CURRENT, colors)
    frame = Frame(shown, camera, extent, coloring, DARK, options=Options(True, True, True, True, True, True))
    image = QImage(600, 400, QImage.Format.Format_ARGB32_Premultiplied)
    painter = QPainter(image)
    paint(painter, frame, Ink(), controller_colors(frame, ColorBy.CURRENT, colors))
    painter.end()
    x, y = frame.places()
    for entity in range(len(x)):
        assert 0 <= x[entity] <= 600
        assert 0 <= y[entity] <= 400
        assert entity_at(frame, x[entity], y[entity]) >= 0
        near = [
            image.pixelColor(round(x[entity]) + dx, round(y[entity]) + dy)
            for dx in range(-4, 5)
            for dy in range(-4, 5)
        ]
        assert any(color not in (QColor(DARK.canvas), QColor(DARK.grid)) for color in near)


def test_a_project_of_another_scenario_is_shown_and_runs(empty_studio: Studio, qtbot: QtBot) -> None:
    canvas = WorldCanvas(empty_studio)
    qtbot.addWidget(canvas)
    canvas.resize(500, 300)
    canvas.show()
    empty_studio.open(corridor.project(), corridor.corridor, None, arm="squads")
    qtbot.waitUntil(lambda: canvas.frame() is not None, timeout=PATIENCE)
    empty_studio.bridge.send(Step(5))
    qtbot.waitUntil(lambda: canvas.scene is not None and canvas.scene.tick == 5, timeout=PATIENCE)
    empty_studio.close_project()
    assert canvas.frame() is None
    qtbot.waitUntil(lambda: not canvas.is_pending)
    assert not canvas.grab().isNull()


def test_a_rigid_world_is_shown(studio: Studio, qtbot: QtBot) -> None:
    canvas = WorldCanvas(studio)
    qtbot.addWidget(canvas)
    canvas.show()
    studio.use_arm("one level", {"physics": "rigid"})
    qtbot.waitUntil(
        lambda: canvas.scene is not None and canvas.scene.place.physics == "rigid", timeout=PATIENCE
    )
    qtbot.waitUntil(lambda: not canvas.is_pending)
    assert not canvas.grab().isNull()


def test_frames_can_be_measured_without_a_window(qapp: QApplication) -> None:
    assert canvas_frames(60) > 0.0
    assert canvas_frames(60, Options(hulls=True, links=True, all_trails=True), 2) > 0.0


def test_very_many_agents_become_dots_and_are_found_all_the_same(qapp: QApplication) -> None:
    small = scene(corridor.project(), corridor.corridor, "alone")
    agents = 10_000
    project = replace(corridor.project(), arms=(Arm("many", LevelTable((agents,), ("agent",)), ""),))
    many = scene(project, corridor.corridor, "many")
    chance = np.random.default_rng(1)
    spread = replace(
        many, columns={**many.columns, **{name: chance.uniform(0, 100, agents + 1) for name in ("x", "y")}}
    )
    extent = spread.extent()
    camera = Camera().resized(300, 300).fitted(extent)
    frame = Frame(spread, camera, extent, color_agents(spread, ColorBy.CURRENT, BehaviorColors()), DARK)
    few = Frame(small, camera, extent, color_agents(small, ColorBy.CURRENT, BehaviorColors()), DARK)
    assert frame.agent_size < 5.0 < few.agent_size
    x, y = frame.places()
    assert entity_at(frame, x[77], y[77]) >= 0


def test_things_without_a_look_are_called_by_their_kind() -> None:
    assert hares().called(3) == "hare 1"
    assert hares().called(5) == "home"
