"""The automaton graph shows what the automaton does and who is where, and follows the hand."""

import pytest
from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from app.core.automaton import START
from app.core.edits import rename_automaton, set_note
from app.editor.graph.hints import HINT, KEYS, Hint
from app.editor.graph.panel import GraphPanel
from app.editor.graph.state_item import Path
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from app.editor.theme import ThemeMode
from app.engine.commands import Step
from tests.gui.conftest import PATIENCE
from tests.gui.graph.author import Author

LEFT = Qt.MouseButton.LeftButton
FORAGE, AUTHORED = BehaviorKey("agent", "forage"), BehaviorKey("authored-agent", "forage")
RETURN: Path = ("return-with-box",)


def test_states_and_edges_are_those_of_the_automaton(panel: GraphPanel) -> None:
    assert set(panel.scene.states) == {(START,), ("wander",), RETURN}
    edge = panel.scene.edges[(), "wander", "return-with-box"]
    assert "sees a box" in edge.toolTip()
    assert "ICanSeeABox = 1" in edge.toolTip()


def test_clicking_a_state_selects_it_for_all_panels(panel: GraphPanel, studio: Studio, qtbot: QtBot) -> None:
    Author(panel, qtbot).click(("wander",))
    assert (studio.selection.behavior, studio.selection.state) == (FORAGE, "wander")


def test_a_state_selected_elsewhere_is_marked(panel: GraphPanel, studio: Studio) -> None:
    studio.selection.select_state("wander")
    assert panel.scene.current == ("wander",)


def test_a_state_selected_elsewhere_is_marked_and_in_sight_also_where_a_transition_was_selected(
    panel: GraphPanel, studio: Studio, qtbot: QtBot
) -> None:
    author = Author(panel, qtbot)
    author.click_edge("wander", "return-with-box")
    assert panel.scene.edge == ((), "wander", "return-with-box")
    author.drag(QPoint(30, 30), QPoint(30, -500))  # what was above is out of sight now
    studio.selection.select_state(START)
    assert panel.scene.selected == ((START,),)
    assert panel.view.viewport().rect().contains(author.at((START,)))


def test_a_state_of_another_behavior_is_brought_in_sight_once_it_is_drawn(
    panel: GraphPanel, studio: Studio, qtbot: QtBot
) -> None:
    author = Author(panel, qtbot)
    panel.resize(300, 260)
    key = BehaviorKey("authored-agent", "goto")
    last = studio.document.project.library(key.type).get(key.id).states[-1].id
    studio.selection.select_behavior(key, last)
    author.settle()
    assert panel.scene.current == (last,)
    assert panel.view.viewport().rect().contains(author.at((last,)))


def test_arrow_keys_walk_from_state_to_state(panel: GraphPanel, studio: Studio, qtbot: QtBot) -> None:
    Author(panel, qtbot).click((START,))
    qtbot.keyClick(panel.view, Qt.Key.Key_Down)
    assert studio.selection.state == "wander"
    qtbot.keyClick(panel.view, Qt.Key.Key_Down)
    assert studio.selection.state == "return-with-box"


def test_page_keys_go_through_the_transitions_of_a_state(panel: GraphPanel, qtbot: QtBot) -> None:
    Author(panel, qtbot).click(("wander",))
    for target in ("return-with-box", "wander", "return-with-box"):
        qtbot.keyClick(panel.view, Qt.Key.Key_PageDown)
        assert panel.scene.edge == ((), "wander", target)
    qtbot.keyClick(panel.view, Qt.Key.Key_PageUp)
    assert panel.scene.edge == ((), "wander", "wander")
    qtbot.keyClick(panel.view, Qt.Key.Key_PageUp)
    qtbot.keyClick(panel.view, Qt.Key.Key_Down)
    assert panel.scene.current == RETURN


def test_shift_and_arrow_keys_select_several_states(panel: GraphPanel, qtbot: QtBot) -> None:
    Author(panel, qtbot).click(("wander",))
    qtbot.keyClick(panel.view, Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
    assert panel.scene.selected == (("wander",), RETURN)


def test_the_expander_opens_an_automaton_in_place_to_any_depth(panel: GraphPanel, qtbot: QtBot) -> None:
    Author(panel, qtbot).click(RETURN, panel.scene.states[RETURN].expander().center())
    Author(panel, qtbot).settle()
    inner = (*RETURN, "approach")
    assert inner in panel.scene.states
    outer, item = panel.scene.states[RETURN], panel.scene.states[inner]
    assert outer.mapRectToScene(outer.box).contains(item.mapRectToScene(item.box))
    Author(panel, qtbot).click(inner, item.expander().center())
    Author(panel, qtbot).settle()
    assert any(len(path) == 3 for path in panel.scene.states)
    Author(panel, qtbot).click(RETURN, panel.scene.states[RETURN].expander().center())
    Author(panel, qtbot).settle()
    assert len(panel.scene.states) == 3


def test_a_state_inside_an_open_one_is_selected_as_one_of_its_own_automaton(
    panel: GraphPanel, studio: Studio, qtbot: QtBot
) -> None:
    panel.toggle(RETURN)
    Author(panel, qtbot).settle()
    Author(panel, qtbot).click((*RETURN, "grab"))
    assert studio.selection.behavior == BehaviorKey("agent", "return-with-box")
    assert studio.selection.state == "grab"
    assert panel.root == FORAGE


def test_a_double_click_goes_into_an_automaton_and_backspace_comes_back(
    panel: GraphPanel, studio: Studio, qtbot: QtBot
) -> None:
    qtbot.mouseDClick(panel.view.viewport(), LEFT, pos=Author(panel, qtbot).at(RETURN))
    Author(panel, qtbot).settle()
    assert panel.root == studio.selection.behavior == BehaviorKey("agent", "return-with-box")
    qtbot.keyClick(panel.view, Qt.Key.Key_Backspace)
    Author(panel, qtbot).settle()
    assert panel.root == FORAGE


def test_a_state_that_is_dragged_stays_there_and_undo_puts_it_back(
    panel: GraphPanel, studio: Studio, qtbot: QtBot
) -> None:
    start = Author(panel, qtbot).at(("wander",))
    Author(panel, qtbot).drag(start, start + QPoint(60, 30))
    Author(panel, qtbot).settle()
    moved = studio.document.project.layout_of("agent", "forage")["wander"]
    assert panel.scene.states["wander",].pos().toTuple() == pytest.approx(moved)
    assert studio.document.history.undo_text == "Move states of Forage"
    studio.undo()
    Author(panel, qtbot).settle()
    assert studio.document.project.layouts == {}


def test_moving_states_does_not_make_anything_stale(panel: GraphPanel, studio: Studio, qtbot: QtBot) -> None:
    before = studio.document.project.libraries
    qtbot.keyClick(panel.view, Qt.Key.Key_Down)
    qtbot.keyClick(panel.view, Qt.Key.Key_Right, Qt.KeyboardModifier.ControlModifier)
    assert studio.document.project.layouts
    assert studio.document.project.libraries is before


def test_escape_ends_a_drag_and_leaves_all_as_it_was(panel: GraphPanel, studio: Studio, qtbot: QtBot) -> None:
    surface, start = panel.view.viewport(), Author(panel, qtbot).at(("wander",))
    before = panel.scene.states["wander",].pos()
    qtbot.mousePress(surface, LEFT, pos=start)
    qtbot.mouseMove(surface, start + QPoint(50, 50))
    assert panel.scene.states["wander",].pos() != before
    qtbot.keyClick(panel.view, Qt.Key.Key_Escape)
    qtbot.mouseRelease(surface, LEFT, pos=start + QPoint(50, 50))
    assert panel.scene.states["wander",].pos() == before
    assert not studio.document.history.can_undo


def test_shares_and_the_active_state_follow_the_world(
    panel: GraphPanel, studio: Studio, qtbot: QtBot
) -> None:
    assert studio.snapshot is not None
    studio.selection.select_nodes(studio.snapshot.place.agents[:1])
    studio.bridge.send(Step())
    qtbot.waitUntil(lambda: panel.scene.states["wander",].look.active, timeout=PATIENCE)
    looks = [item.look for item in panel.scene.states.values()]
    assert sum(look.count for look in looks) == len(studio.snapshot.place.agents)
    assert sum(look.share for look in looks) == pytest.approx(1.0, abs=0.01)


def test_authored_rules_are_told_with_their_order(panel: GraphPanel, studio: Studio, qtbot: QtBot) -> None:
    studio.selection.select_behavior(AUTHORED)
    Author(panel, qtbot).settle()
    edge = panel.scene.edges[(), "wander", "return-with-box"].edge
    assert [(way.order, way.words) for way in edge.rules] == [(1, "sees a box")]


def test_a_behavior_that_is_gone_leaves_an_explanation(
    panel: GraphPanel, studio: Studio, qtbot: QtBot
) -> None:
    studio.close_project()
    qtbot.waitUntil(lambda: panel.root is None and not panel.scene.states, timeout=PATIENCE)


def test_all_of_an_automaton_is_seen_where_the_user_asks_for_it(
    panel: GraphPanel, author: Author, studio: Studio
) -> None:
    studio.selection.select_behavior(BehaviorKey("agent", "return-with-box"))
    author.settle()
    panel.resize(300, 300)
    seen = panel.view.viewport().rect()
    places = [item.sceneBoundingRect() for item in panel.scene.states.values()]
    assert not all(seen.contains(panel.view.mapFromScene(place).boundingRect()) for place in places)
    studio.actions["graph.fit"].trigger()
    assert all(seen.contains(panel.view.mapFromScene(place).boundingRect()) for place in places)


def test_whoever_comes_to_the_graph_by_keys_is_told_what_keys_do(panel: GraphPanel, qtbot: QtBot) -> None:
    panel.activateWindow()
    qtbot.waitUntil(panel.isActiveWindow, timeout=PATIENCE)
    panel.view.clearFocus()
    panel.view.setFocus(Qt.FocusReason.TabFocusReason)
    hint = panel.findChild(Hint)
    assert isinstance(hint, Hint)
    qtbot.waitUntil(lambda: hint.text() == KEYS, timeout=PATIENCE)
    qtbot.mouseClick(panel.view.viewport(), LEFT, pos=QPoint(3, 3))
    assert hint.text() == HINT


def test_the_picture_stays_where_nothing_that_it_shows_has_changed_and_what_it_is_made_of_is_the_new(
    panel: GraphPanel, studio: Studio, qtbot: QtBot
) -> None:
    author, edge = Author(panel, qtbot), ((), "wander", "return-with-box")
    author.settle()
    item, tip = panel.scene.edges[edge], panel.scene.edges[edge].toolTip()
    studio.document.do(set_note, FORAGE.type, FORAGE.id, "It brings boxes home.")
    author.settle()
    assert panel.scene.edges[edge] is item
    assert item.toolTip() == tip
    assert panel.scene.levels[()].automaton is studio.document.automaton(FORAGE.type, FORAGE.id)
    studio.document.do(rename_automaton, "agent", "wander", "Stroll")
    author.settle()
    assert panel.scene.edges[edge] is not item
    assert panel.scene.states["wander",].state.name == "Stroll"


def test_another_theme_is_seen_in_the_picture_and_the_first_one_again(
    panel: GraphPanel, studio: Studio, qtbot: QtBot
) -> None:
    author, pictures = Author(panel, qtbot), []
    for mode in (ThemeMode.LIGHT, ThemeMode.DARK, ThemeMode.LIGHT):
        studio.theme.use(mode)
        author.settle()
        pictures.append(panel.view.grab().toImage())
    assert pictures[0] != pictures[1]
    assert pictures[0] == pictures[2]
