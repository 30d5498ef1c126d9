"""Leaving the window of experiments by keys."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from app.editor.experiments.window import ExperimentsWindow
from app.editor.window.main_window import MainWindow

NONE, CONTROL = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ControlModifier


@pytest.mark.parametrize(("key", "modifier"), [(Qt.Key.Key_Escape, NONE), (Qt.Key.Key_W, CONTROL)])
def test_the_window_is_left_by_keys_and_what_it_showed_is_there_again(
    shown: tuple[MainWindow, ExperimentsWindow], qtbot: QtBot, key: Qt.Key, modifier: Qt.KeyboardModifier
) -> None:
    main, window = shown
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    QTest.keyClick(window, key, modifier)
    assert not window.isVisible()
    assert main.isVisible()
    main.studio.actions["experiment.show"].trigger()
    assert window.isVisible()
