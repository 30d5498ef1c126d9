"""Ctrl-C and SIGTERM at a window: heeded between two events, whatever the window is at, and also while it only waits."""

import os
import signal
from collections.abc import Iterator
from threading import Thread

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.editor.studio import Studio
from app.editor.told_to_end import SIGNALS, ToldToEnd


@pytest.fixture
def told(qapp: QApplication) -> Iterator[ToldToEnd]:
    before = [signal.getsignal(number) for number in SIGNALS]
    told = ToldToEnd()
    yield told
    told.close()
    assert [signal.getsignal(number) for number in SIGNALS] == before


@pytest.mark.parametrize("number", SIGNALS)
def test_what_comes_halfway_into_a_step_is_heeded_after_it(
    told: ToldToEnd, number: signal.Signals, qtbot: QtBot
) -> None:
    came: list[str] = []
    told.came.connect(lambda: came.append("told"))
    with qtbot.waitSignal(told.came):
        signal.raise_signal(number)
        came.append("done")
    assert came == ["done", "told"]


def test_it_is_heeded_while_the_window_waits_and_no_python_runs(told: ToldToEnd, qtbot: QtBot) -> None:
    def from_outside() -> None:
        os.kill(os.getpid(), signal.SIGTERM)

    with qtbot.waitSignal(told.came):
        QTimer.singleShot(0, lambda: Thread(target=from_outside).start())


def test_a_studio_can_be_shut_down_by_it_also_while_a_command_is_on_its_way(
    told: ToldToEnd, studio: Studio, qtbot: QtBot
) -> None:
    engine = studio.bridge._engine
    assert engine is not None
    told.came.connect(studio.bridge.shut_down)  # which waits for the engine's thread
    with qtbot.waitSignal(told.came), engine._wake:
        signal.raise_signal(signal.SIGINT)
        assert studio.bridge.is_open
    assert engine.has_ended


def test_other_signals_that_python_listens_to_end_nothing(told: ToldToEnd, qtbot: QtBot) -> None:
    before = signal.signal(signal.SIGUSR1, lambda *_: None)
    try:
        with qtbot.assertNotEmitted(told.came):
            signal.raise_signal(signal.SIGUSR1)
            QApplication.processEvents()
    finally:
        signal.signal(signal.SIGUSR1, before)
