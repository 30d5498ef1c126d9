"""What exists and may be chosen: what a state can hold, what slots can be bound to, what a rule can test."""

from collections.abc import Iterator
from itertools import product
from typing import Any

from ...core.automaton import Automaton, Basic, Content, Nested, RaiseFlag
from ...core.check.scope import Scope
from ...core.conditions import AtMost, Condition, Equals, InArc, Test
from ...core.errors import ScenarioError
from ...core.features import (
    Binding,
    FeatureUse,
    FlagUp,
    Ground,
    Operation,
    Over,
    Parameter,
    Sense,
    Source,
    Statistic,
    TicksInState,
    declaration,
    describe,
)
from ...core.library import Library, known_flags
from ...core.naming import natural
from ...core.telling import declared
from ...core.vocabulary import FINISHED, Feature, FeatureKind, Vocabulary

#: A choice as a list shows it, and what it stands for.
Choice = tuple[str, Any]
#: What a drag from the library carries.
BEHAVIOR_MIME = "application/x-understudy-behavior"


def called(name: str, parameters: tuple[str, ...]) -> str:
    """A behavior with its slots: "Goto(X)"."""
    return f"{name}({', '.join(parameters)})" if parameters else name


def automata(scope: Scope, automaton_id: str) -> list[Choice]:
    """The automata that a state of an automaton can hold: those that do not hold it."""
    above = scope.library.all_users(automaton_id) | {automaton_id}
    there = sorted(scope.library.automata.values(), key=lambda other: natural(other.name))
    return [
        (called(other.name, other.parameters), Nested(other.id)) for other in there if other.id not in above
    ]


def basics(scope: Scope) -> list[Choice]:
    """The basic behaviors."""
    there = scope.vocabulary.behaviors.values()
    return [(called(basic.name, basic.parameters), Basic(basic.name)) for basic in there]


def flags(scope: Scope) -> list[Choice]:
    """The flags that are known."""
    there = known_flags(scope.library, scope.vocabulary)
    return [(flag, RaiseFlag(flag)) for flag in there if flag != FINISHED]


def slots_of(content: Content, scope: Scope) -> tuple[str, ...]:
    """The slots of what a state holds."""
    return content_slots(content, scope.vocabulary, scope.library)


def content_slots(content: Content, vocabulary: Vocabulary, library: Library) -> tuple[str, ...]:
    """The slots of what a state holds; none for what does not exist."""
    match content:
        case Basic(name) if name in vocabulary.behaviors:
            return vocabulary.behaviors[name].parameters
        case Nested(held) if held in library.automata:
            return library.automata[held].parameters
    return ()


def bindings(scope: Scope, automaton: Automaton) -> list[Choice]:
    """What a slot can be bound to: targets, and parameters of the automaton."""
    own: list[Choice] = [(f"{name} (parameter)", Parameter(name)) for name in automaton.parameters]
    return [*own, *((name, Ground(name)) for name in scope.vocabulary.targets)]


# ---------------------------------------------------------------------------------------------- what is tested


def sources(scope: Scope, automaton: Automaton) -> list[Choice]:
    """All that the automaton can look at, with every way to bind it; what it looks at already is left out."""
    used = [use.source for use in automaton.features]
    found: list[Source] = [*_senses(scope, automaton), *_flags_up(scope), TicksInState()]
    found += _statistics(scope, automaton)
    return [(describe(source), source) for source in found if source not in used]


def _senses(scope: Scope, automaton: Automaton) -> Iterator[Sense]:
    for feature in scope.vocabulary.features.values():
        yield from _bound(feature, [binding for _, binding in bindings(scope, automaton)])


def _bound(feature: Feature, possible: list[Binding]) -> Iterator[Sense]:
    for chosen in product(possible, repeat=len(feature.parameters)):
        yield Sense(feature.name, dict(zip(feature.parameters, chosen, strict=True)))


def _flags_up(scope: Scope) -> Iterator[FlagUp]:
    yield from (FlagUp(flag) for flag, _ in flags(scope))


def _statistics(scope: Scope, automaton: Automaton) -> Iterator[Statistic]:
    """What a controller can sum up of its subsidiaries."""
    if not scope.type.subsidiaries:
        return
    for over in Over:
        for flag in sorted(scope.shown[over]):
            yield from (Statistic(operation, FlagUp(flag), over) for operation in _counting())
        if scope.senses[over]:
            yield from _of_agents(scope, automaton, over)


def _of_agents(scope: Scope, automaton: Automaton, over: Over) -> Iterator[Statistic]:
    possible = [binding for _, binding in bindings(scope, automaton)]
    for feature in scope.statistics.features.values():
        operations = _counting() if feature.kind is FeatureKind.BOOLEAN else _measuring()
        for sense in _bound(feature, possible):
            yield from (Statistic(operation, sense, over) for operation in operations)


def _counting() -> tuple[Operation, ...]:
    return Operation.ANY, Operation.ALL, Operation.COUNT


def _measuring() -> tuple[Operation, ...]:
    return Operation.MIN, Operation.MAX, Operation.MEAN


def kind_of(use: FeatureUse, vocabulary: Vocabulary) -> Feature:
    """How a feature is declared; see `app.core.telling.declared`."""
    return declared(use, vocabulary)


def first_test(feature_id: str, source: Source, vocabulary: Vocabulary) -> Condition:
    """A test of a feature to begin with, to be changed by the user."""
    try:
        feature = declaration(source, vocabulary)
    except ScenarioError:
        return Condition(Equals(feature_id, 1.0))
    test: Test
    match feature.kind:
        case FeatureKind.CONTINUOUS:
            test = AtMost(feature_id, 1.0)
        case FeatureKind.TOROIDAL:
            test = InArc(feature_id, -feature.period / 24, feature.period / 24)
        case FeatureKind.CATEGORICAL:
            test = Equals(feature_id, 0.0)
        case FeatureKind.BOOLEAN:
            test = Equals(feature_id, 1.0)
    return Condition(test)
