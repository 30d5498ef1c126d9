"""In a window of 1280 by 800, and in dialogs as they open, no words are cut unless a tool tip has them in full; dialogs have
room on a screen of 1280 by 720, and whoever does not see a control is told what it is."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import QSize
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QDialog,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QSlider,
    QTabBar,
    QTabWidget,
    QToolButton,
    QWidget,
)
from pytestqt.qtbot import QtBot

from app.editor.cut_line import CutLine
from app.editor.room import FRAME
from app.editor.selection import BehaviorKey
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE
from tests.patient_bot import have_done_what_is_due

#: A screen of 1920 by 1080 on which everything is half as large again.
SCREEN = QSize(1280, 720)
CONTROLS = QAbstractButton | QComboBox | QAbstractSpinBox | QSlider | QLineEdit | QPlainTextEdit
DIALOGS = (
    "behavior.new",
    "behavior.note",
    "behavior.settings",
    "behavior.demonstrations",
    "behavior.delete",
    "arm.settings",
    "edit.preferences",
    "file.new",
    "file.save_as",
    "file.export",
    "help.about",
    "help.keys",
)


def cut(widget: QWidget) -> list[str]:
    """The words that do not fit in, and that no tool tip tells."""
    found = [*cut_in_fields(widget), *cut_in_tabs(widget)]
    for part in widget.findChildren(QWidget):
        if not part.isVisible() or part.toolTip() or not isinstance(part, QLabel | QAbstractButton):
            continue
        words = part.text()
        if isinstance(part, CutLine):  # has its tool tip once it is painted
            continue
        if isinstance(part, QLabel) and part.wordWrap():
            needed, room = part.heightForWidth(part.width()), part.height()
        elif isinstance(part, QToolButton) and not part.text():
            continue
        else:
            needed, room = part.sizeHint().width(), part.width()
        if words and needed > room:
            found.append(f"{words!r} needs {needed} and has {room}")
    return found


def cut_in_fields(widget: QWidget) -> list[str]:
    """Those of fields, and of lists to choose from."""
    found = []
    for field in widget.findChildren(QLineEdit):
        above = field.parentWidget()
        told = above.toolTip() if isinstance(above, QComboBox) else field.toolTip()
        if not field.isVisible() or told or isinstance(above, QAbstractSpinBox):
            continue
        words = field.text() or field.placeholderText()
        if field.fontMetrics().horizontalAdvance(words) > field.width():
            found.append(f"{words!r} has {field.width()}")
    for box in widget.findChildren(QComboBox):
        if box.isVisible() and not box.isEditable() and not box.toolTip():
            needed = box.fontMetrics().horizontalAdvance(box.currentText())
            found += [f"{box.currentText()!r} has {box.width()}"] if needed + 30 > box.width() else []
    return found


def cut_in_tabs(widget: QWidget) -> list[str]:
    """Those of tabs."""
    return [
        f"{bar.tabText(at)!r} has {bar.tabRect(at).width()}"
        for bar in widget.findChildren(QTabBar)
        for at in range(bar.count())
        if bar.isVisible()
        and not bar.tabToolTip(at)
        and bar.fontMetrics().horizontalAdvance(bar.tabText(at)) > bar.tabRect(at).width()
    ]


def nameless(widget: QWidget) -> list[str]:
    """The controls in sight of which one who does not see them is told nothing."""
    return [
        f"{type(part).__name__} {part.objectName()} in {type(part.parentWidget()).__name__}: {part.toolTip()}"
        for part in widget.findChildren(QWidget)
        if isinstance(part, CONTROLS)
        and part.isVisible()
        and not isinstance(part.parentWidget(), QComboBox | QAbstractSpinBox | QLineEdit)
        and not part.objectName().startswith("qt_")
        and not called(part)
    ]


def called(part: QWidget) -> str:
    return QAccessible.queryAccessibleInterface(part).text(QAccessible.Text.Name)


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
    assert not nameless(small)


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
    assert not nameless(small)


def test_on_every_page_of_a_dialog(dialog: QDialog) -> None:
    room = SCREEN - FRAME
    assert dialog.size().boundedTo(room) == dialog.size()
    assert dialog.minimumSizeHint().boundedTo(room) == dialog.minimumSizeHint()
    tabs = dialog.findChild(QTabWidget)
    assert not cut(dialog)
    assert not nameless(dialog)
    for page in range(tabs.count() if isinstance(tabs, QTabWidget) else 0):
        assert isinstance(tabs, QTabWidget)
        tabs.setCurrentIndex(page)
        have_done_what_is_due()
        assert not cut(dialog)
        assert not nameless(dialog)
