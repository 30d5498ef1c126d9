"""Work in several threads that is done by one of them at a time."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Lock
from typing import TypeVar

from .worker import IsCancelled

Asked = TypeVar("Asked")
Answered = TypeVar("Answered")

#: Seconds after which who waits goes on all the same: learning may take minutes.
PATIENCE = 1.0


class Turns:
    """Who takes part works while nobody else does.

    Threads that run Python never do so at the same time, and the window, which asks for its turn thousands of times to
    paint once, waits for each of them then. So several that work beside it get nothing done any sooner than one.
    """

    def __init__(self, patience: float = PATIENCE) -> None:
        self._lock = Lock()
        self._patience = patience

    def taken(
        self, work: Callable[[Asked, IsCancelled], Answered]
    ) -> Callable[[Asked, IsCancelled], Answered]:
        """*work*, for a `Worker`: it begins once the others have ended, or after a while all the same."""

        def in_turn(question: Asked, cancelled: IsCancelled) -> Answered:
            with self._turn():
                return work(question, cancelled)

        return in_turn

    @contextmanager
    def _turn(self) -> Iterator[None]:
        mine = self._lock.acquire(timeout=self._patience)
        try:
            yield
        finally:
            if mine:
                self._lock.release()


#: Of those who find out, after every edit, what is to be learned and shown.
AFTER_EDITS = Turns()
