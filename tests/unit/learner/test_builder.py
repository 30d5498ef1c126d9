"""Trees worked out by hand."""

from math import pi

import pytest

from app.core.conditions import AtMost, Equals, InArc
from app.core.tree import Branch, Leaf, Tree
from app.learner.builder import Growth, LearningCancelled, build
from app.learner.dataset import Dataset
from tests.unit.learner.examples import (
    BOOLEAN,
    CATEGORICAL,
    CONTINUOUS,
    TOROIDAL,
    column,
    example,
    of,
    of_one_feature,
)


def table(*rows: tuple[str, float, float], kinds: tuple = (CONTINUOUS, CONTINUOUS)) -> Dataset:
    """Rows (label, f, g)."""
    made = [example(n, label, {"f": f, "g": g}) for n, (label, f, g) in enumerate(rows)]
    return of(made, column("f", kinds[0]), column("g", kinds[1]))


def test_examples_of_one_label_make_a_leaf() -> None:
    assert build(of_one_feature(CONTINUOUS, (1.0, "A"), (2.0, "A"))) == Tree(("A",), Leaf((2.0,)))


def test_without_features_there_is_one_leaf_with_all_counts() -> None:
    assert build(of([example(1, "A", {}), example(2, "B", {}), example(3, "B", {})])) == Tree(
        ("A", "B"), Leaf((1.0, 2.0))
    )


def test_a_threshold_parts_two_labels() -> None:
    assert build(of_one_feature(CONTINUOUS, (1.0, "A"), (2.0, "A"), (4.0, "B"))) == Tree(
        ("A", "B"), Branch(AtMost("f", 3.0), Leaf((2.0, 0.0)), Leaf((0.0, 1.0)), (2.0, 1.0))
    )


def test_conflicting_examples_end_in_one_leaf_with_the_counts_of_both() -> None:
    data = of_one_feature(CONTINUOUS, (1.0, "A"), (5.0, "A"), (5.0, "B"), (5.0, "B"))
    assert build(data).root == Branch(AtMost("f", 3.0), Leaf((1.0, 0.0)), Leaf((1.0, 2.0)), (2.0, 2.0))


def test_exclusive_or_is_learned_although_no_first_split_gains_anything() -> None:
    data = table(("A", 0, 0), ("B", 0, 1), ("B", 1, 0), ("A", 1, 1))
    tree = build(data)
    assert tree.depth() == 2
    assert sum(isinstance(node, Leaf) for node in tree.nodes()) == 4


def test_where_nothing_gains_a_node_is_halved() -> None:
    """Four values with both labels each: no cut gains, the most even one is taken, not the first."""
    points = [
        (label, float(value), float((label == "A") == (value % 2 == 0)))
        for value in range(4)
        for label in "AB"
    ]
    tree = build(table(*points))
    assert isinstance(tree.root, Branch)
    assert tree.root.test == AtMost("f", 1.5)


def test_where_nothing_gains_the_feature_that_parts_most_evenly_is_taken() -> None:
    """f parts 2 from 6, g parts 4 from 4, both labels evenly on every side."""
    tree = build(
        table(
            *(("A", 0, 0), ("A", 1, 0), ("A", 1, 1), ("A", 1, 1)),
            *(("B", 0, 1), ("B", 1, 0), ("B", 1, 0), ("B", 1, 1)),
        )
    )
    assert isinstance(tree.root, Branch)
    assert tree.root.test == AtMost("g", 0.5)


def test_equal_offers_are_decided_for_the_first_feature() -> None:
    tree = build(table(("A", 1, 10), ("B", 2, 20)))
    assert tree.features() == ("f",)


def test_equal_cuts_are_decided_for_the_lower_one() -> None:
    tree = build(of_one_feature(CONTINUOUS, (1.0, "A"), (2.0, "B"), (3.0, "A")))
    assert isinstance(tree.root, Branch)
    assert tree.root.test == AtMost("f", 1.5)


def three_booleans() -> dict[str, Dataset]:
    """Eight A and eight B. f is true for 7 A and 1 B, g for 5 A, h for 5 A and 3 B.

    Gains 0.456, 0.419, 0.046; split informations 1, 0.896, 1; ratios 0.456, 0.468, 0.046.
    """
    made = []
    for n in range(8):
        made.append(example(n, "A", {"f": float(n < 7), "g": float(n < 5), "h": float(n < 5)}))
        made.append(example(10 + n, "B", {"f": float(n == 7), "g": 0.0, "h": float(n < 3)}))
    return {names: of(made, *(column(name, BOOLEAN) for name in names)) for names in ("fgh", "fg")}


def test_the_highest_gain_ratio_wins_among_those_of_average_gain() -> None:
    """The average is 0.307."""
    tree = build(three_booleans()["fgh"])
    assert isinstance(tree.root, Branch)
    assert tree.root.test == Equals("g", 1.0)


def test_a_split_of_less_than_average_gain_is_not_taken_however_high_its_ratio() -> None:
    """Without h the average is 0.438, and g below it."""
    tree = build(three_booleans()["fg"])
    assert isinstance(tree.root, Branch)
    assert tree.root.test == Equals("f", 1.0)


def test_of_equal_gain_ratios_the_higher_gain_wins() -> None:
    """f parts the one A off, g the two C: both are pure (ratio 1). h lowers the average enough for both."""
    rows = [("A", 1, 0, 0), ("B", 0, 0, 0), ("B", 0, 0, 1), ("C", 0, 1, 0), ("C", 0, 1, 1)]
    made = [example(n, label, {"f": f, "g": g, "h": h}) for n, (label, f, g, h) in enumerate(rows)]
    tree = build(of(made, *(column(name, BOOLEAN) for name in "fgh")))
    assert isinstance(tree.root, Branch)
    assert tree.root.test == Equals("g", 1.0)


def test_by_gain_the_highest_gain_wins() -> None:
    tree = build(three_booleans()["fgh"], Growth(gain_ratio=False))
    assert isinstance(tree.root, Branch)
    assert tree.root.test == Equals("f", 1.0)


def test_an_average_is_taken_over_offers_that_gain_anything() -> None:
    """Constant and useless features do not lower the bar."""
    rows = [example(n, "AAAABBBB"[n], {"c": 1.0, "n": float(n % 2), "f": float(n)}) for n in range(8)]
    data = of(rows, column("c"), column("n", BOOLEAN), column("f"))
    assert build(data) == Tree(
        ("A", "B"), Branch(AtMost("f", 3.5), Leaf((4.0, 0.0)), Leaf((0.0, 4.0)), (4.0, 4.0))
    )


def test_min_leaf_keeps_single_examples_from_leaves_of_their_own() -> None:
    data = of_one_feature(CONTINUOUS, (1.0, "A"), (2.0, "B"), (3.0, "B"), (4.0, "B"))
    assert build(data, Growth(min_leaf=2.0)).depth() == 0
    assert build(data, Growth(min_leaf=1.0)).depth() == 1


def test_all_kinds_work_in_one_tree() -> None:
    kinds = {"near": CONTINUOUS, "toward": TOROIDAL, "sees": BOOLEAN, "ground": CATEGORICAL}
    rows = [
        ("A", (1.0, 0.0, 0.0, 0.0)),
        ("B", (9.0, 0.0, 0.0, 0.0)),
        ("C", (1.0, pi - 0.1, 0.0, 0.0)),
        ("C", (1.0, 0.1 - pi, 0.0, 0.0)),
        ("D", (1.0, 0.0, 1.0, 0.0)),
        ("E", (1.0, 0.0, 0.0, 2.0)),
    ]
    made = [
        example(n, label, dict(zip(kinds, values, strict=True))) for n, (label, values) in enumerate(rows)
    ]
    tree = build(of(made, *(column(name, kind) for name, kind in kinds.items())))
    for e in made:
        assert tree.decide(e.values.__getitem__).probabilities[tree.labels.index(e.label)] == 1.0
    assert {type(node.test) for node in tree.nodes() if isinstance(node, Branch)} == {AtMost, InArc, Equals}


def test_learning_stops_when_asked() -> None:
    with pytest.raises(LearningCancelled):
        build(of_one_feature(CONTINUOUS, (1.0, "A"), (2.0, "B")), cancelled=lambda: True)
