"""What can be done with the decision tree."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..actions import ActionRow

if TYPE_CHECKING:
    from ..studio import Studio
    from .panel import TreePanel


def tree_rows(panel: TreePanel) -> tuple[ActionRow, ...]:
    """Looking at the tree."""

    def has_tree(_studio: Studio) -> bool:
        return panel.subject is not None and panel.subject.tree is not None

    return (
        ActionRow(
            "tree.fit",
            "Fit the decision tree in",
            "",
            lambda _: panel.view.fit(),
            icon="fit-to-page-outline",
            tip="Show the whole decision tree; the wheel zooms",
            enabled=has_tree,
        ),
    )
