"""The teach panel: what can be picked, by clicks and keys, and what a pick does."""

from PySide6.QtCore import Qt, QTimer

from app.core.automaton import Basic, Nested
from app.core.edits import add_automaton, add_feature
from app.core.features import Ground, Sense
from app.editor.teach.button import Ring
from app.engine.snapshots import Mode
from tests.gui.teach.hand import Hand


def test_before_a_lesson_the_panel_says_what_teaching_would_be_about(hand: Hand) -> None:
    hand.show("Wander", "agent-3", "agent-7")
    assert "Teach Wander to Agent 3, Agent 7." in hand.panel.idle.words.text()
    hand.act(lambda: hand.click(hand.panel.idle.teach))
    assert hand.lesson.plan.nodes == ("agent-3", "agent-7")
    assert hand.window.docks["teach"].windowTitle() == "Teaching Wander to Agent 3"


def test_without_a_selection_the_first_node_of_the_type_is_taught(hand: Hand) -> None:
    hand.teach("Wander")
    assert hand.lesson.plan.nodes == ("agent-1",)
    assert hand.studio.selection.nodes == ("agent-1",)


def test_states_have_digits_and_what_raises_a_flag_has_a_letter(hand: Hand) -> None:
    hand.teach("ReturnWithBox", "agent-6")
    keys = {choice.name: choice.key for choice in hand.page.choices if choice.state}
    assert keys == {
        "Goto(nearest visible box)": "1",
        "GrabBox": "2",
        "Goto(deposit)": "3",
        "ReleaseBoxAndFinish": keys["ReleaseBoxAndFinish"],
        "Done": "D",
    }
    assert keys["ReleaseBoxAndFinish"].isalpha()
    assert len({choice.key for choice in hand.page.choices}) == len(hand.page.choices)
    assert "T" not in {choice.key for choice in hand.page.choices}


def test_a_pick_is_carried_out_in_the_next_tick(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    button = hand.page.buttons["rotate-left"]
    hand.act(lambda: hand.click(button))
    assert hand.lesson.waiting == {"agent-3"}
    assert (button.ring, button.ring_color) == (Ring.NEXT, "teach")
    hand.hold(1)
    assert hand.studio.teaching.state == "rotate-left"
    hand.wait(lambda: button.ring is Ring.NOW)
    assert not hand.lesson.waiting


def test_a_digit_picks_a_state_and_a_letter_adds_one(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.act(lambda: hand.key(Qt.Key.Key_2))
    hand.hold(1)
    assert hand.studio.teaching.state == "rotate-left"
    letter = next(choice.key for choice in hand.page.choices if choice.name == "GrabBox")
    hand.act(lambda: hand.key(Qt.Key(ord(letter))))
    assert hand.automaton.states[-1].content == Basic("GrabBox")
    assert hand.page.buttons["grab-box"].isVisible()


def test_the_example_is_said_in_words_and_counted(hand: Hand) -> None:
    hand.teach("Forage", "agent-3")
    before = len(hand.examples)
    hand.pick("Wander")
    hand.hold(3)
    hand.pick("ReturnWithBox")
    assert len(hand.examples) == before + 4
    assert hand.page.badge.text() == f"{before + 4} examples · kept"
    assert hand.page.last.text.startswith("Last: Wander → ReturnWithBox when it sees ")
    counted = sum(example.label == "return-with-box" for example in hand.examples)
    assert hand.page.buttons["return-with-box"]._caption == f"{counted} examples"


def test_a_state_that_raises_a_flag_is_a_state_like_the_others_and_counted(hand: Hand) -> None:
    hand.show("Goto", "agent-3")
    hand.key(Qt.Key.Key_T)
    hand.choose_target(hand.panel.idle.targets, "X", "deposit")
    hand.wait(lambda: hand.studio.mode is Mode.TEACHING and bool(hand.page.buttons))
    counted = sum(example.label == "done" for example in hand.examples)
    assert hand.page.buttons["done"]._caption == f"{counted} examples"
    assert "in Start now" in hand.page.buttons["done"].toolTip()
    hand.pick("Forward")
    hand.hold(1)
    hand.wait(lambda: "in Start now" not in hand.page.buttons["done"].toolTip())
    assert not hand.page.buttons["done"]._ghost


def test_only_what_makes_no_circle_is_offered(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    offered = {choice.name for choice in hand.page.choices if not choice.state}
    assert "Forage" not in offered  # it holds Wander
    assert "Goto" in offered


def test_whatever_can_be_added_is_found_by_name(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.click(hand.page.add)
    hand.qtbot.keyClicks(hand.page.list.search, "grab")
    assert hand.page.list.list.count() == 2  # and a flag of that name
    hand.act(lambda: hand.qtbot.keyClick(hand.page.list.search, Qt.Key.Key_Return))
    assert hand.automaton.states[-1].content == Basic("GrabBox")
    assert not hand.page.list.isVisible()


def test_a_behavior_with_a_slot_asks_for_its_target_and_is_picked_then(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    goto = next(choice for choice in hand.page.choices if choice.name == "Goto")
    hand.key(Qt.Key(ord(goto.key)))
    row = hand.page.targets
    assert hand.acts == 0
    menu = row.menus["X"].menu()
    told: list[str] = []
    menu.aboutToShow.connect(lambda: told.extend(action.text() for action in menu.actions()))
    hand.act(lambda: hand.choose_target(row, "X", "deposit"))
    assert "deposit" in told
    assert told[0].startswith("nearest visible box   (")
    assert hand.automaton.states[-1].content == Nested("goto", {"X": Ground("deposit")})
    assert hand.acts == 1


def test_a_target_is_chosen_by_keys_alone_and_keys_pick_on_then(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    goto = next(choice for choice in hand.page.choices if choice.name == "Goto")
    hand.key(Qt.Key(ord(goto.key)))
    chooser = hand.page.targets.menus["X"]
    assert chooser.hasFocus()
    menu = chooser.menu()

    def choose_first() -> None:
        hand.qtbot.keyClick(menu, Qt.Key.Key_Down)
        hand.qtbot.keyClick(menu, Qt.Key.Key_Return)

    menu.aboutToShow.connect(lambda: QTimer.singleShot(0, menu, choose_first))
    hand.act(lambda: hand.qtbot.keyClick(chooser, Qt.Key.Key_Return))
    assert hand.automaton.states[-1].content == Nested("goto", {"X": Ground("nearest visible box")})
    hand.window.activateWindow()  # without a screen, nobody gives the keys back once a menu has closed
    hand.wait(hand.window.hasFocus)
    hand.act(lambda: hand.key(Qt.Key.Key_1))
    assert hand.acts == 1  # the second replaces the first, which no tick has carried out


def test_escape_gives_up_a_target_first_and_ends_the_lesson_then(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    goto = next(choice for choice in hand.page.choices if choice.name == "Goto")
    hand.page.choose(goto)
    hand.settle()
    hand.key(Qt.Key.Key_Escape)
    assert not hand.studio.teaching.choosing.is_busy
    assert hand.studio.mode is Mode.TEACHING
    hand.act(lambda: hand.key(Qt.Key.Key_Escape))
    hand.wait(lambda: hand.studio.mode is Mode.RUNNING)


def test_no_target_is_asked_for_once_the_lesson_has_ended_with_another_arm(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.page.choose(next(choice for choice in hand.page.choices if choice.name == "Goto"))
    hand.settle()
    assert hand.studio.teaching.choosing.is_busy
    hand.act(lambda: hand.studio.use_arm("one level"))
    hand.wait(lambda: hand.studio.mode is Mode.RUNNING)
    assert not hand.studio.teaching.choosing.is_busy


def test_a_pick_can_step_on_while_time_stands_still(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.studio.actions["teach.steps_on"].trigger()
    hand.pick("Forward")
    hand.wait(lambda: hand.snapshot.tick == 1)
    assert hand.studio.teaching.state == "forward"


def test_examples_are_filed_under_the_name_of_the_demonstration(hand: Hand) -> None:
    hand.show("Wander", "agent-3")
    field = hand.panel.idle.filed
    field.setFocus()
    hand.qtbot.keyClicks(field, "zigzag")
    hand.qtbot.keyClick(field, Qt.Key.Key_Return)
    hand.act(lambda: hand.click(hand.panel.idle.teach))
    hand.pick("Forward")
    assert hand.examples[-1].demonstration == "zigzag"


def test_a_lesson_without_a_name_gets_one_of_its_own(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    assert hand.examples[-1].demonstration == "wander-2"  # wander-1 is stored in the project


def test_a_behavior_without_states_shows_all_that_it_could_do(hand: Hand) -> None:
    document = hand.studio.document
    new_id = document.do(add_automaton, "agent", "Blank")
    document.do(add_feature, "agent", new_id, Sense("ICanSeeABox"))
    hand.teach("Blank", "agent-3")
    assert hand.page.new["Wander"].isVisible()
    hand.act(lambda: hand.click(hand.page.new["Wander"]))
    assert hand.automaton.states[-1].content == Nested("wander")


def test_what_a_controller_directs_has_its_own_color_on_the_button_too(hand: Hand) -> None:
    with hand.qtbot.waitSignal(hand.studio.bridge.place_changed):
        hand.studio.use_arm("one level")
    hand.teach("ControlForage", "group-1", type_name="group")
    colors = {button.text(): button.color for button in hand.all_buttons}
    assert colors["Forage"] == hand.studio.colors.color("agent", "forage")
    assert colors["ReturnWithBox"] == hand.studio.colors.color("agent", "return-with-box")
    assert colors["ReleaseBox"] == hand.studio.colors.color("agent", "")


def test_buttons_stay_where_they_are_while_what_they_pick_becomes_a_state(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")

    def stand() -> list[str]:
        """What can be picked, from left to right and from above."""
        seen = [(button.y(), button.x(), button.text()) for button in hand.all_buttons if button.isVisible()]
        return [name for _, _, name in sorted(seen)]

    before = stand()
    at = before.index("GrabBox")
    hand.act(lambda: hand.click(hand.page.new["GrabBox"]))
    hand.wait(lambda: "GrabBox" not in hand.page.new)
    assert stand()[: at + 1] == before[: at + 1]
    hand.undo()
    hand.wait(lambda: "GrabBox" in hand.page.new)
    assert stand()[: at + 1] == before[: at + 1]
