"""Whatever is in the tables of actions: its words, its menu, its keys."""

from PySide6.QtWidgets import QMenu, QToolButton
from pytestqt.qtbot import QtBot

from app.editor.actions import MENUS, always
from app.editor.studio import Studio
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import said


def test_every_action_has_a_text_and_a_tip_and_is_in_a_menu_that_exists(window: MainWindow) -> None:
    for row in window.studio.actions.rows.values():
        assert row.text, row.id
        assert row.tip, f"{row.id} has no tip"
        assert row.menu in ("", *MENUS), row.id
        assert row.icon or row.checked, f"{row.id} has no icon, and no mark either"
        assert not row.icon or not window.studio.actions[row.id].icon().pixmap(16).isNull(), row.id


def test_what_is_not_possible_says_why_in_its_tip(window: MainWindow) -> None:
    actions = window.studio.actions
    possible = [name for name in actions.rows if actions[name].isEnabled()]
    assert 0 < len(possible) < len(actions.rows)
    for name, row in actions.rows.items():
        if row.enabled is not always:
            assert row.enabled.why_not(window.studio) or name in possible, f"{name} would not say why"
        said_why = "Not now: " in actions[name].toolTip()
        assert said_why is (name not in possible), f"{name}: {actions[name].toolTip()}"


def test_without_a_project_what_needs_one_says_so(empty_studio: Studio, qtbot: QtBot) -> None:
    window = MainWindow(empty_studio)
    qtbot.addWidget(window)
    for name in ("file.save_as", "run.play", "run.faster", "view.copy_tick", "file.reload", "behavior.new"):
        assert not empty_studio.actions[name].isEnabled()
        assert "open a project" in empty_studio.actions[name].toolTip(), name


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
