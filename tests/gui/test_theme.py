"""The window changes its colors as a whole, and looks then as if it had always had them."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage
from PySide6.QtWidgets import (
    QApplication,
    QCheckBox,
    QComboBox,
    QLabel,
    QLineEdit,
    QPushButton,
    QSlider,
    QSpinBox,
    QTabBar,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)
from pytestqt.qtbot import QtBot

from app.editor.theme import Theme, ThemeMode
from app.editor.window.main_window import MainWindow
from tests.gui.conftest import PATIENCE

MODES = pytest.mark.parametrize(
    ("before", "after"), [(ThemeMode.LIGHT, ThemeMode.DARK), (ThemeMode.DARK, ThemeMode.LIGHT)]
)


@pytest.fixture
def theme(qapp: QApplication) -> Iterator[Theme]:
    theme = Theme(qapp, ThemeMode.LIGHT)
    yield theme
    theme.use(ThemeMode.LIGHT)


def gallery(theme: Theme, qtbot: QtBot, owner: QWidget | None = None) -> QWidget:
    """A window with one of everything that has colors, or a dialog of another window."""
    window = QWidget(owner, Qt.WindowType.Window)
    if owner is None:
        theme.dress(window)
        qtbot.addWidget(window)
    layout = QVBoxLayout(window)
    for enabled in (True, False):
        for part in parts():
            part.setEnabled(enabled)
            part.setFocusPolicy(Qt.FocusPolicy.NoFocus)
            part.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)  # wherever it was left
            layout.addWidget(part)
    with qtbot.waitExposed(window):
        window.show()
    return window


def parts() -> tuple[QWidget, ...]:
    check, caption, box, tree, tabs = QCheckBox("on"), QLabel("words"), QComboBox(), QTreeWidget(), QTabBar()
    check.setChecked(True)
    caption.setProperty("role", "caption")
    box.addItem("one")
    item = QTreeWidgetItem(["above"])
    item.addChild(QTreeWidgetItem(["below"]))
    tree.addTopLevelItem(item)
    tree.setCurrentItem(item)
    tree.setFixedHeight(60)
    tabs.addTab("one")
    tabs.addTab("two")
    slider = QSlider(Qt.Orientation.Horizontal)
    slider.setValue(40)
    return check, caption, box, tree, tabs, slider, QPushButton("press"), QLineEdit("text"), QSpinBox()


def seen(widget: QWidget) -> QImage:
    return widget.grab().toImage()


@MODES
def test_what_is_in_sight_looks_as_if_it_were_made_in_the_new_theme_at_once(
    theme: Theme, qtbot: QtBot, before: ThemeMode, after: ThemeMode
) -> None:
    theme.use(before)
    window = gallery(theme, qtbot)
    old = seen(window)
    theme.use(after)
    now = seen(window)  # nothing else has happened between
    assert now != old
    assert now == seen(gallery(theme, qtbot))


@MODES
def test_what_was_hidden_has_the_colors_when_it_comes(
    theme: Theme, qtbot: QtBot, before: ThemeMode, after: ThemeMode
) -> None:
    theme.use(before)
    window = gallery(theme, qtbot)
    window.hide()
    theme.use(after)
    qtbot.waitUntil(lambda: not theme.is_restyling, timeout=PATIENCE)
    with qtbot.waitExposed(window):
        window.show()
    assert seen(window) == seen(gallery(theme, qtbot))


def test_what_belongs_to_a_window_has_the_pictures_of_its_ground(window: MainWindow, qtbot: QtBot) -> None:
    theme = window.studio.theme
    theme.use(ThemeMode.DARK)
    dialog = gallery(theme, qtbot, window)
    assert seen(dialog) == seen(gallery(theme, qtbot))
    theme.use(ThemeMode.LIGHT)
    assert seen(dialog) == seen(gallery(theme, qtbot, window))
