"""A behavior that is an automaton: the tuple <S, F, T, B> of the paper, section 3, as a frozen value.

State 0 is Start and idles. Every other state holds a basic behavior, another automaton, or a flag. The transition
function of a state is its authored rules in order, then its learned model, then "stay".
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from enum import StrEnum

from .conditions import Guard, Test
from .features import Bindings, FeatureUse
from .tree import Forest, Leaf, Tree

START = "start"


@dataclass(frozen=True, slots=True)
class Start:
    """What the start state holds: nothing; it idles."""


@dataclass(frozen=True, slots=True)
class Basic:
    """A basic behavior by name, with its target slots bound."""

    behavior: str
    bindings: Bindings = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Nested:
    """Another automaton of the same library by id, with its parameters bound."""

    automaton: str
    bindings: Bindings = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class RaiseFlag:
    """A flag state: it raises *flag* on the automaton that holds it and puts that in Start."""

    flag: str


Content = Start | Basic | Nested | RaiseFlag


@dataclass(frozen=True, slots=True)
class State:
    """One state. Two states may hold the same behavior with different bindings."""

    id: str
    content: Content
    name: str = ""
    note: str = ""


@dataclass(frozen=True, slots=True)
class Rule:
    """An authored transition: in state *source*, where *guard* is met, go to *target* with *probability*."""

    id: str
    source: str
    guard: Guard
    target: str
    probability: float = 1.0


@dataclass(frozen=True, slots=True)
class Prune:
    """In state *source*, where *guard* is met, the learned model may not choose *forbidden*."""

    id: str
    source: str
    guard: Guard
    forbidden: frozenset[str]


@dataclass(frozen=True, slots=True)
class Cut:
    """A test of the tree of state *source* whose numbers the user has moved; see `app.core.cuts`.

    Attributes:
        guard: The tests on the way to it; only which features they test and how they come out counts.
        test: Its feature, with the user's numbers.
    """

    id: str
    source: str
    guard: Guard
    test: Test


class Sampling(StrEnum):
    """How a state is chosen from the distribution at a leaf."""

    SAMPLE = "sample"
    ARGMAX = "argmax"
    HOLD = "hold"


@dataclass(frozen=True, slots=True)
class Settings:
    """How an automaton learns and samples.

    Attributes:
        classifier: A name from the learner's registry; ``c45`` is the paper's.
        pruning_confidence: For pessimistic pruning, in (0, 0.5]; None keeps the full tree.
        options: Further settings of the classifier, by name.
    """

    classifier: str = "c45"
    sampling: Sampling = Sampling.SAMPLE
    pruning_confidence: float | None = None
    options: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Refit:
    """A learned model that has no table form: it is fitted again from the examples when the project is loaded."""

    classifier: str


Model = Tree | Forest | Refit


@dataclass(frozen=True, slots=True)
class Automaton:
    """A hierarchical behavior.

    Attributes:
        id: Stable; others refer to it. A rename changes only *name*.
        parameters: Names of its target parameters.
        states: ``states[0]`` is Start.
        features: What its transition functions may look at.
        learned: The model of each state that has one, by state id; its labels are state ids.
        learned_from: Fingerprint of what the models were learned from, to tell that they are stale.
    """

    id: str
    name: str
    parameters: tuple[str, ...] = ()
    states: tuple[State, ...] = (State(START, Start(), "Start"),)
    features: tuple[FeatureUse, ...] = ()
    rules: tuple[Rule, ...] = ()
    learned: Mapping[str, Model] = field(default_factory=dict)
    learned_from: str = ""
    prunes: tuple[Prune, ...] = ()
    settings: Settings = Settings()
    note: str = ""
    cuts: tuple[Cut, ...] = ()

    def state(self, state_id: str) -> State:
        """The state with this id; KeyError if there is none."""
        for state in self.states:
            if state.id == state_id:
                return state
        raise KeyError(state_id)

    def has_state(self, state_id: str) -> bool:
        """Whether a state has this id."""
        return any(state.id == state_id for state in self.states)

    def feature(self, feature_id: str) -> FeatureUse:
        """The feature with this id; KeyError if there is none."""
        for use in self.features:
            if use.id == feature_id:
                return use
        raise KeyError(feature_id)

    def rules_of(self, state_id: str) -> tuple[Rule, ...]:
        """The authored rules that leave a state, in order."""
        return tuple(rule for rule in self.rules if rule.source == state_id)

    def prunes_of(self, state_id: str) -> tuple[Prune, ...]:
        """The prunes of a state's learned model."""
        return tuple(prune for prune in self.prunes if prune.source == state_id)

    def cuts_of(self, state_id: str) -> tuple[Cut, ...]:
        """The moved cuts of a state's tree."""
        return tuple(cut for cut in self.cuts if cut.source == state_id)

    def nested(self) -> tuple[str, ...]:
        """Ids of the automata that its states hold, each once, in order."""
        held = (state.content for state in self.states)
        return tuple(dict.fromkeys(content.automaton for content in held if isinstance(content, Nested)))


def reachable(automaton: Automaton) -> frozenset[str]:
    """States that can be entered from Start by a rule or a learned transition that no prune forbids everywhere."""
    found, waiting = {START}, [START]
    while waiting:
        for target in successors(automaton, waiting.pop()) - found:
            found.add(target)
            waiting.append(target)
    return frozenset(found)


def successors(automaton: Automaton, state_id: str) -> set[str]:
    """States that can follow *state_id* within the automaton."""
    after: set[str] = set()
    for rule in automaton.rules_of(state_id):
        if rule.probability > 0:
            after.add(rule.target)
        if not rule.guard and rule.probability >= 1:
            return after  # it leaves nothing to the rules and the model after it
    model = automaton.learned.get(state_id)
    if isinstance(model, Tree | Forest):
        forbidden = {label for p in automaton.prunes_of(state_id) if not p.guard for label in p.forbidden}
        after |= predicted(model) - forbidden
    elif isinstance(model, Refit):
        after |= {state.id for state in automaton.states}
    return after


def predicted(model: Tree | Forest) -> set[str]:
    """Labels that some leaf of *model* gives a probability above zero."""
    trees = model.trees if isinstance(model, Forest) else (model,)
    return {
        label
        for tree in trees
        for node in tree.nodes()
        if isinstance(node, Leaf)
        for label, count in zip(tree.labels, node.counts, strict=True)
        if count > 0
    }


def trimmed(automaton: Automaton) -> Automaton:
    """*automaton* without the states that cannot be entered: what runs and what is exported (paper, section 3.1).

    A rule of probability 0 to such a state stays, leading nowhere: whether its guard is met counts where a choice is held.
    """
    kept = reachable(automaton)
    rules = (
        rule if rule.target in kept or rule.probability > 0 else replace(rule, target=rule.source)
        for rule in automaton.rules
        if rule.source in kept
    )
    return replace(
        automaton,
        states=tuple(state for state in automaton.states if state.id in kept),
        rules=tuple(rule for rule in rules if rule.target in kept),
        learned={state_id: model for state_id, model in automaton.learned.items() if state_id in kept},
        prunes=tuple(prune for prune in automaton.prunes if prune.source in kept),
        cuts=tuple(cut for cut in automaton.cuts if cut.source in kept),
    )
