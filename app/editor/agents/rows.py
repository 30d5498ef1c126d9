"""What can be done with nodes and arms, as actions of the window."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..actions import ActionRow, needs, when_open
from .arms_dialog import arms_and_worlds
from .moving import Move

if TYPE_CHECKING:
    from ..studio import Studio
    from .panel import AgentsPanel


@needs("open a project, and choose an arm of it")
def has_arm(studio: Studio) -> bool:
    """Whether there is an arm whose forest can be changed."""
    return studio.is_open and studio.arm is not None


@needs("select agents or controllers first")
def has_nodes(studio: Studio) -> bool:
    """Whether nodes are selected."""
    return has_arm(studio) and bool(studio.selection.nodes)


def agent_rows(panel: AgentsPanel) -> tuple[ActionRow, ...]:
    """The actions that concern the forest."""
    ways = (
        (Move.UP, "up", "before the node above", "Alt+Up", "arrow-up"),
        (Move.DOWN, "down", "behind the node below", "Alt+Down", "arrow-down"),
        (Move.OUT, "out of the group", "behind their controller", "Alt+Left", "arrow-left"),
        (
            Move.IN,
            "into the group before",
            "under the controller right above them",
            "Alt+Right",
            "arrow-right",
        ),
    )
    return (
        ActionRow(
            "arm.settings",
            "Arms and worlds…",
            "Edit",
            lambda studio: arms_and_worlds(studio, panel),
            "arms",
            "Ctrl+Shift+I",
            "Arms, their forests and parameters, worlds, and node types",
            "file-tree-outline",
            when_open,
        ),
        ActionRow(
            "node.add",
            "Add node",
            "Edit",
            lambda _: panel.hand.add(),
            "forest",
            tip="Add an agent or controller where the selection is",
            icon="plus",
            enabled=has_arm,
        ),
        ActionRow(
            "node.rename",
            "Rename node",
            "Edit",
            lambda _: panel.rename(),
            "forest",
            tip="Give the current node a name (F2 in the agents)",
            icon="rename-box",
            enabled=has_nodes,
        ),
        ActionRow(
            "node.group",
            "Group nodes",
            "Edit",
            lambda _: panel.hand.group(),
            "forest",
            tip="Put the selected nodes under a new controller (Ctrl+G in the agents)",
            icon="group",
            enabled=has_nodes,
        ),
        ActionRow(
            "node.dissolve",
            "Dissolve group",
            "Edit",
            lambda _: panel.hand.dissolve(),
            "forest",
            tip="Put the nodes of the selected controllers in their place (Ctrl+Shift+G in the agents)",
            icon="ungroup",
            enabled=has_nodes,
        ),
        ActionRow(
            "node.remove",
            "Remove nodes",
            "Edit",
            lambda _: panel.hand.remove(),
            "forest",
            tip="Remove the selected nodes and all below them (Delete in the agents)",
            icon="delete-outline",
            enabled=has_nodes,
        ),
        *(_move_row(panel, *way) for way in ways),
    )


def _move_row(panel: AgentsPanel, way: Move, words: str, where: str, keys: str, icon: str) -> ActionRow:
    return ActionRow(
        f"node.{way.value}",
        f"Move nodes {words}",
        "Edit",
        lambda _: panel.hand.shift(way),
        "forest",
        tip=f"Move the selected nodes {where} ({keys} in the agents)",
        icon=icon,
        enabled=has_nodes,
    )
