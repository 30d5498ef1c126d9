"""Forests of agents and controllers: agents are the leaves, controllers the inner nodes (paper, section 3.2).

A forest may have any depth and shape. Agents are numbered in the order in which a walk from the roots meets them, so
every controller's agents have consecutive numbers.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from .errors import HierarchyError
from .library import NodeType


@dataclass(frozen=True, slots=True)
class Node:
    """An agent (no children) or a controller."""

    id: str
    type: str
    children: tuple["Node", ...] = ()
    name: str = ""

    @property
    def level(self) -> int:
        """0 for agents; otherwise one more than the highest child's."""
        return 1 + max(child.level for child in self.children) if self.children else 0

    def walk(self) -> Iterator["Node"]:
        """This node and all below, parents first, children in order."""
        return _walk((self,))

    def agents(self) -> Iterator["Node"]:
        """The agents at or below this node, in order."""
        return (node for node in self.walk() if not node.children)


@dataclass(frozen=True)  # no slots: what is derived is kept once it was asked for
class Hierarchy:
    """A forest of nodes."""

    roots: tuple[Node, ...]

    def walk(self) -> Iterator[Node]:
        """All nodes, parents first."""
        return iter(self._walked)

    def agents(self) -> tuple[Node, ...]:
        """All agents, in the order of their numbers."""
        return self._agents

    def controllers(self) -> tuple[Node, ...]:
        """All controllers, the highest level first, each level in the order of the walk."""
        return self._controllers

    def parents(self) -> Mapping[str, str]:
        """Node id -> id of its controller, for all that have one."""
        return self._parents

    @cached_property
    def _walked(self) -> tuple[Node, ...]:
        return tuple(_walk(self.roots))

    @cached_property
    def _agents(self) -> tuple[Node, ...]:
        return tuple(node for node in self._walked if not node.children)

    @cached_property
    def _controllers(self) -> tuple[Node, ...]:
        inner = [node for node in self._walked if node.children]
        return tuple(sorted(inner, key=lambda node: -node.level))

    @cached_property
    def _parents(self) -> Mapping[str, str]:
        return {child.id: node.id for node in self._walked for child in node.children}

    def node(self, node_id: str) -> Node:
        """The node with this id.

        Raises:
            HierarchyError: There is none.
        """
        for node in self.walk():
            if node.id == node_id:
                return node
        raise HierarchyError(f"there is no node {node_id!r}")


def _walk(nodes: Sequence[Node]) -> Iterator[Node]:
    """These nodes and all below; one generator for all of them, since there may be ten thousand."""
    waiting = list(reversed(nodes))
    while waiting:
        node = waiting.pop()
        yield node
        if node.children:
            waiting.extend(reversed(node.children))


def from_table(sizes: Sequence[int], types: Sequence[str]) -> Hierarchy:
    """A regular forest: *sizes* from the roots down, *types* likewise.

    ``from_table([2, 5, 5], ["squad", "group", "agent"])`` is two squads of five groups of five agents.

    Raises:
        HierarchyError: The two differ in length, are empty, or a size is below 1.
    """
    if not sizes or len(sizes) != len(types):
        raise HierarchyError(
            f"there are {len(sizes)} level sizes and {len(types)} types; allowed: one type a level, one level or more"
        )
    if bad := [size for size in sizes if size < 1]:
        raise HierarchyError(f"a level size must be 1 or more, but one is {bad[0]}")
    counters = dict.fromkeys(types, 0)

    def grow(depth: int) -> tuple[Node, ...]:
        nodes = []
        for _ in range(sizes[depth]):
            counters[types[depth]] += 1
            node_id = f"{types[depth]}-{counters[types[depth]]}"
            children = grow(depth + 1) if depth + 1 < len(sizes) else ()
            nodes.append(Node(node_id, types[depth], children))
        return tuple(nodes)

    return Hierarchy(grow(0))


def problems(hierarchy: Hierarchy, types: Mapping[str, NodeType]) -> list[tuple[str, str]]:
    """What is wrong with a forest: pairs of node id and message."""
    found: list[tuple[str, str]] = []
    if not hierarchy.roots:
        found.append(("", "the hierarchy is empty; it needs at least one agent"))
    seen: set[str] = set()
    for node in hierarchy.walk():
        if node.id in seen:
            found.append((node.id, f"the node id {node.id!r} stands twice"))
        seen.add(node.id)
        node_type = types.get(node.type)
        if node.children or node_type is None or node_type.level > 0:  # most are agents, as they should be
            found += [(node.id, message) for message in _node_problems(node, types)]
    return found


def _node_problems(node: Node, types: Mapping[str, NodeType]) -> Iterator[str]:
    node_type = types.get(node.type)
    if node_type is None:
        yield f"its type {node.type!r} does not exist; there are: {', '.join(types) or 'none'}"
    elif node_type.level == 0 and node.children:
        yield f"{node.type!r} is a type of agents, but it has {len(node.children)} subsidiaries"
    elif node_type.level > 0 and not node.children:
        yield f"{node.type!r} is a type of controllers, but it has no subsidiaries"
    elif node_type.level > 0:
        for child in node.children:
            if child.type not in node_type.subsidiaries:
                allowed = ", ".join(node_type.subsidiaries) or "none"
                yield f"{child.id!r} is of type {child.type!r}; allowed under {node.type!r}: {allowed}"
