"""Cuts that the user has moved: tests of a learned tree whose numbers are the user's, whatever is learned.

A moved cut moves the boundary and nothing else: the counts at the leaves stay those of the examples, so what a leaf
predicts stays the same, and only who comes there changes. A cut is found again by the features that are tested on the
way to it, and how they came out, not by their numbers, so that it stands when thresholds shift with new examples.
Where the tree does not test that feature there any more, the cut waits.
"""

from collections.abc import Iterable
from dataclasses import replace

from .automaton import Cut
from .conditions import Guard, Test
from .tree import Branch, Tree, TreeNode


def with_cuts(tree: Tree, cuts: Iterable[Cut]) -> Tree:
    """*tree* with the tests that *cuts* are about replaced by theirs; cuts that wait change nothing."""
    for cut in cuts:
        above = _way(tree, cut.guard)
        if above is not None and is_about(cut.test, above[-1]):
            tree = Tree(tree.labels, _replaced(above, cut))
    return tree


def stands(tree: Tree, cut: Cut) -> bool:
    """Whether the tree has the test that a cut is about."""
    above = _way(tree, cut.guard)
    return above is not None and is_about(cut.test, above[-1])


def is_about(test: Test, node: TreeNode) -> bool:
    """Whether a node tests the same feature in the same way."""
    return isinstance(node, Branch) and type(node.test) is type(test) and node.test.feature == test.feature


def same_place(a: Guard, b: Guard) -> bool:
    """Whether two ways down test the same features with the same outcome."""
    return _steps(a) == _steps(b)


def _steps(guard: Guard) -> list[tuple[str, bool]]:
    return [(condition.test.feature, condition.wanted) for condition in guard]


def _way(tree: Tree, guard: Guard) -> list[TreeNode] | None:
    """The nodes on the way that *guard* describes, the root first; None if the tree tests other features there."""
    node, found = tree.root, [tree.root]
    for condition in guard:
        if not is_about(condition.test, node) or not isinstance(node, Branch):
            return None
        node = node.yes if condition.wanted else node.no
        found.append(node)
    return found


def _replaced(above: list[TreeNode], cut: Cut) -> TreeNode:
    """The root with the last of *above* replaced; everything beside the way is shared."""
    last = above[-1]
    assert isinstance(last, Branch)
    made: Branch = replace(last, test=cut.test)
    for node, condition in zip(reversed(above[:-1]), reversed(cut.guard), strict=True):
        assert isinstance(node, Branch)
        made = replace(node, yes=made) if condition.wanted else replace(node, no=made)
    return made
