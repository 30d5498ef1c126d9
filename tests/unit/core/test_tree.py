from collections.abc import Callable
from dataclasses import replace

import pytest

from app.core.conditions import AtMost, Condition, Equals, InArc, Test
from app.core.tree import LEAF, Branch, FlatTree, Forest, Leaf, Tree, TreeNode, flatten, shares, unflatten

NEAR, SEES, AHEAD = AtMost("d", 2.0), Equals("sees", 1.0), InArc("angle", 3.0, -3.0)
#: near? yes: leaf; no: sees? yes: (ahead? yes: leaf, no: leaf); no: leaf
TREE = Tree(
    ("go", "stop"),
    Branch(
        NEAR,
        Leaf((0.0, 4.0)),
        Branch(
            SEES,
            Branch(AHEAD, Leaf((3.0, 1.0)), Leaf((0.0, 0.0)), (3.0, 1.0)),
            Leaf((1.0, 0.0)),
            (4.0, 1.0),
        ),
        (4.0, 5.0),
    ),
)


def seen(**known: float) -> Callable[[str], float]:
    return known.__getitem__


def test_a_tree_decides_with_the_shares_of_the_leaf_it_reaches() -> None:
    assert TREE.decide(seen(d=1.0)).probabilities == (0.0, 1.0)
    assert TREE.decide(seen(d=3.0, sees=1.0, angle=3.1)).probabilities == (0.75, 0.25)
    assert TREE.decide(seen(d=3.0, sees=0.0)).probabilities == (1.0, 0.0)


def test_a_leaf_without_counts_decides_nothing() -> None:
    assert TREE.decide(seen(d=3.0, sees=1.0, angle=0.0)).probabilities == (0.0, 0.0)


def test_each_leaf_has_a_key_of_its_own() -> None:
    ways = [
        seen(d=1.0),
        seen(d=3.0, sees=1.0, angle=3.1),
        seen(d=3.0, sees=1.0, angle=0.0),
        seen(d=3.0, sees=0.0),
    ]
    assert [TREE.decide(way).key for way in ways] == [(0b11,), (0b1011,), (0b1010,), (0b100,)]


def test_an_explanation_lists_the_tests_on_the_way_as_they_came_out() -> None:
    assert TREE.explain(seen(d=3.0, sees=1.0, angle=0.0)) == (
        Condition(NEAR, wanted=False),
        Condition(SEES, wanted=True),
        Condition(AHEAD, wanted=False),
    )
    assert Tree(("go",), Leaf((1.0,))).explain(seen()) == ()


def test_an_explanation_is_met_by_what_it_explains() -> None:
    way = seen(d=3.0, sees=1.0, angle=-3.1)
    assert all(condition.met(way) for condition in TREE.explain(way))


def test_features_and_depth_are_those_of_the_tests() -> None:
    assert TREE.features() == ("d", "sees", "angle")
    assert TREE.depth() == 3
    assert Tree(("go",), Leaf((1.0,))).depth() == 0


def test_nodes_come_in_preorder_yes_before_no() -> None:
    assert [node.test if isinstance(node, Branch) else node.counts for node in TREE.nodes()] == [
        NEAR, (0.0, 4.0), SEES, AHEAD, (3.0, 1.0), (0.0, 0.0), (1.0, 0.0),
    ]  # fmt: skip


def test_shares_add_up_to_1_or_are_all_zero() -> None:
    assert shares((1.0, 3.0)) == (0.25, 0.75)
    assert shares((0.0, 0.0)) == (0.0, 0.0)
    assert shares((2.5, 7.5)) == (0.25, 0.75)


def test_a_forest_decides_with_the_mean_of_its_trees() -> None:
    always = Tree(("go", "stop"), Leaf((1.0, 1.0)))
    decision = Forest(("go", "stop"), (TREE, always)).decide(seen(d=1.0))
    assert decision.probabilities == (0.25, 0.75)
    assert decision.key == (0b11, 1)


def test_a_forest_without_trees_decides_nothing() -> None:
    assert Forest(("go", "stop"), ()).decide(seen()).probabilities == (0.0, 0.0)


# ---------------------------------------------------------------------------------------------- flat form


def test_a_flat_tree_is_in_preorder() -> None:
    assert flatten(TREE) == FlatTree(
        labels=("go", "stop"),
        features=("d", "sees", "angle"),
        slot=(0, LEAF, 1, 2, LEAF, LEAF, LEAF),
        operation=("at most", "", "equals", "in arc", "", "", ""),
        a=(2.0, 0.0, 1.0, 3.0, 0.0, 0.0, 0.0),
        b=(0.0, 0.0, 0.0, -3.0, 0.0, 0.0, 0.0),
        yes=(1, LEAF, 3, 4, LEAF, LEAF, LEAF),
        no=(2, LEAF, 6, 5, LEAF, LEAF, LEAF),
        counts=((4.0, 5.0), (0.0, 4.0), (4.0, 1.0), (3.0, 1.0), (3.0, 1.0), (0.0, 0.0), (1.0, 0.0)),
    )


@pytest.mark.parametrize("tree", [TREE, Tree(("go",), Leaf((1.0,))), Tree((), Leaf(()))])
def test_unflattening_gives_the_same_tree_back(tree: Tree) -> None:
    assert unflatten(flatten(tree)) == tree


def test_subtrees_that_are_one_and_the_same_value_are_flattened_in_their_own_places() -> None:
    same = Branch(SEES, Leaf((1.0, 0.0)), Leaf((0.0, 1.0)), (1.0, 1.0))
    tree = Tree(("go", "stop"), Branch(NEAR, same, same, (2.0, 2.0)))
    flat = flatten(tree)
    assert (flat.yes, flat.no) == ((1, 2, LEAF, LEAF, 5, LEAF, LEAF), (4, 3, LEAF, LEAF, 6, LEAF, LEAF))
    assert unflatten(flat) == tree


def test_a_very_deep_tree_does_not_overflow_the_stack() -> None:
    root: TreeNode = Leaf((1.0,))
    for k in range(5000):
        root = Branch(AtMost("d", float(k)), root, Leaf((1.0,)), (float(k + 2),))
    tree = Tree(("go",), root)
    flat = flatten(tree)
    again = unflatten(flat)
    assert flatten(again) == flat
    assert again.depth() == 5000
    assert again.decide(seen(d=4.5)).probabilities == (1.0,)


@pytest.mark.parametrize(
    ("damage", "message"),
    [
        ({"yes": (0, LEAF, 3, 4, LEAF, LEAF, LEAF)}, "node 0 points to 0 and 2; allowed: 1 to 6"),
        ({"no": (2, LEAF, 7, 5, LEAF, LEAF, LEAF)}, "node 2 points to 3 and 7; allowed: 3 to 6"),
        (
            {"operation": ("at most", "", "is", "in arc", "", "", "")},
            "unknown test 'is'; allowed: at most, equals, in arc",
        ),
    ],
)
def test_a_damaged_flat_tree_is_refused_with_the_place(
    damage: dict[str, tuple[int, ...]], message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        unflatten(replace(flatten(TREE), **damage))  # type: ignore[arg-type]  # whatever it names


@pytest.mark.parametrize("test", [NEAR, SEES, AHEAD])
def test_every_kind_of_test_survives_the_flat_form(test: Test) -> None:
    tree = Tree(("go",), Branch(test, Leaf((1.0,)), Leaf((2.0,)), (3.0,)))
    assert unflatten(flatten(tree)) == tree
