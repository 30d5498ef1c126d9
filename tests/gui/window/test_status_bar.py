"""The status bar: what world this is, how fast time passes, what was learned, what is saved."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from app.core.edits import add_automaton, disable_examples, rename_automaton
from app.core.project import Project
from app.editor.selection import BehaviorKey
from app.editor.studio import Studio
from app.editor.window.main_window import MainWindow
from app.editor.window.status_bar import StatusBar
from app.editor.window.toolbar import Toolbar
from app.engine.scenarios import open_scenario
from tests.gui.conftest import PATIENCE
from tests.patient_bot import have_done_what_is_due


def test_the_status_bar_counts_what_the_world_counts(window: MainWindow, qtbot: QtBot) -> None:
    measures = window.statusBar().findChildren(QLabel)
    qtbot.waitUntil(lambda: any("boxes 0" in label.text() for label in measures), timeout=PATIENCE)


def test_a_window_that_comes_later_says_tick_and_seed_at_once(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    bar, tools = StatusBar(studio), Toolbar(studio, window.speed)
    for part in (bar, tools):
        qtbot.addWidget(part)
    assert (bar.tick.text(), tools.seed.text()) == ("tick 0", "1")


def test_how_well_a_behavior_fits_is_said_of_what_it_is_now_also_while_the_library_is_hidden(
    window: MainWindow, qtbot: QtBot
) -> None:
    studio, bar = window.studio, window.statusBar()
    assert isinstance(bar, StatusBar)
    studio.selection.select_behavior(BehaviorKey("agent", "wander"))
    qtbot.waitUntil(lambda: bar.fit.text() == "Wander fits 90% of 10 examples", timeout=PATIENCE)
    window.hide_panel("library")
    studio.document.do(disable_examples, "agent", "wander", ["1"])
    qtbot.waitUntil(lambda: bar.fit.text() == "Wander fits 89% of 9 examples", timeout=PATIENCE)
    studio.document.do(rename_automaton, "agent", "wander", "Roam")
    qtbot.waitUntil(lambda: bar.fit.text() == "Roam fits 89% of 9 examples", timeout=PATIENCE)


def test_the_status_bar_says_how_fast_time_passes_what_was_learned_and_what_is_saved(
    window: MainWindow, foraging: Project, qtbot: QtBot
) -> None:
    bar = window.statusBar()
    assert isinstance(bar, StatusBar)
    qtbot.waitUntil(lambda: (bar.tick.text(), bar.rate.text()) == ("tick 0", "paused"), timeout=PATIENCE)
    assert bar.saved.text() == "saved"
    qtbot.keyClick(window, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: bar.rate.text().endswith(" ticks/s"), timeout=PATIENCE)
    qtbot.keyClick(window, Qt.Key.Key_Space)
    window.studio.document.do(disable_examples, "agent", "wander", ["1"])
    qtbot.waitUntil(lambda: bar.learner.text().startswith("learned "), timeout=PATIENCE)
    window.studio.selection.select_behavior(BehaviorKey("agent", "forage"))
    qtbot.waitUntil(lambda: bar.fit.text() == "Forage fits all 10 examples", timeout=PATIENCE)
    window.studio.selection.select_behavior(
        BehaviorKey("agent", "wander")
    )  # two of its examples contradict each other
    qtbot.waitUntil(lambda: bar.fit.text() == "Wander fits 89% of 9 examples", timeout=PATIENCE)
    assert bar.saved.text() == "unsaved changes"
    window.studio.open(foraging, open_scenario(foraging), None, saved=False)
    qtbot.waitUntil(lambda: bar.learner.text() == "", timeout=PATIENCE)  # that was another project


def test_what_was_undone_is_said_until_something_else_is_done(window: MainWindow, qtbot: QtBot) -> None:
    bar, document = window.statusBar(), window.studio.document
    assert isinstance(bar, StatusBar)
    for name in ("Roam", "Stroll"):
        document.do(rename_automaton, "agent", "wander", name)
    window.studio.selection.select_behavior(BehaviorKey("agent", "forage"))  # what is undone is not in sight
    undo = Qt.KeyboardModifier.ControlModifier
    qtbot.keyClick(window, Qt.Key.Key_Z, undo)
    assert bar.undone.text() == "undone: Rename Roam to Stroll"
    qtbot.keyClick(window, Qt.Key.Key_Z, undo)
    assert bar.undone.text() == "undone: Rename Wander to Roam"
    qtbot.keyClick(window, Qt.Key.Key_Z, undo | Qt.KeyboardModifier.ShiftModifier)
    assert bar.undone.text() == "undone: Rename Roam to Stroll"
    document.do(rename_automaton, "agent", "wander", "Amble")
    assert bar.undone.text() == ""


def test_what_was_undone_makes_no_window_wider_however_long_it_is(window: MainWindow, qtbot: QtBot) -> None:
    bar, document = window.statusBar(), window.studio.document
    assert isinstance(bar, StatusBar)
    have_done_what_is_due()
    before = window.minimumSizeHint().width()
    document.do(rename_automaton, "agent", "wander", "Stroll" * 40)
    qtbot.keyClick(window, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert bar.undone.text() == f"undone: Rename Wander to {'Stroll' * 40}"
    qtbot.waitUntil(lambda: bar.undone.toolTip() == bar.undone.text())  # it is cut
    assert window.minimumSizeHint().width() == before


def test_nothing_is_said_to_be_learned_where_there_are_no_examples(window: MainWindow, qtbot: QtBot) -> None:
    bar, studio = window.statusBar(), window.studio
    assert isinstance(bar, StatusBar)
    busy: list[bool] = []
    studio.relearning.changed.connect(lambda: busy.append(studio.relearning.busy))
    studio.document.do(add_automaton, "agent", "Mine")
    qtbot.waitUntil(lambda: bool(busy) and not busy[-1], timeout=PATIENCE)
    assert bar.learner.text() == ""
    studio.document.do(disable_examples, "agent", "wander", ["1"])
    qtbot.waitUntil(lambda: bar.learner.text().startswith("learned "), timeout=PATIENCE)


def test_a_world_that_departs_from_its_arm_says_how_until_the_arm_is_chosen_again(
    window: MainWindow, qtbot: QtBot
) -> None:
    bar = window.statusBar()
    assert isinstance(bar, StatusBar)
    window.studio.use_arm("independent", {"world.boxes": 20})
    qtbot.waitUntil(lambda: bar.scenario.text() == "foraging · kinematic · boxes 20", timeout=PATIENCE)
    assert "Choosing the arm again begins its own world" in bar.scenario.toolTip()
    window.toolbar.arm.setFocus()
    qtbot.keyClick(window.toolbar.arm, Qt.Key.Key_Down)
    qtbot.keyClick(window.toolbar.arm, Qt.Key.Key_Up)
    qtbot.waitUntil(lambda: bar.scenario.text() == "foraging · kinematic", timeout=PATIENCE)
