"""Keys that move through what has the focus are no shortcuts meanwhile."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QAbstractSpinBox, QCheckBox, QPushButton, QToolButton, QWidget
from pytestqt.qtbot import QtBot

from app.editor.actions import ActionRow, When
from app.editor.agents.panel import AgentsPanel
from app.editor.library.panel import LibraryPanel
from app.editor.soon import catch_up
from app.editor.studio import Studio
from app.editor.window.main_window import MainWindow
from app.engine.commands import Step
from app.engine.snapshots import Mode
from tests.gui.conftest import PATIENCE


@pytest.fixture
def later(window: MainWindow, qtbot: QtBot) -> MainWindow:
    """The window at a tick from which the beginning can be gone back to."""
    window.studio.bridge.send(Step(5))
    qtbot.waitUntil(lambda: tick(window) == 5, timeout=PATIENCE)
    qtbot.waitUntil(window.studio.actions["run.begin"].isEnabled, timeout=PATIENCE)
    return window


def tick(window: MainWindow) -> int:
    assert window.studio.snapshot is not None
    return window.studio.snapshot.tick


def answered(window: MainWindow, qtbot: QtBot) -> int:
    """The tick once all that was asked of the session is done."""
    ticket = window.studio.bridge.send(Step(1))
    qtbot.waitUntil(
        lambda: window.studio.snapshot is not None and window.studio.snapshot.acknowledged >= ticket,
        timeout=PATIENCE,
    )
    qtbot.waitUntil(lambda: tick(window) > 0, timeout=PATIENCE)
    return tick(window)


def agents(window: MainWindow) -> QWidget:
    panel = window.docks["agents"].widget()
    assert isinstance(panel, AgentsPanel)
    return panel.tree


def test_after_a_single_step_the_beginning_can_be_gone_to(window: MainWindow, qtbot: QtBot) -> None:
    assert not window.studio.actions["run.begin"].isEnabled()
    window.studio.bridge.send(Step(1))
    qtbot.waitUntil(window.studio.actions["run.begin"].isEnabled, timeout=PATIENCE)


@pytest.mark.parametrize("place", ["arm", "seed", "speed", "agents"])
def test_home_stays_in_lists_boxes_sliders_and_fields(later: MainWindow, qtbot: QtBot, place: str) -> None:
    toolbar = later.toolbar
    places = {"arm": toolbar.arm, "seed": toolbar.seed, "speed": toolbar.slider, "agents": agents(later)}
    places[place].setFocus()
    qtbot.keyClick(places[place], Qt.Key.Key_Home)
    assert answered(later, qtbot) == 6


def test_home_goes_to_the_beginning_from_the_world(later: MainWindow, qtbot: QtBot) -> None:
    later.canvas.setFocus()
    qtbot.keyClick(later.canvas, Qt.Key.Key_Home)
    qtbot.waitUntil(lambda: tick(later) == 0, timeout=PATIENCE)


def test_the_space_bar_switches_a_check_box_that_has_the_focus(later: MainWindow, qtbot: QtBot) -> None:
    box = QCheckBox("a switch", later)
    box.show()
    box.setFocus()
    qtbot.keyClick(box, Qt.Key.Key_Space)
    assert box.isChecked()
    assert answered(later, qtbot) == 6


@pytest.mark.parametrize("make", [QPushButton, QToolButton])
def test_enter_presses_the_button_that_has_the_focus_and_the_space_bar_plays(
    window: MainWindow, qtbot: QtBot, make: type[QAbstractButton]
) -> None:
    done = list[str]()
    button = make(window)
    button.clicked.connect(lambda: done.append("pressed"))
    window.studio.actions["run.play"].triggered.connect(lambda: done.append("played"))
    button.show()
    button.setFocus()
    qtbot.keyClick(button, Qt.Key.Key_Return)
    assert done == ["pressed"]
    qtbot.keyClick(button, Qt.Key.Key_Space)
    assert done == ["pressed", "played"]


def test_escape_empties_a_filter_then_leaves_it_for_the_list(window: MainWindow, qtbot: QtBot) -> None:
    panel = window.docks["library"].widget()
    assert isinstance(panel, LibraryPanel)
    window.activateWindow()
    panel.filter.setFocus()
    qtbot.keyClicks(panel.filter, "go")
    qtbot.keyClick(panel.filter, Qt.Key.Key_Escape)
    assert (panel.filter.text(), panel.filter.hasFocus()) == ("", True)
    qtbot.keyClick(panel.filter, Qt.Key.Key_Escape)
    assert panel.tree.hasFocus()


@pytest.mark.parametrize("place", ["seed", "ask"])
def test_escape_leaves_a_field_and_only_then_ends_a_lesson(
    window: MainWindow, qtbot: QtBot, place: str
) -> None:
    studio = window.studio
    window.activateWindow()
    studio.actions["teach.teach"].trigger()
    qtbot.waitUntil(lambda: studio.mode is Mode.TEACHING)
    studio.teaching.asking.toggle()
    spin = window.toolbar.findChild(QAbstractSpinBox)
    assert spin is not None
    qtbot.waitUntil(spin.isEnabled)
    field = window.toolbar.seed if place == "seed" else spin
    field.setFocus()
    qtbot.keyClick(field, Qt.Key.Key_Escape)
    assert window.hasFocus()
    assert studio.actions["teach.stop"].isEnabled()
    qtbot.keyClick(window, Qt.Key.Key_Escape)
    qtbot.waitUntil(lambda: studio.mode is Mode.RUNNING)


@pytest.mark.parametrize("floats", [False, True])
def test_a_key_finds_what_has_become_possible_in_the_same_moment(
    window: MainWindow, qtbot: QtBot, floats: bool
) -> None:
    dock = window.docks["agents"]
    dock.setFloating(floats)
    if floats:
        dock.activateWindow()  # as a window manager does
        qtbot.waitUntil(dock.isActiveWindow)
    studio, possible, done = window.studio, list[str](), list[str]()
    when = When(lambda _: bool(possible), "wait")
    row = ActionRow("f9", "F9", "", lambda _: done.append("it"), keys="F9", enabled=when)
    studio.actions.add([row])
    window.addAction(studio.actions["f9"])
    QTest.keyClick(agents(window), Qt.Key.Key_F9)  # Qt's own: that of the tests does first what was put off
    assert done == []
    possible.append("it")
    studio.touch()
    QTest.keyClick(agents(window), Qt.Key.Key_F9)
    assert done == ["it"]


def test_what_was_put_off_is_not_done_any_more_once_all_has_ended(empty_studio: Studio) -> None:
    seen: list[str] = []

    def look(_studio: Studio) -> bool:
        seen.append("looked")
        return True

    row = ActionRow("f9", "F9", "", lambda _: None, enabled=When(look, ""))
    empty_studio.actions.add([row])
    seen.clear()
    empty_studio.touch()
    empty_studio.shut_down()
    catch_up()
    assert seen == []
