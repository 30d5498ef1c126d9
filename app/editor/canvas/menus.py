"""What can be done at a place of the canvas: its context menu."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtWidgets import QMenu

from ...core.wording import state_words
from ..letters import plain
from .frame import Frame

if TYPE_CHECKING:
    from ..studio import Studio

_CAMERA = ("canvas.fit", "canvas.follow", "canvas.zoom_in", "canvas.zoom_out")
_SHOWN = (
    "canvas.hulls",
    "canvas.links",
    "canvas.ranges",
    "canvas.trails",
    "canvas.all_trails",
    "canvas.grid",
)


def fill_menu(menu: QMenu, studio: Studio, frame: Frame, entity: int, controller: str) -> None:
    """Put into *menu* what can be done with an entity or a controller, then what can be done anywhere."""
    menu.setToolTipsVisible(True)
    node = frame.scene.node(entity) or controller
    if node:
        _node(menu, studio, frame, node)
    elif entity >= 0:
        _attached(menu, studio, frame, entity)
    for names in (_CAMERA, _SHOWN):
        for name in names:
            menu.addAction(studio.actions[name])
        menu.addSeparator()


def _node(menu: QMenu, studio: Studio, frame: Frame, node: str) -> None:
    place, select = frame.scene.place, studio.selection.select_nodes
    name = place.called(node)
    menu.addAction(plain(f"Select {name}"), lambda: select((node,)))
    parent = place.hierarchy.parents().get(node)
    if parent is not None:
        menu.addAction(plain(f"Select its controller {place.called(parent)}"), lambda: select((parent,)))
    first = frame.scene.doing.controllers
    if place.rows[node] < first:
        under = tuple(child.id for child in place.hierarchy.node(node).children)
        menu.addAction(plain(f"Select the {len(under)} under {name}"), lambda: select(under))

    def teach() -> None:
        select((node,))
        studio.actions["teach.teach"].trigger()

    action = menu.addAction(plain(f"Teach {name}"), teach)
    action.setToolTip(studio.actions.rows["teach.teach"].tip)
    if studio.teaching.can_pick_for(node):
        menu.addMenu(_picks(menu, studio, node, name))
    menu.addSeparator()


def _picks(menu: QMenu, studio: Studio, node: str, name: str) -> QMenu:
    """What the node can be taught to do now: the states of what is taught."""
    picks = QMenu(plain(f"Pick for {name}"), menu)
    teaching, automaton, key = studio.teaching, studio.teaching.automaton, studio.teaching.key
    if automaton is None or key is None:
        return picks
    library = studio.document.project.library(key.type)
    for state in automaton.states[1:]:
        words = state_words(automaton, state.id, library)
        picks.addAction(plain(words), partial(teaching.pick_for, node, state.id))
    picks.setEnabled(not picks.isEmpty())
    return picks


def _attached(menu: QMenu, studio: Studio, frame: Frame, entity: int) -> None:
    scene = frame.scene
    numbers = np.flatnonzero(scene.held == entity).tolist()
    nodes = tuple(scene.place.agents[number] for number in numbers)
    called = scene.called(entity)
    words = f"Select the {len(nodes)} attached to {called}" if nodes else f"Nobody is attached to {called}"
    action = menu.addAction(plain(words), lambda: studio.selection.select_nodes(nodes))
    action.setEnabled(bool(nodes))
    menu.addSeparator()
