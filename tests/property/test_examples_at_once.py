"""What is worked out for all examples of a behavior at once is what is found by looking at one after another."""

from collections.abc import Sequence
from math import fsum

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.core.automaton import Automaton, Basic, Model, Refit, State
from app.core.conditions import AtMost, Equals, InArc
from app.core.examples import Example
from app.core.features import FeatureUse, Sense
from app.core.library import Library
from app.core.project import Project
from app.core.tree import Branch, Forest, Leaf, Tree, TreeNode
from app.core.vocabulary import Feature, FeatureKind, Vocabulary
from app.editor.examples.verdicts import Matter, Verdict, judge
from app.editor.library.fits import Fit, fit_of
from app.learner.dataset import sift
from app.learner.freshness import Freshness
from tests.twins import one_by_one

STATES, FEATURES = ("go", "stop", "turn"), ("near", "sees")
#: Some examples have values of a feature that was dropped, and some models test it.
MEASURED = (*FEATURES, "dropped")
VALUES = st.sampled_from([-1.0, -0.0, 0.0, 0.5, 1.0])
SCENARIO = Vocabulary(
    features={name: Feature(name, kind) for name, kind in zip(FEATURES, FeatureKind, strict=False)}
)


@st.composite
def examples(draw: st.DrawFn) -> tuple[Example, ...]:
    row = st.tuples(
        st.sampled_from([*STATES, "gone"]),
        st.sampled_from([*STATES, "gone"]),
        st.dictionaries(st.sampled_from(MEASURED), VALUES)
        | st.fixed_dictionaries(dict.fromkeys(MEASURED, VALUES)),
        st.booleans() | st.just(value=True),
        st.sampled_from([1.0, 1.0, 0.1, 2.5]),
    )
    return tuple(
        Example(str(number), source, label, values, enabled=enabled, weight=weight)
        for number, (source, label, values, enabled, weight) in enumerate(draw(st.lists(row, max_size=30)))
    )


def nodes(labels: Sequence[str]) -> st.SearchStrategy[TreeNode]:
    counts = st.tuples(*(st.sampled_from([0.0, 1.0, 1.0, 3.0]) for _ in labels))
    tests = st.sampled_from(MEASURED).flatmap(
        lambda name: (
            st.builds(AtMost, st.just(name), VALUES)
            | st.builds(Equals, st.just(name), VALUES)
            | st.builds(InArc, st.just(name), VALUES, VALUES)
        )
    )
    return st.recursive(
        st.builds(Leaf, counts), lambda below: st.builds(Branch, tests, below, below, counts), max_leaves=6
    )


@st.composite
def models(draw: st.DrawFn) -> Model:
    labels = draw(st.permutations(STATES))[: draw(st.integers(1, 3))]
    trees = draw(st.lists(st.builds(Tree, st.just(tuple(labels)), nodes(labels)), min_size=1, max_size=3))
    made: tuple[Model, ...] = Refit("knn"), Forest(tuple(labels), tuple(trees)), trees[0]
    return draw(st.sampled_from(made))


@st.composite
def automata(draw: st.DrawFn) -> Automaton:
    return Automaton(
        "a",
        "A",
        states=(*Automaton("", "").states, *(State(name, Basic(name)) for name in STATES)),
        features=tuple(
            FeatureUse(name, Sense(name)) for name in draw(st.sampled_from([FEATURES, FEATURES[:1], ()]))
        ),
        learned=draw(st.dictionaries(st.sampled_from(STATES), models())),
    )


@given(automata(), examples())
def test_every_example_is_judged_as_if_it_were_judged_alone(
    automaton: Automaton, examples: tuple[Example, ...]
) -> None:
    assert judge(Matter(automaton, examples)).verdicts == one_by_one.verdicts(automaton, examples)


@given(automata(), examples())
def test_a_behavior_fits_as_many_examples_as_its_models_guess(
    automaton: Automaton, examples: tuple[Example, ...]
) -> None:
    fit, kept = fit_in_project(automaton, examples), sift(automaton, examples).kept
    assert kept == tuple(e for e in examples if e.enabled and one_by_one.learnable(automaton, e))
    assert (fit.learned_from, fit.problem) == (len(kept), "")
    assert fit.conflicts == sum(map(len, one_by_one.conflicts(automaton, kept)))
    told = [example for example in kept if can_be_told(automaton, example)]
    if kept and automaton.learned and not any(isinstance(m, Refit) for m in automaton.learned.values()):
        right = fsum(
            example.weight
            for example in told
            if one_by_one.opinion(automaton.learned.get(example.source), example) is Verdict.AGREES
        )
        assert fit.share == pytest.approx(right / sum(example.weight for example in kept))


def fit_in_project(automaton: Automaton, examples: tuple[Example, ...]) -> Fit:
    project = Project(
        "p", "s", libraries={"agent": Library({"a": automaton})}, examples={"agent": {"a": examples}}
    )
    return fit_of(project, SCENARIO, ("agent", "a"), Freshness())


def can_be_told(automaton: Automaton, example: Example) -> bool:
    """Whether the model tests only what the automaton still looks at."""
    model = automaton.learned.get(example.source)
    trees = model.trees if isinstance(model, Forest) else (model,) if isinstance(model, Tree) else ()
    return {f for tree in trees for f in tree.features()} <= {use.id for use in automaton.features}
