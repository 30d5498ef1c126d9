"""Immutable decision trees with class counts at the leaves: decide, explain, flatten.

A leaf predicts with the probabilities of its counts (the paper's "probabilistic leaf nodes").
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from .conditions import AtMost, Condition, Equals, InArc, Test, Values

#: Which leaf, or leaves, an evaluation ended in. `hold` draws again only when this changes.
LeafKey = tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Leaf:
    """Class counts (sums of example weights), in the order of the tree's labels."""

    counts: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Branch:
    """A test; *counts* are those of all examples below it, for display and pruning."""

    test: Test
    yes: "TreeNode"
    no: "TreeNode"
    counts: tuple[float, ...]


TreeNode = Leaf | Branch


@dataclass(frozen=True, slots=True)
class Decision:
    """Where an evaluation ended, and the probabilities there in the order of the labels."""

    key: LeafKey
    probabilities: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Tree:
    """A decision tree; *labels* are ids of states."""

    labels: tuple[str, ...]
    root: TreeNode

    def decide(self, values: Values) -> Decision:
        """Walk down to a leaf. Its key is the way there: 1, then a binary digit a test, 1 for yes."""
        node, key = self.root, 1
        while isinstance(node, Branch):
            yes = node.test.holds(values(node.test.feature))
            node = node.yes if yes else node.no
            key = 2 * key + yes
        return Decision((key,), shares(node.counts))

    def explain(self, values: Values) -> tuple[Condition, ...]:
        """The tests on the way to the leaf, as they came out."""
        node, path = self.root, []
        while isinstance(node, Branch):
            yes = node.test.holds(values(node.test.feature))
            path.append(Condition(node.test, yes))
            node = node.yes if yes else node.no
        return tuple(path)

    def nodes(self) -> Iterator[TreeNode]:
        """All nodes in preorder, yes before no."""
        stack = [self.root]
        while stack:
            node = stack.pop()
            yield node
            if isinstance(node, Branch):
                stack += (node.no, node.yes)

    def depth(self) -> int:
        """The number of tests on the longest way down."""
        deepest, stack = 0, [(self.root, 0)]
        while stack:
            node, depth = stack.pop()
            deepest = max(deepest, depth)
            if isinstance(node, Branch):
                stack += ((node.yes, depth + 1), (node.no, depth + 1))
        return deepest

    def features(self) -> tuple[str, ...]:
        """The ids of the features it tests, in order of first use."""
        return tuple(dict.fromkeys(node.test.feature for node in self.nodes() if isinstance(node, Branch)))


@dataclass(frozen=True, slots=True)
class Forest:
    """Several trees over the same labels; the decision is the mean of theirs."""

    labels: tuple[str, ...]
    trees: tuple[Tree, ...]

    def decide(self, values: Values) -> Decision:
        """The mean of the trees' probabilities, summed in order."""
        decisions = [tree.decide(values) for tree in self.trees]
        totals = [0.0] * len(self.labels)
        for decision in decisions:
            totals = [total + p for total, p in zip(totals, decision.probabilities, strict=True)]
        probabilities = tuple(total / len(decisions) for total in totals) if decisions else tuple(totals)
        return Decision(tuple(number for d in decisions for number in d.key), probabilities)


def trees_of(model: object) -> tuple[Tree, ...]:
    """The trees that a model is made of; none, if it is made of something else."""
    if isinstance(model, Forest):
        return model.trees
    return (model,) if isinstance(model, Tree) else ()


def shares(counts: tuple[float, ...]) -> tuple[float, ...]:
    """*counts* divided by their sum; none at all stay zeros ("no data: stay")."""
    total = 0.0
    for count in counts:
        total += count
    return tuple(count / total for count in counts) if total > 0 else counts


# ---------------------------------------------------------------------------------------------- flat form

LEAF = -1
OPERATIONS: Mapping[str, type[Test]] = {"at most": AtMost, "equals": Equals, "in arc": InArc}
_OPERATION_NAMES = {kind: name for name, kind in OPERATIONS.items()}


@dataclass(frozen=True, slots=True)
class FlatTree:
    """A tree as parallel arrays, one entry a node in preorder, yes before no. This is the form on disk.

    Attributes:
        slot: Index into *features*, or `LEAF`.
        operation: "at most", "equals", "in arc", or "" at a leaf.
        a, b: The test's numbers (threshold; value; start and end of the arc).
        yes, no: Indices of the nodes below, or `LEAF`.
        counts: One tuple of class counts a node.
    """

    labels: tuple[str, ...]
    features: tuple[str, ...]
    slot: tuple[int, ...]
    operation: tuple[str, ...]
    a: tuple[float, ...]
    b: tuple[float, ...]
    yes: tuple[int, ...]
    no: tuple[int, ...]
    counts: tuple[tuple[float, ...], ...]


def flatten(tree: Tree) -> FlatTree:
    """*tree* as arrays; `unflatten` gives the same tree back."""
    features, nodes = tree.features(), tuple(tree.nodes())
    below = _below(nodes)
    slot, operation, a, b = zip(*(_row(node, features) for node in nodes), strict=True)
    yes, no = zip(*below, strict=True)
    return FlatTree(
        tree.labels, features, slot, operation, a, b, yes, no, tuple(node.counts for node in nodes)
    )


def _below(preorder: Sequence[TreeNode]) -> list[tuple[int, int]]:
    """For each node the places of the nodes below it: yes comes next, no after all that is below yes."""
    below = [(LEAF, LEAF)] * len(preorder)
    waiting: list[int] = []  # roots of subtrees that are known in full, the leftmost last
    for index in reversed(range(len(preorder))):
        if isinstance(preorder[index], Branch):
            yes, no = waiting.pop(), waiting.pop()
            below[index] = (yes, no)
        waiting.append(index)
    return below


def _row(node: TreeNode, features: tuple[str, ...]) -> tuple[int, str, float, float]:
    if isinstance(node, Leaf):
        return LEAF, "", 0.0, 0.0
    return features.index(node.test.feature), _OPERATION_NAMES[type(node.test)], *_numbers_of(node.test)


def _numbers_of(test: Test) -> tuple[float, float]:
    match test:
        case AtMost(_, threshold):
            return threshold, 0.0
        case Equals(_, value):
            return value, 0.0
        case InArc(_, start, end):
            return start, end


def unflatten(flat: FlatTree) -> Tree:
    """The tree that *flat* describes.

    Raises:
        ValueError: A node points backward, which in preorder none does, or to no node; or a test is unknown.
    """
    built: dict[int, TreeNode] = {}
    for index in reversed(range(len(flat.slot))):
        if flat.slot[index] == LEAF:
            built[index] = Leaf(flat.counts[index])
        else:
            yes, no = flat.yes[index], flat.no[index]
            if yes not in built or no not in built:
                raise ValueError(
                    f"node {index} points to {yes} and {no}; allowed: {index + 1} to {len(flat.slot) - 1}"
                )
            built[index] = Branch(_test(flat, index), built[yes], built[no], flat.counts[index])
    return Tree(flat.labels, built[0])


def _test(flat: FlatTree, index: int) -> Test:
    feature, a, b = flat.features[flat.slot[index]], flat.a[index], flat.b[index]
    match flat.operation[index]:
        case "at most":
            return AtMost(feature, a)
        case "equals":
            return Equals(feature, a)
        case "in arc":
            return InArc(feature, a, b)
        case other:
            raise ValueError(f"unknown test {other!r}; allowed: {', '.join(OPERATIONS)}")
