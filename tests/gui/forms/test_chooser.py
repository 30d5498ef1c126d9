"""Choosing one of many: words of its name leave those that have them all."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractItemView
from pytestqt.qtbot import QtBot

from app.editor.forms.choosing import Choice, Chooser

NAMES = ("distance to the nearest box", "angle to the nearest box", "distance to the deposit", "Box seen")


@pytest.fixture
def chooser(qtbot: QtBot) -> Iterator[Chooser]:
    chooser = Chooser("feature", "which")
    qtbot.addWidget(chooser)
    chooser.offer(Choice(name, number) for number, name in enumerate(NAMES))
    with qtbot.waitExposed(chooser):
        chooser.show()
    chooser.activateWindow()
    qtbot.waitUntil(chooser.isActiveWindow)
    chooser.field.setFocus()
    yield chooser
    chooser.hide()


def popup_of(chooser: Chooser) -> QAbstractItemView:
    completer = chooser.completer()
    assert completer is not None
    popup = completer.popup()
    assert popup is not None
    return popup


def offered(chooser: Chooser) -> list[str]:
    popup = popup_of(chooser)
    model = popup.model()
    return [model.index(row, 0).data() for row in range(model.rowCount())] if popup.isVisible() else []


def test_words_in_any_order_leave_the_choices_that_have_them_all(chooser: Chooser, qtbot: QtBot) -> None:
    qtbot.keyClicks(chooser.field, "box")
    assert offered(chooser) == [NAMES[0], NAMES[1], NAMES[3]]
    qtbot.keyClicks(chooser.field, " dist")
    assert offered(chooser) == [NAMES[0]]
    qtbot.keyClick(chooser.field, Qt.Key.Key_Backspace)
    qtbot.keyClick(chooser.field, Qt.Key.Key_Backspace)
    qtbot.keyClicks(chooser.field, "x")
    assert offered(chooser) == []


def test_enter_takes_the_only_choice_that_is_left(chooser: Chooser, qtbot: QtBot) -> None:
    chosen: list[object] = []
    chooser.chosen.connect(lambda choice: chosen.append(choice.value))
    qtbot.keyClicks(chooser.field, "nearest angle")
    popup = popup_of(chooser)
    qtbot.keyClick(popup, Qt.Key.Key_Return)
    assert chooser.currentText() == NAMES[1]
    assert chosen == [1]


def test_what_is_left_is_chosen_by_an_arrow_key_and_enter(chooser: Chooser, qtbot: QtBot) -> None:
    qtbot.keyClicks(chooser.field, "box nearest")
    popup = popup_of(chooser)
    qtbot.keyClick(popup, Qt.Key.Key_Down)
    qtbot.keyClick(popup, Qt.Key.Key_Down)
    qtbot.keyClick(popup, Qt.Key.Key_Return)
    assert chooser.currentText() == NAMES[1]
