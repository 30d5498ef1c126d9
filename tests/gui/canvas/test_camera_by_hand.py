"""Moving the view, zooming, following."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QToolButton

from app.engine.commands import Step
from tests.gui.canvas.pilot import CONTROL, LEFT, MIDDLE, RIGHT, Pilot


def test_all_of_the_world_is_in_view_at_first_and_after_a_change_of_size(pilot: Pilot) -> None:
    for size in ((1440, 900), (1000, 700)):
        pilot.window.resize(*size)
        camera = pilot.canvas.looking.camera
        pilot.wait(lambda: pilot.canvas.looking.camera.width == pilot.canvas.width())
        camera = pilot.canvas.looking.camera
        left, top = camera.to_view(0.0, 200.0)
        right, bottom = camera.to_view(200.0, 0.0)
        assert min(left, top) >= 0
        assert right <= pilot.canvas.width()
        assert bottom <= pilot.canvas.height() - pilot.canvas.on_top.legend.height()


def test_the_wheel_zooms_around_the_mouse_and_fit_shows_all_again(pilot: Pilot) -> None:
    at, before = QPoint(300, 200), pilot.canvas.looking.camera
    pilot.wheel(at, 3)
    after = pilot.canvas.looking.camera
    assert after.scale == pytest.approx(2 * before.scale)
    assert after.to_world(300, 200) == pytest.approx(before.to_world(300, 200))
    pilot.key(Qt.Key.Key_0, CONTROL)
    assert pilot.canvas.looking.camera == before


@pytest.mark.parametrize("button", [MIDDLE, RIGHT])
def test_drags_with_the_middle_and_the_right_button_move_the_view(
    pilot: Pilot, button: Qt.MouseButton
) -> None:
    before = pilot.at(0)
    start = pilot.nowhere()
    pilot.drag(start, start + QPoint(60, -40), button)
    assert pilot.at(0) - before == QPoint(60, -40)
    assert pilot.selected == []


def test_with_space_held_the_left_button_moves_the_view_and_time_stays_as_it_is(pilot: Pilot) -> None:
    before = pilot.at(0)
    pilot.canvas.setFocus()
    pilot.qtbot.keyPress(pilot.canvas, Qt.Key.Key_Space)
    pilot.drag(pilot.at(0), pilot.at(0) + QPoint(30, 20), LEFT)
    pilot.qtbot.keyRelease(pilot.canvas, Qt.Key.Key_Space)
    assert pilot.at(0) - before == QPoint(30, 20)
    pilot.send(Step())
    assert pilot.snapshot.speed != 1.0 or pilot.snapshot.tick <= 1


def test_space_alone_lets_time_pass_as_everywhere(pilot: Pilot) -> None:
    pilot.key(Qt.Key.Key_Space)
    pilot.wait(lambda: pilot.snapshot.tick > 2)


def test_the_selected_agent_is_followed_until_the_view_is_moved(pilot: Pilot) -> None:
    agent = pilot.alone()
    pilot.click(pilot.at(agent))
    pilot.wait(pilot.studio.actions["canvas.follow"].isEnabled)
    pilot.key(Qt.Key.Key_F, CONTROL | Qt.KeyboardModifier.ShiftModifier)
    pilot.send(Step(30))
    pilot.wait(lambda: pilot.snapshot.tick == 30)
    camera = pilot.canvas.looking.camera
    x, y = pilot.snapshot.columns["x"][agent], pilot.snapshot.columns["y"][agent]
    assert (camera.x, camera.y) == pytest.approx((x, y))
    assert pilot.studio.actions["canvas.follow"].isChecked()
    pilot.key(Qt.Key.Key_Left)
    assert not pilot.canvas.looking.follows


def test_a_double_click_follows_an_agent(pilot: Pilot) -> None:
    agent = pilot.alone()
    pilot.qtbot.mouseDClick(pilot.canvas, LEFT, Qt.KeyboardModifier.NoModifier, pilot.at(agent))
    assert pilot.selected == [pilot.snapshot.place.agents[agent]]
    assert pilot.canvas.looking.follows


@pytest.mark.parametrize(("action", "larger"), [("canvas.zoom_in", True), ("canvas.zoom_out", False)])
def test_the_buttons_zoom(pilot: Pilot, action: str, *, larger: bool) -> None:
    before = pilot.canvas.looking.camera.scale
    place = ("canvas.zoom_in", "canvas.zoom_out").index(action)
    button = pilot.canvas.on_top.camera_buttons.findChildren(QToolButton)[place]
    pilot.qtbot.mouseClick(button, LEFT)
    assert (pilot.canvas.looking.camera.scale > before) is larger


def test_the_view_turns_to_whose_turn_it_is_unless_all_of_the_world_is_in_view(pilot: Pilot) -> None:
    agents = pilot.snapshot.place.agents
    pilot.studio.selection.select_nodes(agents[:2])
    before = pilot.canvas.looking.camera
    pilot.studio.teaching.follow_requested.emit(agents[0])
    assert pilot.selected == [agents[1], agents[0]]
    assert pilot.canvas.looking.camera == before
    pilot.wheel(QPoint(300, 200), 3)
    pilot.studio.teaching.follow_requested.emit(agents[1])
    pilot.send(Step())
    camera = pilot.canvas.looking.camera
    assert camera.x == pytest.approx(pilot.snapshot.columns["x"][1])


def test_a_reset_looks_from_where_the_user_was(pilot: Pilot) -> None:
    pilot.wheel(QPoint(300, 200), 3)
    before, place = pilot.canvas.looking.camera, pilot.snapshot.place
    pilot.key(Qt.Key.Key_R, CONTROL)
    pilot.wait(lambda: pilot.snapshot.place is not place)
    assert pilot.canvas.looking.camera == before
