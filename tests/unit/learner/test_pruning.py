"""Pessimistic pruning, against the numbers in Quinlan's book (C4.5, section 4.2)."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.core.conditions import AtMost, Equals
from app.core.errors import ParameterError
from app.core.tree import Branch, Leaf, Tree
from app.learner.pruning import error_limit, expected_errors, pruned

INNER = Branch(Equals("f", 1.0), Leaf((9.0, 0.0)), Leaf((0.0, 1.0)), (9.0, 1.0))
THE_BOOKS = Branch(Equals("g", 1.0), Leaf((6.0, 0.0)), INNER, (15.0, 1.0))


@pytest.mark.parametrize(
    ("errors", "total", "limit"),
    [(0, 6, 0.206), (0, 9, 0.143), (0, 1, 0.750), (1, 16, 0.157)],
)
def test_error_limits_are_those_of_the_book(errors: int, total: int, limit: float) -> None:
    """Which approximates them where there are errors."""
    assert error_limit(errors, total, 0.25) == pytest.approx(limit, abs=0.003 if errors else 0.0005)


def test_an_error_limit_is_where_so_few_errors_have_the_probability_of_the_confidence() -> None:
    rate = error_limit(1, 16, 0.25)
    assert (1 - rate) ** 16 + 16 * rate * (1 - rate) ** 15 == pytest.approx(0.25)


def test_a_subtree_that_does_not_pay_becomes_a_leaf() -> None:
    """The book's example: three pure leaves of 6, 9 and 1 expect 3.273 errors, one leaf with 1 of 16 wrong 2.512."""
    tree = Tree(("A", "B"), THE_BOOKS)
    leaves = [node for node in tree.nodes() if isinstance(node, Leaf)]
    assert sum(expected_errors(leaf.counts, 0.25) for leaf in leaves) == pytest.approx(3.273, abs=0.005)
    assert expected_errors((15.0, 1.0), 0.25) == pytest.approx(2.512, abs=0.05)
    assert pruned(tree, 0.25) == Tree(("A", "B"), Leaf((15.0, 1.0)))


def test_a_subtree_that_pays_stays() -> None:
    tree = Tree(("A", "B"), Branch(AtMost("f", 1.0), Leaf((20.0, 0.0)), Leaf((0.0, 20.0)), (20.0, 20.0)))
    assert pruned(tree, 0.25) == tree


def test_only_the_part_that_does_not_pay_is_replaced() -> None:
    root = Branch(AtMost("f", 1.0), Leaf((0.0, 30.0)), THE_BOOKS, (15.0, 31.0))
    assert pruned(Tree(("A", "B"), root), 0.25).root == Branch(
        AtMost("f", 1.0), Leaf((0.0, 30.0)), Leaf((15.0, 1.0)), (15.0, 31.0)
    )


@given(
    counts=st.lists(st.floats(0.5, 50), min_size=1, max_size=4),
    confidences=st.tuples(st.floats(0.01, 0.5), st.floats(0.01, 0.5)),
)
def test_less_confidence_expects_more_errors_and_never_fewer_than_were_made(
    counts: list[float], confidences: tuple[float, float]
) -> None:
    low, high = sorted(confidences)
    made = sum(counts) - max(counts)
    assert expected_errors(tuple(counts), low) >= expected_errors(tuple(counts), high) - 1e-9
    assert expected_errors(tuple(counts), high) >= made - 1e-9


def test_a_tree_deeper_than_python_recurses_is_pruned() -> None:
    node: Leaf | Branch = Leaf((0.0, 50.0))
    for depth in range(3000):
        leaf = Leaf((50.0, 0.0) if depth % 2 else (0.0, 50.0))
        counts = (leaf.counts[0] + node.counts[0], leaf.counts[1] + node.counts[1])
        node = Branch(AtMost("f", float(depth)), leaf, node, counts)
    assert pruned(Tree(("A", "B"), node), 0.25).depth() == 2999


@pytest.mark.parametrize("confidence", [0.0, -0.1, 0.51, 25.0, float("nan")])
def test_a_confidence_out_of_range_is_refused(confidence: float) -> None:
    with pytest.raises(ParameterError, match=r"must be above 0 and at most 0\.5"):
        pruned(Tree(("A",), Leaf((1.0,))), confidence)
