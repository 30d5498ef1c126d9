"""Whatever is in the tables of actions: its words, its menu, its keys."""

from PySide6.QtWidgets import QMenu, QToolButton

from app.editor.actions import MENUS
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import said


def test_every_action_has_a_text_and_a_tip_and_is_in_a_menu_that_exists(window: MainWindow) -> None:
    for row in window.studio.actions.rows.values():
        assert row.text, row.id
        assert row.tip, f"{row.id} has no tip"
        assert row.menu in ("", *MENUS), row.id
        assert row.icon or row.checked, f"{row.id} has no icon, and no mark either"
        assert not row.icon or not window.studio.actions[row.id].icon().pixmap(16).isNull(), row.id


def test_every_action_is_in_a_menu_or_on_a_button(window: MainWindow) -> None:
    buttons = window.findChildren(QToolButton)
    pressed = {action.objectName() for button in buttons for action in button.actions()}
    for row in window.studio.actions.rows.values():
        assert row.menu or row.id in pressed, f"{row.id} is found by nobody who does not know its name"


def test_no_menu_is_higher_than_what_a_low_screen_has_below_the_menu_bar(window: MainWindow) -> None:
    menus = [menu for menu in window.menuBar().findChildren(QMenu) if not menu.isEmpty()]
    assert len(menus) > len(MENUS)
    for menu in menus:
        assert menu.sizeHint().height() < 720, menu.title()


def test_every_action_of_a_menu_is_found_in_it_or_in_one_that_opens_from_it(window: MainWindow) -> None:
    bar = {said(action): action.menu() for action in window.menuBar().actions()}
    for row in window.studio.actions.rows.values():
        if row.menu:
            menu = bar[row.menu]
            assert isinstance(menu, QMenu)
            found = [menu, *menu.findChildren(QMenu)]
            assert any(window.studio.actions[row.id] in each.actions() for each in found), row.id


def test_no_two_actions_have_the_same_shortcut(window: MainWindow) -> None:
    keys: dict[str, str] = {}
    for action_id in window.studio.actions.rows:
        shortcut = window.studio.actions.keys_of(action_id)
        if shortcut:
            assert shortcut not in keys, f"{action_id} and {keys[shortcut]} both have {shortcut}"
            keys[shortcut] = action_id
