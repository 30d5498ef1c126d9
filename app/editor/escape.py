"""Escape within a part of the window that it closes: it means that, and nothing else."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent


def takes_escape(event: QEvent, close: Callable[[], object]) -> bool:
    """Do *close* if *event* is Escape pressed, which is kept from shortcuts; whether the event was taken.

    Asked first in the `event` of the part, to which every key comes that nobody within it wants.
    """
    if not isinstance(event, QKeyEvent) or event.key() != Qt.Key.Key_Escape:
        return False
    if event.type() is QEvent.Type.ShortcutOverride:
        event.accept()
        return True
    if event.type() is QEvent.Type.KeyPress:
        close()
        return True
    return False
