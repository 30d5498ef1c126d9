"""Long work in a thread of its own, of which only what was asked for last still counts."""

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from threading import Event, Lock
from typing import Generic, TypeVar

Asked = TypeVar("Asked")
Answered = TypeVar("Answered")

#: Whether the work is not wanted any more.
IsCancelled = Callable[[], bool]


class Worker(Generic[Asked, Answered]):
    """Takes questions, gives answers when asked for them."""

    def __init__(
        self,
        work: Callable[[Asked, IsCancelled], Answered],
        broken: Callable[[Asked, str], Answered],
        ready: Callable[[], None],
        name: str,
    ) -> None:
        """Start no thread yet.

        Args:
            work: Answers a question, in the thread; gives up soon after it is told that it is cancelled.
            broken: The answer where *work* raised, with what it raised in words.
            ready: Called from the thread when an answer has come; it must only wake somebody up.
            name: Of the thread.
        """
        self._pool = ThreadPoolExecutor(1, thread_name_prefix=name)
        self._work = work
        self._broken = broken
        self._ready = ready
        self._asking = Lock()
        self._open: tuple[Asked, Future[Answered], Event] | None = None

    @property
    def busy(self) -> bool:
        """Whether a question is open, or answered with the answer not yet fetched."""
        return self._open is not None

    def ask(self, question: Asked) -> None:
        """Begin to work; an earlier question that is still open is given up."""
        self.give_up()
        stop = Event()
        with self._asking:
            future = self._pool.submit(self._begin, question, stop.is_set)
            self._open = question, future, stop
            future.add_done_callback(lambda _: self._ready())

    def _begin(self, question: Asked, cancelled: IsCancelled) -> Answered:
        with self._asking:
            pass  # otherwise quick work would be ready before who asks has finished asking
        return self._work(question, cancelled)

    def answers(self) -> list[Answered]:
        """The answer to the last question, once it has come; work that breaks down answers so as well."""
        if self._open is None or not self._open[1].done():
            return []
        (question, future, _), self._open = self._open, None
        error = future.exception()
        if error is not None:
            return [self._broken(question, f"{type(error).__name__}: {error}")]
        return [future.result()]

    def close(self, *, wait: bool = True) -> None:
        """Give up what is open and wait for the thread to end, or let it end by itself."""
        self.give_up()
        self._pool.shutdown(wait=wait, cancel_futures=True)

    def give_up(self) -> None:
        """Nobody wants the answer to the question that is open, if one is."""
        if self._open is not None:
            (_, future, stop), self._open = self._open, None  # first, since cancelling tells whoever waits
            stop.set()
            future.cancel()
