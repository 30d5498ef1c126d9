"""Pages of a dialog are there when somebody turns to them."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QLineEdit
from pytestqt.qtbot import QtBot

from app.editor.forms.late_pages import LatePages


@pytest.fixture
def pages(qtbot: QtBot) -> LatePages:
    pages = LatePages()
    qtbot.addWidget(pages)
    pages.offer({"One": QLineEdit, "Two": QLabel, "Three": QLineEdit})
    with qtbot.waitExposed(pages):
        pages.show()
    return pages


def test_only_the_first_is_made_at_once(pages: LatePages) -> None:
    assert len(pages.made(QLineEdit)) == 1
    assert not pages.made(QLabel)
    assert pages.page("One", QLineEdit).isVisible()


def test_keys_turn_to_pages_which_are_made_then(pages: LatePages, qtbot: QtBot) -> None:
    qtbot.keyClick(pages.tabBar(), Qt.Key.Key_Right)
    assert [pages.tabText(k) for k in range(pages.count())] == ["One", "Two", "Three"]
    assert pages.page("Two", QLabel).isVisible()
    qtbot.keyClick(pages.tabBar(), Qt.Key.Key_Right)
    assert pages.page("Three", QLineEdit).isVisible()
    qtbot.keyClick(pages.tabBar(), Qt.Key.Key_Left)
    assert pages.currentWidget() is pages.page("Two", QLabel)


def test_asking_for_a_page_leaves_the_one_in_front_there(pages: LatePages) -> None:
    last = pages.page("Three", QLineEdit)
    assert pages.currentWidget() is pages.page("One", QLineEdit)
    pages.turn_to("Three")
    assert pages.currentWidget() is last


def test_other_pages_take_the_place_of_those_before(pages: LatePages) -> None:
    pages.turn_to("Three")
    pages.offer({"Four": QLabel, "Five": QLabel})
    assert [pages.tabText(k) for k in range(pages.count())] == ["Four", "Five"]
    assert pages.page("Four", QLabel).isVisible()
