"""Learning beside the session: asked for with a revision, answered later with the same one."""

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from threading import Event
from typing import Protocol

from ..core.errors import UnderstudyError
from ..core.project import Project
from ..core.vocabulary import Vocabulary
from ..learner.builder import LearningCancelled
from ..learner.trainer import Learned, learn


@dataclass(frozen=True, slots=True)
class Question:
    """Learn one automaton of a project.

    Attributes:
        revision: Of the project; the answer carries it, and is dropped if the project has moved on.
    """

    revision: int
    project: Project
    vocabulary: Vocabulary
    type: str
    automaton: str


@dataclass(frozen=True, slots=True)
class Answer:
    """What came of a question: models, or why there are none."""

    question: Question
    learned: Learned | None = None
    problem: str = ""


class Learner(Protocol):
    """Takes questions, gives answers when asked for them."""

    def ask(self, question: Question) -> None:
        """Begin to learn; an earlier question that is still open is given up."""

    def answers(self) -> list[Answer]:
        """What has been finished since the last call."""

    def close(self) -> None:
        """Give up whatever is open and let go of all threads."""


def answer(question: Question, cancelled: Callable[[], bool] = lambda: False) -> Answer:
    """Learn, now."""
    wanted = [(question.type, question.automaton)]
    try:
        return Answer(question, learn(question.project, question.vocabulary, wanted, cancelled=cancelled))
    except UnderstudyError as error:
        return Answer(question, problem=str(error))
    except LearningCancelled:
        return Answer(question, problem="learning was cancelled")


class InlineLearner:
    """Learns at once, in the caller's thread: for headless use, where the same calls must give the same results."""

    def __init__(self) -> None:
        self._answers: list[Answer] = []

    def ask(self, question: Question) -> None:
        """Learn now; the answer waits."""
        self._answers = [answer(question)]

    def answers(self) -> list[Answer]:
        """The answer to the last question, once."""
        given, self._answers = self._answers, []
        return given

    def close(self) -> None:
        """Nothing is open."""


class WorkerLearner:
    """Learns in a thread of its own."""

    def __init__(self, ready: Callable[[], None] = lambda: None) -> None:
        """Start no thread yet.

        Args:
            ready: Called from the worker when an answer has come; it must only wake somebody up.
        """
        self._pool = ThreadPoolExecutor(1, thread_name_prefix="learner")
        self._ready = ready
        self._open: tuple[Question, Future[Answer], Event] | None = None

    def ask(self, question: Question) -> None:
        """Begin to learn; an earlier question that is still open is given up."""
        self._give_up()
        stop = Event()
        future = self._pool.submit(answer, question, stop.is_set)
        future.add_done_callback(lambda _: self._ready())
        self._open = question, future, stop

    def answers(self) -> list[Answer]:
        """The answer to the last question, once it has come; a learner that breaks down answers so as well."""
        if self._open is None or not self._open[1].done():
            return []
        (question, future, _), self._open = self._open, None
        error = future.exception()
        if error is not None:
            return [Answer(question, problem=f"learning failed: {type(error).__name__}: {error}")]
        return [future.result()]

    def close(self) -> None:
        """Give up what is open and wait for the thread to end."""
        self._give_up()
        self._pool.shutdown(wait=True, cancel_futures=True)

    def _give_up(self) -> None:
        if self._open is not None:
            _, future, stop = self._open
            stop.set()
            future.cancel()
            self._open = None
