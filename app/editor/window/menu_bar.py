"""The menus, made from the table of actions, and their letters."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QMenuBar

from ..actions import MENUS, SUBMENUS, ActionRow
from ..letters import letters_of, marked

if TYPE_CHECKING:
    from ..actions import Actions


def menu_bar_rows(bar: QMenuBar) -> tuple[ActionRow, ...]:
    """The menus by keys."""
    return (
        ActionRow(
            "help.menus",
            "Go to the menus",
            "Help",
            lambda _: bar.setActiveAction(bar.actions()[0]),
            "search",
            keys="F10",
            tip="Open the first menu: arrow keys go on, a letter chooses; Alt and its letter opens a menu at once",
            icon="menu",
        ),
    )


def fill_menu_bar(bar: QMenuBar, actions: Actions) -> None:
    """Add a menu for each in `MENUS` that has rows, those of one group together."""
    bar.setNativeMenuBar(False)
    for name in MENUS:
        rows = [row for row in actions.rows.values() if row.menu == name]
        if rows:
            _fill(_shown(bar.addMenu(name), name), rows, actions)


def letter_menus(bar: QMenuBar, actions: Actions) -> None:
    """Give every menu its letter, and every entry one that no other of the same menu has, where it can have one."""
    letters = {menu: letter for letter, menu in actions.menu_letters().items()}
    for entry in bar.actions():
        menu = _menu_of(entry)
        if menu is not None:
            entry.setText(marked(menu.objectName(), letters.get(menu.objectName(), "")))
            _letter_entries(menu, actions)


def _letter_entries(menu: QMenu, actions: Actions) -> None:
    entries = [entry for entry in menu.actions() if not entry.isSeparator()]
    # What an action says may change, but all of it begins in the same way: it comes first.
    entries.sort(key=lambda entry: (row := actions.rows.get(entry.objectName())) is None or row.says is None)
    given: dict[str, str] = {}
    for entry, letter in zip(entries, letters_of([_name(entry, actions) for entry in entries]), strict=True):
        inner = _menu_of(entry)
        if inner is None:
            given[entry.objectName()] = letter
            continue
        entry.setText(marked(inner.objectName(), letter))
        if any(action.objectName() in actions.rows for action in inner.actions()):
            _letter_entries(inner, actions)
    actions.use_letters(given)


def _name(entry: QAction, actions: Actions) -> str:
    inner = _menu_of(entry)
    return actions.rows[entry.objectName()].text if inner is None else inner.objectName()


def _menu_of(entry: QAction) -> QMenu | None:
    menu = entry.menu()
    return menu if isinstance(menu, QMenu) else None


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
                inner[title] = _shown(menu.addMenu(title), title)
            place = inner[title]
        elif number:
            menu.addSeparator()
        for row in rows:
            if row.group == group:
                place.addAction(actions[row.id])


def _shown(menu: QMenu, name: str) -> QMenu:
    """A menu that shows tool tips, and can be found by what it is called without the mark of its letter."""
    menu.setObjectName(name)
    menu.setToolTipsVisible(True)
    return menu
