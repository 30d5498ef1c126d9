"""Plots as a user sees them."""

from collections.abc import Mapping
from typing import Any

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.editor.plots.panel import PlotsPanel
from app.editor.plots.series import LineKey
from app.editor.theme import ThemeMode
from app.editor.window.main_window import MainWindow
from app.engine.commands import Pause, Play
from tests.gui.conftest import PATIENCE


@pytest.fixture
def panel(window: MainWindow, qtbot: QtBot) -> PlotsPanel:
    """The panel in front, in a world of groups that has run for a while."""
    studio = window.studio
    with qtbot.waitSignal(studio.bridge.place_changed, timeout=PATIENCE):
        studio.use_arm("one level")
    studio.actions["run.plot"].trigger()
    panel = window.docks["plots"].widget()
    assert isinstance(panel, PlotsPanel)
    studio.bridge.send(Play(16.0))
    qtbot.waitUntil(lambda: len(panel._record.points) > 5, timeout=PATIENCE)
    studio.bridge.send(Pause())
    qtbot.waitUntil(lambda: bool(curves(panel)), timeout=PATIENCE)
    return panel


def curves(panel: PlotsPanel) -> Mapping[LineKey, Any]:
    return {} if panel.view is None else panel.view.curves


def names(panel: PlotsPanel) -> set[str]:
    return {panel.name(key) for key in curves(panel)}


def test_shares_of_behaviors_are_drawn_in_their_colors(window: MainWindow, panel: PlotsPanel) -> None:
    assert "Wander" in names(panel)
    key = next(key for key in curves(panel) if key[-1] == "Wander")
    pen = curves(panel)[key].opts["pen"]
    assert pen.color() == window.studio.colors.color("agent", "wander")


def test_the_share_of_states_and_every_measure_can_be_chosen(panel: PlotsPanel, qtbot: QtBot) -> None:
    there = [panel.what.itemText(k) for k in range(panel.what.count())]
    assert there[0] == "Behaviors of agents"
    assert there[1].startswith("States of ")
    assert there[2:] == ["Boxes", "Weight"]
    panel.what.setFocus()
    for _ in range(panel.what.count()):
        qtbot.keyClick(panel.what, Qt.Key.Key_Down)
    assert panel.what.currentText() == "Weight"
    qtbot.waitUntil(lambda: names(panel) == {"weight"}, timeout=PATIENCE)


def test_a_group_can_be_plotted_by_itself(window: MainWindow, panel: PlotsPanel, qtbot: QtBot) -> None:
    window.studio.selection.select_nodes(["group-2"])
    qtbot.waitUntil(lambda: panel.whom.count() == 2, timeout=PATIENCE)
    panel.whom.setFocus()
    qtbot.keyClick(panel.whom, Qt.Key.Key_Down)
    qtbot.waitUntil(lambda: bool(curves(panel)), timeout=PATIENCE)
    key = next(iter(curves(panel)))
    values = panel._lines.line(key)[1]
    assert set((5 * values).round(6)) <= {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}
    shares = panel.what.currentText()
    for subject, whom in (("Boxes", "of the world"), (shares, "of Group 2")):  # a measure is of the world
        panel.choose(subject)
        assert panel.whom.currentText() == whom


def test_another_world_begins_other_curves(window: MainWindow, panel: PlotsPanel, qtbot: QtBot) -> None:
    with qtbot.waitSignal(window.studio.bridge.place_changed, timeout=PATIENCE):
        window.studio.use_arm("independent")
    qtbot.waitUntil(lambda: len(panel._record.points) <= 1, timeout=PATIENCE)


def test_before_time_has_passed_the_panel_says_what_to_do(window: MainWindow) -> None:
    window.show_panel("plots")
    panel = window.docks["plots"].widget()
    assert isinstance(panel, PlotsPanel)
    assert panel._pages.currentIndex() == 0


def test_the_legend_has_room_in_a_narrow_panel(panel: PlotsPanel) -> None:
    panel.resize(600, 200)  # as in a small window
    panel.grab()  # lays it out
    assert panel.view is not None
    assert panel.view.legend.width() >= panel.view.legend.sizeHint().width()


def test_a_low_plot_gives_the_room_of_words_to_the_lines(
    panel: PlotsPanel, window: MainWindow, qtbot: QtBot
) -> None:
    view = panel.view
    assert view is not None
    label = view._plot.getAxis("bottom").label
    window.docks["plots"].setFloating(True)
    window.docks["plots"].resize(600, 400)
    qtbot.waitUntil(label.isVisible, timeout=PATIENCE)
    window.docks["plots"].resize(600, 150)
    qtbot.waitUntil(lambda: not label.isVisible(), timeout=PATIENCE)
    window.studio.settings.theme = ThemeMode.DARK
    assert not label.isVisible()


def test_once_there_is_something_to_plot_the_world_is_no_lower_than_before(
    window: MainWindow, panel: PlotsPanel
) -> None:
    beside = window.docks["examples"].widget()
    assert panel.minimumSizeHint().height() <= beside.minimumSizeHint().height()
