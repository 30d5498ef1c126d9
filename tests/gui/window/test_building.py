"""A window for a run is built a part at a time, so that the window that asked for it goes on."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from app.editor.application import RunWindows
from app.editor.settings import Settings
from app.editor.studio import Studio
from app.editor.theme import Theme, ThemeMode
from app.editor.window.main_window import MainWindow
from tests.patient_bot import have_done_what_is_due


def main_windows() -> set[MainWindow]:
    """Those that there are; other tests may have left some that nobody has deleted yet."""
    return {window for window in QApplication.topLevelWidgets() if isinstance(window, MainWindow)}


def others(main: MainWindow) -> list[MainWindow]:
    return [window for window in main_windows() if window is not main and window.isVisible()]


def want_a_run(window: MainWindow) -> None:
    """As the page of runs does for a run of another forest."""
    document = window.studio.document
    arm = document.project.arms[0].name
    window.studio.window_wanted.emit(document.project, document.scenario, arm, 3, 5)


def test_a_window_built_in_parts_is_the_same_whatever_happens_between(
    window: MainWindow, qapp: QApplication, settings: Settings, qtbot: QtBot
) -> None:
    parts = MainWindow(Studio(Theme(qapp, settings.theme), settings), at_once=False)
    qtbot.addWidget(parts)
    built = 0
    while parts.build_more():
        built += 1
        settings.theme = ThemeMode.DARK if built % 2 else ThemeMode.LIGHT
        have_done_what_is_due()
    assert built > 2 * len(parts.docks), "a panel and its dock take a turn each"
    assert parts.docks.keys() == window.docks.keys()
    assert parts.studio.actions.rows.keys() == window.studio.actions.rows.keys()
    titles = [[action.text() for action in each.menuBar().actions()] for each in (parts, window)]
    assert titles[0] == titles[1]
    parts.studio.shut_down()


def test_a_run_comes_in_a_window_of_its_own(window: MainWindow, qapp: QApplication, qtbot: QtBot) -> None:
    windows = RunWindows(qapp, window)
    want_a_run(window)
    assert not others(window)
    qtbot.waitUntil(lambda: bool(others(window)))
    (other,) = others(window)
    qtbot.waitUntil(lambda: other.studio.snapshot is not None and other.studio.snapshot.tick == 5)
    windows.close()
    qtbot.waitUntil(lambda: not others(window))


def test_who_closes_before_a_window_is_there_sees_none(
    window: MainWindow, qapp: QApplication, qtbot: QtBot
) -> None:
    windows = RunWindows(qapp, window)
    want_a_run(window)
    windows.close()
    have_done_what_is_due()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert not others(window)


def is_gone(window: MainWindow) -> bool:
    return not isValid(window)


def test_windows_of_runs_that_were_closed_are_gone(
    window: MainWindow, qapp: QApplication, settings: Settings, qtbot: QtBot
) -> None:
    windows, before = RunWindows(qapp, window), main_windows()
    for _ in range(2):
        want_a_run(window)
        qtbot.waitUntil(lambda: bool(others(window)))
        (other,) = others(window)
        other.close()
        qtbot.waitUntil(partial(is_gone, other))
        settings.theme = ThemeMode.LIGHT if settings.theme is ThemeMode.DARK else ThemeMode.DARK
        have_done_what_is_due()
    assert main_windows() <= before
    windows.close()
