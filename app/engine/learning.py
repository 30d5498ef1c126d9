"""Learning beside the session: asked for with a revision, answered later with the same one."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from ..core.errors import UnderstudyError
from ..core.project import Project
from ..core.vocabulary import Vocabulary
from ..learner.builder import LearningCancelled
from ..learner.trainer import Learned, learn
from .worker import Worker


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


class WorkerLearner(Worker[Question, Answer]):
    """Learns in a thread of its own."""

    def __init__(self, ready: Callable[[], None] = lambda: None) -> None:
        """Start no thread yet.

        Args:
            ready: Called from the worker when an answer has come; it must only wake somebody up.
        """
        super().__init__(answer, _broken, ready, "learner")


def _broken(question: Question, why: str) -> Answer:
    return Answer(question, problem=f"learning failed: {why}")
