"""What nobody foresaw fails in one place: the window goes on, and says so once, with where to find what to report."""

import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QStringListModel, Qt, QTimer
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import QListView, QPushButton, QWidget
from pytestqt.qtbot import QtBot

from app.editor.unforeseen import Unforeseen
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE


class Failing(QStringListModel):
    """Cannot say what it holds."""

    def data(self, _index: QModelIndex | QPersistentModelIndex, _role: int = 0) -> object:
        raise LookupError("no such row")


class Unpaintable(QWidget):
    """Cannot be painted."""

    def paintEvent(self, _event: QPaintEvent) -> None:  # noqa: N802 - Qt's name
        raise ZeroDivisionError("by design")


@pytest.fixture
def unforeseen(window: MainWindow, tmp_path: Path) -> Iterator[Unforeseen]:
    """Listens, and writes down what it hears."""

    def keep(error: BaseException) -> Path:
        kept = tmp_path / "crash.txt"
        kept.write_text(str(error))
        return kept

    before = sys.excepthook
    sys.excepthook = lambda *_: None  # the one of the tests would have this test fail
    unforeseen = Unforeseen(keep)
    unforeseen.came.connect(window.studio.warn)
    yield unforeseen
    unforeseen.close()
    sys.excepthook = before


def failing_list() -> QWidget:
    view = QListView()
    model = Failing(["a", "b"], view)
    view.setModel(model)
    return view


def failing_widget() -> QWidget:
    return Unpaintable()


def failing_button() -> QWidget:
    def fail() -> None:
        raise ValueError("by design")

    button = QPushButton("Fail")
    button.clicked.connect(fail)
    return button


def failing_through_qt() -> QWidget:
    """Fails in our code that Qt calls when our code calls Qt."""
    unpaintable = Unpaintable()

    def fail() -> None:
        unpaintable.grab()

    button = QPushButton("Fail")
    button.clicked.connect(fail)
    return button


@pytest.mark.qt_no_exception_capture
@pytest.mark.parametrize("make", [failing_list, failing_widget, failing_button, failing_through_qt])
def test_what_fails_is_told_once_and_the_window_goes_on(
    make: Callable[[], QWidget],
    window: MainWindow,
    unforeseen: Unforeseen,
    tmp_path: Path,
    qtbot: QtBot,
) -> None:
    told: list[str] = []
    window.messages.shown.connect(told.append)
    part = make()
    qtbot.addWidget(part)
    QTimer.singleShot(0, part.show)  # from here on it is Qt that calls
    qtbot.waitUntil(part.isVisible, timeout=PATIENCE)
    target = part.viewport() if isinstance(part, QListView) else part
    for _ in range(3):
        qtbot.mouseClick(target, Qt.MouseButton.LeftButton)
        target.update()
    qtbot.waitUntil(lambda: bool(told), timeout=PATIENCE)
    part.hide()
    assert len(told) == 1
    assert "something in the program failed, and it went on without" in told[0]
    assert "override" not in told[0]  # of what, nobody asked
    assert str(tmp_path / "crash.txt") in told[0]
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow, timeout=PATIENCE)
    qtbot.keyClick(window, Qt.Key.Key_Space)
    studio = window.studio
    qtbot.waitUntil(lambda: studio.snapshot is not None and studio.snapshot.speed != 0.0, timeout=PATIENCE)
