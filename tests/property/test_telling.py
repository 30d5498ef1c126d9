"""Properties of what is told: spans say the same as the tests they are made of, and reasons name what decides."""

from math import pi
from random import Random

from hypothesis import given, settings
from hypothesis import strategies as st

from app.core.automaton import Automaton
from app.core.conditions import AtMost, Condition, Equals, Guard, InArc, guard_met
from app.core.library import Types
from app.core.machine import stored_classifiers
from app.core.spans import Arc, Between, Is, IsNot, Span, spans
from app.core.transition import distribution
from app.core.tree import Forest, Tree
from app.core.wording import CAPTIONS, Speech, guard_words, reading_words, value_words
from app.engine.deciding import deciding_way, leaves
from app.engine.watching import totals
from tests.random_automata import random_types

EXPLAINED = Speech(clause=True, group="Group 3", held="Goto", targets={"target": "deposit"}, detailed=True)
NUMBERS = st.sampled_from([-3.0, -1.5, 0.0, 1.0, 2.0, 3.0])
TESTS = st.one_of(
    st.builds(AtMost, st.just("number"), NUMBERS),
    st.builds(Equals, st.just("number"), NUMBERS),
    st.builds(InArc, st.just("angle"), NUMBERS, NUMBERS),
)
GUARDS = st.lists(st.builds(Condition, TESTS, st.booleans()), max_size=5).map(tuple)


def holds(span: Span, value: float) -> bool:
    match span:
        case Between(low, high):
            return low < value <= high
        case Arc(start, end):
            return InArc("", start, end).holds(value)
        case Is(wanted):
            return value == wanted
        case IsNot(refused):
            return value not in refused


@given(GUARDS, NUMBERS, st.floats(-pi, pi, exclude_max=True))
def test_spans_let_the_same_values_pass_as_the_tests(guard: Guard, number: float, angle: float) -> None:
    values = {"number": number, "angle": angle}
    told = list(spans(guard, lambda _: 2 * pi))
    assert all(holds(span, values[feature]) for feature, span in told) == guard_met(guard, values.__getitem__)


def automata(types: Types) -> list[tuple[str, Automaton]]:
    return [(name, made) for name in types.types for made in types.library(name).automata.values()]


def values_of(random: Random, made: Automaton) -> dict[str, float]:
    return {use.id: random.choice([0.0, 1.0, 2.0, random.uniform(-3.0, 3.0)]) for use in made.features}


@settings(max_examples=40)
@given(st.integers(0, 1 << 32))
def test_everything_can_be_told_in_words(seed: int) -> None:
    random = Random(seed)
    types = random_types(random)
    scenario = types.agent_features()
    for _, made in automata(types):
        guards = [rule.guard for rule in made.rules] + [prune.guard for prune in made.prunes]
        trees = [model for model in made.learned.values() if isinstance(model, Tree)]
        guards += [path for tree in trees for path, _ in leaves(tree.root)]
        for guard in guards:
            for speech in (CAPTIONS, EXPLAINED):
                words = guard_words(guard, made, scenario, speech)
                assert words == words.strip() != ""
        for use in made.features:
            value = values_of(random, made)[use.id]
            assert value_words(use, value, scenario)
            assert reading_words(use, value, scenario, EXPLAINED)


@settings(max_examples=60)
@given(st.integers(0, 1 << 32))
def test_the_reason_is_met_and_speaks_for_what_comes_next(seed: int) -> None:
    random = Random(seed)
    for type_name, made in automata(random_types(random)):
        for state in made.states:
            values = values_of(random, made)
            classifier = stored_classifiers(type_name, made, state.id)
            outcome = totals(distribution(made, state.id, classifier, values.__getitem__))
            goes, probability = max(outcome, key=lambda pair: pair[1])
            way = deciding_way(made, state.id, values, goes, ())
            if way is None:
                is_tree = not isinstance(made.learned.get(state.id), Forest)
                assert not is_tree or goes == state.id
            else:
                assert way.failing(values) == ()
                assert way.shares[goes] > 0.0
                if len(outcome) == 1 and not made.rules_of(state.id):
                    assert way.shares == {goes: probability}
