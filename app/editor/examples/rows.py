"""What can be done with examples."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..actions import ActionRow, When, needs

if TYPE_CHECKING:
    from ..studio import Studio
    from .panel import ExamplesPanel


NONE_CHOSEN = "select examples first"


def example_rows(panel: ExamplesPanel) -> tuple[ActionRow, ...]:
    """The actions."""

    @needs(NONE_CHOSEN)
    def chosen(_studio: Studio) -> bool:
        return bool(panel.chosen)

    return (
        ActionRow(
            "examples.disable",
            "Do not learn from examples",
            "Behavior",
            lambda _: panel.switch(on=False),
            "examples",
            "Ctrl+Backspace",
            "Keep the selected examples, but do not learn from them",
            "circle-off-outline",
            When(lambda _: panel.has_chosen(on=True), "select examples that are learned from"),
        ),
        ActionRow(
            "examples.enable",
            "Learn from examples again",
            "Behavior",
            lambda _: panel.switch(on=True),
            "examples",
            "Ctrl+Shift+Backspace",
            "Learn from the selected examples again",
            "check",
            When(lambda _: panel.has_chosen(on=False), "select examples that are not learned from"),
        ),
        ActionRow(
            "examples.relabel",
            "Relabel examples…",
            "Behavior",
            lambda _: panel.relabel(),
            "examples",
            "Ctrl+Alt+L",
            "Let the selected examples say something else",
            "label-outline",
            chosen,
        ),
        ActionRow(
            "examples.weigh",
            "Weight of examples…",
            "Behavior",
            lambda _: panel.weigh(),
            "examples",
            tip="Let the selected examples count more or less",
            icon="weight",
            enabled=chosen,
        ),
        ActionRow(
            "examples.moment",
            "Show the moment of the example",
            "Behavior",
            lambda _: panel.show_moment(),
            "examples",
            "Ctrl+M",
            "Show on the canvas when the selected example was recorded",
            "history",
            When(lambda _: panel.has_moment, "select one example, of which the moment is known"),
        ),
        ActionRow(
            "examples.conflicts",
            "Show examples in conflict",
            "Behavior",
            lambda _: panel.show_conflicts(),
            "examples",
            tip="Show only examples of the behavior that contradict each other: equal features, another label",
            icon="swap-horizontal-bold",
            enabled=When(lambda _: panel.model.subject is not None, "choose a behavior in the library first"),
        ),
    )
