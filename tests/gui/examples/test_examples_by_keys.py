"""Examples by keys alone, from anywhere in the window."""

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.editor.examples.panel import ExamplesPanel
from app.editor.examples.verdicts import Verdict
from app.editor.selection import BehaviorKey
from app.editor.window.main_window import MainWindow

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
WANDER = BehaviorKey("agent", "wander")


@pytest.fixture
def panel(window: MainWindow, qtbot: QtBot) -> ExamplesPanel:
    """The panel with the examples of Wander, the keys on it."""
    window.studio.selection.select_behavior(WANDER)
    panel = window.docks["examples"].widget()
    assert isinstance(panel, ExamplesPanel)
    qtbot.waitUntil(lambda: panel.model.subject is not None and panel.model.subject.automaton.id == WANDER.id)
    qtbot.waitUntil(lambda: panel.model.verdict(panel.model.example(0)) is not Verdict.UNKNOWN)
    window.show_panel("examples")
    return panel


def is_live(window: MainWindow) -> bool:
    return window.canvas.is_live


def test_examples_are_switched_off_and_on_together(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    def enabled() -> list[bool]:
        return [e.enabled for e in window.studio.document.project.examples_of(WANDER.type, WANDER.id)]

    qtbot.keyClick(panel.table, Qt.Key.Key_A, CONTROL)
    qtbot.waitUntil(window.studio.actions["examples.disable"].isEnabled)
    qtbot.keyClick(panel.table, Qt.Key.Key_Backspace, CONTROL)
    assert not any(enabled())
    qtbot.keyClick(panel.table, Qt.Key.Key_Z, CONTROL)
    assert all(enabled())
    qtbot.keyClick(panel.table, Qt.Key.Key_Z, CONTROL | SHIFT)
    qtbot.keyClick(panel.table, Qt.Key.Key_Backspace, CONTROL | SHIFT)
    assert all(enabled())


def test_the_moment_of_an_example_is_shown_by_ctrl_m_and_escape_goes_back(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    example = panel.model.example(2)
    window.studio.selection.select_examples([example.id])  # as the tree does, which shows no moment
    qtbot.waitUntil(window.studio.actions["examples.moment"].isEnabled)
    assert is_live(window)
    qtbot.keyClick(panel.table, Qt.Key.Key_M, CONTROL)
    assert not is_live(window)
    assert window.canvas.on_top.moment.words.text().startswith(f"The moment of example {example.id}")
    qtbot.keyClick(panel.table, Qt.Key.Key_Escape)
    assert is_live(window)


def test_examples_that_contradict_each_other_are_shown_from_the_menu(
    window: MainWindow, panel: ExamplesPanel, qtbot: QtBot
) -> None:
    window.studio.actions["examples.conflicts"].trigger()
    assert panel.filters.verdict.currentData() == Verdict.CONFLICT
    qtbot.waitUntil(lambda: panel.model.counts[0] == 2)


@pytest.mark.parametrize("name", ["source", "label", "node", "demonstration"])
def test_every_filter_is_set_by_keys_and_leaves_what_it_says(
    panel: ExamplesPanel, qtbot: QtBot, name: str
) -> None:
    everything = [panel.model.example(row) for row in range(panel.model.rowCount())]
    box = getattr(panel.filters, name)
    box.setFocus()
    qtbot.keyClick(box, Qt.Key.Key_Down)
    wanted = box.currentData()
    passing = [example for example in everything if getattr(example, name) == wanted]
    assert passing
    shown = [panel.model.example(row) for row in range(panel.model.rowCount())]
    assert {example.id for example in shown} == {example.id for example in passing}
