"""How sure a state is at least holds in every situation."""

from random import Random

from hypothesis import given, settings
from hypothesis import strategies as st

from app.core.certainty import least_certainty
from app.core.machine import stored_classifiers
from app.core.transition import distribution
from app.engine.watching import totals
from tests.random_automata import random_types
from tests.samples import AGENT, GROUP, SQUAD

SEEDS = st.integers(0, 1 << 32)


@settings(max_examples=60)
@given(SEEDS, SEEDS)
def test_no_situation_is_less_certain_than_the_least(seed: int, at: int) -> None:
    random = Random(at)
    types = random_types(Random(seed))
    for kind in (AGENT, GROUP, SQUAD):
        for automaton in types.library(kind).automata.values():
            for state in automaton.states:
                classifier = stored_classifiers(kind, automaton, state.id)
                least = least_certainty(automaton, state.id, classifier)
                for _ in range(8):
                    values = {use.id: some_value(random) for use in automaton.features}
                    outcome = distribution(automaton, state.id, classifier, values.__getitem__)
                    assert max(share for _, share in totals(outcome)) >= least


def some_value(random: Random) -> float:
    return random.choice((0.0, 1.0, 2.0, random.uniform(-3.2, 3.2), random.uniform(0.0, 100.0)))
