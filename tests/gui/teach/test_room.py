"""A lesson in a small window: what there is no room for is said in fewer words."""

from functools import partial

from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QCursor
from PySide6.QtWidgets import QMenu, QToolButton

from app.core.edits import rename_parameter
from tests.gui.teach.hand import Hand

ICON, WORDS = Qt.ToolButtonStyle.ToolButtonIconOnly, Qt.ToolButtonStyle.ToolButtonTextBesideIcon
SMALL = 1280, 800


def _looks(hand: Hand, style: Qt.ToolButtonStyle) -> bool:
    return hand.page.next.toolButtonStyle() == style


def test_a_window_keeps_its_size_whatever_is_taught_and_tested(hand: Hand) -> None:
    hand.window.resize(*SMALL)
    hand.show("GatherAt", "agent-3", "agent-7")
    sides = {hand.window.docks[name]: hand.window.docks[name].width() for name in ("library", "graph")}
    hand.key(Qt.Key.Key_T)
    hand.choose_target(hand.panel.idle.targets, "X", "nearest visible box")
    hand.wait(lambda: hand.studio.teaching.lesson is not None)
    hand.settle()
    hand.test()
    assert (hand.window.width(), hand.window.height()) == SMALL
    assert {dock: dock.width() for dock in sides} == sides


def test_a_window_keeps_its_size_whatever_parameters_are_called(hand: Hand) -> None:
    hand.window.resize(*SMALL)
    hand.show("Wander", "agent-3")
    hand.settle()
    sides = {hand.window.docks[name]: hand.window.docks[name].width() for name in ("library", "graph")}
    hand.studio.document.attempt(rename_parameter, "agent", "goto", "X", "WhereTheJourneyGoes")
    hand.show("Goto", "agent-3")
    hand.settle()
    assert {dock: dock.width() for dock in sides} == sides
    hand.key(Qt.Key.Key_T)
    hand.wait(lambda: hand.studio.teaching.choosing.is_busy)
    hand.settle()
    assert {dock: dock.width() for dock in sides} == sides


def test_while_a_target_is_chosen_nothing_else_takes_room(hand: Hand) -> None:
    hand.show("GatherAt", "agent-3")
    idle = hand.panel.idle
    hand.key(Qt.Key.Key_T)
    hand.wait(lambda: hand.studio.teaching.choosing.is_busy)
    assert not idle.filed.isVisible()
    assert not idle.keep.isVisible()
    hand.key(Qt.Key.Key_Escape)
    hand.wait(lambda: not hand.studio.teaching.choosing.is_busy)
    assert idle.filed.isVisible()
    assert idle.keep.isVisible()


def test_what_to_do_is_said_in_a_small_window_too(hand: Hand) -> None:
    hand.window.resize(*SMALL)
    hand.show("GatherAt", "agent-3")
    hand.key(Qt.Key.Key_T)
    hand.choose_target(hand.panel.idle.targets, "X", "nearest visible box")
    hand.wait(lambda: hand.studio.teaching.lesson is not None)
    hand.settle()
    last = hand.page.last
    assert last.text == "Pick what it is to do."
    hand.wait(lambda: last.width() >= last.fontMetrics().horizontalAdvance(last.text) * 11 // 13)


def test_buttons_say_what_they_do_where_there_is_room(hand: Hand) -> None:
    hand.window.resize(*SMALL)
    hand.show("GatherAt", "agent-3", "agent-7")
    hand.key(Qt.Key.Key_T)
    hand.choose_target(hand.panel.idle.targets, "X", "nearest visible box")
    hand.wait(lambda: hand.studio.teaching.lesson is not None)
    hand.settle()
    hand.test()
    for width, style in ((1900, WORDS), (SMALL[0], ICON), (1900, WORDS)):
        hand.window.resize(width, 800)
        hand.wait(partial(_looks, hand, style))
    assert hand.page.mend.toolButtonStyle() == WORDS


def test_a_button_is_not_lit_once_its_menu_was_closed_elsewhere(hand: Hand) -> None:
    (button,) = [
        each for each in hand.window.findChildren(QToolButton) if each.accessibleName() == "What to ask about"
    ]
    menu = button.menu()
    assert isinstance(menu, QMenu)
    QCursor.setPos(hand.window.mapToGlobal(hand.window.rect().center()))
    menu.popup(button.mapToGlobal(QPoint(0, button.height())))
    # On a screen, the menu has the mouse, and no Leave comes.
    button.setAttribute(Qt.WidgetAttribute.WA_UnderMouse)
    hand.qtbot.keyClick(menu, Qt.Key.Key_Escape)
    assert not menu.isVisible()
    assert not button.underMouse()


def test_a_demonstration_is_named_only_where_something_can_be_taught(hand: Hand) -> None:
    page = hand.panel.idle
    hand.show("Wander", "agent-3")
    hand.wait(page.filed.isVisible)
    assert page.filed.placeholderText() in page.filed.toolTip()
    hand.studio.selection.select_behavior(None)
    hand.wait(lambda: not page.filed.isVisible() and not page.keep.isVisible())
