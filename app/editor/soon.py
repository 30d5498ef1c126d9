"""What is done soon, once for all that asks for it: after all that is going on now, a bit at a time."""

from collections import deque
from collections.abc import Callable
from functools import cache
from time import perf_counter
from typing import ClassVar

from PySide6.QtCore import QCoreApplication, QObject, QTimer
from PySide6.QtWidgets import QWidget
from shiboken6 import isValid

from .turn import Patience

#: Seconds of such work in a row, at most; then whatever else has come is dealt with first, so that the window answers.
SPELL = 0.004
#: What is done may ask for more: a panel changes, then what is possible, then who shows that.
ROUNDS = 3


class Soon(QObject):
    """Does something once, after all that is going on now and before the next key, however often it is asked for.

    A timer of its own would do it too, but keys that come fast, or while the window is busy, are all delivered before a
    timer's turn: they would find what the first of them has changed as it was before. So who deals with keys catches up.

    Args:
        parent: What a widget puts off, only keys wait for that go to it, or into it.
        everywhere: All keys do, e.g. since it says what they mean.
    """

    #: All that is due, the longest first.
    line: ClassVar[deque["Soon"]] = deque()

    def __init__(self, parent: QObject, do: Callable[[], object], *, everywhere: bool = False) -> None:
        super().__init__(parent)
        self._do = do
        self._of = None if everywhere or not isinstance(parent, QWidget) else parent
        self._is_in_line = False

    @property
    def is_due(self) -> bool:
        """Whether it was asked for and is not done yet."""
        return self._is_in_line

    def ask(self, *_: object) -> None:
        """Do it soon; any signal may ask for it."""
        self._line_up()

    def _line_up(self) -> None:
        if not self._is_in_line:
            self._is_in_line = True
            self.line.append(self)
            _timer().start()

    def forget(self) -> None:
        """Do not do it after all."""
        if self._is_in_line:
            self._is_in_line = False
            self.line.remove(self)

    def is_awaited(self, focus: QWidget) -> bool:
        """Whether keys wait for it that go to *focus*."""
        return self._of is None or self._of is focus or self._of.isAncestorOf(focus)

    def be_done(self) -> None:
        """Do it: it was in line."""
        self._is_in_line = False
        self._do()


class Later(Soon):
    """Does something once, so many milliseconds after it is asked for first: what follows the world, which no key waits for.

    Timers that are late are all done in a row, which makes them later still; those of this kind are taken one by one.
    """

    line: ClassVar[deque[Soon]] = deque()

    def __init__(self, parent: QObject, do: Callable[[], object], after: int = 0) -> None:
        super().__init__(parent, do)
        self._wait = QTimer(self, interval=after, singleShot=True)
        self._wait.timeout.connect(self._line_up)

    @property
    def is_due(self) -> bool:
        """Whether it was asked for and is not done yet."""
        return self._is_in_line or self._wait.isActive()

    def ask(self, *_: object) -> None:
        """Do it once the time has passed."""
        if self._wait.interval() == 0:
            self._line_up()
        elif not self.is_due:
            self._wait.start()

    def hurry(self) -> None:
        """Do it as soon as possible, at whatever time it was last done."""
        self._wait.stop()
        self._line_up()

    def forget(self) -> None:
        """Do not do it after all."""
        self._wait.stop()
        super().forget()


_patience = Patience()


@cache
def _timer() -> QTimer:
    """A timer, since what is posted from within a spell would be done in the same one."""
    timer = QTimer(QCoreApplication.instance(), interval=0, singleShot=True)
    timer.timeout.connect(_work)
    return timer


def _do_first(line: deque[Soon]) -> None:
    _do(line.popleft())


def _do(due: Soon) -> None:
    if isValid(due):  # otherwise whoever it was for is gone
        due.be_done()


def _work() -> None:
    if _patience.waits():
        _timer().start()
        return
    end = perf_counter() + SPELL
    try:
        while line := Soon.line or Later.line:
            _do_first(line)
            if perf_counter() >= end:
                break
    finally:
        if Soon.line or Later.line:
            _timer().start()


def catch_up(focus: QWidget | None = None) -> None:
    """Do now all that is to be done before the next key, and what that asks for in turn, up to `ROUNDS` deep.

    Args:
        focus: Where the key goes; without it, whatever is put off is done, wherever it goes.
    """
    for _ in range(ROUNDS):
        for due in tuple(Soon.line):
            if due in Soon.line and (not isValid(due) or focus is None or due.is_awaited(focus)):
                Soon.line.remove(due)  # one may have given up another
                _do(due)
