"""Time by keys, pressed faster than the engine answers."""

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from app.core.automaton import Basic
from app.core.edits import add_state
from app.editor.window.main_window import MainWindow
from app.engine.commands import Step, Watch


def test_a_second_press_stops_what_the_first_began_though_no_answer_came_between(
    window: MainWindow, qtbot: QtBot
) -> None:
    bridge = window.studio.bridge
    window.activateWindow()
    for _ in range(2):
        QTest.keyClick(window, Qt.Key.Key_Space)  # nothing of the window runs between the two
    ticket = bridge.send(Watch(()))
    qtbot.waitUntil(lambda: bridge.snapshot is not None and bridge.snapshot.acknowledged >= ticket)
    assert bridge.snapshot is not None
    assert bridge.snapshot.speed == 0.0


def test_a_single_press_lets_time_pass_and_the_next_stops_it(window: MainWindow, qtbot: QtBot) -> None:
    bridge = window.studio.bridge

    def passes() -> bool:
        return bridge.snapshot is not None and bridge.snapshot.speed != 0.0

    for _ in range(2):
        qtbot.keyClick(window, Qt.Key.Key_Space)
        qtbot.waitUntil(passes)
        qtbot.keyClick(window, Qt.Key.Key_Space)
        qtbot.waitUntil(lambda: not passes())


def test_the_beginning_is_as_early_as_the_run_is_known(window: MainWindow, qtbot: QtBot) -> None:
    studio = window.studio
    bridge, begin = studio.bridge, studio.actions["run.begin"]

    def pass_ticks(until: int) -> None:
        bridge.send(Step(until - _tick(window)))
        qtbot.waitUntil(lambda: _tick(window) == until)

    pass_ticks(20)
    studio.document.do(
        add_state, "agent", "wander", Basic("GrabBox")
    )  # from here on agents run something else
    pass_ticks(30)
    with qtbot.waitSignal(window.messages.shown) as shown:
        qtbot.keyClick(window, Qt.Key.Key_Home)
    assert shown.args is not None
    assert "can be gone back in to tick 20: what came before ran with other behaviors" in shown.args[0]
    qtbot.waitUntil(lambda: _tick(window) == 20)
    qtbot.waitUntil(lambda: not begin.isEnabled())
    pass_ticks(21)
    qtbot.waitUntil(begin.isEnabled)


def _tick(window: MainWindow) -> int:
    assert window.studio.snapshot is not None
    return window.studio.snapshot.tick
