"""What moves things: said where it is switched, and in the status bar."""

from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from app.core.storage import load
from app.editor.agents.panel import AgentsPanel
from app.editor.library.panel import LibraryPanel
from app.editor.window.main_window import MainWindow
from app.editor.window.physics import physics_words
from app.engine.scenarios import open_scenario
from tests.gui.conftest import FORAGING


def test_whoever_takes_rigid_physics_is_told_what_is_different(window: MainWindow, qtbot: QtBot) -> None:
    studio = window.studio
    qtbot.waitUntil(studio.actions["run.rigid"].isEnabled)
    with qtbot.waitSignal(window.messages.shown) as shown, qtbot.waitSignal(studio.bridge.place_changed):
        studio.actions["run.rigid"].trigger()
    assert shown.args is not None
    assert "agents are bodies, 1 wide, so two of them come no nearer than 1 to each other" in shown.args[0]
    status = window.statusBar().findChildren(QLabel)
    qtbot.waitUntil(lambda: any("come no nearer" in label.toolTip() for label in status))
    with qtbot.waitSignal(studio.bridge.place_changed):
        studio.actions["run.rigid"].trigger()
    qtbot.waitUntil(lambda: any("nothing bumps into anything" in label.toolTip() for label in status))
    qtbot.waitUntil(lambda: not window.messages.isVisible())  # it does not hold any more


def test_what_was_said_of_physics_and_looked_for_does_not_go_on_in_another_project(
    window: MainWindow, qtbot: QtBot
) -> None:
    studio, panels = window.studio, [window.docks[name].widget() for name in ("library", "agents")]
    qtbot.waitUntil(studio.actions["run.rigid"].isEnabled)
    with qtbot.waitSignal(window.messages.shown), qtbot.waitSignal(studio.bridge.place_changed):
        studio.actions["run.rigid"].trigger()
    filters = [panel.filter for panel in panels if isinstance(panel, LibraryPanel | AgentsPanel)]
    assert len(filters) == len(panels)
    for field in filters:
        qtbot.keyClicks(field, "no such thing")
    project = load(FORAGING)
    studio.open(project, open_scenario(project), None, saved=False)
    assert not any(field.text() for field in filters)
    qtbot.waitUntil(lambda: not window.messages.isVisible())


def test_another_arm_has_the_physics_that_was_taken(window: MainWindow, qtbot: QtBot) -> None:
    studio = window.studio
    qtbot.waitUntil(studio.actions["run.rigid"].isEnabled)
    with qtbot.waitSignal(studio.bridge.place_changed):
        studio.actions["run.rigid"].trigger()
    with qtbot.waitSignal(studio.bridge.place_changed):
        studio.use_arm("one level")
    assert studio.snapshot is not None
    assert (studio.snapshot.arm, studio.snapshot.place.physics) == ("one level", "rigid")


def test_where_agents_do_not_bump_no_nearness_is_spoken_of() -> None:
    bodies = open_scenario(load(FORAGING)).bodies
    words = physics_words("rigid", bodies, {"contact": False, "agent_diameter": 1.0})
    assert "do not bump" in words
    assert "nearer" not in words
