"""The context menu of a node of the tree."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QMenu

from ..letters import plain
from .subject import Subject

if TYPE_CHECKING:
    from .panel import TreePanel


def node_menu(panel: TreePanel, subject: Subject, key: int) -> QMenu:
    """What can be done with a node: prune it, forbid one of its states, drag its cut."""
    actions = panel.studio.actions
    actions.refresh()
    menu = QMenu(panel)
    menu.addAction(actions["tree.prune"])
    menu.addAction(actions["tree.take_back"])
    menu.addSeparator()
    for label in subject.labels_at(key):
        menu.addAction(plain(f"Never to {subject.name(label)} here")).triggered.connect(
            lambda _checked, label=label: panel.pruning.label(subject, key, label)
        )
    menu.addSeparator()
    menu.addAction(actions["tree.histogram"])
    return menu
