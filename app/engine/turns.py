"""Work in several threads that is done by one of them at a time."""

from collections.abc import Callable
from threading import Lock
from time import monotonic
from typing import TypeVar

from .worker import IsCancelled

Asked = TypeVar("Asked")
Answered = TypeVar("Answered")

#: Seconds after which who waits goes on all the same: learning may take minutes.
PATIENCE = 1.0
#: Seconds after which who waits looks whether what it waits with is still wanted.
STEP = 0.05


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
        """*work*, for a `Worker`: it begins once the others have ended, or after a while all the same; cancelled, at once."""

        def in_turn(question: Asked, cancelled: IsCancelled) -> Answered:
            mine = self._waited(cancelled)
            try:
                return work(question, cancelled)
            finally:
                if mine:
                    self._lock.release()

        return in_turn

    def _waited(self, cancelled: IsCancelled) -> bool:
        """Wait for the turn; False where it has not come by the time that nobody waits for it any more."""
        end = monotonic() + self._patience
        while not self._lock.acquire(timeout=STEP):
            if cancelled() or monotonic() > end:
                return False
        return True


#: Of those who find out, after every edit, what is to be learned and shown.
AFTER_EDITS = Turns()
