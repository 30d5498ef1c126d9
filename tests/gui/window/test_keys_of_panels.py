"""What the panels do by keys of the window, wherever the focus is."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QPlainTextEdit
from pytestqt.qtbot import QtBot

from app.core.automaton import Basic
from app.core.edits import add_state
from app.editor.graph.panel import GraphPanel
from app.editor.library.panel import LibraryPanel
from app.editor.plots.panel import PlotsPanel
from app.editor.problems.panel import ProblemsPanel
from app.editor.selection import BehaviorKey
from app.editor.window.main_window import MainWindow

NONE, CONTROL = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
FORAGE = BehaviorKey("agent", "forage")


def press(window: MainWindow, qtbot: QtBot, action: str, key: Qt.Key, keys: Qt.KeyboardModifier) -> None:
    """Press a key of the window once its action is possible."""
    qtbot.waitUntil(window.studio.actions[action].isEnabled)
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    qtbot.keyClick(window, key, keys)


def test_f8_shows_what_is_wrong_and_shift_f8_mends_it(window: MainWindow, qtbot: QtBot) -> None:
    studio = window.studio
    before = studio.document.project
    state = studio.document.do(add_state, "agent", "wander", Basic("GrabBox"))
    panel = window.docks["problems"].widget()
    assert isinstance(panel, ProblemsPanel)
    qtbot.waitUntil(lambda: panel.model.rowCount() == 1)
    press(window, qtbot, "problems.next", Qt.Key.Key_F8, NONE)
    assert studio.selection.behavior == BehaviorKey("agent", "wander")
    assert studio.selection.state == state
    press(window, qtbot, "problems.fix", Qt.Key.Key_F8, SHIFT)
    qtbot.waitUntil(lambda: panel.model.rowCount() == 0)
    press(window, qtbot, "edit.undo", Qt.Key.Key_Z, CONTROL)
    qtbot.waitUntil(lambda: panel.model.rowCount() == 1)
    press(window, qtbot, "edit.undo", Qt.Key.Key_Z, CONTROL)
    assert studio.document.project is before


def test_ctrl_l_finds_a_behavior_whatever_has_the_keys(window: MainWindow, qtbot: QtBot) -> None:
    library = window.docks["library"].widget()
    assert isinstance(library, LibraryPanel)
    window.docks["library"].hide()
    press(window, qtbot, "behavior.filter", Qt.Key.Key_L, CONTROL)
    qtbot.waitUntil(library.filter.hasFocus)
    qtbot.keyClicks(library.filter, "goto")
    qtbot.keyClick(library.filter, Qt.Key.Key_Return)
    assert window.studio.selection.behavior == BehaviorKey("agent", "goto")


def test_ctrl_shift_e_opens_and_closes_a_state_in_place(window: MainWindow, qtbot: QtBot) -> None:
    panel = window.docks["graph"].widget()
    assert isinstance(panel, GraphPanel)
    window.studio.selection.select_behavior(FORAGE, "return-with-box")
    qtbot.waitUntil(lambda: ("return-with-box",) in panel.scene.states)
    for states in (9, 3):
        press(window, qtbot, "graph.expand", Qt.Key.Key_E, CONTROL | SHIFT)
        qtbot.waitUntil(lambda: len(panel.scene.states) == states)  # noqa: B023 - called at once


def test_a_plot_is_cleared_and_begins_anew(window: MainWindow, qtbot: QtBot) -> None:
    plots = window.docks["plots"].widget()
    assert isinstance(plots, PlotsPanel)
    window.studio.actions["run.plot"].trigger()
    press(window, qtbot, "run.play", Qt.Key.Key_Space, NONE)
    qtbot.waitUntil(lambda: len(plots._record.points) > 5)
    press(window, qtbot, "run.play", Qt.Key.Key_Space, NONE)
    qtbot.waitUntil(lambda: window.studio.snapshot is not None and window.studio.snapshot.speed == 0.0)
    window.studio.actions["run.clear_plot"].trigger()
    assert len(plots._record.points) <= 1
    press(window, qtbot, "run.play", Qt.Key.Key_Space, NONE)
    qtbot.waitUntil(lambda: len(plots._record.points) > 3)
    press(window, qtbot, "run.play", Qt.Key.Key_Space, NONE)


def test_a_note_on_a_behavior_is_written_from_the_menu(window: MainWindow, qtbot: QtBot) -> None:
    document = window.studio.document
    window.studio.selection.select_behavior(FORAGE)
    before = document.project
    qtbot.waitUntil(window.studio.actions["behavior.note"].isEnabled)
    window.studio.actions["behavior.note"].trigger()
    qtbot.waitUntil(lambda: isinstance(QApplication.focusWidget(), QPlainTextEdit))
    field = QApplication.focusWidget()
    assert isinstance(field, QPlainTextEdit)
    qtbot.keyClick(field, Qt.Key.Key_A, CONTROL)
    qtbot.keyClicks(field, "looks for boxes")
    qtbot.waitUntil(lambda: document.project.library("agent").get("forage").note == "looks for boxes")
    qtbot.keyClick(field.window(), Qt.Key.Key_Escape)
    press(window, qtbot, "edit.undo", Qt.Key.Key_Z, CONTROL)
    assert document.project is before
