"""The transition function T of one state: authored rules in order, then the learned model, then "stay".

`distribution` says where an automaton may go next and why; `choose` draws from it.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

from .automaton import Automaton, Prune, Sampling
from .conditions import Values, guard_met
from .tree import Decision


class Classifier(Protocol):
    """A learned transition function that can be evaluated: a tree, a forest, or one refitted from examples."""

    @property
    def labels(self) -> tuple[str, ...]:
        """Ids of the states that it can predict."""

    def decide(self, values: Values) -> Decision:
        """The probabilities of the labels for the current values."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """Where a state may go next.

    Attributes:
        states: Ids in the order in which they are drawn; a state can come up more than once.
        probabilities: As many; they add up to 1.
        key: What decided: the rules whose guards were met, the leaf reached, and which labels are possible there: a
            leaf that is pruned otherwise is another leaf. `hold` compares it.
    """

    states: tuple[str, ...]
    probabilities: tuple[float, ...]
    key: tuple[object, ...]


def distribution(automaton: Automaton, state: str, classifier: Classifier | None, values: Values) -> Outcome:
    """The distribution over next states of *automaton* in *state*.

    Each rule whose guard is met takes its probability of what the rules before it left; what they all leave falls
    through to the classifier, and what that leaves (no data, or everything pruned) stays.
    """
    states: list[str] = []
    shares: list[float] = []
    met: list[object] = []
    left = 1.0
    for rule in automaton.rules_of(state):
        if left > 0.0 and guard_met(rule.guard, values):
            states.append(rule.target)
            shares.append(left * rule.probability)
            met.append(rule.id)
            left = left * (1.0 - rule.probability)
    if classifier is not None and left > 0.0:
        decision = classifier.decide(values)
        allowed = pruned(decision.probabilities, classifier.labels, automaton.prunes_of(state), values)
        states += classifier.labels
        shares += [left * p for p in allowed]
        met += [decision.key, tuple([p > 0.0 for p in allowed])]
        left = left if sum(allowed) == 0.0 else 0.0
    return Outcome((*states, state), (*shares, left), tuple(met))


def pruned(
    probabilities: Sequence[float], labels: Sequence[str], prunes: Sequence[Prune], values: Values
) -> Sequence[float]:
    """*probabilities* without the forbidden labels, made to add up to 1 again; all zeros if nothing is left."""
    forbidden = {label for prune in prunes if guard_met(prune.guard, values) for label in prune.forbidden}
    if not forbidden:
        return probabilities
    kept = [0.0 if label in forbidden else p for label, p in zip(labels, probabilities, strict=True)]
    total = 0.0
    for p in kept:
        total += p
    return [p / total for p in kept] if total > 0.0 else kept


def choose(
    outcome: Outcome, sampling: Sampling, current: str, last_key: object, draw: Callable[[], float]
) -> str:
    """The next state.

    `argmax` takes the most probable state, the first of equals. `hold` draws only where *last_key*, what decided at
    the last evaluation since *current* was entered, differs from what decides now; otherwise that draw, which was to
    stay, still stands.
    """
    if sampling is Sampling.ARGMAX:
        return _most_probable(outcome)
    if sampling is Sampling.HOLD and outcome.key == last_key:
        return current
    return _sampled(outcome, draw())


def _most_probable(outcome: Outcome) -> str:
    totals: dict[str, float] = {}
    for state, p in zip(outcome.states, outcome.probabilities, strict=True):
        totals[state] = totals.get(state, 0.0) + p
    return max(totals, key=lambda state: totals[state])


def _sampled(outcome: Outcome, u: float) -> str:
    """The first state at which the running sum of probabilities exceeds *u*; rounding leaves the last possible one."""
    last, total = outcome.states[-1], 0.0
    for state, p in zip(outcome.states, outcome.probabilities, strict=True):
        total += p
        if u < total:
            return state
        if p > 0.0:
            last = state
    return last
