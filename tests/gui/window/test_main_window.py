"""The window as a whole: keys of time and undo, what is framed, how wide it is, help."""

import pytest
from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QApplication, QDialog
from pytestqt.qtbot import QtBot

from app import __version__
from app.core.automaton import START
from app.core.edits import add_automaton, note_project
from app.editor.documents.asking import Question
from app.editor.focus_frame import FocusFrame
from app.editor.graph.view import GraphView
from app.editor.preferences.dialog import Preferences
from app.editor.room import FRAME, resize_within
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from app.editor.window.main_window import SIZE, MainWindow
from app.engine.snapshots import Mode
from tests.gui.conftest import PATIENCE


def test_space_lets_time_pass_and_stops_it(window: MainWindow, qtbot: QtBot) -> None:
    studio = window.studio
    qtbot.keyClick(window, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: studio.snapshot is not None and studio.snapshot.tick > 3, timeout=PATIENCE)
    qtbot.keyClick(window, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: studio.snapshot is not None and studio.snapshot.speed == 0.0, timeout=PATIENCE)


def test_an_edit_is_undone_and_redone_by_keys_that_come_right_after_it(
    window: MainWindow, qtbot: QtBot
) -> None:
    document = window.studio.document
    before = document.project
    document.do(note_project, "another note")
    after = document.project
    assert window.isWindowModified()
    qtbot.keyClick(window, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert document.project is before
    assert not window.isWindowModified()
    both = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier
    qtbot.keyClick(window, Qt.Key.Key_Z, both)
    assert document.project is after


def test_a_world_of_rigid_bodies_is_begun_from_the_menu(
    window: MainWindow, qtbot: QtBot, studio: Studio
) -> None:
    qtbot.waitUntil(studio.actions["run.rigid"].isEnabled, timeout=PATIENCE)
    with qtbot.waitSignal(studio.bridge.place_changed, timeout=PATIENCE):
        studio.actions["run.rigid"].trigger()
    assert studio.snapshot is not None
    assert studio.snapshot.place.physics == "rigid"
    assert studio.actions["run.rigid"].isChecked()


def test_a_view_is_framed_while_keys_go_there_because_of_keys(window: MainWindow, qtbot: QtBot) -> None:
    window.activateWindow()
    view = window.docks["graph"].findChild(GraphView)
    assert view is not None
    frame = view.findChild(FocusFrame)
    assert frame is not None
    assert not frame.isVisible()
    window.show_panel("graph")
    qtbot.waitUntil(frame.isVisible, timeout=PATIENCE)
    assert frame.geometry() == view.rect()
    window.show_panel("library")
    qtbot.waitUntil(lambda: not frame.isVisible(), timeout=PATIENCE)
    view.setFocus(Qt.FocusReason.MouseFocusReason)
    assert not frame.isVisible()


def test_a_view_is_framed_again_when_escape_leads_back_to_it_from_a_form(
    window: MainWindow, qtbot: QtBot
) -> None:
    window.activateWindow()
    window.studio.selection.select_behavior(BehaviorKey("agent", "wander"), "forward")
    window.show_panel("graph")
    view = window.docks["graph"].findChild(GraphView)
    assert view is not None
    frame = view.findChild(FocusFrame)
    assert frame is not None
    qtbot.waitUntil(window.studio.actions["graph.edit"].isEnabled)
    qtbot.keyClick(view, Qt.Key.Key_F2)
    qtbot.waitUntil(lambda: not view.hasFocus() and not frame.isVisible())
    focus = QApplication.focusWidget()
    assert focus is not None
    qtbot.keyClick(focus, Qt.Key.Key_Escape)
    assert view.hasFocus()
    assert frame.isVisible()
    qtbot.keyClick(view, Qt.Key.Key_F10)
    qtbot.keyClick(QApplication.activePopupWidget(), Qt.Key.Key_Escape)
    qtbot.keyClick(window.menuBar(), Qt.Key.Key_Escape)
    assert view.hasFocus()
    assert frame.isVisible()


def test_help_tells_the_version_and_all_keys(window: MainWindow, studio: Studio, qtbot: QtBot) -> None:
    studio.actions["help.about"].trigger()
    about = window.findChild(Question)
    assert about is not None
    assert about.details is not None
    assert f"Understudy {__version__}" in about.details.toPlainText()
    with qtbot.waitSignal(about.destroyed, timeout=PATIENCE):
        qtbot.keyClick(about, Qt.Key.Key_Escape)
    studio.actions["help.keys"].trigger()
    preferences = window.findChild(Preferences)
    assert preferences is not None
    assert preferences.keys.isVisible()
    preferences.close()


@pytest.mark.parametrize("mode", ["before a lesson", "in a lesson"])
def test_names_of_any_length_leave_the_window_as_narrow_as_the_user_made_it(
    window: MainWindow, qtbot: QtBot, mode: str
) -> None:
    studio = window.studio
    window.resize(1280, 800)
    name = "A behavior that somebody has given a name of many words, which " * 3
    behavior = studio.document.do(add_automaton, "agent", name.strip())
    studio.selection.select_behavior(BehaviorKey("agent", behavior))
    studio.selection.select_nodes(("agent-1",))
    if mode == "in a lesson":
        window.show_panel("plots")
        studio.actions["run.step"].trigger()
        studio.teaching.teach()
        qtbot.waitUntil(lambda: studio.mode is Mode.TEACHING, timeout=PATIENCE)
    panel = window.docks["graph"]
    qtbot.waitUntil(lambda: panel.windowTitle().startswith("Automaton · A behavior"), timeout=PATIENCE)
    QApplication.processEvents()
    assert window.minimumSizeHint().width() <= 1280
    assert window.width() == 1280


def test_selecting_an_agent_shows_how_the_state_decides_that_it_is_in(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    qtbot.keyClick(window, Qt.Key.Key_Period)
    qtbot.waitUntil(lambda: studio.snapshot is not None and studio.snapshot.tick == 1, timeout=PATIENCE)
    studio.selection.select_nodes(("agent-1",))
    qtbot.waitUntil(lambda: studio.selection.state != START, timeout=PATIENCE)
    chosen = studio.selection.state
    studio.selection.select_nodes(("agent-2",))  # a state that is shown stays
    qtbot.waitUntil(lambda: studio.snapshot is not None and "agent-2" in studio.snapshot.watched)
    assert studio.selection.state == chosen


def test_the_first_window_and_dialogs_are_no_larger_than_the_screen(
    empty_studio: Studio, qtbot: QtBot
) -> None:
    window = MainWindow(empty_studio)
    qtbot.addWidget(window)
    window.take_place()
    room = window.screen().availableSize()
    assert room.width() < SIZE.width()
    assert window.size() == SIZE.boundedTo(room)
    assert window.isMaximized()
    dialog = QDialog(window)
    resize_within(dialog, 2 * room.width(), 100)
    assert dialog.size() == QSize(room.width() - FRAME.width(), 100)
