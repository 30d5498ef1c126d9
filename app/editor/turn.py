"""A turn of the window: all that it does before it looks again what has come. Long ones make keys, mouse and frames late."""

from functools import cache
from time import thread_time

from PySide6.QtCore import QAbstractEventDispatcher, QCoreApplication, QObject

#: From so many seconds of work on, whatever can wait is left to the next turn, but no more than so often.
LONG, MOST = 0.004, 3


class _Turn(QObject):
    """The turn that goes on.

    Attributes:
        began: The time of this thread when it began; waiting for something to come is no work.
    """

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.began = thread_time()
        QAbstractEventDispatcher.instance().awake.connect(self._begin)

    def _begin(self) -> None:
        self.began = thread_time()


@cache
def _turn() -> _Turn:
    application = QCoreApplication.instance()
    assert application is not None
    return _Turn(application)


def is_long() -> bool:
    """Whether enough was done in this turn."""
    return thread_time() - _turn().began > LONG


class Patience:
    """Lets work wait for the next turn where this one is long already, so that the two are not one stall; not for ever."""

    def __init__(self) -> None:
        self._waited = 0

    def waits(self) -> bool:
        """Whether it is to be done in the next turn instead."""
        if self._waited < MOST and is_long():
            self._waited += 1
            return True
        self._waited = 0
        return False
