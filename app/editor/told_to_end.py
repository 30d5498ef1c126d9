"""Ctrl-C, and the system's wish that the program end, told to the window when it can deal with them."""

import signal
import socket
from types import FrameType
from typing import Any

from PySide6.QtCore import QObject, QSocketNotifier, Signal

#: What a terminal and a system that shuts down send.
SIGNALS = (signal.SIGINT, signal.SIGTERM)


class ToldToEnd(QObject):
    """Turns signals of the system into one of Qt's.

    Python runs the handler of a signal between any two steps of the main thread, also halfway into an edit, or while it holds
    a lock that the engine waits for; and while Qt waits for a mouse, it runs none at all. So the handler does nothing, and
    what came is written to a socket that Qt waits for as well.

    Signals:
        came: The program is to end.
    """

    came = Signal()

    def __init__(self) -> None:
        """Listen from now on, in the main thread."""
        super().__init__()
        self._ours, self._pythons = socket.socketpair()
        self._ours.setblocking(False)
        self._pythons.setblocking(False)
        self._notifier = QSocketNotifier(self._ours.fileno(), QSocketNotifier.Type.Read, self)
        self._notifier.activated.connect(self._heed)
        self._wakeup = signal.set_wakeup_fd(self._pythons.fileno(), warn_on_full_buffer=False)
        self._before: dict[signal.Signals, Any] = {number: signal.signal(number, _note) for number in SIGNALS}

    def close(self) -> None:
        """Listen no more."""
        for number, handler in self._before.items():
            signal.signal(number, handler)
        signal.set_wakeup_fd(self._wakeup)
        self._notifier.setEnabled(False)
        self._ours.close()
        self._pythons.close()

    def _heed(self, *_: object) -> None:
        if set(self._ours.recv(4096)) & set(SIGNALS):
            self.came.emit()


def _note(_number: int, _frame: FrameType | None) -> None:
    """Do nothing: what came is on its way through the socket."""
