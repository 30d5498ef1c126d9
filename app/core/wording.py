"""Tests, values, states and examples in the words that the user reads: "sees a box", "between 5 and 12 from deposit".

Wherever a *vocabulary* is asked for, it is the scenario's, which has the features of agents and of groups.
"""

from collections.abc import Iterable, Mapping

from .automaton import Automaton, Basic, Content, Nested, Rule
from .conditions import Condition, Guard
from .examples import Example
from .features import FeatureUse, Sense
from .hierarchy import Node
from .library import Library
from .naming import shown_content, shown_state
from .phrasing import for_people, in_degrees, number, unit_of
from .predicates import category
from .spans import spans
from .telling import CAPTIONS, Speech, Telling, declared
from .transition import Classifier
from .tree import Tree
from .vocabulary import FeatureKind, Vocabulary

__all__ = [
    "CAPTIONS",
    "Speech",
    "condition_words",
    "content_words",
    "example_words",
    "guard_words",
    "held_words",
    "node_words",
    "reading_words",
    "readings",
    "rule_words",
    "state_words",
    "value_words",
]

#: So many features of an example are told where it is not known which of them matter.
MOST_TOLD = 3


def condition_words(
    condition: Condition, automaton: Automaton, vocabulary: Vocabulary, speech: Speech = CAPTIONS
) -> str:
    """One test as it is to come out: "sees a box", "farther than 12.3 from nearest visible box", "not done"."""
    return guard_words((condition,), automaton, vocabulary, speech)


def guard_words(guard: Guard, automaton: Automaton, vocabulary: Vocabulary, speech: Speech = CAPTIONS) -> str:
    """A conjunction of tests, those of one feature taken together; "always" if there are none.

    Where there is to be no target, what other features say of it is a matter of course, and left out.
    """

    def period(feature_id: str) -> float:
        return declared(feature_of(automaton, feature_id), vocabulary).period

    wanted = [
        (Telling(feature_of(automaton, feature_id), vocabulary, speech), span)
        for feature_id, span in spans(guard, period)
    ]
    lost = [telling.targets for telling, span in wanted if telling.wants_nobody(span)]
    said = [
        telling.test(span)
        for telling, span in wanted
        if telling.wants_nobody(span) or not telling.targets or telling.targets not in lost
    ]
    return " and ".join(dict.fromkeys(said)) or "always"


def value_words(use: FeatureUse, value: float, vocabulary: Vocabulary) -> str:
    """A value by itself, for tables: "12.3 units", "yes", "-10°", "grass"."""
    feature = declared(use, vocabulary)
    if feature.kind is FeatureKind.BOOLEAN:
        return "yes" if value else "no"
    if feature.kind is FeatureKind.CATEGORICAL:
        return category(feature, value)
    told = number(for_people(feature, value))
    unit = unit_of(feature, told)
    return told + ("°" if in_degrees(feature) else f" {unit}" if unit else "")


def reading_words(use: FeatureUse, value: float, vocabulary: Vocabulary, speech: Speech = CAPTIONS) -> str:
    """What a feature says now: "sees no box", "4.2 units from deposit", "there is no nearest visible box"."""
    return Telling(use, vocabulary, speech).value(value)


def readings(
    uses: Iterable[FeatureUse], values: Mapping[str, float], vocabulary: Vocabulary, speech: Speech = CAPTIONS
) -> list[str]:
    """What several features say now; where one says that there is no target, what others say of it means nothing."""
    told = [(Telling(use, vocabulary, speech), values[use.id]) for use in uses if use.id in values]
    lost = [telling.targets for telling, value in told if telling.is_of_nobody(value)]
    return [
        telling.value(value)
        for telling, value in told
        if telling.is_of_nobody(value) or not telling.targets or telling.targets not in lost
    ]


def feature_of(automaton: Automaton, feature_id: str) -> FeatureUse:
    """A feature by id; of one that is gone, only its id can be told."""
    known = (use for use in automaton.features if use.id == feature_id)
    return next(known, FeatureUse(feature_id, Sense(feature_id), feature_id))


# ------------------------------------------------------------------------------------- states and examples


def content_words(content: Content, library: Library) -> str:
    """What a state does: "Goto(deposit)", "Forward", "done"."""
    return shown_content(content, library)


def state_words(automaton: Automaton, state_id: str, library: Library) -> str:
    """What the user calls a state."""
    return shown_state(automaton, state_id, library)


def held_words(automaton: Automaton, state_id: str, library: Library) -> str:
    """What a state holds by its name alone, to say something of it: "Goto"; the state's own name where that is not one."""
    content = next((state.content for state in automaton.states if state.id == state_id), None)
    match content:
        case Basic(behavior):
            return behavior
        case Nested(held) if held in library.automata:
            return library.automata[held].name
    return shown_state(automaton, state_id, library)


def node_words(node: Node) -> str:
    """What the user calls a node: its name, or else its id made readable: "Agent 17" for "agent-17"."""
    readable = node.id.replace("-", " ").replace("_", " ").strip()
    return node.name or readable[:1].upper() + readable[1:]


def rule_words(rule: Rule, automaton: Automaton, vocabulary: Vocabulary, speech: Speech = CAPTIONS) -> str:
    """When an authored rule applies: "sees a box", "otherwise", "by chance, 0.5%", "always"."""
    earlier = automaton.rules_of(rule.source)
    first = not earlier or earlier[0].id == rule.id
    share = "" if rule.probability >= 1.0 else f"{number(100.0 * rule.probability)}%"
    if rule.guard:
        words = guard_words(rule.guard, automaton, vocabulary, speech)
        return f"{words}, {share}" if share else words
    if share:
        return f"by chance, {share}"
    return "always" if first else "otherwise"


def example_words(
    example: Example,
    automaton: Automaton,
    library: Library,
    vocabulary: Vocabulary,
    classifier: Classifier | None = None,
) -> str:
    """What an example says: "Wander → ReturnWithBox when it sees a box", "stays in Wander when it sees no box".

    The features told are those that are tested on the example's way to its leaf.

    Args:
        classifier: The model of its state, if not the one that the automaton has.
    """
    source, label = (shown_state(automaton, state, library) for state in (example.source, example.label))
    speech = Speech(clause=True, held=held_words(automaton, example.source, library))
    told = readings(_mattering(example, automaton, classifier), example.values, vocabulary, speech)
    went = f"stays in {label}" if example.source == example.label else f"{source} → {label}"
    return went + (f" when {' and '.join(told)}" if told else "")


def _mattering(
    example: Example, automaton: Automaton, classifier: Classifier | None
) -> tuple[FeatureUse, ...]:
    """The features that are tested on an example's way to its leaf; the first ones, if there is no tree to tell."""
    model = classifier if classifier is not None else automaton.learned.get(example.source)
    if not isinstance(model, Tree):
        return tuple([use for use in automaton.features if use.id in example.values][:MOST_TOLD])
    try:
        tested = [condition.test.feature for condition in model.explain(example.values.__getitem__)]
    except KeyError:  # a feature that was added later
        tested = list(model.features())
    return tuple(feature_of(automaton, i) for i in dict.fromkeys(tested) if i in example.values)
