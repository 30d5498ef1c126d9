"""The tree builder against its brute-force twin, scikit-learn, and its own promises, on random data of all kinds."""

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from math import inf, nextafter, pi
from random import Random
from unittest.mock import patch

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.tree import DecisionTreeClassifier

from app.core.examples import Example
from app.core.tree import Branch, Leaf, Tree, TreeNode
from app.core.vocabulary import FeatureKind
from app.learner import arcs
from app.learner.builder import Growth, build
from app.learner.dataset import Column, Dataset, conflicts, values_of
from app.learner.impurity import Whole, gain_and_information, whole
from tests.twins.brute_force_tree import EQUAL, Row, best_offer, offer, worths
from tests.unit.learner.examples import BOOLEAN, CATEGORICAL, CONTINUOUS, TOROIDAL, column, example, of

LABELS = "ABCD"
AFTER_ONE = nextafter(1.0, inf)

VALUES = {
    CONTINUOUS: st.sampled_from([-1e300, -2.5, 0.0, 1.0, AFTER_ONE, 3.0, 40.0]) | st.floats(-10, 10),
    TOROIDAL: st.sampled_from([-pi, -2.0, -0.5, 0.0, 0.5, 2.0, nextafter(pi, 0)]) | st.floats(-pi, pi),
    BOOLEAN: st.sampled_from([0.0, 1.0]),
    CATEGORICAL: st.sampled_from([0.0, 1.0, 2.0, 3.0]),
}


@st.composite
def columns(draw: st.DrawFn) -> tuple[Column, ...]:
    kinds = draw(st.lists(st.sampled_from(list(FeatureKind)), min_size=1, max_size=4))
    return tuple(column(f"f{number}", kind) for number, kind in enumerate(kinds))


@st.composite
def example_lists(draw: st.DrawFn, used: tuple[Column, ...], *, most: int = 14) -> list[Example]:
    rows = st.tuples(
        st.sampled_from(LABELS),
        st.tuples(*(VALUES[c.kind] for c in used)),
        st.booleans(),
        st.sampled_from([1.0, 1.0, 1.0, 2.0, 0.3]),
    )
    return [
        example(number, label, values_of(used, values), continuation=continuation, weight=weight)
        for number, (label, values, continuation, weight) in enumerate(
            draw(st.lists(rows, min_size=1, max_size=most))
        )
    ]


@st.composite
def datasets(draw: st.DrawFn) -> Dataset:
    used = draw(columns())
    return of(draw(example_lists(used)), *used)


def nodes_with_rows(tree: Tree, data: Dataset) -> Iterator[tuple[TreeNode, list[Example]]]:
    """Every node with the examples that reach it, by the tests' own word."""
    stack = [(tree.root, list(data.examples))]
    while stack:
        node, here = stack.pop()
        yield node, here
        if isinstance(node, Branch):
            test = node.test
            stack.append((node.yes, [e for e in here if test.holds(e.values[test.feature])]))
            stack.append((node.no, [e for e in here if not test.holds(e.values[test.feature])]))


def as_rows(examples: list[Example]) -> list[Row]:
    return [Row(dict(e.values), e.label, e.weight) for e in examples]


@pytest.mark.parametrize("gain_ratio", [True, False])
@given(data=datasets())
@settings(max_examples=120)
def test_every_split_is_as_good_as_the_brute_force_twins(data: Dataset, gain_ratio: bool) -> None:
    tree = build(data, Growth(gain_ratio=gain_ratio))
    for node, examples in nodes_with_rows(tree, data):
        rows = as_rows(examples)
        worth = worths(rows, data.columns, gain_ratio=gain_ratio)
        if isinstance(node, Leaf):
            assert len({e.label for e in examples}) == 1 or not worth
        else:
            test = node.test
            parts: tuple[list[Row], list[Row]] = ([], [])
            for row in rows:
                parts[test.holds(row.values[test.feature])].append(row)
            assert all(parts)
            used = next(c for c in data.columns if c.feature == test.feature)
            assert offer(*parts) == pytest.approx(best_offer(rows, used), abs=10 * EQUAL)
            assert worth[test.feature] >= max(worth.values()) - 10 * EQUAL


@given(data=datasets())
@settings(max_examples=120)
def test_the_counts_at_every_node_are_those_of_the_examples_that_reach_it(data: Dataset) -> None:
    for node, examples in nodes_with_rows(build(data), data):
        counts = [sum(e.weight for e in examples if e.label == label) for label in data.labels]
        assert node.counts == pytest.approx(counts)


@given(data=datasets())
@settings(max_examples=120)
def test_examples_without_conflict_are_reproduced_and_conflicting_ones_share_a_leaf(data: Dataset) -> None:
    tree = build(data)
    in_conflict = {number for group in conflicts(data) for number in group}
    for e in data.examples:
        alike = [other for other in data.examples if other.values == e.values]
        decision = tree.decide(e.values.__getitem__)
        shares = dict(zip(tree.labels, decision.probabilities, strict=True))
        own = sum(other.weight for other in alike if other.label == e.label)
        assert shares[e.label] == pytest.approx(own / sum(other.weight for other in alike))
        assert (shares[e.label] < 1.0) == (e.id in in_conflict)


@given(data=datasets(), seed=st.integers(0, 1000))
@settings(max_examples=80)
def test_the_order_of_examples_does_not_matter(data: Dataset, seed: int) -> None:
    shuffled = list(data.examples)
    Random(seed).shuffle(shuffled)
    assert build(of(shuffled, *data.columns)) == build(data)


@given(data=datasets(), min_leaf=st.sampled_from([2.0, 3.0, 5.0]))
@settings(max_examples=60)
def test_no_leaf_is_lighter_than_min_leaf(data: Dataset, min_leaf: float) -> None:
    tree = build(data, Growth(min_leaf=min_leaf))
    leaves = [node for node in tree.nodes() if isinstance(node, Leaf)]
    assert len(leaves) == 1 or min(sum(leaf.counts) for leaf in leaves) >= min_leaf - EQUAL


@given(data=datasets(), depth=st.integers(1, 3))
@settings(max_examples=40)
def test_a_depth_limit_holds(data: Dataset, depth: int) -> None:
    assert build(data, Growth(max_depth=depth)).depth() <= depth


@given(rows=st.lists(st.tuples(*[st.integers(-20, 20)] * 3, st.sampled_from("ABC")), min_size=2, max_size=40))
@settings(max_examples=60)
def test_splits_by_gain_are_as_good_as_those_of_scikit_learn(rows: list[tuple[int, int, int, str]]) -> None:
    used = tuple(column(f"f{number}") for number in range(3))
    data = of([example(n, row[3], values_of(used, row[:3])) for n, row in enumerate(rows)], *used)
    for node, examples in nodes_with_rows(build(data, Growth(gain_ratio=False)), data):
        x = np.array([list(e.values.values()) for e in examples])
        stump = DecisionTreeClassifier(criterion="entropy", max_depth=1)
        stump.fit(x, [e.label for e in examples])
        assert isinstance(node, Leaf) == (stump.get_depth() == 0)
        if isinstance(node, Branch):
            low = [e for e in as_rows(examples) if node.test.holds(e.values[node.test.feature])]
            high = [e for e in as_rows(examples) if not node.test.holds(e.values[node.test.feature])]
            measured = stump.tree_
            sides = measured.weighted_n_node_samples[1:] / measured.weighted_n_node_samples[0]
            gain = measured.impurity[0] - (sides * measured.impurity[1:]).sum()
            assert offer(low, high)[0] == pytest.approx(gain, abs=1e-6)


# ------------------------------------------------------------------------------------------------ many cuts


@st.composite
def prefix_sums(draw: st.DrawFn) -> tuple[np.ndarray, Whole]:
    """Class weights below each of many cuts: runs of labels of random lengths, sometimes with much order in them."""
    random = np.random.default_rng(draw(st.integers(0, 10**6)))
    blocks, classes = draw(st.integers(65, 260)), draw(st.integers(2, 5))
    sizes = random.integers(1, draw(st.sampled_from([2, 10])), blocks) * draw(st.sampled_from([1.0, 0.3]))
    labels = random.integers(0, classes, blocks)
    ordered = random.random(blocks) < draw(st.sampled_from([0.0, 0.6, 0.95]))
    labels = np.where(ordered, np.arange(blocks) * 3 // blocks % classes, labels)
    weights = np.zeros((classes, blocks))
    weights[labels, np.arange(blocks)] = sizes
    return np.cumsum(weights, axis=1) - weights, whole(weights.sum(axis=1, keepdims=True))


@given(sums=prefix_sums(), least=st.sampled_from([0.0, 5.0]))
@settings(max_examples=60)
def test_the_bounded_search_for_arcs_finds_what_trying_all_pairs_finds(
    sums: tuple[np.ndarray, Whole], least: float
) -> None:
    below, node = sums
    low, high = np.triu_indices(below.shape[1], 1)
    gain, information = gain_and_information(below[:, high] - below[:, low], node, least)
    best = gain >= gain.max() - EQUAL
    found = arcs._Search(below, node, least).near_best()
    assert found[2].max() == gain.max()
    near = found[2] >= gain.max() - EQUAL
    assert set(zip(found[0][near], found[1][near], strict=True)) == set(
        zip(low[best], high[best], strict=True)
    )
    assert found[3][near].max() == information[best].max()


@given(
    labels=st.lists(st.sampled_from(["A", "B", "ABC", "ABAB"]), min_size=8, max_size=40),
    repeats=st.integers(2, 4),
)
@settings(max_examples=40)
def test_few_and_many_cuts_are_searched_with_one_result(labels: list[str], repeats: int) -> None:
    """The labels come round again, so that many arcs are equally good."""
    around = ("".join(labels) * repeats)[: arcs.FEW_CUTS]
    points = [example(n, label, {"f": 6 * n / len(around) - 3}) for n, label in enumerate(around)]
    data = of(points, column("f", TOROIDAL))
    plainly = build(data, Growth(max_depth=1))
    with patch.object(arcs, "FEW_CUTS", 8):
        assert build(data, Growth(max_depth=1)) == plainly


@given(sums=prefix_sums())
@settings(max_examples=40)
def test_no_pair_of_cuts_gains_more_than_the_bound_on_its_runs(sums: tuple[np.ndarray, Whole]) -> None:
    below, node = sums
    count = below.shape[1]
    search = arcs._Search(below, node, 0.0)
    low, high = np.triu_indices(count, 1)
    gain, _ = gain_and_information(below[:, high] - below[:, low], node, 0.0)
    for length in arcs.RUNS:
        runs = np.minimum(np.arange(0, count, length)[:, None] + np.arange(length), count - 1)
        first, second = np.triu_indices(len(runs))
        bounds = np.zeros((len(runs), len(runs)))
        bounds[first, second] = search._bounds(runs, first, second)
        assert np.all(gain <= bounds[low // length, high // length] + EQUAL)


def test_equal_examples_in_any_number_make_one_leaf() -> None:
    data = of([example(n, "AB"[n % 2], {"f": 1.0}) for n in range(7)], column("f"))
    assert build(data) == Tree(("A", "B"), Leaf((4.0, 3.0)))


def test_a_tree_as_deep_as_its_examples_are_many_is_built() -> None:
    """Alternating labels along a line peel off one by one, deeper than Python recurses."""
    data = of([example(n, "AB"[n % 2], {"f": float(n)}) for n in range(1500)], column("f"))
    tree = build(data)
    assert sum(isinstance(node, Leaf) for node in tree.nodes()) == 1500
    assert all(
        tree.decide({"f": value}.__getitem__).probabilities == ((1.0, 0.0) if value % 2 == 0 else (0.0, 1.0))
        for value in (0.0, 1.0, 700.0, 701.0, 1499.0)
    )


def test_weights_count_like_repeated_examples() -> None:
    used = (column("f"), column("g", TOROIDAL))
    points = [("A", 1.0, 0.1), ("B", 2.0, 0.4), ("A", 3.0, -2.0), ("B", 4.0, 2.5)]
    once = [example(n, label, {"f": f, "g": g}) for n, (label, f, g) in enumerate(points)]
    weighted = [replace(e, weight=2.0) if n % 2 else e for n, e in enumerate(once)]
    repeated = [*once, *(replace(e, id=f"{e.id}b") for e in once[1::2])]
    assert build(of(weighted, *used)) == build(of(repeated, *used))


def test_beyond_the_most_cuts_only_quantiles_are_tried() -> None:
    count = 3 * arcs.MOST_CUTS
    random = np.random.default_rng(1)
    labels = random.integers(0, 2, count)
    spread = [example(n, "AB"[label], {"f": -3 + 6 * n / count}) for n, label in enumerate(labels.tolist())]
    # All of this range is A: an arc about it gains most.
    spread = [replace(e, label="A") if 0.5 < e.values["f"] < 1.5 else e for e in spread]
    tree = build(of(spread, column("f", TOROIDAL)), Growth(max_depth=1))
    assert isinstance(tree.root, Branch)
    inside = [n for n, e in enumerate(spread) if tree.root.test.holds(e.values["f"])]
    assert all(b == a + 1 for a, b in pairwise(inside))
    assert spread[inside[0]].values["f"] == pytest.approx(0.5, abs=0.01)
    assert spread[inside[-1]].values["f"] == pytest.approx(1.5, abs=0.01)
