"""What is done soon, once for all that asks for it: after all that is going on now, and before the next key."""

from collections import deque
from collections.abc import Callable
from functools import cache
from time import perf_counter

from PySide6.QtCore import QCoreApplication, QObject, QTimer
from shiboken6 import isValid

#: Seconds of such work in a row, at most; then whatever else has come is dealt with first, so that the window answers.
SPELL = 0.004
#: What is done may ask for more: a panel changes, then what is possible, then who shows that.
ROUNDS = 3


class Soon(QObject):
    """Does something once, after all that is going on now, however often it is asked for until then.

    A timer of its own would do it too, but keys that come fast, or while the window is busy, are all delivered before a
    timer's turn: they would find what the first of them has changed as it was before. So who deals with keys catches up.
    """

    def __init__(self, parent: QObject, do: Callable[[], object]) -> None:
        super().__init__(parent)
        self._do = do
        self._is_due = False

    @property
    def is_due(self) -> bool:
        """Whether it was asked for and is not done yet."""
        return self._is_due

    def ask(self, *_: object) -> None:
        """Do it soon; any signal may ask for it."""
        if not self._is_due:
            self._is_due = True
            _due.append(self)
            _timer().start()

    def forget(self) -> None:
        """Do not do it after all."""
        if self._is_due:
            self._is_due = False
            _due.remove(self)

    def be_done(self) -> None:
        """It is time."""
        self._is_due = False
        self._do()


#: What is due, the longest first.
_due: deque[Soon] = deque()


@cache
def _timer() -> QTimer:
    """A timer, since what is posted from within a spell would be done in the same one."""
    timer = QTimer(QCoreApplication.instance(), interval=0, singleShot=True)
    timer.timeout.connect(_work)
    return timer


def _do_first() -> None:
    first = _due.popleft()
    if isValid(first):  # otherwise whoever it was for is gone
        first.be_done()


def _work() -> None:
    end = perf_counter() + SPELL
    try:
        while _due:
            _do_first()
            if perf_counter() >= end:
                break
    finally:
        if _due:
            _timer().start()


def catch_up() -> None:
    """Do now all that is to be done soon."""
    for _ in range(ROUNDS):
        for _ in range(len(_due)):
            if _due:  # one may have given up another
                _do_first()
