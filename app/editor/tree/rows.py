"""What can be done with the decision tree."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..actions import ActionRow, When, needs

if TYPE_CHECKING:
    from ..studio import Studio
    from .panel import TreePanel

TOOLS = (
    (
        "histogram",
        "Histogram of the node",
        "The examples at the selected node, and the cut of its test",
        "cut",
    ),
    ("prunes", "Prunes and moved cuts", "List them all, and take them back", "prunes"),
    ("confidence", "Pruning confidence", "How strongly trees are pruned after learning", "confidence"),
)


def tree_rows(panel: TreePanel) -> tuple[ActionRow, ...]:
    """Looking at the tree."""

    @needs("choose a state that has learned a decision tree, and show the panel Decision tree")
    def has_tree(studio: Studio) -> bool:
        return shows(studio) and panel.subject is not None and panel.subject.tree is not None

    @needs("choose a behavior in the library, and show the panel Decision tree")
    def shows(_studio: Studio) -> bool:
        return panel.subject is not None and panel.isVisible()

    @needs("select a node of the decision tree first")
    def has_node(studio: Studio) -> bool:
        return has_tree(studio) and bool(panel.scene.chosen)

    @needs("select a node of the decision tree at which something is pruned")
    def has_prunes(studio: Studio) -> bool:
        subject = panel.subject
        return has_node(studio) and subject is not None and bool(subject.prunes_at(panel.scene.chosen))

    return (
        ActionRow(
            "tree.follow",
            "Follow the selected in the tree",
            "Behavior",
            lambda _: panel.following.switch(on=not panel.following.on),
            "tree",
            tip="Turn the decision tree to the state that the selected agent is in; choosing a state or a node stops that",
            icon="crosshairs",
            enabled=shows,
            checked=lambda _: panel.following.on,
        ),
        ActionRow(
            "tree.fit",
            "Fit the decision tree in",
            "",
            lambda _: panel.view.fit_whole(),
            icon="fit-to-page-outline",
            tip="Show the whole decision tree; the wheel zooms",
            enabled=has_tree,
        ),
        ActionRow(
            "tree.prune",
            "Prune the leaf or subtree",
            "Behavior",
            lambda _: panel.prune(),
            "tree",
            tip="Forbid all transitions at the selected node of the decision tree; Delete in the tree does the same",
            icon="content-cut",
            enabled=has_node,
        ),
        ActionRow(
            "tree.take_back",
            "Take back the prunes of the node",
            "Behavior",
            lambda _: panel.take_back(),
            "tree",
            tip="What is pruned at the selected node of the decision tree is possible again",
            icon="restore",
            enabled=has_prunes,
        ),
        *(_tool_row(panel, shows, *tool) for tool in TOOLS),
    )


def _tool_row(panel: TreePanel, shows: When, name: str, text: str, tip: str, page: str) -> ActionRow:
    return ActionRow(
        f"tree.{name}",
        text,
        "Behavior",
        lambda _: panel.tools.toggle(page),
        "tree",
        tip=tip,
        enabled=shows,
        checked=lambda _: panel.tools.page == page,
    )
