"""Ctrl-C while threads and processes are at work.

Python turns it into a `KeyboardInterrupt` between any two steps of the main thread, also halfway into a lock that it
shares with other threads: the lock is then let go of twice, or never, and those threads fail. So while they are at
work Ctrl-C is only noted, and whoever waits for them looks.
"""

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass


@dataclass(slots=True)
class Interrupts:
    """What the user has said meanwhile.

    Attributes:
        came: Ctrl-C was pressed.
    """

    came: bool = False


@contextmanager
def noted_interrupts() -> Iterator[Interrupts]:
    """Note Ctrl-C instead of raising; only for the main thread, since no other one is interrupted."""
    interrupts = Interrupts()

    def note(*_: object) -> None:
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
