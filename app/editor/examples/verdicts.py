"""What has become of each example: whether what was learned agrees with it, and what stands against it.

Ten thousand are judged after every edit, so models are asked about all examples of a state at once.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum

import numpy as np

from ...core.automaton import Automaton, Model, Refit
from ...core.examples import Example
from ...core.tree import Forest, Tree, trees_of
from ...engine.worker import IsCancelled
from ...learner.dataset import contradictory, matrix, sift
from ...learner.prediction import most_probable


class Verdict(StrEnum):
    """What became of an example, the worst first."""

    CONFLICT = "conflict"
    OUTVOTED = "outvoted"
    LEFT_OUT = "left out"
    AGREES = "agrees"
    OFF = "off"
    UNKNOWN = "not learned yet"
    UNTOLD = "not told"


#: What each verdict means, for tool tips.
MEANINGS: Mapping[Verdict, str] = {
    Verdict.CONFLICT: "another example has the same features but says something else: relabel or disable one of them",
    Verdict.OUTVOTED: "what was learned would do something else here",
    Verdict.LEFT_OUT: "it cannot be learned from: it mentions a state that is gone, or lacks the value of a feature",
    Verdict.AGREES: "what was learned does what it says",
    Verdict.OFF: "it is disabled: kept, but not learned from",
    Verdict.UNKNOWN: "nothing was learned for its state yet",
    Verdict.UNTOLD: "it is learned from, by a model that has no tree; the behavior's settings say how well it fits",
}


@dataclass(frozen=True, slots=True)
class Matter:
    """What is judged."""

    automaton: Automaton
    examples: tuple[Example, ...]


@dataclass(frozen=True, slots=True)
class Judged:
    """The verdicts on *matter*, by example id."""

    matter: Matter
    verdicts: Mapping[str, Verdict]


def judge(matter: Matter, cancelled: IsCancelled = lambda: False) -> Judged:
    """Judge every example; given up early where *cancelled*."""
    automaton, examples = matter.automaton, matter.examples
    verdicts = {example.id: Verdict.LEFT_OUT if example.enabled else Verdict.OFF for example in examples}
    for source, kept in _by_source(sift(automaton, examples).kept).items():
        if cancelled():
            return Judged(matter, {})
        verdicts |= _opinions(automaton.learned.get(source), kept)
    features = dict.fromkeys(use.id for use in automaton.features)
    measured = [e for e in examples if e.enabled and features.keys() <= e.values.keys()]
    for example_id in _conflicting(measured, list(features)):
        if verdicts[example_id] is not Verdict.LEFT_OUT:
            verdicts[example_id] = Verdict.CONFLICT
    return Judged(matter, verdicts)


def _by_source(examples: Iterable[Example]) -> Mapping[str, Sequence[Example]]:
    found: dict[str, list[Example]] = {}
    for example in examples:
        found.setdefault(example.source, []).append(example)
    return found


def _opinions(model: Model | None, examples: Sequence[Example]) -> Mapping[str, Verdict]:
    """What a state's model says of examples, by id."""
    if isinstance(model, Refit):
        return {example.id: Verdict.UNTOLD for example in examples}
    if not isinstance(model, Tree | Forest):
        return {example.id: Verdict.UNKNOWN for example in examples}
    tested = dict.fromkeys(feature for tree in trees_of(model) for feature in tree.features())
    measured: list[Example] = []
    lacking: list[Example] = []
    for example in examples:
        (measured if tested.keys() <= example.values.keys() else lacking).append(example)
    best = most_probable(model, matrix(measured, list(tested)), list(tested)).tolist()
    found = {
        example.id: _agreement(model.labels[label], example)
        for example, label in zip(measured, best, strict=True)
    }
    return found | {example.id: _said(model, example) for example in lacking}


def _said(model: Tree | Forest, example: Example) -> Verdict:
    """What a model says of an example that lacks a value of a feature that the model tests somewhere."""
    try:
        probabilities = model.decide(example.values.__getitem__).probabilities
    except KeyError:  # it is of before a feature was dropped
        return Verdict.UNKNOWN
    best = max(range(len(probabilities)), key=probabilities.__getitem__)
    return _agreement(model.labels[best], example)


def _agreement(label: str, example: Example) -> Verdict:
    return Verdict.AGREES if label == example.label else Verdict.OUTVOTED


def _conflicting(examples: Sequence[Example], features: Sequence[str]) -> Iterator[str]:
    """Ids of examples that have the same features as another of their state, and another label."""
    numbers: dict[str, int] = {}
    for alike in _by_source(examples).values():
        y = np.array([numbers.setdefault(example.label, len(numbers)) for example in alike], np.int64)
        for row in contradictory(matrix(alike, features), y).tolist():
            yield alike[row].id
