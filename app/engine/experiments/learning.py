"""Learning behaviors anew within an experiment: with another classifier, or from a random part of the user's picks."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from ...core.automaton import Settings as Learning
from ...core.chance import draw, world_key
from ...core.check.reach import in_use
from ...core.examples import Example, enabled
from ...core.library import Library
from ...core.project import Arm, Project
from ...core.vocabulary import Vocabulary
from ...learner.registry import options_of
from ...learner.trainer import apply, learn

#: Type name and automaton id.
Key = tuple[str, str]
#: One act of the user's hand: what was taught, and the number of the pick.
PickKey = tuple[str, str, int]


@dataclass(frozen=True, slots=True)
class Lesson:
    """How the behaviors of an arm are learned anew.

    Attributes:
        classifier: Instead of each automaton's own, with *options*; empty keeps them.
        picks: How many of the user's picks are learned from; None takes all.
    """

    classifier: str = ""
    options: tuple[tuple[str, float], ...] = ()
    picks: int | None = None

    def refuse_bad(self) -> None:
        """Raise a `ParameterError` if there is no such classifier or option."""
        if self.classifier:
            options_of(Learning(self.classifier, options=dict(self.options)))


@dataclass(frozen=True, slots=True)
class Relearned:
    """A project whose behaviors were learned anew, and from how much."""

    project: Project
    picks: int
    examples: int


def behaviors_in_use(project: Project, scenario: Vocabulary, arm: Arm) -> tuple[Key, ...]:
    """All automata that nodes of an arm can come to run, by type and id."""
    return tuple(sorted(in_use(project.types_with(scenario), arm)))


def picks_of(project: Project, keys: Sequence[Key]) -> tuple[PickKey, ...]:
    """Everything that the user's hand did for these behaviors and that is learned from."""
    return tuple(
        sorted({(*key, example.pick) for key in keys for example in enabled(project.examples_of(*key))})
    )


def drawn(picks: Sequence[PickKey], count: int | None, seed: int, run: int) -> frozenset[PickKey]:
    """*count* of the picks, drawn at random; the same run draws the same first ones whatever the count."""
    key = world_key(seed, run)
    order = sorted(range(len(picks)), key=lambda place: draw(key, place, 0, 0))
    return frozenset(picks[place] for place in order[:count])


def relearned(
    project: Project, scenario: Vocabulary, arm: Arm, lesson: Lesson, seed: int, run: int
) -> Relearned:
    """*project* with the behaviors of *arm* that have examples learned anew, from the picks drawn for this run.

    A behavior of which no pick was drawn has learned nothing: it stays in Start.
    """
    keys = behaviors_in_use(project, scenario, arm)
    chosen = drawn(picks_of(project, keys), lesson.picks, seed, run)
    count = 0
    for key in keys:
        if enabled(project.examples_of(*key)):
            kept = tuple(e for e in enabled(project.examples_of(*key)) if (*key, e.pick) in chosen)
            project = _with(project, key, lesson, kept)
            count += len(kept)
    learnable = [key for key in keys if project.examples_of(*key)]
    return Relearned(apply(project, learn(project, scenario, learnable)), len(chosen), count)


def _with(project: Project, key: Key, lesson: Lesson, examples: tuple[Example, ...]) -> Project:
    """*project* with a behavior that is to be learned in this way from these examples, and knows nothing yet."""
    type_name, automaton_id = key
    library = project.library(type_name)
    automaton = library.get(automaton_id)
    if lesson.classifier:
        settings = replace(automaton.settings, classifier=lesson.classifier, options=dict(lesson.options))
        automaton = replace(automaton, settings=settings)
    blank = replace(automaton, learned={}, learned_from="")
    of_type = {**project.examples.get(type_name, {}), automaton_id: examples}
    return replace(
        project,
        libraries={**project.libraries, type_name: Library({**library.automata, automaton_id: blank})},
        examples={**project.examples, type_name: of_type},
    )
