"""What is clicked too late, deleted too early, or ended in between has an answer in the window."""

from PySide6.QtCore import Qt

from app.core.edits import add_automaton, delete_automaton, drop_feature, remove_state
from app.engine.commands import Pick
from app.engine.snapshots import Mode
from tests.gui.conftest import PATIENCE
from tests.gui.teach.hand import Hand


def test_a_click_on_what_no_target_means_says_so_and_asks_again(hand: Hand) -> None:
    hand.show("Goto", "agent-3")
    hand.key(Qt.Key.Key_T)
    choosing = hand.studio.teaching.choosing
    hand.wait(lambda: "agent-3" in hand.snapshot.watched)
    agent = hand.snapshot.place.spans["agent"].start + 8
    choosing.entity_chosen(agent)
    assert "Agent 3 has no target that is Agent 9 now" in hand.said[-1]
    assert "deposit" in hand.said[-1]
    assert choosing.wanted == "X"
    choosing.entity_chosen(hand.snapshot.place.spans["deposit"].start)
    hand.wait(lambda: hand.studio.mode is Mode.TEACHING)
    assert hand.lesson.plan.arguments == {"X": "deposit"}


def test_a_click_on_a_target_that_is_gone_by_then_is_answered(hand: Hand) -> None:
    hand.show("Goto", "agent-3")
    hand.key(Qt.Key.Key_T)
    hand.wait(lambda: "agent-3" in hand.snapshot.watched)
    with hand.qtbot.waitSignal(hand.studio.bridge.place_changed, timeout=PATIENCE):
        hand.studio.use_arm("one level")
    hand.settle()
    choosing = hand.studio.teaching.choosing
    choosing.entity_chosen(10_000)
    assert "has no target that is nothing now" in hand.said[-1] or not choosing.is_busy


def test_a_pick_for_a_node_that_another_arm_does_not_have_is_refused_in_words(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    with hand.qtbot.waitSignal(hand.studio.bridge.place_changed, timeout=PATIENCE):
        hand.studio.use_arm("one level, authored")
    hand.studio.bridge.send(Pick("agent-3", "forward"))
    hand.settle()
    assert any("nothing is being taught" in said for said in hand.said)
    hand.studio.teaching.pick("forward")
    assert "nobody is taught now" in hand.said[-1]
    assert hand.panel.idle.isVisible()


def test_deleting_what_is_taught_ends_the_lesson_and_says_so(hand: Hand) -> None:
    document = hand.studio.document
    new_id = document.do(add_automaton, "agent", "Spare")
    hand.teach("Spare", "agent-3")
    hand.pick("GrabBox")
    hand.act(lambda: document.do(delete_automaton, "agent", new_id))
    hand.wait(lambda: hand.studio.mode is Mode.RUNNING)
    assert any("the lesson is over" in said for said in hand.said)
    assert hand.panel.idle.isVisible()
    document.undo()
    hand.teach("Spare", "agent-3")
    assert hand.page.isVisible()
    assert "grab-box" in hand.page.buttons


def test_agents_go_on_once_undo_brings_back_what_they_did(hand: Hand) -> None:
    hand.hold(3)
    before = hand.snapshot.nodes["agent-3"]
    assert before.behavior == "Forage"
    hand.act(lambda: hand.studio.document.do(delete_automaton, "agent", "forage", "wander"))
    assert any("is gone, so they begin with Wander" in said for said in hand.said)
    hand.wait(lambda: hand.snapshot.nodes["agent-3"].behavior == "Wander")
    hand.act(hand.undo)
    hand.wait(lambda: hand.snapshot.nodes["agent-3"] == before)


def test_deleting_the_state_that_was_just_picked_is_said(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.pick("RotateLeft")
    hand.act(lambda: hand.studio.document.do(remove_state, "agent", "wander", "rotate-left"))
    assert any("what was picked for Agent 3 is not done" in said for said in hand.said)
    assert "rotate-left" not in hand.page.buttons
    assert hand.studio.mode is Mode.TEACHING


def test_a_lesson_can_be_ended_in_the_middle_of_learning(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    hand.key(Qt.Key.Key_T, Qt.KeyboardModifier.ShiftModifier)
    hand.studio.teaching.stop()
    hand.settle()
    assert hand.studio.mode is Mode.RUNNING
    assert hand.panel.idle.isVisible()
    hand.hold(3)


def test_an_edit_in_the_middle_of_learning_is_learned_from_as_well(hand: Hand) -> None:
    hand.teach("Forage", "agent-3")
    hand.pick("Wander")
    hand.hold(1)
    hand.key(Qt.Key.Key_T, Qt.KeyboardModifier.ShiftModifier)
    hand.studio.document.do(drop_feature, "agent", "forage", "done")
    hand.wait(lambda: hand.studio.mode is Mode.TESTING)
    hand.settle()
    assert [use.id for use in hand.automaton.features] == ["sees"]
    hand.hold(2)


def test_closing_the_project_in_a_lesson_leaves_an_empty_panel(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    hand.studio.close_project()
    assert hand.studio.teaching.lesson is None
    assert hand.panel.idle.teach.isEnabled() is False or not hand.studio.is_open


def test_without_a_behavior_there_is_a_sentence_instead_of_a_lesson(hand: Hand) -> None:
    hand.studio.selection.select_behavior(None)
    hand.settle()
    hand.key(Qt.Key.Key_T)
    assert "choose a behavior to teach in the library" in hand.said[-1]
    assert hand.panel.idle.words.text().startswith("Choose a behavior to teach in the library")
