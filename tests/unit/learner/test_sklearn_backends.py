"""scikit-learn's trees as ours, and the encodings of the others."""

from itertools import pairwise
from math import inf, nextafter, pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.ensemble import RandomForestClassifier

from app.core.automaton import Settings
from app.core.conditions import AtMost, Equals, InArc
from app.core.tree import Branch, Forest, Tree
from app.core.vocabulary import FeatureKind
from app.learner.dataset import Dataset
from app.learner.prediction import probabilities
from app.learner.registry import METHODS, fit
from tests.unit.learner.examples import (
    BOOLEAN,
    CATEGORICAL,
    CONTINUOUS,
    TOROIDAL,
    at,
    column,
    example,
    of,
    of_one_feature,
)


def cart(data: Dataset) -> Tree:
    tree = fit(data, Settings("cart"))
    assert isinstance(tree, Tree)
    return tree


def test_neighboring_floats_that_single_precision_confuses_are_told_apart() -> None:
    """scikit-learn alone sees one and the same number."""
    values = [1.0]
    while len(values) < 12:
        values.append(nextafter(values[-1], inf))
    assert len({np.float32(value) for value in values}) == 1
    data = of_one_feature(CONTINUOUS, *((value, "AB"[n // 3 % 2]) for n, value in enumerate(values)))
    for model in (cart(data), fit(data, Settings("c45"))):
        assert (probabilities(model, data).argmax(axis=1) == data.y).all()


@given(
    rows=st.lists(
        st.tuples(st.floats(-9, 9), st.floats(-pi, 3.1), st.sampled_from("ABC")), min_size=2, max_size=30
    )
)
@settings(max_examples=30)
def test_cart_reproduces_examples_without_conflict(rows: list[tuple[float, float, str]]) -> None:
    unique = {(f, g): label for f, g, label in rows}
    made = [example(n, label, {"f": f, "g": g}) for n, ((f, g), label) in enumerate(unique.items())]
    data = of(made, column("f"), column("g", TOROIDAL))
    tree = cart(data)
    for e in made:
        assert tree.decide(e.values.__getitem__).probabilities[data.labels.index(e.label)] == 1.0


def test_thresholds_are_placed_as_the_builder_places_them() -> None:
    data = of_one_feature(CONTINUOUS, (1.0, "go"), (5.0, "turn"), continuations="go")
    tree = cart(data)
    assert isinstance(tree.root, Branch)
    assert tree.root.test == AtMost("f", nextafter(5.0, -inf))


def test_an_angle_is_cut_once_by_an_arc_that_begins_at_the_seam() -> None:
    tree = cart(of_one_feature(TOROIDAL, (-1.0, "A"), (1.0, "B")))
    assert isinstance(tree.root, Branch)
    assert tree.root.test == InArc("f", -pi, 5e-324)
    assert tree.root.yes.counts == (1.0, 0.0)


@pytest.mark.parametrize("kind", [BOOLEAN, CATEGORICAL])
def test_values_are_told_apart_one_against_the_rest(kind: FeatureKind) -> None:
    tree = cart(of_one_feature(kind, (0.0, "A"), (1.0, "B")))
    assert isinstance(tree.root, Branch)
    assert tree.root.test == Equals("f", 1.0)
    assert tree.root.yes.counts == (0.0, 1.0)


def test_our_forest_says_what_scikit_learns_says_about_ranks() -> None:
    random = np.random.default_rng(3)
    x = np.round(random.uniform(0, 30, (80, 3)))
    labels = np.where(x[:, 0] + random.normal(0, 6, 80) > 15, "A", np.where(x[:, 1] > 12, "B", "C"))
    names = ("f", "g", "h")
    made = [
        example(n, str(label), dict(zip(names, row.tolist(), strict=True)))
        for n, (row, label) in enumerate(zip(x, labels, strict=True))
    ]
    data = of(made, *(column(name) for name in names))
    ours = fit(data, Settings("forest", options={"trees": 20, "min_leaf": 2}))
    ranks = np.column_stack([np.unique(values, return_inverse=True)[1] for values in data.x.T])
    theirs = RandomForestClassifier(20, min_samples_leaf=2, random_state=0).fit(ranks, data.y, data.weight)
    assert isinstance(ours, Forest)
    assert probabilities(ours, data) == pytest.approx(theirs.predict_proba(ranks))


def test_leaves_hold_counts_of_whole_examples() -> None:
    data = of_one_feature(CONTINUOUS, *((float(n % 7), "ABC"[n % 3]) for n in range(50)))
    for node in cart(data).nodes():
        assert all(count == int(count) for count in node.counts)


@pytest.mark.parametrize("name", [name for name, method in METHODS.items() if not method.lowers])
def test_both_sides_of_the_seam_are_near_each_other(name: str) -> None:
    """Behind on the left and behind on the right were taught; what lies between them is behind as well."""
    ahead = [(angle, "go") for angle in (-0.4, -0.2, 0.0, 0.2, 0.4)]
    behind = [(angle, "turn") for angle in (-3.0, -2.8, -2.9, 3.0, 2.8)]
    model = fit(of_one_feature(TOROIDAL, *ahead, *behind), Settings(name))
    assert model.decide(at(-pi)).probabilities[model.labels.index("turn")] > 0.8
    assert model.decide(at(0.1)).probabilities[model.labels.index("go")] > 0.8


@pytest.mark.parametrize("name", [name for name, method in METHODS.items() if not method.lowers])
def test_the_unit_of_a_feature_does_not_matter(name: str) -> None:
    def model(scale: float) -> list[float]:
        made = [example(n, "AB"[n // 6], {"f": scale * float(n), "g": float(n % 3)}) for n in range(12)]
        data = of(made, column("f"), column("g"))
        return [row[0] for row in probabilities(fit(data, Settings(name)), data).tolist()]

    assert model(1.0) == pytest.approx(model(1024.0), abs=0.02)


@pytest.mark.parametrize("name", [name for name, method in METHODS.items() if not method.lowers])
def test_the_key_for_hold_changes_only_when_a_probability_moves_to_another_step(name: str) -> None:
    data = of_one_feature(CONTINUOUS, *((float(n), "AB"[n // 10]) for n in range(20)))
    model = fit(data, Settings(name))
    decisions = [model.decide(at(value)) for value in np.linspace(0, 19, 200).tolist()]
    for one, next_one in pairwise(decisions):
        moved = [round(10 * p) for p in one.probabilities] != [round(10 * p) for p in next_one.probabilities]
        assert (one.key != next_one.key) == moved


def test_not_having_converged_is_no_warning() -> None:
    random = np.random.default_rng(0)
    made = [
        example(n, "AB"[int(random.integers(2))], {"f": float(random.normal()), "g": float(random.normal())})
        for n in range(60)
    ]
    data = of(made, column("f"), column("g"))
    fit(data, Settings("mlp", options={"steps": 10}))
    fit(data, Settings("logistic", options={"strength": 1e6}))
