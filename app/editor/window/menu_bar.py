"""The menus, made from the table of actions."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QMenu, QMenuBar

from ..actions import MENUS, SUBMENUS

if TYPE_CHECKING:
    from ..actions import ActionRow, Actions


def fill_menu_bar(bar: QMenuBar, actions: Actions) -> None:
    """Add a menu for each in `MENUS` that has rows, those of one group together."""
    bar.setNativeMenuBar(False)
    for name in MENUS:
        rows = [row for row in actions.rows.values() if row.menu == name]
        if rows:
            _fill(_shown(bar.addMenu(name)), rows, actions)


def _fill(menu: QMenu, rows: list[ActionRow], actions: Actions) -> None:
    groups = list(dict.fromkeys(row.group for row in rows))
    inner: dict[str, QMenu] = {}
    for number, group in enumerate(groups):
        title = SUBMENUS.get((rows[0].menu, group), "")
        place = menu
        if title:
            # Menus that open from this one stand together, without lines between them.
            if not inner:
                menu.addSeparator()
            if title in inner:
                inner[title].addSeparator()
            else:
                inner[title] = _shown(menu.addMenu(title))
            place = inner[title]
        elif number:
            menu.addSeparator()
        for row in rows:
            if row.group == group:
                place.addAction(actions[row.id])


def _shown(menu: QMenu) -> QMenu:
    menu.setToolTipsVisible(True)
    return menu
