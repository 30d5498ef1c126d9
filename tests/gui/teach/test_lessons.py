"""Lessons: who is taught, by turns, controllers, tests, and corrections."""

from PySide6.QtCore import Qt

from app.engine.commands import Others
from app.engine.snapshots import Mode
from tests.gui.conftest import PATIENCE
from tests.gui.teach.hand import CONTROL, Hand


def test_an_open_parameter_is_asked_for_and_choosing_it_begins_the_lesson(hand: Hand) -> None:
    hand.show("Goto", "agent-3")
    hand.key(Qt.Key.Key_T)
    choosing = hand.studio.teaching.choosing
    assert choosing.wanted == "X"
    assert hand.studio.mode is Mode.RUNNING
    hand.choose_target(hand.panel.idle.targets, "X", "deposit")
    hand.wait(lambda: hand.studio.mode is Mode.TEACHING)
    assert hand.lesson.plan.arguments == {"X": "deposit"}
    assert hand.page.targets.menus["X"].text() == "deposit"


def test_what_was_taught_another_day_is_tested_without_teaching_it_again(hand: Hand) -> None:
    hand.show("Wander", "agent-3")
    before = hand.studio.document.project
    hand.key(Qt.Key.Key_T, Qt.KeyboardModifier.ShiftModifier)
    hand.wait(lambda: hand.studio.mode is Mode.TESTING)
    hand.hold(2)
    assert {node.path[0][0] for node in hand.snapshot.nodes.values()} == {"wander"}
    assert hand.studio.document.project.examples_of("agent", "wander") == before.examples_of(
        "agent", "wander"
    )


def test_an_open_parameter_is_asked_for_before_a_test_too(hand: Hand) -> None:
    hand.show("Goto", "agent-3")
    hand.key(Qt.Key.Key_T, Qt.KeyboardModifier.ShiftModifier)
    assert hand.studio.teaching.choosing.wanted == "X"
    hand.choose_target(hand.panel.idle.targets, "X", "deposit")
    hand.wait(lambda: hand.studio.mode is Mode.TESTING)


def test_what_a_parameter_means_can_be_changed_in_the_middle_of_a_lesson(hand: Hand) -> None:
    hand.show("Goto", "agent-3")
    hand.key(Qt.Key.Key_T)
    hand.studio.teaching.set_argument("X", "deposit")
    hand.wait(lambda: hand.studio.mode is Mode.TEACHING)
    hand.pick("Forward")
    hand.hold(2)
    hand.act(lambda: hand.studio.teaching.set_argument("X", "nearest visible box"))
    hand.settle()
    assert hand.lesson.plan.arguments == {"X": "nearest visible box"}
    assert hand.studio.teaching.state == "start"
    hand.undo()  # the pick of before is undone as examples
    assert not hand.said
    assert len(hand.examples) == len(hand.studio.document.project.examples_of("agent", "goto"))


def test_ctrl_tab_makes_it_the_next_ones_turn(hand: Hand) -> None:
    hand.teach("Wander", "agent-3", "agent-7")
    followed: list[str] = []
    hand.studio.teaching.follow_requested.connect(followed.append)
    assert hand.studio.teaching.node == "agent-3"
    hand.key(Qt.Key.Key_Tab, CONTROL)
    assert hand.studio.teaching.node == "agent-7"
    assert hand.studio.selection.node == "agent-7"
    hand.wait(lambda: hand.page.turn.accessibleName() == "2 of 2: Agent 7")
    hand.settle()
    hand.pick("RotateLeft")
    assert hand.examples[-1].node == "agent-7"
    hand.key(Qt.Key.Key_Tab, CONTROL)
    assert hand.studio.teaching.node == "agent-3"
    assert followed == ["agent-7", "agent-3"]
    assert set(hand.studio.selection.nodes) == {"agent-3", "agent-7"}


def test_with_several_that_are_taught_tab_goes_on_through_the_window(hand: Hand) -> None:
    hand.teach("Wander", "agent-3", "agent-7")
    hand.window.activateWindow()
    hand.window.canvas.setFocus()
    where = hand.window.canvas
    for key in (Qt.Key.Key_Tab, Qt.Key.Key_Tab, Qt.Key.Key_Backtab):
        before = hand.window.focusWidget()
        hand.qtbot.keyClick(before, key)
        assert hand.window.focusWidget() not in (None, before)
    assert hand.window.focusWidget() is not where
    assert hand.studio.teaching.node == "agent-3"


def test_the_button_for_the_next_agent_says_its_key_the_users_own_included(hand: Hand) -> None:
    hand.window.resize(1900, 1000)
    hand.teach("Wander", "agent-3", "agent-7")
    hand.wait(lambda: hand.page.next.text() == "Next agent (Ctrl+Tab)")
    hand.studio.settings.set_key("teach.next", "Ctrl+J")
    assert hand.page.next.text() == "Next agent (Ctrl+J)"
    hand.key(Qt.Key.Key_J, CONTROL)
    assert hand.studio.teaching.node == "agent-7"


def test_after_undo_it_is_the_turn_of_whose_pick_was_taken_back(hand: Hand) -> None:
    hand.teach("Wander", "agent-3", "agent-7")
    hand.pick("RotateLeft")
    hand.key(Qt.Key.Key_Tab, CONTROL)
    hand.pick("RotateLeft")
    hand.undo()
    assert hand.studio.teaching.node == "agent-7"
    hand.undo()
    assert hand.studio.teaching.node == "agent-3"
    assert hand.page.turn.accessibleName() == "1 of 2: Agent 3"


def test_others_stand_still_or_run_by_a_switch(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.hold(5)
    x = hand.snapshot.columns["x"].copy()
    hand.hold(5)
    assert (hand.snapshot.columns["x"] == x).all()
    hand.act(hand.studio.actions["teach.others"].trigger)
    assert hand.lesson.plan.others is Others.RUN
    hand.hold(5)
    assert (hand.snapshot.columns["x"] != x).any()


def test_a_controller_is_taught_and_its_subsidiaries_obey(hand: Hand) -> None:
    with hand.qtbot.waitSignal(hand.studio.bridge.place_changed, timeout=PATIENCE):
        hand.studio.use_arm("one level")
    hand.teach("ControlForage", "group-1", type_name="group")
    hand.pick("Forage")
    hand.hold(1)
    for agent in range(1, 6):
        assert hand.snapshot.nodes[f"agent-{agent}"].behavior == "Forage"
    assert hand.snapshot.nodes["agent-6"].behavior == ""
    assert "Goto(closest attached agent)" in {choice.name for choice in hand.page.choices if choice.state}


def test_an_arm_with_a_node_of_the_type_is_offered_where_this_one_has_none(hand: Hand) -> None:
    hand.show("ControlForage", type_name="group")
    hand.key(Qt.Key.Key_T)
    bar = hand.window.messages
    assert "no node of type 'group' in the arm 'independent'" in bar.words.text()
    button = next(button for button in bar._answers if button.text() == "Use one level")
    hand.click(button)
    hand.wait(lambda: hand.studio.mode is Mode.TEACHING)
    assert hand.lesson.plan.nodes == ("group-1",)
    assert hand.snapshot.arm == "one level"


def test_a_pick_in_a_test_takes_only_that_node_back_and_records_the_correction(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.test()
    hand.hold(3)
    assert not hand.lesson.taught
    hand.studio.selection.select_nodes(("agent-9",))
    before = len(hand.examples)
    hand.pick("RotateRight")
    assert hand.lesson.taught == {"agent-9"}
    assert len(hand.examples) > before
    hand.hold(1)
    hand.wait(lambda: hand.page.buttons["rotate-right"].ring_color == "teach")


def test_who_was_selected_during_the_lesson_is_corrected_in_its_test(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.studio.selection.select_nodes(("agent-7",))
    assert hand.studio.teaching.node == "agent-3"  # who is taught, whatever is looked at
    hand.test()
    assert hand.studio.teaching.node == "agent-7"
    hand.pick("RotateLeft")
    assert hand.lesson.taught == {"agent-7"}


def test_backspace_mends_the_last_transition_of_a_test(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    assert not hand.studio.actions["teach.mend"].isEnabled()
    hand.test()
    hand.hold(400)
    before = hand.examples
    hand.act(lambda: hand.key(Qt.Key.Key_Backspace))
    (mended,) = hand.examples[len(before) :]
    assert mended.source == mended.label
    assert hand.lesson.taught == {"agent-3"}


def test_teaching_the_same_again_changes_nothing(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    hand.hold(2)
    hand.key(Qt.Key.Key_T)
    hand.settle()
    assert hand.studio.teaching.state == "forward"
    assert hand.acts == 1


def test_for_a_selected_node_of_another_type_it_says_whose_behavior_to_choose(hand: Hand) -> None:
    hand.studio.use_arm("one level")
    hand.wait(lambda: hand.snapshot.arm == "one level")
    hand.show("Wander", "group-3")
    assert hand.panel.idle.words.text().endswith(
        "For Group 3 choose a behavior of type group in the library, or make one."
    )
    hand.show("ControlForage", "group-3", type_name="group")
    assert hand.panel.idle.words.text().startswith("Teach ControlForage to Group 3.")
    hand.show("Wander", "agent-3")
    assert hand.panel.idle.words.text().endswith("Others can be selected in the world.")
