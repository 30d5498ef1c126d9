"""Picks where the states and the agents are seen: on the graph, and on the canvas."""

from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtWidgets import QApplication, QMenu
from pytestqt.qtbot import QtBot

from app.editor.graph.panel import GraphPanel
from app.editor.window.main_window import MainWindow
from tests.gui.canvas.pilot import RIGHT, Pilot
from tests.gui.graph.author import Author
from tests.gui.teach.hand import Hand


def _graph(hand: Hand) -> Author:
    panel = hand.window.docks["graph"].widget()
    assert isinstance(panel, GraphPanel)
    author = Author(panel, hand.qtbot)
    author.settle()
    return author


def _opened(author: Author, at: QPoint) -> QMenu:
    """The menu that the right button opens."""
    surface = author.panel.view.viewport()
    reason = QContextMenuEvent.Reason.Mouse
    QApplication.sendEvent(surface, QContextMenuEvent(reason, at, surface.mapToGlobal(at)))
    menu = author.panel.menu
    assert menu is not None
    return menu


def test_a_state_can_be_picked_on_the_graph_while_its_automaton_is_taught(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    author = _graph(hand)
    author.click(author.named("RotateLeft"))
    menu = _opened(author, author.at(author.named("RotateLeft")))
    hand.act(lambda: author.pick(menu, "Pick RotateLeft"))
    hand.window.activateWindow()  # without a screen, nobody gives the keys back once a menu has closed
    hand.wait(hand.window.isActiveWindow)
    assert hand.lesson.waiting == {"agent-3"}
    hand.hold(1)
    assert hand.studio.teaching.state == "rotate-left"


def test_nothing_can_be_picked_on_the_graph_of_what_is_not_taught(hand: Hand) -> None:
    author = _graph(hand)
    author.click(author.panel.scene.current or next(iter(author.panel.scene.states)))
    assert not hand.studio.actions["graph.pick"].isEnabled()
    hand.teach("Wander", "agent-3")
    author.click(author.named("Start"))
    hand.settle()
    assert not hand.studio.actions["graph.pick"].isEnabled()  # nobody is told to begin anew


def _menu_of(pilot: Pilot, node: str) -> QMenu:
    at = pilot.at(pilot.entity(node))
    pilot.down(at, RIGHT).up(at, RIGHT)
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    return menu


def test_a_state_can_be_picked_for_an_agent_on_the_canvas(
    hand: Hand, window: MainWindow, qtbot: QtBot
) -> None:
    pilot = Pilot(window, qtbot)
    pilot.wait(lambda: pilot.canvas.frame() is not None)
    hand.teach("Wander", "agent-3", "agent-7")
    menu = _menu_of(pilot, "agent-7")
    (pick,) = [action for action in menu.actions() if action.text() == "Pick for Agent 7"]
    states = pick.menu()
    assert isinstance(states, QMenu)
    (turn,) = [action for action in states.actions() if action.text() == "RotateLeft"]
    hand.act(turn.trigger)
    menu.close()
    assert hand.lesson.waiting == {"agent-7"}
    assert hand.studio.teaching.node == "agent-7"


def test_nothing_can_be_picked_for_who_is_not_taught(hand: Hand, window: MainWindow, qtbot: QtBot) -> None:
    pilot = Pilot(window, qtbot)
    pilot.wait(lambda: pilot.canvas.frame() is not None)
    hand.teach("Wander", "agent-3")
    menu = _menu_of(pilot, "agent-7")
    assert not [action for action in menu.actions() if action.text().startswith("Pick for")]
    menu.close()


def test_the_letter_that_added_a_state_goes_on_picking_it(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    letter = next(choice.key for choice in hand.page.choices if choice.name == "GrabBox")
    hand.act(lambda: hand.key(Qt.Key(ord(letter))))
    hand.hold(1)
    states = hand.automaton.states
    hand.act(lambda: hand.key(Qt.Key(ord(letter))))
    assert hand.automaton.states == states
    assert hand.lesson.waiting == {"agent-3"}
    assert f"or {letter})" in hand.page.buttons["grab-box"].toolTip()
