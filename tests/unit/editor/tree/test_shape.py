"""A decision tree is shown as far as it is open, however deep it is."""

from app.core.conditions import AtMost
from app.core.examples import Example
from app.core.tree import Branch, Leaf, Tree, TreeNode
from app.editor.tree.reaching import Reaching, passed
from app.editor.tree.shape import (
    HEIGHT,
    LEVELS,
    ROOT,
    WIDTH,
    below,
    find,
    leading_to,
    leaves,
    lit,
    path_to,
    shape,
)


def chain(length: int) -> Tree:
    """Tests x <= length - 1, then x <= length - 2, and so on; no ends."""
    node: TreeNode = Leaf((1.0, 0.0))
    for number in range(length):
        node = Branch(AtMost("x", float(number)), node, Leaf((0.0, 1.0)), (1.0, number + 1.0))
    return Tree(("a", "b"), node)


def bushy(depth: int) -> TreeNode:
    if depth == 0:
        return Leaf((1.0, 1.0))
    return Branch(AtMost("x", float(depth)), bushy(depth - 1), bushy(depth - 1), (1.0, 1.0))


def test_only_the_first_levels_are_open_and_what_is_hidden_is_counted() -> None:
    knots = shape(chain(500))
    assert len(knots) == 1 + 2 * LEVELS
    assert max(knot.hidden for knot in knots.values()) == 500 - LEVELS


def test_opening_a_node_shows_the_next_levels() -> None:
    tree = chain(500)
    deepest = max(knot.key for knot in shape(tree).values() if knot.hidden)
    knots = shape(tree, below(tree, deepest))
    assert len(knots) == 1 + 4 * LEVELS


def test_all_of_a_deep_tree_can_be_open() -> None:
    tree = chain(500)
    assert len(shape(tree, below(tree, ROOT, 500))) == 1001


def test_nodes_of_a_level_do_not_cover_each_other() -> None:
    tree = Tree(("a", "b"), bushy(5))
    knots = shape(tree, below(tree, ROOT, 5))
    rows: dict[float, list[float]] = {}
    for knot in knots.values():
        rows.setdefault(knot.at[1], []).append(knot.at[0])
    assert len(knots) == 63
    assert all(
        b - a >= WIDTH for xs in rows.values() for a, b in zip(sorted(xs), sorted(xs)[1:], strict=False)
    )
    assert all(b - a >= HEIGHT for a, b in zip(sorted(rows), sorted(rows)[1:], strict=False))


def test_no_stands_to_the_left_of_yes() -> None:
    knots = shape(chain(2))
    assert knots[2].at[0] < knots[1].at[0] < knots[3].at[0]


def test_the_lit_path_ends_where_the_tree_decides() -> None:
    tree = chain(500)
    keys = lit(tree, {"x": 250.0}.__getitem__)
    assert find(tree, keys[-1]) == Leaf((0.0, 1.0))
    assert path_to(tree, keys[-1]) == tree.explain({"x": 250.0}.__getitem__)
    assert len(keys) == 252


def test_examples_at_a_node_are_those_that_pass_its_path() -> None:
    examples = [Example(str(i), "s", "a", {"x": float(i)}) for i in range(10)]
    disabled = Example("off", "s", "a", {"x": 1.0}, enabled=False)
    lacking = Example("lacking", "s", "a", {})
    reaching = Reaching([*examples, disabled, lacking], "s", ["x"])
    tree = chain(9)
    assert reaching.ids(path_to(tree, 3)) == tuple(str(i) for i in range(9))
    assert reaching.ids(path_to(tree, 2)) == ("9",)


def test_the_nodes_that_examples_pass_are_those_that_each_of_them_passes() -> None:
    tree = Tree(("a", "b"), bushy(3))
    examples = [Example(str(x), "s", "a", {"x": x}) for x in (0.5, 2.5, 9.0)]
    keys = passed(tree, examples)
    assert keys == {key for example in examples for key in lit(tree, example.values.__getitem__)}
    assert sorted(leaves(tree, keys)) == sorted(lit(tree, e.values.__getitem__)[-1] for e in examples)


def test_no_examples_pass_nothing() -> None:
    assert passed(chain(3), []) == frozenset()


def test_the_ways_that_lead_to_a_state_are_those_to_its_leaves() -> None:
    keys = leading_to(chain(3), "a")
    assert keys == {1, 3, 7, 15}
    assert leaves(chain(3), keys) == [15]
    assert leading_to(chain(3), "c") == frozenset()
