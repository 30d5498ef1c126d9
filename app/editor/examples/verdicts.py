"""What has become of each example: whether what was learned agrees with it, and what stands against it."""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum

from ...core.automaton import Automaton, Refit
from ...core.examples import Example
from ...core.tree import Forest, Tree
from ...engine.worker import IsCancelled


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
    features = tuple(use.id for use in matter.automaton.features)
    against = _conflicting(matter.examples, features)
    verdicts: dict[str, Verdict] = {}
    for example in matter.examples:
        if cancelled():
            break
        verdicts[example.id] = _verdict(example, matter.automaton, features, conflict=example.id in against)
    return Judged(matter, verdicts)


def _verdict(example: Example, automaton: Automaton, features: Sequence[str], *, conflict: bool) -> Verdict:
    if not example.enabled:
        return Verdict.OFF
    gone = not (automaton.has_state(example.source) and automaton.has_state(example.label))
    if gone or any(feature not in example.values for feature in features):
        return Verdict.LEFT_OUT
    if conflict:
        return Verdict.CONFLICT
    model = automaton.learned.get(example.source)
    if isinstance(model, Refit):
        return Verdict.UNTOLD
    if not isinstance(model, Tree | Forest):
        return Verdict.UNKNOWN
    try:
        probabilities = model.decide(example.values.__getitem__).probabilities
    except KeyError:  # the model still tests a feature that was dropped
        return Verdict.UNKNOWN
    best = max(range(len(probabilities)), key=probabilities.__getitem__)
    return Verdict.AGREES if model.labels[best] == example.label else Verdict.OUTVOTED


def _conflicting(examples: Sequence[Example], features: Sequence[str]) -> set[str]:
    """Ids of enabled examples that have the same features as another of their state, and another label."""
    alike: dict[object, list[Example]] = defaultdict(list)
    for example in examples:
        if example.enabled:
            key = (example.source, *(example.values.get(feature) for feature in features))
            alike[key].append(example)
    return {
        example.id
        for group in alike.values()
        if len({example.label for example in group}) > 1
        for example in group
    }
