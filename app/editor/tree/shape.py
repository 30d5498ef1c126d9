"""Which nodes of a decision tree are shown, and where they stand: pure, and quick however deep the tree is."""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass

from ...core.conditions import Condition, Guard, Values
from ...core.tree import Branch, Tree, TreeNode

#: The root is 1, and below k come 2k + 1 for yes and 2k for no.
Key = int
ROOT: Key = 1
#: So many levels are open at first, and as many more whenever one is opened.
LEVELS = 3
WIDTH, HEIGHT, ASIDE, BELOW = 136.0, 48.0, 16.0, 40.0


@dataclass(frozen=True, slots=True)
class Knot:
    """A node that is shown.

    Attributes:
        at: The middle of its box.
        hidden: How many tests there are below it that are not shown.
    """

    key: Key
    node: TreeNode
    at: tuple[float, float]
    hidden: int = 0


def shown_keys(tree: Tree, opened: Collection[Key], closed: Collection[Key]) -> dict[Key, TreeNode]:
    """The nodes that are shown, a parent before its children.

    Args:
        opened: Nodes below the first levels whose children are shown.
        closed: Nodes of the first levels whose children are not.
    """
    found: dict[Key, TreeNode] = {}
    stack: list[tuple[Key, TreeNode, int]] = [(ROOT, tree.root, 0)]
    while stack:
        key, node, depth = stack.pop()
        found[key] = node
        if isinstance(node, Branch) and (key in opened or (depth < LEVELS and key not in closed)):
            stack.append((2 * key + 1, node.yes, depth + 1))
            stack.append((2 * key, node.no, depth + 1))
    return found


def shape(tree: Tree, opened: Collection[Key] = (), closed: Collection[Key] = ()) -> Mapping[Key, Knot]:
    """The nodes that are shown with their places: no to the left, yes to the right, parents above the middle."""
    shown = shown_keys(tree, opened, closed)
    xs: dict[Key, float] = {}
    free = 0.0
    for key in _left_to_right(shown):
        xs[key] = free
        free += WIDTH + ASIDE
    for key in reversed(shown):
        if key not in xs:
            xs[key] = (xs[2 * key] + xs[2 * key + 1]) / 2
    middle = xs[ROOT]
    levels = depths(shown)
    return {
        key: Knot(key, node, (xs[key] - middle, levels[key] * (HEIGHT + BELOW)), _hidden(key, node, shown))
        for key, node in shown.items()
    }


def _left_to_right(shown: Mapping[Key, TreeNode]) -> Iterator[Key]:
    """The shown nodes without shown children."""
    stack = [ROOT]
    while stack:
        key = stack.pop()
        if 2 * key in shown:
            stack += (2 * key + 1, 2 * key)
        else:
            yield key


def depths(shown: Mapping[Key, TreeNode]) -> dict[Key, int]:
    """How many tests stand above each node."""
    found: dict[Key, int] = {}
    for key in shown:
        found[key] = 0 if key == ROOT else found[key // 2] + 1
    return found


def _hidden(key: Key, node: TreeNode, shown: Mapping[Key, TreeNode]) -> int:
    if 2 * key in shown or not isinstance(node, Branch):
        return 0
    return sum(isinstance(below, Branch) for below in Tree((), node).nodes())


def find(tree: Tree, key: Key) -> TreeNode | None:
    """The node with a key, if there is one."""
    node: TreeNode = tree.root
    for digit in bin(key)[3:]:
        if not isinstance(node, Branch):
            return None
        node = node.yes if digit == "1" else node.no
    return node


def path_to(tree: Tree, key: Key) -> Guard:
    """The tests on the way to a node, as they must come out; as far as there are nodes."""
    node, path = tree.root, []
    for digit in bin(key)[3:]:
        if not isinstance(node, Branch):
            break
        path.append(Condition(node.test, wanted=digit == "1"))
        node = node.yes if digit == "1" else node.no
    return tuple(path)


def lit(tree: Tree, values: Values) -> tuple[Key, ...]:
    """The nodes that an evaluation passes, the root first."""
    node, key, found = tree.root, ROOT, [ROOT]
    while isinstance(node, Branch):
        yes = node.test.holds(values(node.test.feature))
        node, key = (node.yes, 2 * key + 1) if yes else (node.no, 2 * key)
        found.append(key)
    return tuple(found)


def leaves(tree: Tree, keys: Collection[Key]) -> list[Key]:
    """Those of the nodes of a tree that nothing is tested in."""
    return [
        key for key in keys if 2 * key not in keys and 2 * key + 1 not in keys and find(tree, key) is not None
    ]


def leading_to(tree: Tree, label: str) -> frozenset[Key]:
    """The nodes on the way to leaves that lead to a state, perhaps among others."""
    place = tree.labels.index(label) if label in tree.labels else len(tree.labels)
    found: set[Key] = set()
    stack: list[tuple[Key, TreeNode]] = [(ROOT, tree.root)]
    while stack:
        key, node = stack.pop()
        if isinstance(node, Branch):
            stack += ((2 * key + 1, node.yes), (2 * key, node.no))
        elif any(count > 0.0 for count in node.counts[place : place + 1]):
            found.update(key >> up for up in range(key.bit_length()))
    return frozenset(found)


def below(tree: Tree, key: Key, levels: int = LEVELS) -> set[Key]:
    """A node and the branches under it, so many levels down: what is opened together."""
    found: set[Key] = set()
    node = find(tree, key)
    stack = [] if node is None else [(key, node, 0)]
    while stack:
        here, node, depth = stack.pop()
        if isinstance(node, Branch) and depth < levels:
            found.add(here)
            stack += ((2 * here + 1, node.yes, depth + 1), (2 * here, node.no, depth + 1))
    return found
