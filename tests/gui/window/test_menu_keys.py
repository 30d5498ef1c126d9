"""The menus by keys: Alt and a letter, F10, and the letters of entries."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QApplication, QMenu, QWidget
from pytestqt.qtbot import QtBot

from app.core.edits import rename_automaton
from app.editor.actions import MENUS
from app.editor.command_palette.catalog import catalog_of
from app.editor.preferences.keys import KeysPage
from app.editor.settings import Settings
from app.editor.studio import Studio
from app.editor.theme import Theme
from app.editor.window.main_window import MainWindow
from app.engine.snapshots import Mode
from tests.gui.conftest import said

ALT, NO_KEY = Qt.KeyboardModifier.AltModifier, Qt.KeyboardModifier.NoModifier


@pytest.fixture(autouse=True)
def no_menu_is_left_open() -> Iterator[None]:
    yield
    while (menu := QApplication.activePopupWidget()) is not None:
        menu.close()


def letter_in(text: str) -> str:
    """The letter that is marked, in upper case."""
    at = text.replace("&&", "  ").find("&")
    return text[at + 1].upper() if at >= 0 else ""


def press_alt(window: MainWindow, qtbot: QtBot, letter: str) -> None:
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    qtbot.keyClick(QApplication.focusWidget() or window, getattr(Qt.Key, f"Key_{letter}"), ALT)


def open_menu(name: str, window: MainWindow, qtbot: QtBot) -> QMenu:
    """Open a menu by its letter."""
    entry = next(action for action in window.menuBar().actions() if said(action) == name)
    press_alt(window, qtbot, letter_in(entry.text()))
    menu = window.menuBar().findChild(QMenu, name)
    assert isinstance(menu, QMenu)
    qtbot.waitUntil(menu.isVisible)
    return menu


@pytest.mark.parametrize("name", MENUS)
def test_alt_and_its_letter_opens_a_menu(window: MainWindow, qtbot: QtBot, name: str) -> None:
    menu = open_menu(name, window, qtbot)
    assert QApplication.activePopupWidget() is menu


def test_every_entry_has_a_letter_that_no_other_of_its_menu_has(window: MainWindow) -> None:
    menus = [menu for menu in window.menuBar().findChildren(QMenu) if not menu.isEmpty()]
    assert len(menus) > len(MENUS)
    for menu in menus:
        letters = [letter_in(entry.text()) for entry in menu.actions() if not entry.isSeparator()]
        assert all(letters) or menu is window.recent, menu.objectName()
        assert len(letters) == len(set(letters)), menu.objectName()
    assert len({letter_in(entry.text()) for entry in window.menuBar().actions()}) == len(MENUS)


def test_what_is_undone_keeps_its_letter_whatever_names_are_in_it(window: MainWindow, qtbot: QtBot) -> None:
    document = window.studio.document
    before = document.project
    document.do(rename_automaton, "agent", "wander", "R&D")
    entry = window.studio.actions["edit.undo"]
    assert "R&&D" in entry.text()
    menu = open_menu("Edit", window, qtbot)
    qtbot.keyClick(menu, Qt.Key.Key_U)
    qtbot.waitUntil(lambda: document.project is before)


def test_a_letter_chooses_an_entry_and_one_that_opens_from_it(window: MainWindow, qtbot: QtBot) -> None:
    menu = open_menu("View", window, qtbot)
    panels = menu.findChild(QMenu, "Panels")
    assert isinstance(panels, QMenu)
    qtbot.keyClick(menu, Qt.Key.Key_P)
    qtbot.waitUntil(panels.isVisible)
    assert not window.docks["library"].isHidden()
    qtbot.keyClick(panels, Qt.Key.Key_L)
    qtbot.waitUntil(panels.isHidden)


def test_f10_opens_the_first_menu_and_escape_leads_back_to_where_the_keys_were(
    window: MainWindow, qtbot: QtBot
) -> None:
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    before: QWidget = window.canvas
    before.setFocus()
    qtbot.keyClick(before, Qt.Key.Key_F10)
    file = window.menuBar().findChild(QMenu, "File")
    assert isinstance(file, QMenu)
    qtbot.waitUntil(file.isVisible)
    qtbot.keyClick(file, Qt.Key.Key_Right)
    edit = window.menuBar().findChild(QMenu, "Edit")
    assert isinstance(edit, QMenu)
    qtbot.waitUntil(edit.isVisible)
    qtbot.keyClick(edit, Qt.Key.Key_Escape)
    qtbot.waitUntil(edit.isHidden)
    qtbot.keyClick(window.menuBar(), Qt.Key.Key_Escape)
    assert before.hasFocus()


def test_menus_open_in_the_middle_of_a_lesson_and_letters_alone_go_on_teaching(
    window: MainWindow, qtbot: QtBot
) -> None:
    studio = window.studio
    studio.selection.select_nodes(["agent-1"])
    studio.actions["teach.teach"].trigger()
    qtbot.waitUntil(lambda: studio.mode is Mode.TEACHING)
    menu = open_menu("Teach", window, qtbot)
    qtbot.keyClick(menu, Qt.Key.Key_Escape)
    qtbot.keyClick(window.menuBar(), Qt.Key.Key_Escape)
    qtbot.keyClick(QApplication.focusWidget() or window, Qt.Key.Key_1, NO_KEY)
    qtbot.waitUntil(lambda: studio.snapshot is not None and studio.snapshot.lesson is not None)
    qtbot.waitUntil(lambda: studio.document.history.can_undo)
    assert studio.document.history.undo_text.startswith("Pick")


def test_what_is_found_and_listed_shows_no_marks(window: MainWindow, studio: Studio) -> None:
    found = [entry.text for entry in catalog_of(studio).find("save")]
    assert "Save" in found
    assert "Save as…" in found
    page = KeysPage(studio)
    rows = range(page.table.rowCount())
    assert all("&" not in item.text() for at in rows if (item := page.table.item(at, 0)) is not None)
    assert all("&" not in studio.actions[name].toolTip() for name in studio.actions.rows)
    page.deleteLater()


def test_keys_that_open_a_menu_are_given_to_no_action(studio: Studio, window: MainWindow) -> None:
    page = KeysPage(studio)
    page.select("run.reset")
    page.edit.setKeySequence(QKeySequence("Alt+F"))
    page.edit.editingFinished.emit()
    assert "opens the menu File" in page.conflict.text()
    assert studio.actions["run.reset"].shortcut() == QKeySequence("Ctrl+R")
    page.deleteLater()


def test_a_menu_leaves_its_letter_to_an_action_that_had_it_already(
    qtbot: QtBot, tmp_path: Path, qapp: QApplication
) -> None:
    settings = Settings(tmp_path / "kept.ini")
    settings.set_key("run.reset", "Alt+F")
    window = MainWindow(Studio(Theme(qapp, settings.theme), settings))
    qtbot.addWidget(window)
    first = window.menuBar().actions()[0]
    assert first.text() == "F&ile"
    settings.set_key("run.reset", None)
    assert first.text() == "&File"
    window.studio.shut_down()
