"""Selecting agents and controllers in the world."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication, QMenu

from app.core.edits import set_hierarchy
from app.core.project import LevelTable
from app.editor.canvas.group_painting import hull_corners, link_ends, marked, shown_hulls, shown_links
from tests.gui.canvas.pilot import CONTROL, RIGHT, SHIFT, Pilot
from tests.gui.conftest import said


def test_a_click_selects_the_agent_there_and_a_click_on_nothing_selects_none(pilot: Pilot) -> None:
    agent = pilot.alone()
    pilot.click(pilot.at(agent))
    assert pilot.selected == [pilot.snapshot.place.agents[agent]]
    pilot.click(pilot.nowhere())
    assert pilot.selected == []


def test_shift_and_ctrl_add_and_take_away(pilot: Pilot) -> None:
    agents = pilot.snapshot.place.agents
    first, second = pilot.alone(), 0
    pilot.studio.selection.select_nodes((agents[second],))
    pilot.click(pilot.at(first), SHIFT)
    assert pilot.selected == [agents[second], agents[first]]
    pilot.click(pilot.at(first), CONTROL)
    assert pilot.selected == [agents[second]]


def test_a_rubber_band_selects_what_is_in_it_and_adds_with_shift(pilot: Pilot) -> None:
    x, y = pilot.frame.places()
    start = pilot.nowhere()
    end = QPoint(start.x() + 120, start.y() + 150)
    pilot.drag(start, end)
    agents = pilot.snapshot.place.agents
    inside = {
        agents[k] for k in range(len(agents)) if start.x() <= x[k] <= end.x() and start.y() <= y[k] <= end.y()
    }
    assert set(pilot.selected) == inside
    assert not pilot.has_band()
    other = next(agent for agent in agents if agent not in inside)
    pilot.studio.selection.select_nodes((other,))
    pilot.drag(start, end, keys=SHIFT)
    assert set(pilot.selected) == {other, *inside}


def test_escape_gives_a_rubber_band_up(pilot: Pilot) -> None:
    start = pilot.nowhere()
    pilot.down(start).move(start + QPoint(200, 100))
    assert pilot.has_band()
    pilot.key(Qt.Key.Key_Escape)
    pilot.up(start + QPoint(200, 100))
    assert not pilot.has_band()
    assert pilot.selected == []


def test_a_click_on_a_link_selects_its_controller(pilot: Pilot) -> None:
    pilot.use_arm("one level")
    pilot.choose("canvas.links")
    frame = pilot.frame
    links = shown_links(frame)
    assert len(links) == 50
    x, y = frame.places()
    for left, top, right, bottom in link_ends(frame, links).tolist():
        at = QPoint(round(left + 0.4 * (right - left)), round(top + 0.4 * (bottom - top)))
        if ((abs(x - at.x()) > 25) | (abs(y - at.y()) > 25)).all():
            break
    pilot.click(at)
    assert len(pilot.selected) == 1
    assert pilot.selected[0].startswith("group-")


def test_who_is_under_the_selected_controller_is_marked_where_its_links_end_and_selected_there(
    pilot: Pilot,
) -> None:
    pilot.use_arm("two levels")
    pilot.studio.selection.select_nodes(("squad-1",))
    frame = pilot.frame
    links = shown_links(frame)
    rows, places = marked(frame, links, link_ends(frame, links))
    ids = [frame.scene.place.ids[row] for row in rows.tolist()]
    assert ids == ["squad-1", *(f"group-{k}" for k in range(1, 6))]
    x, y = frame.places()
    free = [
        (node, QPoint(round(at[0]), round(at[1])))
        for node, at in zip(ids[1:], places[1:].tolist(), strict=True)
        if (np.hypot(x - at[0], y - at[1]) > 20).all()
    ]
    assert free
    pilot.click(free[0][1])
    assert pilot.selected == [free[0][0]]


def test_a_click_in_a_hull_selects_its_controller_and_none_where_hulls_are_off(pilot: Pilot) -> None:
    pilot.use_arm("one level")
    at = pilot.nowhere()
    pilot.click(at)
    assert pilot.selected == []
    pilot.choose("canvas.hulls")
    frame = pilot.frame
    corners = hull_corners(frame, shown_hulls(frame))
    middles = [QPoint(round(xs.mean()), round(ys.mean())) for xs, ys in zip(*corners, strict=True)]
    x, y = frame.places()
    free = next(m for m in middles if ((abs(x - m.x()) > 25) | (abs(y - m.y()) > 25)).all())
    pilot.click(free)
    assert len(pilot.selected) == 1
    assert pilot.selected[0].startswith("group-")


def test_keys_go_through_the_agents_and_select_them_all(pilot: Pilot) -> None:
    agents = pilot.snapshot.place.agents
    pilot.key(Qt.Key.Key_PageDown)
    assert pilot.selected == list(agents[:1])
    pilot.key(Qt.Key.Key_PageDown)
    pilot.key(Qt.Key.Key_PageDown)
    pilot.key(Qt.Key.Key_PageUp)
    assert pilot.selected == list(agents[1:2])
    pilot.key(Qt.Key.Key_A, CONTROL)
    assert pilot.selected == list(agents)


def test_the_right_button_offers_what_can_be_done_with_an_agent(pilot: Pilot) -> None:
    pilot.use_arm("one level")
    agent = pilot.alone()
    at = pilot.at(agent)
    pilot.down(at, RIGHT).up(at, RIGHT)
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    texts = [said(action) for action in menu.actions()]
    node = pilot.snapshot.place.agents[agent]
    parent = pilot.snapshot.place.hierarchy.parents()[node]
    choice = next(action for action in menu.actions() if action.text().startswith("Select its controller"))
    choice.trigger()
    menu.close()
    assert pilot.selected == [parent]
    assert "Fit the world" in texts


def test_the_right_button_says_where_nobody_is_attached_to_a_box(pilot: Pilot) -> None:
    x, y = pilot.frame.places()
    agents, boxes = pilot.frame.scene.agents, pilot.snapshot.place.spans["box"]
    box = next(k for k in boxes if (np.hypot(x[:agents] - x[k], y[:agents] - y[k]) > 30).all())
    pilot.down(pilot.at(box), RIGHT).up(pilot.at(box), RIGHT)
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    first = menu.actions()[0]
    menu.close()
    assert first.text() == f"Nobody is attached to box {box - boxes.start + 1}"
    assert not first.isEnabled()


def test_of_hundreds_of_controllers_the_highest_and_those_under_the_selected_are_outlined(
    pilot: Pilot,
) -> None:
    sizes = LevelTable((6, 20, 2), ("squad", "group", "agent"))
    pilot.studio.document.do(set_hierarchy, "two levels", sizes)
    pilot.use_arm("two levels")
    pilot.choose("canvas.hulls")
    pilot.choose("canvas.links")
    ids = pilot.snapshot.place.ids
    assert [ids[row] for row in shown_hulls(pilot.frame)] == [f"squad-{k}" for k in range(1, 7)]
    assert len(shown_links(pilot.frame)) == 6 * 20
    pilot.studio.selection.select_nodes(("squad-2",))
    shown = [ids[row] for row in shown_hulls(pilot.frame)]
    assert shown[6:] == [f"group-{k}" for k in range(21, 41)]
    pilot.studio.selection.select_nodes(("group-3",))
    assert [ids[row] for row in shown_hulls(pilot.frame)][6:] == ["group-3"]
    assert len(shown_links(pilot.frame)) == 6 * 20 + 2


def test_every_one_of_very_many_selected_is_marked_close_around_it(pilot: Pilot) -> None:
    pilot.studio.document.do(set_hierarchy, "independent", LevelTable((300,), ("agent",)))
    pilot.studio.use_arm("independent")
    pilot.wait(lambda: pilot.frame.scene.agents == 300)
    plain = pilot.picture()
    pilot.key(Qt.Key.Key_A, CONTROL)
    marked = pilot.picture()
    x, y = pilot.frame.places()
    for agent in range(300):
        around = [
            QPoint(round(x[agent]) + dx, round(y[agent]) + dy) for dx in range(-9, 10) for dy in range(-9, 10)
        ]
        assert any(plain.pixel(at) != marked.pixel(at) for at in around if plain.valid(at))
