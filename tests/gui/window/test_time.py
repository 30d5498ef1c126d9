"""Time by keys, pressed faster than the engine answers."""

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from app.editor.window.main_window import MainWindow
from app.engine.commands import Watch


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
