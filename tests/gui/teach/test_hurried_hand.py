"""A hand that waits for nothing: picks, edits, undo and redo cross on their way, and window and session agree in the end."""

import random
from collections.abc import Callable

import pytest
from PySide6.QtWidgets import QApplication

from app.core.edits import note_project, set_note
from app.editor.studio import Studio
from app.engine.commands import Step
from tests.gui.teach.hand import Hand
from tests.gui.teach.test_undoing_picks import same_everywhere

STATES = ("forward", "rotate-left", "rotate-right")


def acts_of(studio: Studio, chance: random.Random) -> list[Callable[[], object]]:
    """What the hand does; picks and undo more often than the rest."""

    def pick() -> None:
        if studio.teaching.lesson is not None:
            studio.teaching.pick(chance.choice(STATES))

    return [
        *4 * [pick],
        *3 * [studio.undo],
        studio.redo,
        studio.redo,
        lambda: studio.document.do(note_project, f"note {chance.random()}"),
        lambda: studio.document.do(set_note, "agent", "wander", f"note {chance.random()}"),
        lambda: studio.bridge.send(Step(2)),
        studio.teaching.test,
        studio.teaching.teach,
        studio.teaching.next_node,
        studio.relearning.learn,
        studio.actions["run.reset"].trigger,
    ]


@pytest.mark.parametrize("seed", range(4))
def test_window_and_session_agree_however_fast_the_hand_is(hand: Hand, seed: int) -> None:
    chance = random.Random(seed)
    before = hand.studio.document.project
    hand.teach("Wander", "agent-3", "agent-5")
    acts = acts_of(hand.studio, chance)
    for _ in range(5):
        for _ in range(15):
            chance.choice(acts)()
            for _ in range(chance.randrange(3)):
                QApplication.processEvents()
        agree(hand)
    history = hand.studio.document.history
    while history.can_undo:
        steps = len(history.steps)
        hand.studio.undo()
        hand.wait(lambda: not hand.studio._undo_ticket)
        assert len(history.steps) < steps, history.undo_text
    agree(hand)
    assert hand.studio.document.project == before


def agree(hand: Hand) -> None:
    """Wait for all answers, and compare."""
    hand.wait(lambda: not hand.studio._undo_ticket and not hand.studio._steps_waiting)
    same_everywhere(hand)
