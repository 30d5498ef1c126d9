"""Telling when the first window is on the screen, for a process that is timed from outside."""

import sys

from PySide6.QtCore import QEvent, QObject, QTimer
from PySide6.QtWidgets import QMainWindow

from ..application import make_application


class _Look(QObject):
    """Waits for the first painting of a window; says so, and closes it."""

    def __init__(self) -> None:
        super().__init__()
        self._told = False

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Let everything happen as it would."""
        if not self._told and event.type() is QEvent.Type.Paint and isinstance(watched, QMainWindow):
            self._told = True
            QTimer.singleShot(0, _tell)  # once all that is in it was painted, too
            QTimer.singleShot(0, watched.close)
        return False


def _tell() -> None:
    sys.stdout.write("shown\n")
    sys.stdout.flush()


def tell_when_painted() -> QObject:
    """From now on wait for a window; for as long as the result lives."""
    look = _Look()
    make_application().installEventFilter(look)
    return look
