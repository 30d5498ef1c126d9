"""Moving agents and boxes by hand."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QPoint, Qt

from app.engine.commands import MoveEntities, Pause, Play
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


# ------------------------------------------------------------------------------------------ several together


def select(pilot: Pilot, *more: int) -> tuple[int, ...]:
    """Click an agent that stands alone, then select *more* by keys; what is selected, the clicked one first."""
    agent = pilot.alone()
    pilot.click(pilot.at(agent))
    agents = (agent, *(one for one in more if one != agent))
    for one in agents[1:]:
        pilot.studio.selection.toggle_node(pilot.snapshot.place.agents[one])
    return agents


def undoes(pilot: Pilot) -> str:
    """What undo says that it would undo."""
    pilot.wait(lambda: "Move" in pilot.studio.actions["edit.undo"].text())
    return pilot.studio.actions["edit.undo"].text().removeprefix("&Undo: ")


def shown(pilot: Pilot, agents: tuple[int, ...]) -> list[int]:
    """The pixels where they are shown, x and y one after the other."""
    return [number for agent in agents for number in (pilot.at(agent).x(), pilot.at(agent).y())]


def places(pilot: Pilot, entities: tuple[int, ...]) -> list[tuple[float, float]]:
    """Where the world has them."""
    columns = pilot.snapshot.columns
    return [(float(columns["x"][entity]), float(columns["y"][entity])) for entity in entities]


def test_of_several_selected_agents_all_are_dragged_and_one_undo_takes_all_back(pilot: Pilot) -> None:
    agents = select(pilot, 0, 1, 2)
    others = tuple(one for one in range(50) if one not in agents)
    before, rest = places(pilot, agents), places(pilot, others)
    start = pilot.at(agents[0])
    shift = QPoint(12, 8)
    pilot.down(start).move(start + shift)
    assert places(pilot, agents) == before
    pilot.up(start + shift)
    pilot.wait(lambda: places(pilot, agents)[0] != before[0] and pilot.canvas.hand.dragged is None)
    first, last = pilot.canvas.looking.camera.to_world(0, 0), pilot.canvas.looking.camera.to_world(12, 8)
    goal = last[0] - first[0], last[1] - first[1]
    for (x, y), (was_x, was_y) in zip(places(pilot, agents), before, strict=True):
        # at the walls they stop
        assert x - was_x == pytest.approx(goal[0], abs=0.5) or x in (0.0, 200.0)
        assert y - was_y == pytest.approx(goal[1], abs=0.5) or y in (0.0, 200.0)
    assert places(pilot, others) == rest
    pilot.wait(lambda: pilot.studio.document.history.can_undo)
    assert undoes(pilot) == f"Move {len(agents)} agents"
    pilot.key(Qt.Key.Key_Z, CONTROL)
    pilot.wait(lambda: places(pilot, agents) == before)
    assert not pilot.studio.document.history.can_undo
    pilot.key(Qt.Key.Key_Z, CONTROL | Qt.KeyboardModifier.ShiftModifier)
    pilot.wait(lambda: places(pilot, agents) != before)


def test_one_that_is_not_selected_is_dragged_alone(pilot: Pilot) -> None:
    agent = pilot.alone()
    pilot.studio.selection.select_nodes(
        [one for one in pilot.snapshot.place.agents[:3] if one != f"agent-{agent + 1}"]
    )
    others = tuple(one for one in range(50) if one != agent)
    before, rest = places(pilot, (agent,)), places(pilot, others)
    pilot.drag(pilot.at(agent), pilot.nowhere())
    pilot.wait(lambda: places(pilot, (agent,)) != before)
    assert places(pilot, others) == rest


@pytest.mark.parametrize("selected", [0, 1, 2])
def test_of_agents_that_lie_upon_each_other_the_one_that_is_selected_is_dragged(
    pilot: Pilot, selected: int
) -> None:
    agents = (0, 1, 2)
    x, y = pilot.canvas.looking.camera.to_world(*pilot.nowhere().toTuple())
    pilot.send(MoveEntities(dict.fromkeys(agents, (x, y))))
    pilot.wait(lambda: places(pilot, agents) == [places(pilot, agents)[0]] * 3)
    before = places(pilot, agents)
    pilot.studio.selection.select_nodes([f"agent-{selected + 1}"])
    start = pilot.at(0)
    pilot.drag(start, start + QPoint(40, 30))
    pilot.wait(lambda: places(pilot, (selected,)) != before[:1])
    rest = tuple(agent for agent in agents if agent != selected)
    assert places(pilot, rest) == before[:2]


def test_all_that_are_under_a_selected_controller_are_dragged_with_one_of_them(pilot: Pilot) -> None:
    pilot.use_arm("one level")
    agent = pilot.alone()
    place = pilot.snapshot.place
    group = next(
        node
        for node in place.hierarchy.controllers()
        if f"agent-{agent + 1}" in {one.id for one in node.walk()}
    )
    pilot.studio.selection.select_nodes([group.id])
    start = pilot.at(agent)
    pilot.drag(start, start + QPoint(12, 8))
    pilot.wait(lambda: pilot.studio.document.history.can_undo)
    assert undoes(pilot) == f"Move {len(list(group.agents()))} agents"


def test_escape_leaves_all_that_were_dragged_where_they_were(pilot: Pilot) -> None:
    agents = select(pilot, 0, 1)
    start, before = pilot.at(agents[0]), shown(pilot, agents)
    pilot.down(start).move(start + QPoint(12, 8))
    there = [number + more for number, more in zip(before, (12, 8) * len(agents), strict=True)]
    assert shown(pilot, agents) == pytest.approx(
        there, abs=1.0
    )  # the first is where the mouse is, to the pixel
    pilot.key(Qt.Key.Key_Escape)
    pilot.up(start)
    assert shown(pilot, agents) == before
    assert not pilot.studio.document.history.can_undo


def test_keys_move_all_selected_agents_as_one_step(pilot: Pilot) -> None:
    agents = select(pilot, 0, 1, 2)
    before, start = places(pilot, agents), shown(pilot, agents)
    pilot.key(Qt.Key.Key_Right, CONTROL)
    pilot.key(Qt.Key.Key_Down, CONTROL)
    assert shown(pilot, agents) == [number + 6 for number in start]
    assert f"move {len(agents)} agents, Enter puts them down" in pilot.canvas.on_top.prompt.words.text()
    pilot.key(Qt.Key.Key_Return)
    pilot.wait(lambda: places(pilot, agents) != before and pilot.canvas.hand.dragged is None)
    pilot.wait(lambda: pilot.studio.document.history.can_undo)
    pilot.key(Qt.Key.Key_Z, CONTROL)
    pilot.wait(lambda: places(pilot, agents) == before)
    assert not pilot.studio.document.history.can_undo


def test_what_is_taken_again_before_the_world_has_it_goes_on_from_where_it_was_let_go(pilot: Pilot) -> None:
    agent = pilot.alone()
    pilot.click(pilot.at(agent))
    start = pilot.at(agent)
    for _ in range(2):
        pilot.key(Qt.Key.Key_Right, CONTROL)
        pilot.key(Qt.Key.Key_Return)
    pilot.wait(lambda: pilot.canvas.hand.dragged is None)
    assert pilot.at(agent) == start + QPoint(12, 0)


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
        assert pilot.canvas.hand.carried == (entity,)
        frame = pilot.canvas.frame()
        assert frame is not None
        assert frame.targets == {entity}
    start = pilot.at(BOX)
    pilot.key(Qt.Key.Key_Down, CONTROL)
    pilot.key(Qt.Key.Key_Escape)
    assert (pilot.canvas.hand.carried, pilot.at(BOX)) == ((), start)
    assert not pilot.studio.document.history.can_undo


def test_a_press_of_the_mouse_lets_go_of_what_keys_hold(pilot: Pilot) -> None:
    pilot.key(Qt.Key.Key_PageDown, CONTROL)
    pilot.click(pilot.nowhere())
    assert pilot.canvas.hand.carried == ()
    assert pilot.canvas.hand.dragged is None


def test_keys_say_why_nothing_is_moved(pilot: Pilot) -> None:
    pilot.studio.selection.select_nodes(())
    pilot.key(Qt.Key.Key_Right, CONTROL)
    assert [text for text in pilot.said if text.startswith("select agents, or take a thing")]
    pilot.send(Play(0.25))
    pilot.key(Qt.Key.Key_PageDown, CONTROL)
    assert [text for text in pilot.said if "pause before you move something" in text]
    pilot.send(Pause())
