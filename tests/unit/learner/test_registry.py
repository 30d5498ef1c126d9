"""Every registered classifier, found by enumeration, on ordinary and on degenerate examples."""

from math import nan, pi

import numpy as np
import pytest

from app.core.automaton import Refit, Settings
from app.core.errors import ParameterError
from app.core.transition import Classifier
from app.core.tree import Forest, Leaf, Tree
from app.learner.builder import LearningCancelled
from app.learner.dataset import Dataset
from app.learner.prediction import predicted, probabilities
from app.learner.registry import METHODS, fit, method, options_of, stored
from tests.unit.learner.examples import BOOLEAN, CATEGORICAL, CONTINUOUS, TOROIDAL, column, example, of

COLUMNS = (column("near"), column("toward", TOROIDAL), column("sees", BOOLEAN), column("ground", CATEGORICAL))


def ordinary(count: int = 60) -> Dataset:
    """Three labels that the features tell apart with a margin."""
    random = np.random.default_rng(7)
    made = []
    for number in range(count):
        label = "ABC"[number % 3]
        near = random.uniform(0, 40) if label == "A" else random.uniform(60, 100)
        toward = random.uniform(-0.6, 0.6) if label == "B" else random.uniform(1.5, 2.5)
        values = {"near": near, "toward": toward, "sees": float(label == "A"), "ground": float(number % 3)}
        made.append(example(number, label, values, weight=1.0 + number % 2))
    return of(made, *COLUMNS)


def points(*labels: str, same: bool = False) -> Dataset:
    made = [
        example(n, label, {"near": 0.0 if same else float(n), "toward": 0.0, "sees": 0.0, "ground": 1.0})
        for n, label in enumerate(labels)
    ]
    return of(made, *COLUMNS)


def fitted(name: str, data: Dataset, **options: float) -> Classifier:
    return fit(data, Settings(classifier=name, options=options))


@pytest.fixture(params=METHODS)
def name(request: pytest.FixtureRequest) -> str:
    return str(request.param)


def test_every_classifier_learns_what_is_easy_to_tell_apart(name: str) -> None:
    data = ordinary()
    assert np.mean(predicted(fitted(name, data), data) == data.y) > 0.95


def test_every_classifier_gives_probabilities_in_the_order_of_its_labels(name: str) -> None:
    data = ordinary()
    model = fitted(name, data)
    assert model.labels == ("A", "B", "C")
    for e in data.examples[::10]:
        decision = model.decide(e.values.__getitem__)
        assert len(decision.probabilities) == 3
        assert sum(decision.probabilities) == pytest.approx(1.0)
        assert min(decision.probabilities) >= 0.0
        assert all(isinstance(number, int) for number in decision.key)


def test_every_classifier_decides_alone_as_it_does_in_batches(name: str) -> None:
    data = ordinary()
    model = fitted(name, data)
    alone = [model.decide(e.values.__getitem__).probabilities for e in data.examples]
    assert probabilities(model, data) == pytest.approx(np.array(alone))


def test_every_classifier_is_the_same_each_time_and_in_any_order(name: str) -> None:
    data = ordinary()
    turned = of(data.examples[::-1], *COLUMNS)
    assert (
        probabilities(fitted(name, data), data).tolist() == probabilities(fitted(name, turned), data).tolist()
    )


def test_the_same_features_always_give_the_same_key(name: str) -> None:
    data = ordinary()
    values = data.examples[0].values.__getitem__
    assert fitted(name, data).decide(values).key == fitted(name, data).decide(values).key


def test_examples_of_one_label_make_a_constant(name: str) -> None:
    model = fitted(name, points("A", "A", "A"))
    assert model.decide({"near": 99.0}.__getitem__).probabilities == (1.0,)


def test_a_single_example_makes_a_constant(name: str) -> None:
    assert fitted(name, points("A")) == Tree(("A",), Leaf((1.0,)))


def test_two_examples_are_enough(name: str) -> None:
    model = fitted(name, points("A", "B"))
    values = {"near": 0.0, "toward": 0.0, "sees": 0.0, "ground": 1.0}
    assert sum(model.decide(values.__getitem__).probabilities) == pytest.approx(1.0)


def test_examples_that_nothing_tells_apart_share_their_probabilities(name: str) -> None:
    data = points("A", "B", "B", "B", same=True)
    assert probabilities(fitted(name, data), data)[0] == pytest.approx([0.25, 0.75], abs=0.2)


def test_without_features_the_counts_decide(name: str) -> None:
    data = of([example(1, "A", {}), example(2, "B", {})])
    assert fitted(name, data) == Tree(("A", "B"), Leaf((1.0, 1.0)))


def test_labels_that_a_fold_lacks_get_no_probability(name: str) -> None:
    data = ordinary()
    some = data.rows(np.flatnonzero(data.y != 1))
    assert probabilities(fitted(name, some), data)[:, 1].tolist() == [0.0] * len(data)


def test_huge_and_tiny_values_are_learned_from(name: str) -> None:
    made = [
        example(n, "AB"[n % 2], {"near": (-1) ** n * 10.0 ** (300 - n), "far": 1e-300 * n}) for n in range(8)
    ]
    data = of(made, column("near"), column("far"))
    assert np.isfinite(probabilities(fitted(name, data), data)).all()


def test_a_category_that_was_never_seen_gets_probabilities_too(name: str) -> None:
    model = fitted(name, ordinary())
    values = {"near": 10.0, "toward": -pi, "sees": 1.0, "ground": 17.0}
    assert sum(model.decide(values.__getitem__).probabilities) == pytest.approx(1.0)


def test_those_that_lower_are_stored_and_the_others_refitted(name: str) -> None:
    kept = stored(fitted(name, ordinary()), Settings(classifier=name))
    assert isinstance(kept, Tree | Forest) == METHODS[name].lowers
    assert METHODS[name].lowers or kept == Refit(name)


def test_every_option_works_at_its_ends(name: str) -> None:
    for option in METHODS[name].options:
        lowest = fitted(name, ordinary(12), **{option.name: option.low})
        assert probabilities(lowest, ordinary(12)).shape == (12, 3)
        if option.name not in ("trees", "steps", "hidden"):  # slow at their upper ends
            fitted(name, ordinary(12), **{option.name: option.high})


def test_every_method_has_words_for_the_user(name: str) -> None:
    assert METHODS[name].name == name
    assert METHODS[name].title
    assert METHODS[name].doc
    assert all(
        option.title and option.low <= option.default <= option.high for option in METHODS[name].options
    )


def test_learning_with_scikit_learn_stops_when_asked() -> None:
    with pytest.raises(LearningCancelled):
        fit(ordinary(), Settings(classifier="forest"), lambda: True)


def test_an_unknown_classifier_is_refused_with_the_names_of_all() -> None:
    with pytest.raises(ParameterError, match="no classifier 'svm'; there are: c45, cart, forest, knn"):
        method("svm")


def test_an_unknown_option_is_refused_with_the_names_of_all() -> None:
    with pytest.raises(ParameterError, match="'knn' has no option 'k'; there are: neighbors"):
        options_of(Settings(classifier="knn", options={"k": 1}))


@pytest.mark.parametrize("value", [0, 1001, 1.5, nan])
def test_an_option_out_of_range_is_refused_with_the_range(value: float) -> None:
    with pytest.raises(ParameterError, match=r"'min_leaf' is .*; it must be a whole number from 1 to 1,000"):
        options_of(Settings(options={"min_leaf": value}))


def test_options_that_are_not_set_have_their_defaults() -> None:
    assert options_of(Settings(options={"min_leaf": 3})) == {"min_leaf": 3, "max_depth": 0, "gain_ratio": 1}


def test_pruning_is_off_by_default_and_applies_to_single_trees() -> None:
    labels = "AAAAAAAABAAAAAAA"
    data = of([example(n, label, {"f": float(n)}) for n, label in enumerate(labels)], column("f", CONTINUOUS))
    for name in ("c45", "cart"):
        full, short = (fit(data, Settings(name, pruning_confidence=given)) for given in (None, 0.1))
        assert isinstance(full, Tree)
        assert isinstance(short, Tree)
        assert full.depth() == 2
        assert short == Tree(("A", "B"), Leaf((15.0, 1.0)))


def test_a_pruning_confidence_out_of_range_is_refused() -> None:
    with pytest.raises(ParameterError, match=r"pruning confidence is 0\.9"):
        fit(points("A", "B"), Settings(pruning_confidence=0.9))
