"""The tool bar: arms, seeds, what undo would undo, and what there is room for."""

from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QToolButton
from pytestqt.qtbot import QtBot

from app.core.edits import add_automaton, note_project
from app.editor.studio import Studio
from app.editor.window.main_window import MainWindow
from app.editor.window.toolbar import UNDO_WORDS, Toolbar
from tests.gui.conftest import PATIENCE, said


def test_another_arm_is_begun_from_the_tool_bar(window: MainWindow, qtbot: QtBot, studio: Studio) -> None:
    arms = window.toolbar.arm
    with qtbot.waitSignal(studio.bridge.place_changed, timeout=PATIENCE):
        arms.setFocus()
        qtbot.keyClick(arms, Qt.Key.Key_Down)
    assert studio.arm is not None
    assert studio.arm.name == "one level"


def test_a_seed_that_is_none_is_refused_in_words(window: MainWindow, qtbot: QtBot) -> None:
    window.toolbar.seed.setText("")
    qtbot.keyClicks(window.toolbar.seed, "minus one")
    with qtbot.waitSignal(window.messages.shown) as shown:
        qtbot.keyClick(window.toolbar.seed, Qt.Key.Key_Return)
    assert shown.args is not None
    assert "a seed is a whole number" in shown.args[0]


def test_where_there_is_room_the_tool_bar_says_what_undo_would_undo(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    undo, arm = window.toolbar.undo, window.toolbar.arm

    def has_words() -> bool:
        return undo.toolButtonStyle() is Qt.ToolButtonStyle.ToolButtonTextBesideIcon

    studio.document.do(note_project, "a note")
    window.resize(1900, 1000)
    qtbot.waitUntil(has_words)
    assert said(undo.defaultAction()).startswith("Undo: ")
    assert undo.text().startswith("Undo: ")
    assert arm.isVisible()
    assert undo.toolTip().startswith("Undo: ")
    studio.actions["edit.undo"].trigger()
    assert undo.text() == "Undo"
    assert undo.toolTip().startswith("Take back the last step, picks included (Ctrl+Z)\nNot now:")
    just_enough = window.toolbar.sizeHint().width() - (undo.minimumWidth() - UNDO_WORDS[0])
    window.resize(just_enough, 1000)
    qtbot.waitUntil(lambda: window.toolbar.width() == just_enough and has_words() and arm.isVisible())
    window.toolbar.seed.setText("1234567890")
    assert not has_words(), "a longer seed needs the room"
    assert arm.isVisible()
    window.resize(1280, 800)
    qtbot.waitUntil(lambda: not has_words() and arm.isVisible())


def test_what_undo_would_undo_is_said_in_full_where_there_is_room_and_stays_in_its_place(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    tools = window.toolbar
    redo = next(
        b for b in tools.findChildren(QToolButton) if b.defaultAction() is studio.actions["edit.redo"]
    )
    studio.document.do(add_automaton, "agent", "Carry boxes home and wait")
    window.resize(1920, 1080)
    qtbot.waitUntil(lambda: tools.undo.text() == "Undo: Add behavior Carry boxes home and wait")
    before = redo.x()
    studio.document.do(note_project, "a note")
    qtbot.waitUntil(lambda: "Carry" not in tools.undo.text())
    assert redo.x() == before
    studio.actions["edit.undo"].trigger()
    window.resize(1600, 1000)
    qtbot.waitUntil(lambda: tools.undo.text().endswith("…"))
    assert tools.undo.sizeHint().width() <= tools.undo.width()
    assert tools.arm.isVisible()


def test_what_is_said_in_full_is_not_cut_off_for_a_fraction_of_a_pixel(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    window.resize(1920, 1080)
    for many in range(12, 42):
        words = "Move-what-was-selected-to-where-it-is-needed"[:many]
        studio.document.push(words, studio.document.project, mark=words)
        qtbot.waitUntil(partial(lambda words: window.toolbar.undo.text() == f"Undo: {words}", words))
        assert window.toolbar.undo.sizeHint().width() <= window.toolbar.undo.minimumWidth()


def test_the_field_of_the_seed_takes_no_more_room_than_the_seed(window: MainWindow, qtbot: QtBot) -> None:
    seed = window.toolbar.seed
    few = seed.width()
    seed.setFocus()
    seed.selectAll()
    qtbot.keyClicks(seed, "1234567890")
    qtbot.waitUntil(lambda: seed.width() > few)
    assert seed.width() >= seed.fontMetrics().horizontalAdvance("1234567890")
    seed.selectAll()
    qtbot.keyClicks(seed, "7")
    qtbot.waitUntil(lambda: seed.width() == few)


def test_what_the_tool_bar_has_no_room_for_opens_at_its_end(window: MainWindow, qtbot: QtBot) -> None:
    window.resize(window.minimumSizeHint().width(), 800)
    tools = window.findChild(Toolbar)
    assert tools is not None
    more = tools.findChild(QToolButton, "qt_toolbar_ext_button")
    assert isinstance(more, QToolButton)
    qtbot.waitUntil(more.isVisible)
    assert not tools.arm.isVisible()
    assert not more.icon().isNull()
    assert more.toolTip() == "What there is no room for"
    window.resize(1440, 900)
    qtbot.waitUntil(lambda: not more.isVisible())
    assert tools.arm.isVisible()
