"""Time by keys, pressed faster than the engine answers."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QToolButton
from pytestqt.qtbot import QtBot

from app.core.automaton import Basic
from app.core.edits import add_state
from app.editor.window.main_window import MainWindow
from app.editor.window.rows import MOST_SEED
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
    # From here on agents run something else.
    studio.document.do(add_state, "agent", "wander", Basic("GrabBox"))
    pass_ticks(30)
    with qtbot.waitSignal(window.messages.shown) as shown:
        qtbot.keyClick(window, Qt.Key.Key_Home)
    assert shown.args is not None
    assert "can be gone back in to tick 20: what came before ran with other behaviors" in shown.args[0]
    qtbot.waitUntil(lambda: _tick(window) == 20)
    qtbot.waitUntil(lambda: not begin.isEnabled())
    pass_ticks(21)
    qtbot.waitUntil(begin.isEnabled)


@pytest.mark.parametrize("way", ["keys", "buttons"])
def test_a_tick_forward_and_a_tick_back_show_the_same_as_before(
    window: MainWindow, qtbot: QtBot, way: str
) -> None:
    def press(action: str, key: Qt.Key) -> None:
        qtbot.waitUntil(window.studio.actions[action].isEnabled)
        if way == "keys":
            qtbot.keyClick(window, key)
        else:
            button = next(b for b in window.toolbar.findChildren(QToolButton) if _does(b, action))
            qtbot.mouseClick(button, Qt.MouseButton.LeftButton)

    for tick in (1, 2, 3):
        press("run.step", Qt.Key.Key_Period)
        qtbot.waitUntil(lambda: _tick(window) == tick)  # noqa: B023 - called at once
    seen = _places(window)
    press("run.step", Qt.Key.Key_Period)
    qtbot.waitUntil(lambda: _tick(window) == 4)
    assert _places(window) != seen
    press("run.back", Qt.Key.Key_Comma)
    qtbot.waitUntil(lambda: _tick(window) == 3)
    assert _places(window) == seen


def test_plus_and_minus_change_the_speed_and_so_does_the_slider(window: MainWindow, qtbot: QtBot) -> None:
    toolbar, said = window.toolbar, ["1×"]
    for key in (Qt.Key.Key_Plus, Qt.Key.Key_Plus, Qt.Key.Key_Minus, Qt.Key.Key_Minus, Qt.Key.Key_Minus):
        qtbot.keyClick(window, key)
        qtbot.waitUntil(lambda: toolbar.speed_words.text() != said[-1])
        said.append(toolbar.speed_words.text())
    assert said == ["1×", "2×", "4×", "2×", "1×", "0.5×"]
    toolbar.slider.setFocus()
    qtbot.keyClick(toolbar.slider, Qt.Key.Key_End)
    qtbot.waitUntil(lambda: toolbar.speed_words.text() == "max")
    qtbot.keyClick(window, Qt.Key.Key_Plus)  # there is nothing faster
    qtbot.keyClick(window, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: _tick(window) > 100)
    qtbot.keyClick(window, Qt.Key.Key_Space)
    assert toolbar.speed_words.text() == "max"


def test_another_project_is_watched_at_the_same_speed_which_the_tool_bar_shows(
    window: MainWindow, qtbot: QtBot
) -> None:
    studio, toolbar = window.studio, window.toolbar
    document = studio.document
    qtbot.keyClick(window, Qt.Key.Key_Plus)
    qtbot.waitUntil(lambda: toolbar.speed_words.text() == "2×")
    studio.open(document.project, document.scenario, document.folder)
    qtbot.waitUntil(lambda: studio.snapshot is not None)
    assert studio.snapshot is not None
    assert studio.snapshot.speed == 0.0
    assert (toolbar.speed_words.text(), toolbar.slider.value()) == ("2×", 3)
    qtbot.keyClick(window, Qt.Key.Key_Space)
    qtbot.waitUntil(lambda: studio.snapshot is not None and studio.snapshot.speed == 2.0)


def test_a_world_is_begun_again_with_its_seed_the_next_one_or_one_that_is_typed(
    window: MainWindow, qtbot: QtBot
) -> None:
    seed, control = window.toolbar.seed, Qt.KeyboardModifier.ControlModifier
    first = _places(window)
    qtbot.keyClick(window, Qt.Key.Key_R, control | Qt.KeyboardModifier.ShiftModifier)
    qtbot.waitUntil(lambda: _seed(window) == 2)
    other = _places(window)
    assert other != first
    assert seed.text() == "2"
    qtbot.keyClick(window, Qt.Key.Key_Period)
    qtbot.waitUntil(lambda: _tick(window) == 1)
    qtbot.keyClick(window, Qt.Key.Key_R, control)
    qtbot.waitUntil(lambda: _tick(window) == 0)
    assert _places(window) == other
    qtbot.mouseDClick(seed, Qt.MouseButton.LeftButton)
    qtbot.keyClicks(seed, "1")
    qtbot.keyClick(seed, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: _seed(window) == 1)
    assert _places(window) == first


def test_after_the_greatest_seed_the_next_is_the_first(window: MainWindow, qtbot: QtBot) -> None:
    seed = window.toolbar.seed
    seed.selectAll()
    qtbot.keyClicks(seed, str(MOST_SEED))
    qtbot.keyClick(seed, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: _seed(window) == MOST_SEED)
    both = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier
    qtbot.keyClick(window, Qt.Key.Key_R, both)
    qtbot.waitUntil(lambda: _seed(window) == 0)


def test_what_is_copied_says_which_world_it_is(window: MainWindow, qtbot: QtBot) -> None:
    with qtbot.waitSignal(window.messages.shown):
        window.studio.actions["view.copy_tick"].trigger()
    copied = QGuiApplication.clipboard().text()
    assert copied == "scenario foraging, arm independent, seed 1, tick 0"


def _does(button: QToolButton, action: str) -> bool:
    return any(found.objectName() == action for found in button.actions())


def _places(window: MainWindow) -> bytes:
    assert window.studio.snapshot is not None
    columns = window.studio.snapshot.columns  # in another order once the world is compiled
    return b"".join(columns[name].tobytes() for name in sorted(columns))


def _seed(window: MainWindow) -> int:
    assert window.studio.snapshot is not None
    return window.studio.snapshot.seed


def _tick(window: MainWindow) -> int:
    assert window.studio.snapshot is not None
    return window.studio.snapshot.tick
