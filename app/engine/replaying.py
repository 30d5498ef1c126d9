"""Whether demonstrations that are played again record the examples that the project holds, found out beside the window."""

from collections import defaultdict
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from ..core.errors import UnderstudyError
from ..core.examples import Example
from ..core.naming import shown_state
from ..core.project import Project
from ..learner.builder import LearningCancelled
from ..sim.scenario import Scenario
from .demonstrations import Where, recreate, where_of
from .worker import IsCancelled, Worker


@dataclass(frozen=True, slots=True)
class Replayed:
    """What came of playing all demonstrations.

    Attributes:
        examples: How many examples of taught behaviors the project holds.
        differences: What playing would record otherwise, a sentence each.
        problem: Why they could not be played; empty if they could.
    """

    examples: int = 0
    differences: tuple[str, ...] = ()
    problem: str = ""


@dataclass(frozen=True, slots=True)
class _Question:
    project: Project
    scenario: Scenario


class Replayer:
    """Plays the demonstrations of a project in a thread of its own; nothing is changed by it."""

    def __init__(self, ready: Callable[[], None]) -> None:
        """Start no thread yet.

        Args:
            ready: Called from the thread when an answer has come; it must only wake somebody up.
        """
        self._worker = Worker(self._answer, _broken, ready, "replayer")
        self._progress = 0.0, ""

    def ask(self, project: Project, scenario: Scenario) -> None:
        """Play them; an earlier question that is still open is given up."""
        self._progress = 0.0, ""
        self._worker.ask(_Question(project, scenario))

    def answers(self) -> list[Replayed]:
        """The answer to the last question, once it has come, once."""
        return self._worker.answers()

    @property
    def progress(self) -> tuple[float, str]:
        """The share that is done, from 0 to 1, and what is being played."""
        return self._progress

    def cancel(self) -> None:
        """Give up what is open."""
        self._worker.give_up()

    def close(self) -> None:
        """Give up what is open; the thread ends by itself soon after."""
        self._worker.close(wait=False)

    def _answer(self, question: _Question, cancelled: IsCancelled) -> Replayed:
        def tell(share: float, what: str) -> None:
            if not cancelled():
                self._progress = share, what

        try:
            again = recreate(question.project, question.scenario, None, tell, cancelled)
        except UnderstudyError as error:
            return Replayed(problem=str(error))
        except LearningCancelled:
            return Replayed(problem="cancelled")
        return compared(question.project, again)


def _broken(_: _Question, why: str) -> Replayed:
    return Replayed(problem=f"playing failed: {why}")


# ------------------------------------------------------------------------------------------------------ comparing

#: What makes two examples the same one, recorded twice.
_Key = tuple[str, int, str, str, str, bool]


def compared(project: Project, again: Project) -> Replayed:
    """What differs between the examples that *project* holds and those that playing has recorded *again*."""
    taught = list(dict.fromkeys(where_of(d) for d in project.demonstrations))
    differences = tuple(said for where in taught for said in _differences(project, again, where))
    return Replayed(sum(len(project.examples_of(*where)) for where in taught), differences)


def _differences(project: Project, again: Project, where: Where) -> Iterator[str]:
    stored, recorded = project.examples_of(*where), again.examples_of(*where)
    if stored == recorded:
        return
    left = defaultdict[_Key, list[Example]](list)
    for example in recorded:
        left[_key(example)].append(example)
    name = project.library(where[0]).get(where[1]).name
    found = False
    for example in stored:
        same = left[_key(example)]
        words = f"{name}: example {example.id} ({_words(project, where, example)})"
        if not same:
            found = True
            yield f"{words} would not be recorded"
        elif odd := _odd(example, same.pop(0)):
            found = True
            yield f"{words} would be recorded {odd}"
    for example in (extra for rest in left.values() for extra in rest):
        found = True
        yield f"{name}: one more would be recorded ({_words(project, where, example)})"
    if not found:
        yield f"{name}: the same examples would be recorded in another order, or under other numbers"


def _key(example: Example) -> _Key:
    return (
        example.demonstration,
        example.tick,
        example.node,
        example.source,
        example.label,
        example.continuation,
    )


def _words(project: Project, where: Where, example: Example) -> str:
    library = project.library(where[0])
    automaton = library.get(where[1])
    source, label = (shown_state(automaton, end, library) for end in (example.source, example.label))
    does = f"stay in {label}" if source == label else f"{source} → {label}"
    return f"{does}, {example.node}, tick {example.tick:,}, {example.demonstration or 'no demonstration'}"


def _odd(stored: Example, recorded: Example) -> str:
    """In what way an example would come out otherwise; empty if it would not."""
    values = [
        f"{key} {_number(recorded.values.get(key))} instead of {_number(stored.values.get(key))}"
        for key in sorted(stored.values.keys() | recorded.values.keys())
        if stored.values.get(key) != recorded.values.get(key)
    ]
    parts = [f"with {', '.join(values)}"] if values else []
    if stored.enabled != recorded.enabled:
        parts.append("as one to learn from" if recorded.enabled else "as one not to learn from")
    if stored.weight != recorded.weight:
        parts.append(f"with the weight {recorded.weight:g} instead of {stored.weight:g}")
    if stored.snapshot != recorded.snapshot:
        parts.append("in another moment" if recorded.snapshot else "without its moment")
    return " and ".join(parts)


def _number(value: float | None) -> str:
    return "nothing" if value is None else f"{value:.6g}"
