"""Accuracy, folds, cross-validation, confusion, and the shape of the report."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from app.core.automaton import Refit, Settings
from app.core.tree import Forest, Leaf, Tree
from app.learner.builder import LearningCancelled
from app.learner.dataset import Dataset, LeftOut
from app.learner.evaluation import (
    BehaviorReport,
    StateReport,
    accuracy,
    confusion,
    cross_validated,
    folds,
    node_count,
    plain,
    report_on,
)
from app.learner.prediction import predicted
from app.learner.registry import fit
from tests.unit.learner.examples import CONTINUOUS, column, example, of, of_one_feature

C45 = Settings()


def line(count: int, label: Callable[[int], str] = lambda n: "AB"[n % 2]) -> Dataset:
    return of([example(n, label(n), {"f": float(n)}) for n in range(count)], column("f"))


def test_accuracy_is_a_share_of_weight() -> None:
    data = of([example(1, "A", {"f": 0.0}, weight=3.0), example(2, "B", {"f": 1.0})], column("f"))
    assert accuracy(data, np.array([0, 0])) == 0.75


def test_confusion_has_true_labels_as_rows_and_guesses_as_columns() -> None:
    data = of_one_feature(CONTINUOUS, (0.0, "A"), (1.0, "A"), (2.0, "B"))
    assert confusion(data, np.array([0, 1, 1])) == ((1.0, 1.0), (0.0, 1.0))


def test_few_examples_are_held_out_one_by_one() -> None:
    assert sorted(folds(line(50)).tolist()) == list(range(50))


def test_many_examples_are_held_out_in_ten_folds_with_labels_spread_evenly() -> None:
    data = line(120, lambda n: "A" if n < 20 else "B")
    fold = folds(data)
    for number in range(10):
        assert np.bincount(data.y[fold == number]).tolist() == [2, 10]


def test_examples_of_one_pick_are_held_out_together() -> None:
    made = [
        replace(
            example(n, "AB"[n % 2], {"f": float(n % 5)}), pick=1 + n // 2, demonstration="d", node="agent-1"
        )
        for n in range(8)
    ]
    data = of(made, column("f"))
    fold = {e.id: number for e, number in zip(data.examples, folds(data).tolist(), strict=True)}
    assert all(fold[str(2 * pair)] == fold[str(2 * pair + 1)] for pair in range(4))
    assert len(set(fold.values())) == 4


def test_equal_pick_numbers_of_different_demonstrations_are_different_picks() -> None:
    made = [replace(example(n, "A", {"f": 0.0}), pick=1, demonstration=f"d{n}") for n in range(3)]
    assert len(set(folds(of(made, column("f"))).tolist())) == 3


def test_folds_do_not_depend_on_the_order_of_examples() -> None:
    made = [example(n, "ABC"[n % 3], {"f": float(n * n % 17)}) for n in range(70)]
    one, other = of(made, column("f")), of(made[::-1], column("f"))
    assert folds(one).tolist() == folds(other).tolist()


def test_each_example_is_guessed_by_a_classifier_that_never_saw_it() -> None:
    """The lonely B in the middle is taken for A when it is held out."""
    data = of_one_feature(CONTINUOUS, (0.0, "A"), (1.0, "A"), (2.0, "B"), (3.0, "A"), (4.0, "A"))
    held_out = cross_validated(data, C45)
    assert held_out is not None
    assert held_out.tolist()[2] == 0
    assert accuracy(data, held_out) < 1.0


def test_what_is_easy_to_tell_apart_is_told_apart_when_held_out() -> None:
    data = of_one_feature(CONTINUOUS, *((n + 50.0 * (n >= 20), "AB"[n >= 20]) for n in range(40)))
    held_out = cross_validated(data, C45)
    assert held_out is not None
    assert accuracy(data, held_out) == 1.0


def test_a_single_pick_cannot_be_held_out() -> None:
    made = [replace(example(n, "A", {"f": float(n)}), pick=4) for n in range(2)]
    assert cross_validated(of(made, column("f")), C45) is None


def test_cross_validation_tells_how_far_it_is() -> None:
    shares: list[float] = []
    cross_validated(line(4), C45, step=shares.append)
    assert shares == [0.25, 0.5, 0.75, 1.0]


def test_cross_validation_stops_when_asked() -> None:
    with pytest.raises(LearningCancelled):
        cross_validated(line(4), C45, lambda: True)


def test_nodes_are_counted_over_all_trees() -> None:
    tree = fit(line(3), C45)
    assert isinstance(tree, Tree)
    assert node_count(tree) == 5
    assert node_count(Forest(tree.labels, (tree, tree))) == 10
    assert node_count(fit(line(30), Settings("knn"))) == 0


def test_a_report_has_held_out_predictions_in_its_confusion_where_there_are_any() -> None:
    data = of_one_feature(CONTINUOUS, (0.0, "A"), (1.0, "A"), (2.0, "B"), (3.0, "A"), (4.0, "A"))
    fitted = fit(data, C45)
    without = report_on(data, fitted, ("here", "Here"))
    assert (without.accuracy, without.cv_accuracy) == (1.0, None)
    assert without.confusion == ((4.0, 0.0), (0.0, 1.0))
    with_them = report_on(data, fitted, ("here", "Here"), cross_validated(data, C45))
    assert with_them.cv_accuracy is not None
    assert with_them.confusion != without.confusion


def test_a_report_names_conflicts() -> None:
    data = of_one_feature(CONTINUOUS, (0.0, "A"), (0.0, "B"), (1.0, "A"))
    report = report_on(data, fit(data, C45), ("here", "Here"))
    assert report.conflicts == (("0", "1"),)
    assert report.accuracy == pytest.approx(2 / 3)


def test_the_plain_form_has_the_keys_that_others_rely_on() -> None:
    state = StateReport(
        "s1", "Forward", 3, 5, 1.0, None, ("s1", "s2"), ((2.0, 0.0), (0.0, 1.0)), (("1", "2"),)
    )
    report = BehaviorReport("agent", "goto", "Goto", 0, 3, (state,), (LeftOut("9", "gone"),))
    behaviors: Any = plain([report])["behaviors"]
    (behavior,) = behaviors
    assert {"name": "Goto", "level": 0, "examples": 3}.items() <= behavior.items()
    assert behavior["left_out"] == [{"example": "9", "reason": "gone"}]
    (row,) = behavior["states"]
    assert {
        "state": "Forward",
        "examples": 3,
        "nodes": 5,
        "accuracy": 1.0,
        "cv_accuracy": None,
    }.items() <= row.items()


def test_a_decision_tie_is_guessed_as_the_first_label() -> None:
    tree = Tree(("A", "B"), Leaf((1.0, 1.0)))
    assert predicted(tree, line(2)).tolist() == [0, 0]


def test_a_refitted_model_is_no_classifier_by_itself() -> None:
    assert not hasattr(Refit("knn"), "decide")
