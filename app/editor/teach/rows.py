"""What the teach panel can do, as rows of the table of actions."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ...engine.commands import Others
from ..actions import ActionRow, When, needs, when_open

if TYPE_CHECKING:
    from ..studio import Studio


@needs("teach several nodes: select them, and choose Teach")
def _several(studio: Studio) -> bool:
    return studio.teaching.is_teaching and len(studio.teaching.nodes) > 1


@needs("nobody asks: switch on Ask me, and test what was taught")
def _is_asked(studio: Studio) -> bool:
    return studio.teaching.asking.asked is not None


def _switch_others(studio: Studio) -> None:
    run = studio.teaching.others is Others.RUN
    studio.teaching.set_others(Others.IDLE if run else Others.RUN)


def teach_panel_rows() -> tuple[ActionRow, ...]:
    """Picking's companions: mending, whose turn it is, and how lessons go."""
    return (
        ActionRow(
            "teach.mend",
            "Should not have left",
            "Teach",
            lambda studio: studio.teaching.should_not_have_left(),
            "lesson",
            "Backspace",
            "Teach the node that it should have stayed in the state that it left by itself last",
            "undo-variant",
            When(lambda studio: studio.teaching.can_mend, "test what was taught first"),
        ),
        ActionRow(
            "teach.next",
            "Next agent",
            "Teach",
            lambda studio: studio.teaching.next_node(),
            "lesson",
            "Ctrl+Tab",
            "It is the next one's turn among those that are taught",
            "account-arrow-right-outline",
            _several,
        ),
        ActionRow(
            "teach.others",
            "Others run meanwhile",
            "Teach",
            _switch_others,
            "switches",
            tip="Let nodes that are not taught run what they run, instead of standing still; a lesson begins again from Start",
            enabled=when_open,
            checked=lambda studio: studio.teaching.others is Others.RUN,
        ),
        ActionRow(
            "teach.steps_on",
            "A pick steps on",
            "Teach",
            lambda studio: studio.teaching.set_steps_on(on=not studio.teaching.steps_on),
            "switches",
            tip="While time stands still, let a pick pass the tick that carries it out",
            enabled=when_open,
            checked=lambda studio: studio.teaching.steps_on,
        ),
        ActionRow(
            "teach.keep",
            "Keep as demonstration",
            "Teach",
            lambda studio: studio.teaching.keeping.set_on(on=not studio.teaching.keeping.on),
            "switches",
            tip="Keep what your hand does in a lesson as a demonstration, which can be played again",
            enabled=when_open,
            checked=lambda studio: studio.teaching.keeping.on,
        ),
        ActionRow(
            "teach.ask",
            "Ask me",
            "Teach",
            lambda studio: studio.teaching.asking.toggle(),
            "ask",
            tip="In a test, stop and ask before a selected node does what it is not sure of; the answer is an example",
            icon="help-circle-outline",
            enabled=when_open,
            checked=lambda studio: studio.teaching.asking.on,
        ),
        ActionRow(
            "teach.let_go",
            "It may decide",
            "Teach",
            lambda studio: studio.teaching.asking.let_go(),
            "ask",
            "Ctrl+Return",
            "Let the node that asks decide by itself, here and wherever the same decides again in this test",
            "play-outline",
            _is_asked,
        ),
    )
