"""Ctrl-C while threads and processes are at work.

Python turns it into a `KeyboardInterrupt` between any two steps of the main thread, also halfway into a lock that it
shares with other threads: the lock is then let go of twice, or never, and those threads fail. So while they are at
work Ctrl-C is only noted, and whoever waits for them looks. Who presses it again has had enough of waiting.
"""

import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from types import FrameType


@dataclass(slots=True)
class Interrupts:
    """What the user has said meanwhile.

    Attributes:
        came: Ctrl-C was pressed.
    """

    came: bool = False


@dataclass(slots=True)
class _Patience:
    """What the user has said to the program as a whole, and what saying it again does.

    Attributes:
        end: Ends the program; None where a second Ctrl-C means no more than the first.
        came: The first was pressed.
    """

    end: Callable[[], object] | None = None
    came: bool = False

    def is_over(self) -> bool:
        """Hear Ctrl-C; whether it was the second, which has been obeyed by now."""
        is_second, self.came = self.came, True
        if not is_second or self.end is None:
            return False
        self.end()
        return True


_patience = _Patience()


@contextmanager
def ended_by_a_second(end: Callable[[], object], *, last: bool = False) -> Iterator[None]:
    """A second Ctrl-C ends the program by *end*, whatever the first one is waiting for; only for the main thread.

    The first is noted, or raises, as it does without this.

    Args:
        last: The program ends with this: who has pressed it once need not press it again.
    """

    def hear(number: int, frame: FrameType | None) -> None:
        if not _patience.is_over():
            signal.default_int_handler(number, frame)

    _patience.end, _patience.came = end, False
    before = signal.signal(signal.SIGINT, hear)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.SIG_IGN if last and _patience.came else before)
        _patience.end = None


@contextmanager
def noted_interrupts() -> Iterator[Interrupts]:
    """Note Ctrl-C instead of raising; only for the main thread, since no other one is interrupted."""
    interrupts = Interrupts()

    def note(*_: object) -> None:
        if not _patience.is_over():
            interrupts.came = True

    before = signal.signal(signal.SIGINT, note)
    try:
        yield interrupts
    finally:
        signal.signal(signal.SIGINT, before)


@contextmanager
def deaf_processes() -> Iterator[None]:
    """Processes that are started meanwhile never hear of Ctrl-C, which a terminal sends to all of them."""
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)
