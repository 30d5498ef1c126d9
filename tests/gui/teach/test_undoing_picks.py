"""Picks are taken back one by one, whatever happened in between."""

import random
from dataclasses import replace

import pytest
from PySide6.QtCore import Qt

from app.core.edits import note_project, set_note
from app.engine.scenarios import open_scenario
from app.engine.session import Session
from app.engine.snapshots import Mode
from tests.gui.conftest import PATIENCE, said
from tests.gui.teach.hand import CONTROL, SHIFT, Hand


def session_of(hand: Hand) -> Session:
    engine = hand.studio.bridge._engine
    assert engine is not None
    session = engine._session
    assert session is not None
    return session


def same_everywhere(hand: Hand) -> None:
    # At once: what is learned in a lesson changes the session's project before the window hears of it.
    hand.wait(lambda: hand.is_answered and hand.studio.mode is not Mode.LEARNING)
    assert session_of(hand).project == hand.studio.document.project


def test_every_pick_is_taken_back_by_itself_and_the_node_put_back(hand: Hand) -> None:
    before = hand.studio.document.project
    hand.teach("Wander", "agent-3")
    states = []
    for name in ("Forward", "RotateLeft", "Forward"):
        states.append((hand.studio.teaching.state, len(hand.examples)))
        hand.pick(name)
        hand.hold(2)
    for state, examples in reversed(states):
        hand.undo()
        assert (hand.studio.teaching.state, len(hand.examples)) == (state, examples)
        same_everywhere(hand)
    assert hand.studio.document.project is before


def test_so_it_is_where_the_window_has_so_much_to_do_that_each_event_has_a_turn_of_its_own(
    hand: Hand, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.editor.turn.is_long", lambda: True)
    before = hand.studio.document.project
    hand.teach("Wander", "agent-3")
    for name in ("Forward", "RotateLeft"):
        hand.pick(name)
        hand.hold(2)
    for _ in range(2):
        hand.undo()
        same_everywhere(hand)
    assert hand.studio.document.project is before


def test_a_state_that_a_pick_added_goes_with_it(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    before = hand.automaton.states
    hand.pick("GrabBox")
    hand.hold(1)
    hand.undo()
    assert hand.automaton.states == before
    assert hand.studio.teaching.state == "start"


def test_undo_three_times_in_a_row_takes_back_three_picks(hand: Hand) -> None:
    before = hand.studio.document.project
    hand.teach("Wander", "agent-3")
    for name in ("Forward", "RotateLeft", "Forward"):
        hand.pick(name)
        hand.hold(1)
    for _ in range(3):
        hand.key(Qt.Key.Key_Z, CONTROL)
    hand.wait(lambda: hand.studio.document.project is before)
    same_everywhere(hand)


def test_a_pick_of_a_lesson_that_is_over_is_undone_without_a_word(hand: Hand) -> None:
    before = hand.studio.document.project
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    hand.act(lambda: hand.key(Qt.Key.Key_Escape))
    hand.undo()
    assert hand.studio.document.project is before
    assert not hand.said
    same_everywhere(hand)


def test_redo_brings_the_examples_back(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    taught = hand.examples
    hand.undo()
    hand.act(lambda: hand.key(Qt.Key.Key_Z, CONTROL | SHIFT))
    assert hand.examples == taught
    same_everywhere(hand)


def recorded(hand: Hand) -> object:
    """What picks have made of the project; what is learned from them may come at any time."""
    project = hand.studio.document.project
    return project.examples, project.demonstrations


def test_redo_lets_the_node_do_again_what_the_pick_had_it_do(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    hand.hold(1)
    hand.pick("RotateLeft")
    hand.hold(1)
    after = recorded(hand)
    for state in ("forward", "start"):
        hand.undo()
        assert hand.studio.teaching.state == state
    for state in ("forward", "rotate-left"):
        hand.act(lambda: hand.key(Qt.Key.Key_Z, CONTROL | SHIFT))
        hand.wait(lambda: hand.studio.teaching.state == state)  # noqa: B023 - called at once
        same_everywhere(hand)
    assert recorded(hand) == after
    assert hand.lesson.acts == 2


def test_a_lesson_whose_pick_was_taken_back_and_done_again_is_still_kept(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    hand.hold(2)
    hand.pick("RotateLeft")
    kept = hand.studio.document.project.demonstrations
    hand.undo()
    hand.act(lambda: hand.key(Qt.Key.Key_Z, CONTROL | SHIFT))
    same_everywhere(hand)
    assert hand.studio.document.project.demonstrations == kept
    assert hand.lesson.obstacle == ""


def test_keys_for_undo_and_redo_in_a_hurry_are_obeyed_in_their_order(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    for name in ("Forward", "RotateLeft"):
        hand.pick(name)
        hand.hold(1)
    after = recorded(hand)
    for keys in (CONTROL, CONTROL, CONTROL | SHIFT, CONTROL | SHIFT):
        hand.key(Qt.Key.Key_Z, keys)
    hand.wait(lambda: recorded(hand) == after and hand.studio.teaching.state == "rotate-left")
    same_everywhere(hand)


def test_redo_of_a_pick_of_a_lesson_that_is_over_brings_its_examples_back(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    after = recorded(hand)
    hand.undo()
    hand.act(lambda: hand.key(Qt.Key.Key_Escape))
    hand.key(Qt.Key.Key_Z, CONTROL | SHIFT)
    hand.wait(lambda: recorded(hand) == after)
    assert not hand.said
    same_everywhere(hand)


def test_what_undo_would_do_is_said(hand: Hand) -> None:
    hand.teach("Wander", "agent-3")
    hand.pick("RotateLeft")
    assert said(hand.studio.actions["edit.undo"]) == f"Undo: {hand.studio.document.history.undo_text}"
    assert "Pick" in hand.studio.document.history.undo_text


@pytest.mark.parametrize("seed", range(4))
def test_all_is_undone_whatever_came_between(hand: Hand, seed: int) -> None:
    choose = random.Random(seed)
    before = hand.studio.document.project
    hand.teach("Wander", "agent-3", "agent-5")
    acts = [
        pick,
        pick,
        pick,
        two_picks_in_one_tick,
        edit,
        edit_what_is_taught,
        test,
        reset,
        undo,
        undo,
        redo,
        teach_again,
        next_node,
        mend,
        end_and_teach_again,
        other_arm,
    ]
    for _ in range(24):
        choose.choice(acts)(hand, choose)
        same_everywhere(hand)
    while hand.studio.document.history.can_undo:
        hand.undo()
        same_everywhere(hand)
    assert hand.studio.document.project is before


def pick(hand: Hand, choose: random.Random) -> None:
    state = choose.choice(("forward", "rotate-left", "rotate-right"))
    if hand.studio.teaching.lesson is not None:
        hand.studio.teaching.pick(state)
        hand.settle()
        if hand.snapshot.asked is None:
            hand.hold(choose.randint(0, 2))


def two_picks_in_one_tick(hand: Hand, _choose: random.Random) -> None:
    if hand.studio.teaching.lesson is not None:
        hand.studio.teaching.pick("forward")
        hand.studio.teaching.pick("rotate-left")


def edit(hand: Hand, choose: random.Random) -> None:
    hand.studio.document.do(note_project, f"note {choose.random()}")


def edit_what_is_taught(hand: Hand, choose: random.Random) -> None:
    hand.studio.document.do(set_note, "agent", "wander", f"note {choose.random()}")


def test(hand: Hand, _choose: random.Random) -> None:
    if hand.studio.teaching.lesson is not None:
        hand.studio.teaching.test()
        hand.wait(lambda: hand.studio.mode != "learning")


test.__test__ = False  # type: ignore[attr-defined]  # it is something the hand does


def reset(hand: Hand, _choose: random.Random) -> None:
    hand.studio.actions["run.reset"].trigger()


def undo(hand: Hand, _choose: random.Random) -> None:
    if hand.studio.document.history.can_undo:
        hand.studio.undo()
        hand.wait(lambda: not hand.studio._undo_ticket)


def redo(hand: Hand, _choose: random.Random) -> None:
    hand.studio.redo()
    hand.wait(lambda: not hand.studio._undo_ticket)


def teach_again(hand: Hand, _choose: random.Random) -> None:
    hand.studio.teaching.teach()


def next_node(hand: Hand, _choose: random.Random) -> None:
    hand.studio.teaching.next_node()


def mend(hand: Hand, _choose: random.Random) -> None:
    if hand.studio.teaching.can_mend:
        hand.studio.teaching.should_not_have_left()


def end_and_teach_again(hand: Hand, _choose: random.Random) -> None:
    hand.studio.teaching.stop()
    hand.settle()
    hand.studio.teaching.teach()


def other_arm(hand: Hand, choose: random.Random) -> None:
    with hand.qtbot.waitSignal(hand.studio.bridge.place_changed, timeout=PATIENCE):
        hand.studio.use_arm(choose.choice(("independent", "one level")))
    hand.settle()
    hand.studio.teaching.teach()


def test_what_was_asked_of_a_session_that_was_closed_holds_up_no_other_project(hand: Hand) -> None:
    studio, foraging = hand.studio, hand.studio.document.project
    hand.teach("Wander", "agent-3")
    hand.pick("Forward")
    studio.actions["edit.undo"].trigger()
    studio.close_project()  # before the session has answered
    assert not studio.can_redo
    studio.open(replace(foraging, arms=()), open_scenario(foraging), None)  # in which no session begins
    studio.document.do(note_project, "another one")
    hand.wait(studio.actions["edit.undo"].isEnabled)
    studio.actions["edit.undo"].trigger()
    assert studio.document.project.note == foraging.note
