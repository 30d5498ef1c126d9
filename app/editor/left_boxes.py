"""Boxes of choices hear that the mouse has left them: Qt does not tell one whose list was open meanwhile."""

from PySide6.QtCore import QEvent
from PySide6.QtGui import QCursor
from PySide6.QtWidgets import QApplication, QComboBox, QWidget


def tell_left_boxes(application: QApplication) -> None:
    """Have boxes that get the keys back from their lists look as what they are: not under the mouse."""
    application.focusChanged.connect(_tell)


def _tell(_before: QWidget | None, now: QWidget | None) -> None:
    if isinstance(now, QComboBox) and now.underMouse() and not _is_on(now):
        QApplication.sendEvent(now, QEvent(QEvent.Type.Leave))
        now.update()


def _is_on(box: QWidget) -> bool:
    """Whether the mouse is on a box."""
    return box.rect().contains(box.mapFromGlobal(QCursor.pos()))
