"""Moving agents and boxes by hand."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QPoint, Qt

from app.engine.commands import Pause, Play
from tests.gui.canvas.pilot import Pilot

BOX = 50


@pytest.mark.parametrize("kind", ["agent", "box"])
def test_what_is_dragged_while_paused_is_where_it_was_let_go_and_undo_takes_it_back(
    pilot: Pilot, kind: str
) -> None:
    entity = pilot.alone() if kind == "agent" else BOX
    start, end = pilot.at(entity), pilot.nowhere()
    before = float(pilot.snapshot.columns["x"][entity]), float(pilot.snapshot.columns["y"][entity])
    goal = pilot.canvas.looking.camera.to_world(end.x(), end.y())
    pilot.drag(start, end)
    pilot.wait(lambda: pilot.snapshot.columns["x"][entity] == pytest.approx(goal[0], abs=1.0))
    pilot.wait(lambda: pilot.canvas.hand.dragged is None)
    assert pilot.snapshot.columns["y"][entity] == pytest.approx(goal[1], abs=1.0)
    assert pilot.selected == []
    pilot.wait(lambda: pilot.studio.document.history.can_undo)
    pilot.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    pilot.wait(lambda: pilot.snapshot.columns["x"][entity] == pytest.approx(before[0]))
    assert pilot.snapshot.columns["y"][entity] == pytest.approx(before[1])


def test_until_it_is_let_go_a_drag_is_only_shown(pilot: Pilot) -> None:
    agent, end = pilot.alone(), pilot.nowhere()
    start, world = pilot.at(agent), pilot.snapshot.columns["x"][agent]
    pilot.down(start).move(end)
    assert pilot.at(agent) == end
    assert pilot.snapshot.columns["x"][agent] == world
    pilot.key(Qt.Key.Key_Escape)
    pilot.up(end)
    assert pilot.at(agent) == start
    assert not pilot.studio.document.history.can_undo


def test_while_time_passes_a_drag_says_why_it_does_nothing(pilot: Pilot) -> None:
    pilot.send(Play(0.25))
    agent = pilot.alone()
    pilot.drag(pilot.at(agent), pilot.at(agent) + QPoint(40, 40))
    assert [text for text in pilot.said if "pause before you move something" in text]
    assert pilot.canvas.hand.dragged is None
    pilot.send(Pause())
    assert not pilot.studio.document.history.can_undo


def test_a_world_that_begins_anew_in_the_middle_of_a_drag_ends_it(pilot: Pilot) -> None:
    agent = pilot.alone()
    pilot.down(pilot.at(agent)).move(pilot.nowhere())
    pilot.use_arm("one level")
    assert pilot.canvas.hand.dragged is None
    pilot.up(pilot.nowhere())
    assert not pilot.studio.document.history.can_undo
