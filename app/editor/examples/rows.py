"""What can be done with examples."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..actions import ActionRow, when_open

if TYPE_CHECKING:
    from ..studio import Studio
    from .panel import ExamplesPanel


def example_rows(panel: ExamplesPanel) -> tuple[ActionRow, ...]:
    """The actions."""

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
            chosen,
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
            chosen,
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
            chosen,
        ),
        ActionRow(
            "examples.conflicts",
            "Show examples in conflict",
            "Behavior",
            lambda _: panel.show_conflicts(),
            "examples",
            tip="Show only examples of the behavior that contradict each other: equal features, another label",
            icon="swap-horizontal-bold",
            enabled=when_open,
        ),
    )
