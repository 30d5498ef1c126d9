"""In a window of 1280 by 800, and in dialogs as they open, no words are cut unless a tool tip has them in full."""

from collections.abc import Iterator

import pytest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QDialog,
    QLabel,
    QTabWidget,
    QToolButton,
    QWidget,
)
from pytestqt.qtbot import QtBot

from app.editor.selection import BehaviorKey
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE
from tests.patient_bot import have_done_what_is_due

DIALOGS = (
    "behavior.new",
    "behavior.settings",
    "behavior.demonstrations",
    "behavior.delete",
    "arm.settings",
    "edit.preferences",
    "file.new",
    "file.save_as",
    "file.export",
    "help.about",
)


def cut(widget: QWidget) -> list[str]:
    """The words of labels and buttons that do not fit in, and that no tool tip tells."""
    found = []
    for part in widget.findChildren(QWidget):
        if not part.isVisible() or part.toolTip() or not isinstance(part, QLabel | QAbstractButton):
            continue
        words = part.text()
        if isinstance(part, QLabel) and part.wordWrap():
            needed, room = part.heightForWidth(part.width()), part.height()
        elif isinstance(part, QToolButton) and not part.text():
            continue
        else:
            needed, room = part.sizeHint().width(), part.width()
        if words and needed > room:
            found.append(f"{words!r} needs {needed} and has {room}")
    return found


@pytest.fixture
def small(window: MainWindow, qtbot: QtBot) -> MainWindow:
    window.resize(1280, 800)
    qtbot.waitUntil(lambda: window.width() == 1280, timeout=PATIENCE)
    window.standard_layout()
    have_done_what_is_due()
    return window


def dialog_of(small: MainWindow, action: str, qtbot: QtBot) -> QDialog:
    small.studio.selection.select_behavior(BehaviorKey("agent", "goto"))
    have_done_what_is_due()
    small.studio.actions[action].trigger()
    dialogs = [w for w in QApplication.topLevelWidgets() if isinstance(w, QDialog) and w.isVisible()]
    assert len(dialogs) == 1
    return dialogs[0]


@pytest.fixture(params=DIALOGS)
def dialog(request: pytest.FixtureRequest, small: MainWindow, qtbot: QtBot) -> Iterator[QDialog]:
    dialog = dialog_of(small, request.param, qtbot)
    yield dialog
    dialog.reject()
    have_done_what_is_due()


def test_in_the_window_that_nobody_has_touched(small: MainWindow) -> None:
    assert not cut(small)


def test_while_an_agent_is_selected_and_taught(small: MainWindow, qtbot: QtBot) -> None:
    studio = small.studio
    assert studio.snapshot is not None
    studio.selection.select_nodes(studio.snapshot.place.agents[:1])
    have_done_what_is_due()
    assert not cut(small)
    studio.selection.select_behavior(BehaviorKey("agent", "forage"))
    have_done_what_is_due()
    studio.actions["teach.teach"].trigger()
    qtbot.waitUntil(lambda: studio.teaching.lesson is not None, timeout=PATIENCE)
    have_done_what_is_due()
    assert not cut(small)


def test_on_every_page_of_a_dialog(dialog: QDialog) -> None:
    assert dialog.width() <= 1280
    assert dialog.height() <= 760
    tabs = dialog.findChild(QTabWidget)
    assert not cut(dialog)
    for page in range(tabs.count() if isinstance(tabs, QTabWidget) else 0):
        assert isinstance(tabs, QTabWidget)
        tabs.setCurrentIndex(page)
        have_done_what_is_due()
        assert not cut(dialog)
