"""Exceptions that nobody caught, told in the window: Qt calls our code and goes on when that fails, and nobody would know."""

import re
import sys
from collections.abc import Callable
from pathlib import Path
from types import TracebackType

from PySide6.QtCore import QObject, Qt, Signal

from ..engine import crashes

#: What PySide puts before the words of an error that came through Qt into our code again.
_PASSED_THROUGH = re.compile(r"(Error calling Python override of \S+: )+")


class Unforeseen(QObject):
    """Hears of what fails in slots, events, painting and models, wherever Qt calls our code in the window's thread.

    What fails at the same place again is told but once: what cannot be painted fails sixty times a second. In the terminal
    PySide says each time where Qt had called, past Python and so past us; to keep that back would be to keep back all that
    Qt and the system write there.

    Signals:
        came: What failed, for the user to read.
    """

    came = Signal(str)
    _failed = Signal(object)

    def __init__(self, keep: Callable[[BaseException], Path | None] = crashes.keep) -> None:
        """Listen from now on.

        Args:
            keep: Writes down what is to be reported; returns where.
        """
        super().__init__()
        self._keep = keep
        self._known: set[object] = set()
        self._before = sys.excepthook
        sys.excepthook = self._hear
        # Not before Qt has ended what it was at: it may be in the middle of painting what would show the message.
        self._failed.connect(self._tell, Qt.ConnectionType.QueuedConnection)

    def close(self) -> None:
        """Listen no more."""
        sys.excepthook = self._before

    def _hear(self, kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        if not issubclass(kind, Exception):
            self._before(kind, error, trace)
            return
        place = kind, _innermost(trace)
        if place not in self._known:
            self._known.add(place)
            self._before(kind, error, trace)
            self._failed.emit(error)

    def _tell(self, error: BaseException) -> None:
        kept = self._keep(error)
        what = f"{type(error).__name__}: {_PASSED_THROUGH.sub('', str(error))}"
        words = f"something in the program failed, and it went on without: {what}."
        report = f" Please report it, with what is in {kept}." if kept is not None else " Please report it."
        self.came.emit(f"{words} Your project can be saved as ever.{report}")


def _innermost(trace: TracebackType | None) -> object:
    """Where an exception was raised."""
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    return None if trace is None else (trace.tb_frame.f_code.co_filename, trace.tb_lineno)
