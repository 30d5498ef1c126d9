"""Moving agents and boxes by hand."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QPoint, Qt

from app.engine.commands import Pause, Play
from tests.gui.canvas.pilot import Pilot

BOX = 50
CONTROL = Qt.KeyboardModifier.ControlModifier


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


# --------------------------------------------------------------------------------------------------- by keys


@pytest.mark.parametrize("kind", ["agent", "box"])
def test_keys_alone_move_what_is_selected_or_taken_and_one_undo_takes_it_back(
    pilot: Pilot, kind: str
) -> None:
    entity = pilot.alone() if kind == "agent" else BOX
    if kind == "agent":
        pilot.studio.selection.select_nodes([pilot.snapshot.place.agents[entity]])
    else:
        pilot.key(Qt.Key.Key_PageDown, CONTROL)
    start = pilot.at(entity)
    before = float(pilot.snapshot.columns["x"][entity])
    for _ in range(4):
        pilot.key(Qt.Key.Key_Right, CONTROL)
    pilot.key(Qt.Key.Key_Up, CONTROL)
    assert pilot.at(entity) == start + QPoint(24, -6)
    assert pilot.snapshot.columns["x"][entity] == before
    assert (
        f"move {pilot.snapshot.place.entity_called(entity)}, Enter" in pilot.canvas.on_top.prompt.words.text()
    )
    pilot.key(Qt.Key.Key_Return)
    pilot.wait(lambda: pilot.snapshot.columns["x"][entity] > before and pilot.canvas.hand.dragged is None)
    assert not pilot.canvas.on_top.prompt.isVisible()
    pilot.wait(lambda: pilot.studio.document.history.can_undo)
    pilot.key(Qt.Key.Key_Z, CONTROL)
    pilot.wait(lambda: pilot.snapshot.columns["x"][entity] == pytest.approx(before))
    assert not pilot.studio.document.history.can_undo


def test_page_keys_with_ctrl_go_through_all_that_is_no_agent_and_escape_leaves_it(pilot: Pilot) -> None:
    for key, entity in ((Qt.Key.Key_PageDown, BOX), (Qt.Key.Key_PageDown, BOX + 1), (Qt.Key.Key_PageUp, BOX)):
        pilot.key(key, CONTROL)
        assert pilot.canvas.hand.carried == entity
        frame = pilot.canvas.frame()
        assert frame is not None
        assert frame.targets == {entity}
    start = pilot.at(BOX)
    pilot.key(Qt.Key.Key_Down, CONTROL)
    pilot.key(Qt.Key.Key_Escape)
    assert (pilot.canvas.hand.carried, pilot.at(BOX)) == (-1, start)
    assert not pilot.studio.document.history.can_undo


def test_a_press_of_the_mouse_lets_go_of_what_keys_hold(pilot: Pilot) -> None:
    pilot.key(Qt.Key.Key_PageDown, CONTROL)
    pilot.click(pilot.nowhere())
    assert pilot.canvas.hand.carried == -1
    assert pilot.canvas.hand.dragged is None


def test_keys_say_why_nothing_is_moved(pilot: Pilot) -> None:
    pilot.studio.selection.select_nodes(())
    pilot.key(Qt.Key.Key_Right, CONTROL)
    assert [text for text in pilot.said if text.startswith("select an agent, or take a thing")]
    pilot.send(Play(0.25))
    pilot.key(Qt.Key.Key_PageDown, CONTROL)
    assert [text for text in pilot.said if "pause before you move something" in text]
    pilot.send(Pause())
