"""Learning again, beside the window, whatever an edit has made stale: models, and values of features added later."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace

from ..core.errors import UnderstudyError
from ..core.project import Project
from ..core.remembered import Remembered
from ..learner.builder import LearningCancelled
from ..learner.freshness import Freshness
from ..learner.trainer import Key, Learned, LearnedAutomaton, every_automaton, learn, with_examples
from ..sim.scenario import Scenario
from .backfill import Filled, fill_values
from .plan import some
from .recording import Values
from .turns import AFTER_EDITS
from .worker import IsCancelled, Worker

#: Told the share that is done, from 0 to 1, and what is being worked on.
Progress = Callable[[float, str], None]


@dataclass(frozen=True, slots=True)
class RelearnAnswer:
    """What came of learning again.

    Attributes:
        revision: The one asked about.
        learned: What was learned from the examples, with the values in *filled*.
        filled: Type name and automaton id -> example id -> the values that the example lacked, for `set_values`.
        problems: What could not be read or learned, in words.
    """

    revision: int
    learned: Learned = field(default_factory=Learned)
    filled: Mapping[Key, Mapping[str, Values]] = field(default_factory=dict)
    problems: tuple[str, ...] = ()

    @property
    def changes(self) -> bool:
        """Whether there is anything to put into the project."""
        return bool(self.learned.automata or self.filled)

    @property
    def teaches(self) -> bool:
        """Whether something was learned: an automaton without examples is up to date with nothing learned."""
        return any(automaton.models for automaton in self.learned.automata.values())


@dataclass(frozen=True, slots=True)
class _Question:
    revision: int
    project: Project
    scenario: Scenario


class Relearner:
    """Learns in a thread of its own what is stale; the caller puts it into its project, if that is still the same."""

    def __init__(self, ready: Callable[[], None], freshness: Freshness | None = None) -> None:
        """Start no thread yet.

        Args:
            ready: Called from the thread when an answer has come; it must only wake somebody up.
            freshness: What others know of the same project, too.
        """
        self._worker = Worker(AFTER_EDITS.taken(self._answer), _broken, ready, "relearner")
        self._progress = 0.0, ""
        self._memory = _Memory(freshness or Freshness())  # only the thread looks at it

    def ask(self, revision: int, project: Project, scenario: Scenario) -> None:
        """Learn every automaton of *project* that is stale; an earlier question that is still open is given up."""
        self._progress = 0.0, ""
        self._worker.ask(_Question(revision, project, scenario))

    def give_up(self) -> None:
        """Nobody wants the answer to a question that is still open."""
        self._worker.give_up()

    def answers(self) -> list[RelearnAnswer]:
        """The answer to the last question, once it has come, once."""
        return self._worker.answers()

    @property
    def busy(self) -> bool:
        """Whether an answer is still to come, or to be fetched."""
        return self._worker.busy

    @property
    def progress(self) -> tuple[float, str]:
        """The share that is done, from 0 to 1, and what is being worked on."""
        return self._progress

    def close(self) -> None:
        """Give up what is open and wait for the thread to end."""
        self._worker.close()

    def _answer(self, question: _Question, cancelled: IsCancelled) -> RelearnAnswer:
        def tell(share: float, what: str) -> None:
            if not cancelled():
                self._progress = share, what

        return _Work(question, self._memory, tell, cancelled).answer()


def _broken(question: _Question, why: str) -> RelearnAnswer:
    return RelearnAnswer(question.revision, problems=(f"learning failed: {why}",))


@dataclass(frozen=True, slots=True, eq=False)
class _Tried:
    """What an attempt to fill in values was made of, and what it missed."""

    made_of: tuple[object, ...]
    missed: Mapping[str, str]

    def again(self, made_of: tuple[object, ...]) -> bool:
        """Whether trying again would come to the same."""
        return all(old is new for old, new in zip(self.made_of, made_of, strict=True))


class _Memory:
    """What was found out about automata, so that the next question is about those only that have changed.

    Attributes:
        freshness: Which are stale.
        tried: What could not be filled in.
    """

    def __init__(self, freshness: Freshness) -> None:
        self.freshness = freshness
        self.tried: dict[Key, _Tried] = {}
        self._lacking: Remembered[Key, bool] = Remembered()

    def lacks_values(self, project: Project, key: Key) -> bool:
        """Whether an example has no value of one of its automaton's features."""
        features, examples = project.library(key[0]).get(key[1]).features, project.examples_of(*key)
        ids = {use.id for use in features}
        return self._lacking.of(
            key, (features, examples), lambda: any(not ids <= example.values.keys() for example in examples)
        )

    def keep_those_of(self, project: Project) -> None:
        """Forget all automata that *project* does not have."""
        keys = every_automaton(project)
        self.freshness.keep(keys)
        self._lacking.keep(keys)


class _Work:
    """One question being worked on."""

    def __init__(
        self, question: _Question, memory: _Memory, progress: Progress, cancelled: IsCancelled
    ) -> None:
        self._question = question
        self._project = question.project
        self._memory = memory
        self._tell = progress
        self._cancelled = cancelled
        self._learned: dict[Key, LearnedAutomaton] = {}
        self._filled: dict[Key, Mapping[str, Values]] = {}
        self._problems: list[str] = []

    def answer(self) -> RelearnAnswer:
        try:
            keys = with_examples(self._project)
            self._memory.keep_those_of(self._project)
            for number, key in enumerate(keys):
                self._step(key, number / len(keys), 1.0 / len(keys))
        except UnderstudyError as error:
            self._problems.append(str(error))
        except LearningCancelled:
            self._problems.append("learning was cancelled")
        self._tell(1.0, "")
        return RelearnAnswer(
            self._question.revision, Learned(self._learned), self._filled, tuple(self._problems)
        )

    def _step(self, key: Key, done: float, share: float) -> None:
        """Fill in and learn one automaton, if need be; its problems do not keep the others from being learned."""
        if self._cancelled():
            raise LearningCancelled
        name = self._project.library(key[0]).get(key[1]).name
        self._tell(done, name)
        try:
            if self._memory.lacks_values(self._project, key):
                self._fill(key, name)
            if self._memory.freshness.is_stale(self._project, key):
                self._learn(key, lambda part, what: self._tell(done + part * share, what))
        except UnderstudyError as error:
            self._problems.append(str(error))

    def _fill(self, key: Key, name: str) -> None:
        project, scenario = self._project, self._question.scenario
        automaton = project.library(key[0]).get(key[1])
        made_of = (
            automaton.features,
            automaton.states,
            project.examples_of(*key),
            project.arms,
            project.moments,
        )
        tried = self._memory.tried.get(key)
        if tried is None or not tried.again((*made_of, scenario)):
            filled = fill_values(project, scenario, *key, self._cancelled)
            if self._cancelled():
                raise LearningCancelled
            self._take(key, filled)
            made_of = (*made_of[:2], self._project.examples_of(*key), *made_of[3:])
            tried = self._memory.tried[key] = _Tried((*made_of, scenario), filled.missed)
        enabled = {example.id for example in project.examples_of(*key) if example.enabled}
        self._problems += _missed(name, {i: why for i, why in tried.missed.items() if i in enabled})

    def _take(self, key: Key, filled: Filled) -> None:
        self._project = filled.project
        if filled.found:
            self._filled[key] = filled.found

    def _learn(self, key: Key, progress: Progress) -> None:
        """Learn one automaton; where none of its examples is left to learn from, it has no models any more."""
        examples = self._project.examples_of(*key)
        alone = replace(self._project, examples={key[0]: {key[1]: examples}})
        vocabulary = self._question.scenario.vocabulary
        self._learned |= learn(alone, vocabulary, None, progress, self._cancelled).automata


def _missed(name: str, missed: Mapping[str, str]) -> Iterator[str]:
    """What could not be read, one line a reason."""
    by_reason: dict[str, list[str]] = {}
    for example_id, why in missed.items():
        by_reason.setdefault(why.removeprefix(f"example {example_id}: "), []).append(example_id)
    for why, examples in by_reason.items():
        many = "examples" if len(examples) > 1 else "example"
        yield f"{name}: {many} {some(examples)} cannot be learned from: {why}"
