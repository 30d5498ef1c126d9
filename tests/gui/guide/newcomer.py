"""Does what the lesson says, by mouse and keys."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QAbstractButton
from pytestqt.qtbot import QtBot

from app.editor.guide.pupil import distances
from app.editor.guide.ring import found
from app.editor.library.panel import LibraryPanel
from app.editor.library.survey import RowKey
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE


def begin(window: MainWindow, qtbot: QtBot) -> None:
    window.studio.actions["help.lesson"].trigger()
    studio = window.studio
    qtbot.waitUntil(lambda: window.guide.isVisible() and studio.snapshot is not None, timeout=PATIENCE)


def at(window: MainWindow, qtbot: QtBot, title: str) -> None:
    """Wait until the lesson has come to a step."""
    qtbot.waitUntil(lambda: window.guide.title.text() == title, timeout=PATIENCE)


def wait_ticks(window: MainWindow, qtbot: QtBot, ticks: int) -> None:
    studio = window.studio
    assert studio.snapshot is not None
    until = studio.snapshot.tick + ticks
    qtbot.waitUntil(lambda: studio.snapshot is not None and studio.snapshot.tick >= until, timeout=PATIENCE)


def pick(window: MainWindow, qtbot: QtBot, name: str) -> None:
    def button() -> QAbstractButton | None:
        target = found(window, f"pick:{name}")
        return target if isinstance(target, QAbstractButton) else None

    qtbot.waitUntil(lambda: button() is not None, timeout=PATIENCE)
    target = button()
    assert target is not None
    qtbot.mouseClick(target, Qt.MouseButton.LeftButton)


def ring_is_around(window: MainWindow, qtbot: QtBot) -> Callable[[], bool]:
    ring = window.guide.ring
    return lambda: ring.isVisible() and ring.target is not None


def time_stands_still(window: MainWindow) -> Callable[[], bool]:
    studio = window.studio
    return lambda: studio.snapshot is not None and studio.snapshot.speed == 0.0


def all_is_answered(window: MainWindow) -> Callable[[], bool]:
    studio, engine = window.studio, window.studio.bridge._engine
    assert engine is not None
    return lambda: studio.snapshot is not None and studio.snapshot.acknowledged >= engine._tickets


def press_next(window: MainWindow, qtbot: QtBot) -> None:
    """Say that one has seen what there was to see."""
    assert window.guide.skip.text() == "Next"
    qtbot.mouseClick(window.guide.skip, Qt.MouseButton.LeftButton)


def turn_left(window: MainWindow, qtbot: QtBot) -> None:
    """Do what the lesson says until the agent turns left, while time passes."""
    qtbot.keyClick(window, Qt.Key.Key_T)
    at(window, qtbot, "Send it ahead")
    pick(window, qtbot, "Forward")
    at(window, qtbot, "Let it walk")
    qtbot.keyClick(window, Qt.Key.Key_Space)
    at(window, qtbot, "Turn it left")
    pick(window, qtbot, "RotateLeft")
    at(window, qtbot, "And ahead again")
    wait_ticks(window, qtbot, 10)


def teach_wander(window: MainWindow, qtbot: QtBot) -> None:
    """Do what the first half of the lesson says."""
    turn_left(window, qtbot)
    pick(window, qtbot, "Forward")
    at(window, qtbot, "Turn it right")
    qtbot.waitUntil(time_stands_still(window), timeout=PATIENCE)
    pick(window, qtbot, "RotateRight")
    at(window, qtbot, "Ahead once more")
    qtbot.keyClick(window, Qt.Key.Key_Space)
    wait_ticks(window, qtbot, 10)
    pick(window, qtbot, "Forward")
    at(window, qtbot, "Test it")
    qtbot.keyClick(window, Qt.Key.Key_T, Qt.KeyboardModifier.ShiftModifier)
    at(window, qtbot, "Watch them")
    window.speed.choose(window.studio, 4.0)


def near_a_box(window: MainWindow) -> str:
    """The agent nearest to a box."""
    snapshot = window.studio.snapshot
    assert snapshot is not None
    return snapshot.place.agents[int(distances(snapshot).argmin())]


def choose_in_library(window: MainWindow, qtbot: QtBot, key: RowKey) -> None:
    """Click a behavior in the library."""
    panel = window.docks["library"].widget()
    assert isinstance(panel, LibraryPanel)
    index = panel.shown.mapFromSource(panel.model.find(key))
    panel.tree.scrollTo(index)
    row = panel.tree.visualRect(index)
    spot = QPoint(row.left() + 30, row.center().y())  # on its name
    qtbot.mouseClick(panel.tree.viewport(), Qt.MouseButton.LeftButton, pos=spot)


def faster(window: MainWindow, qtbot: QtBot, speed: float) -> None:
    """Press the key for faster until it is as fast as that."""
    for _ in range(20):
        if window.speed.chosen != speed:
            qtbot.keyClick(window, Qt.Key.Key_Plus)
    assert window.speed.chosen == speed


def play_until(window: MainWindow, qtbot: QtBot, feature: str) -> None:
    """Let time pass, which stops by itself, unless it is so already."""
    if not seen_by(window, feature):
        qtbot.keyClick(window, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: seen_by(window, feature) and time_stands_still(window)(), timeout=PATIENCE)


def walk_on(window: MainWindow, qtbot: QtBot) -> None:
    """Have time go on although it stands still at a box, until that is out of sight."""

    def gone_or_still() -> bool:
        return not seen_by(window, "sees") or time_stands_still(window)()

    while seen_by(window, "sees"):
        tick = tick_of(window)
        qtbot.keyClick(window, Qt.Key.Key_Space)
        qtbot.waitUntil(
            partial(lambda tick: tick_of(window) > tick and gone_or_still(), tick), timeout=PATIENCE
        )


def tick_of(window: MainWindow) -> int:
    snapshot = window.studio.snapshot
    return 0 if snapshot is None else snapshot.tick


def seen_by(window: MainWindow, feature: str) -> bool:
    """Whether a feature of Forage is true for the agent that is taught."""
    studio = window.studio
    watched = None if studio.snapshot is None else studio.snapshot.watched.get(studio.teaching.node)
    return watched is not None and watched.levels[0].values.get(feature, 0.0) > 0.0


def press(window: MainWindow, qtbot: QtBot, key: Qt.Key) -> None:
    """Press a key that passes a tick."""
    before = tick_of(window)
    qtbot.keyClick(window, key)
    qtbot.waitUntil(lambda: tick_of(window) > before, timeout=PATIENCE)
