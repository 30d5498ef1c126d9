"""Where panels stand: low and narrow windows, tabs, and what puts them back."""

import pytest
from PySide6.QtWidgets import QApplication, QTabBar
from pytestqt.qtbot import QtBot

from app.core.edits import add_automaton
from app.core.project import Project
from app.editor.selection import BehaviorKey
from app.editor.settings import Settings
from app.editor.studio import Studio
from app.editor.theme import Theme
from app.editor.window.docks import DOCKS
from app.editor.window.main_window import MainWindow
from app.engine.scenarios import open_scenario
from app.engine.snapshots import Mode
from tests.gui.conftest import PATIENCE


@pytest.mark.parametrize("panel", [row.id for row in DOCKS])
def test_every_panel_can_be_hidden_and_brought_back(window: MainWindow, panel: str) -> None:
    dock = window.docks[panel]
    dock.hide()
    window.studio.actions[f"view.{panel}"].trigger()
    assert not dock.isHidden()


@pytest.mark.parametrize(("height", "shared"), [(800, True), (900, False)])
def test_in_a_low_window_the_automaton_and_its_tree_share_a_place(
    window: MainWindow, studio: Studio, qtbot: QtBot, height: int, *, shared: bool
) -> None:
    window.resize(1280, height)
    studio.actions["view.standard"].trigger()
    graph, tree = window.docks["graph"], window.docks["tree"]
    assert (tree in window.tabifiedDockWidgets(graph)) is shared
    qtbot.waitUntil(lambda: graph.isVisible() and not graph.visibleRegion().isEmpty(), timeout=PATIENCE)
    assert tree.visibleRegion().isEmpty() is shared
    window.show_panel("tree")
    qtbot.waitUntil(lambda: not tree.visibleRegion().isEmpty(), timeout=PATIENCE)


def test_a_tab_says_what_it_is_however_long_names_are(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    window.resize(1280, 800)
    studio.actions["view.standard"].trigger()
    name = "A behavior that somebody has given a name of many words"
    studio.selection.select_behavior(BehaviorKey("agent", studio.document.do(add_automaton, "agent", name)))
    graph, tree = window.docks["graph"], window.docks["tree"]
    qtbot.waitUntil(lambda: graph.windowTitle().startswith("Automaton · A behavior"), timeout=PATIENCE)
    assert graph.windowTitle().endswith("…")
    assert tree.windowTitle() == "Decision tree"
    graph.setFloating(True)
    qtbot.waitUntil(lambda: graph.windowTitle() == f"Automaton · {name}", timeout=PATIENCE)


def test_what_a_lesson_took_of_the_window_goes_back_after_it(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    examples = window.docks["examples"]
    qtbot.waitUntil(lambda: examples.height() > 150, timeout=PATIENCE)
    before = examples.height()
    studio.selection.select_nodes(("agent-1",))
    studio.teaching.teach()
    qtbot.waitUntil(lambda: studio.mode is Mode.TEACHING, timeout=PATIENCE)
    qtbot.waitUntil(lambda: examples.height() < before, timeout=PATIENCE)
    studio.teaching.stop()
    qtbot.waitUntil(lambda: examples.height() >= before - 20, timeout=PATIENCE)


def test_a_layout_from_before_there_was_some_panel_is_not_taken_up(
    qapp: QApplication, window: MainWindow, qtbot: QtBot, settings: Settings, foraging: Project
) -> None:
    window.removeDockWidget(window.docks["timeline"])
    settings.keep("state", window.saveState(len(DOCKS) - 1))
    studio = Studio(Theme(qapp, settings.theme), settings)
    later = MainWindow(studio)
    qtbot.addWidget(later)
    later.show()
    studio.open(foraging, open_scenario(foraging), None, saved=True)
    beside = later.tabifiedDockWidgets(later.docks["examples"])
    assert later.docks["timeline"] in beside
    later.hide()
    studio.shut_down()


def test_the_standard_layout_leaves_no_tabs_of_another_one(
    window: MainWindow, studio: Studio, qtbot: QtBot
) -> None:
    def tabs_on_the_window() -> list[str]:
        bars = [bar for bar in window.findChildren(QTabBar) if bar.parent() is window and bar.isVisible()]
        seen = [bar for bar in bars if window.rect().intersects(bar.geometry())]
        return sorted(bar.tabText(k).split(" ")[0] for bar in seen for k in range(bar.count()))

    window.docks["graph"].setFloating(True)
    for _ in range(2):
        studio.actions["view.standard"].trigger()
    qtbot.waitUntil(
        lambda: tabs_on_the_window() == ["Examples", "Plots", "Problems", "Timeline"], timeout=PATIENCE
    )
    assert not window.docks["graph"].isFloating()


def test_opening_another_project_leaves_window_and_panels_where_they_are(
    window: MainWindow, studio: Studio, foraging: Project
) -> None:
    window.resize(1300, 820)
    window.docks["examples"].hide()
    size = window.size()
    studio.open(foraging, open_scenario(foraging), None, saved=False)
    assert window.size() == size
    assert window.docks["examples"].isHidden()


def test_a_panel_that_floated_elsewhere_is_back_in_its_place(window: MainWindow, qtbot: QtBot) -> None:
    dock = window.docks["graph"]
    place = dock.geometry()
    dock.setFloating(True)
    dock.move(300, 200)
    QApplication.processEvents()
    dock.setFloating(False)
    qtbot.waitUntil(lambda: dock.geometry().topLeft() == place.topLeft(), timeout=PATIENCE)
