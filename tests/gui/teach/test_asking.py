"""Ask me: in a test the run stops where a node is not sure, and the answer is an example."""

from math import inf

import pytest
from PySide6.QtCore import QPoint, Qt, QTimer
from pytestqt.qtbot import QtBot

from app.core.edits import add_automaton, add_feature
from app.core.features import Ground, Sense
from app.editor.teach.ask_control import AskControl
from app.editor.window.main_window import MainWindow
from app.engine.snapshots import Asked, Mode
from tests.gui.teach.hand import CONTROL, LEFT, POLL, Hand


@pytest.fixture
def unsure(hand: Hand) -> Hand:
    """A behavior was taught that wavers in Forward, to agent 3, and is tested; agent 3 is selected."""
    document = hand.studio.document
    new_id = document.do(add_automaton, "agent", "Waver")
    document.do(add_feature, "agent", new_id, Sense("IAmAttachedToABox"))
    hand.teach("Waver", "agent-3")
    for name in ("Forward", "RotateLeft", "Forward", "RotateRight", "Forward"):
        hand.pick(name)
        hand.hold(2)
    return hand


def control(window: MainWindow) -> AskControl:
    found = window.toolbar.findChild(AskControl)
    assert isinstance(found, AskControl)
    return found


def switch_on(hand: Hand, below: int) -> None:
    ask = control(hand.window)
    hand.act(lambda: hand.click(ask.switch))
    ask.below.setFocus()
    ask.below.selectAll()
    hand.qtbot.keyClicks(ask.below, str(below))
    hand.qtbot.keyClick(ask.below, Qt.Key.Key_Return)
    hand.settle()


def wait_for_question(hand: Hand) -> None:
    hand.wait(lambda: hand.snapshot.asked is not None)
    hand.settle()


def wait_for_another(hand: Hand, asked: Asked | None, until: float = inf) -> None:
    """Wait for another question, or none, or a tick."""
    hand.wait(lambda: hand.snapshot.asked is not asked or hand.snapshot.tick >= until)
    hand.settle()


def test_a_question_has_room_in_a_small_window(unsure: Hand) -> None:
    unsure.window.resize(1280, 800)
    switch_on(unsure, 100)
    unsure.test()
    unsure.key(Qt.Key.Key_Space)
    wait_for_question(unsure)
    panel, page = unsure.panel, unsure.page
    assert (unsure.window.width(), unsure.window.height()) == (1280, 800)
    unsure.wait(lambda: page.row.y() > page.rows.geometry().bottom())
    assert page.geometry().bottom() <= panel.rect().bottom()
    words = panel.question.words
    assert words.height() >= words.heightForWidth(words.width())
    answers = (*panel.question.buttons, panel.question.let_go)
    unsure.wait(lambda: all(each.visibleRegion().boundingRect() == each.rect() for each in answers))


def test_the_run_stops_and_asks_with_what_it_wavers_between(unsure: Hand) -> None:
    switch_on(unsure, 100)
    unsure.test()
    unsure.key(Qt.Key.Key_Space)
    wait_for_question(unsure)
    words = unsure.panel.question.words.text()
    assert words.startswith("Agent 3 is not sure: Forward")
    assert words.endswith("What should it do?")
    assert {b.text() for b in unsure.panel.question.buttons} == {"Forward", "RotateLeft", "RotateRight"}
    assert unsure.studio.selection.node == "agent-3"
    tick = unsure.snapshot.tick
    unsure.act(lambda: unsure.key(Qt.Key.Key_Period))
    assert unsure.snapshot.tick == tick


def test_an_answer_is_an_example_and_the_run_goes_on(unsure: Hand) -> None:
    switch_on(unsure, 100)
    unsure.test()
    unsure.key(Qt.Key.Key_Space)
    wait_for_question(unsure)
    before, tick = len(unsure.examples), unsure.snapshot.tick
    answer = next(b for b in unsure.panel.question.buttons if b.text() == "RotateLeft")
    unsure.click(answer)
    unsure.wait(lambda: len(unsure.examples) > before)
    unsure.wait(lambda: unsure.snapshot.tick > tick)
    assert unsure.studio.mode is Mode.TESTING
    assert unsure.examples[before].label == "rotate-left"


def test_it_may_decide_by_itself_and_is_not_asked_about_the_same_again(unsure: Hand) -> None:
    switch_on(unsure, 100)
    unsure.test()
    unsure.key(Qt.Key.Key_Space)
    wait_for_question(unsure)
    before, tick = len(unsure.examples), unsure.snapshot.tick
    states = []
    while unsure.snapshot.tick < tick + 60:
        asked = unsure.snapshot.asked
        if asked is not None:
            states.append(asked.state)
            if len(states) % 2:
                unsure.key(Qt.Key.Key_Return, CONTROL)
            else:
                unsure.click(unsure.panel.question.let_go)
        wait_for_another(unsure, asked, tick + 60)
    assert "forward" in states
    assert len(states) == len(set(states))
    assert len(unsure.examples) == before


def test_below_a_probability_that_all_reach_nobody_asks(unsure: Hand) -> None:
    switch_on(unsure, 1)
    unsure.test()
    unsure.hold(10)
    assert unsure.snapshot.asked is None
    assert not unsure.panel.question.isVisible()


def test_switching_off_takes_the_question_away(unsure: Hand) -> None:
    switch_on(unsure, 100)
    unsure.test()
    unsure.key(Qt.Key.Key_Space)
    wait_for_question(unsure)
    unsure.click(control(unsure.window).switch)
    unsure.wait(lambda: unsure.snapshot.asked is None)
    unsure.settle()
    assert not unsure.panel.question.isVisible()


def test_the_node_that_asks_does_not_become_the_only_one_that_is_asked_about(
    unsure: Hand, qtbot: QtBot
) -> None:
    unsure.studio.selection.select_nodes(("agent-3", "agent-4"))
    switch_on(unsure, 100)
    unsure.test()
    unsure.key(Qt.Key.Key_Space)
    asking = set()
    for _ in range(2):
        wait_for_question(unsure)
        assert unsure.snapshot.asked is not None
        asking.add(unsure.snapshot.asked.node)
        asked = unsure.snapshot.asked
        unsure.click(unsure.panel.question.let_go)
        wait_for_another(unsure, asked)
    assert asking == {"agent-3", "agent-4"}


def test_far_from_all_examples_it_asks_and_an_answer_makes_that_familiar(hand: Hand) -> None:
    document = hand.studio.document
    new_id = document.do(add_automaton, "agent", "Roam")
    document.do(add_feature, "agent", new_id, Sense("DistanceTo", {"target": Ground("deposit")}))
    hand.teach("Roam", "agent-3")
    for name in ("Forward", "RotateLeft", "Forward"):  # at last it goes on forward, farther than taught
        hand.pick(name)
        hand.hold(4)
    ask_beyond(hand, "1.5")
    hand.test()
    hand.key(Qt.Key.Key_Space)
    wait_for_question(hand)
    asked = hand.snapshot.asked
    assert asked is not None
    assert asked.distance > 1.5
    assert hand.panel.question.words.text().startswith("Agent 3 has seen nothing like this; it would do: ")
    known = len(hand.examples)
    hand.act(lambda: hand.click(hand.panel.question.buttons[0]))
    assert len(hand.examples) > known
    assert hand.studio.mode is Mode.TESTING
    assert hand.snapshot.asked is None or hand.snapshot.asked.values != asked.values


def test_another_project_asks_nothing_until_it_is_wished_for_there(hand: Hand) -> None:
    ask, studio = control(hand.window), hand.studio
    ask_beyond(hand, "1.5")
    hand.act(lambda: hand.click(ask.switch))
    switch_on(hand, 80)
    assert ask.switch.isChecked()
    project, scenario, folder = studio.document.project, studio.document.scenario, studio.document.folder
    studio.actions["file.close"].trigger()
    hand.wait(lambda: not studio.is_open)
    studio.open(project, scenario, folder)
    hand.wait(lambda: studio.snapshot is not None)
    hand.settle()
    assert not ask.switch.isChecked()
    assert (ask.unsure.isChecked(), ask.unknown.isChecked()) == (True, False)
    assert (ask.below.value(), ask.beyond.value()) == (60, 0.5)
    assert (studio.teaching.asking.below, studio.teaching.asking.beyond) == (0.6, None)


def ask_beyond(hand: Hand, distance: str) -> None:
    """Ask by distance alone, as set in the menu beside the switch."""
    ask = control(hand.window)

    def choose() -> None:
        if not ask.more.menu().isVisible():
            QTimer.singleShot(POLL, choose)
            return
        for box in (ask.unsure, ask.unknown):
            hand.qtbot.mouseClick(box, LEFT, pos=QPoint(8, box.height() // 2))
        ask.beyond.setFocus()
        ask.beyond.selectAll()
        hand.qtbot.keyClicks(ask.beyond, distance)
        hand.qtbot.keyClick(ask.beyond, Qt.Key.Key_Tab)
        hand.qtbot.keyClick(ask.more.menu(), Qt.Key.Key_Escape)

    QTimer.singleShot(POLL, choose)  # an open menu waits inside the click that opened it
    hand.click(ask.more)
    hand.window.activateWindow()  # as a window manager does when a menu closes
    hand.wait(hand.window.isActiveWindow)
    assert not ask.more.menu().isVisible()
    assert (ask.unsure.isChecked(), ask.unknown.isChecked()) == (False, True)
    hand.act(lambda: hand.click(ask.switch))
