"""Pessimistic pruning as in C4.5 (Quinlan 1993, chapter 4): replace subtrees that do not pay for themselves.

A leaf that got E of N examples wrong is expected to get more wrong of those to come: N times the upper confidence limit
of a binomial error rate. A subtree whose leaves together expect no fewer errors than one leaf in its place becomes that
leaf. The limits are exact (Clopper and Pearson 1934), where C4.5 approximates them. Subtrees are replaced, never raised.
"""

from scipy.special import betaincinv

from ..core.errors import ParameterError
from ..core.tree import Branch, Leaf, Tree, TreeNode

#: C4.5 prefers the leaf unless the subtree saves more than this many errors.
SLACK = 0.1


def pruned(tree: Tree, confidence: float) -> Tree:
    """*tree* with subtrees replaced by leaves, bottom up.

    Args:
        confidence: In (0, 0.5]. The smaller it is, the less is left; C4.5's default is 0.25.
    """
    refuse_confidence(confidence)
    done: dict[int, tuple[TreeNode, float]] = {}
    for node in reversed(list(tree.nodes())):
        as_leaf = expected_errors(node.counts, confidence)
        if isinstance(node, Branch):
            (yes, errors_yes), (no, errors_no) = done[id(node.yes)], done[id(node.no)]
            if as_leaf > errors_yes + errors_no + SLACK:
                done[id(node)] = Branch(node.test, yes, no, node.counts), errors_yes + errors_no
                continue
        done[id(node)] = Leaf(node.counts), as_leaf
    return Tree(tree.labels, done[id(tree.root)][0])


def refuse_confidence(confidence: float) -> None:
    """Raise a `ParameterError` unless *confidence* is in (0, 0.5]."""
    if not 0.0 < confidence <= 0.5:
        raise ParameterError(f"the pruning confidence is {confidence}; it must be above 0 and at most 0.5")


def expected_errors(counts: tuple[float, ...], confidence: float) -> float:
    """How many of as many examples to come a leaf with these class counts is expected to get wrong, at worst."""
    total = sum(counts)
    return total * error_limit(total - max(counts), total, confidence)


def error_limit(errors: float, total: float, confidence: float) -> float:
    """The error rate at which so few errors, or fewer, come up with probability *confidence* only."""
    if errors >= total:
        return 1.0
    return float(betaincinv(errors + 1.0, total - errors, 1.0 - confidence))
