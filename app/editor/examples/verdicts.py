"""What has become of each example: whether what was learned agrees with it, and what stands against it."""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum

from ...core.automaton import Automaton, Model, Refit
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


class Judge:
    """Judges examples time after time; what a model says of an example is worked out once for the two of them."""

    def __init__(self) -> None:
        self._opinions: dict[str, tuple[Example, Model | None, Verdict]] = {}

    def judge(self, matter: Matter, cancelled: IsCancelled = lambda: False) -> Judged:
        """Judge every example; given up early where *cancelled*."""
        automaton = matter.automaton
        features, states = {use.id for use in automaton.features}, {state.id for state in automaton.states}
        against = _conflicting(matter.examples, tuple(use.id for use in automaton.features))
        verdicts: dict[str, Verdict] = {}
        for example in matter.examples:
            if cancelled():
                break
            if not example.enabled:
                verdict = Verdict.OFF
            elif not (
                example.source in states and example.label in states and features <= example.values.keys()
            ):
                verdict = Verdict.LEFT_OUT
            elif example.id in against:
                verdict = Verdict.CONFLICT
            else:
                verdict = self._opinion(example, automaton.learned.get(example.source))
            verdicts[example.id] = verdict
        return Judged(matter, verdicts)

    def _opinion(self, example: Example, model: Model | None) -> Verdict:
        known = self._opinions.get(example.id)
        if known is None or known[0] is not example or known[1] is not model:
            known = self._opinions[example.id] = example, model, _said(model, example)
        return known[2]


def _said(model: Model | None, example: Example) -> Verdict:
    """What a state's model says of an example."""
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
            key = (example.source, *map(example.values.get, features))
            alike[key].append(example)
    return {
        example.id
        for group in alike.values()
        if len({example.label for example in group}) > 1
        for example in group
    }
