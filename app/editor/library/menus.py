"""Menus of the library: what can be done with a behavior, and where it is used."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMenu, QWidget

from ..letters import plain
from .survey import Row, Use

if TYPE_CHECKING:
    from ..studio import Studio

#: Actions of the context menu; an empty one is a line.
ACTIONS = (
    "behavior.open",
    "behavior.settings",
    "behavior.note",
    "",
    "behavior.rename",
    "behavior.duplicate",
    "behavior.delete",
    "",
    "behavior.new",
)
#: Shows a behavior that uses another, or that is used.
Jump = Callable[[Use], None]


def context_menu(parent: QWidget, studio: Studio, row: Row | None, jump: Jump) -> QMenu:
    """What can be done with a behavior, who uses it, and what it uses; None stands for a group."""
    menu = _new_menu(parent)
    if row is None or not row.is_automaton:
        menu.addAction(studio.actions["behavior.new"])
    else:
        for action in ACTIONS:
            if action:
                menu.addAction(studio.actions[action])
            else:
                menu.addSeparator()
    if row is not None:
        menu.addSeparator()
        for title, uses in (("Used by", row.used_by), ("Uses", row.uses)):
            below = menu.addMenu(f"{title} ({len(uses)})")
            below.setEnabled(bool(uses))
            _list(below, uses, jump)
    return menu


def uses_menu(parent: QWidget, uses: tuple[Use, ...], jump: Jump) -> QMenu:
    """A behavior's users, or those it uses, to go to."""
    menu = _new_menu(parent)
    _list(menu, uses, jump)
    return menu


def _list(menu: QMenu, uses: tuple[Use, ...], jump: Jump) -> None:
    for use in uses:
        action = menu.addAction(plain(use.words[:1].upper() + use.words[1:]))
        action.triggered.connect(lambda _=False, use=use: jump(use))


def _new_menu(parent: QWidget) -> QMenu:
    menu = QMenu(parent)
    menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    menu.setToolTipsVisible(True)
    return menu
