"""Edits of one arm's forest, node by node. A table of level sizes is written out at the first such edit.

Every node keeps its id. A controller that loses its last subsidiary goes too, since a node without subsidiaries would
be an agent.
"""

from collections.abc import Collection, Sequence
from dataclasses import replace

from ..errors import EditError, HierarchyError
from ..hierarchy import Hierarchy, Node
from ..project import LevelTable, Project
from .arms import change_arm, find_arm
from .place import find_type, listed
from .words import says

Nodes = tuple[Node, ...]


@says("Change the hierarchy of arm {arm}")
def set_hierarchy(project: Project, arm: str, hierarchy: Hierarchy | LevelTable) -> Project:
    """Another forest, or a table of level sizes, for an arm."""
    return change_arm(project, arm, hierarchy=hierarchy)


@says("Add a node to arm {arm}")
def add_node(project: Project, arm: str, node_type: str, under: str = "") -> tuple[Project, str]:
    """One more node, the last under controller *under* or else of the roots; also returns its id.

    A new controller comes with one subsidiary of its type's first kind, and so on down.
    """
    forest = _forest(project, arm)
    _refuse_agent(forest, arm, under)
    taken = {node.id for node in forest.walk()}
    node = _grown(project, node_type, taken)
    return set_hierarchy(project, arm, Hierarchy(_put(forest.roots, (node,), under))), node.id


def _grown(project: Project, node_type: str, taken: set[str]) -> Node:
    node_id = fresh_node_id(taken, node_type)
    taken.add(node_id)
    below = find_type(project, node_type).subsidiaries[:1]
    return Node(node_id, node_type, tuple(_grown(project, child, taken) for child in below))


def fresh_node_id(taken: Collection[str], node_type: str) -> str:
    """The first of ``agent-1``, ``agent-2`` and so on that is not taken."""
    number = 1
    while f"{node_type}-{number}" in taken:
        number += 1
    return f"{node_type}-{number}"


@says("Remove node {node} from arm {arm}")
def remove_node(project: Project, arm: str, node: str) -> Project:
    """No such node any more, nor those below it."""
    forest = _forest(project, arm)
    _find_node(forest, arm, node)
    return set_hierarchy(project, arm, _tidied(_without(forest.roots, {node}), forest))


@says("Move nodes in arm {arm}")
def move_nodes(
    project: Project, arm: str, nodes: Sequence[str], under: str = "", to: int | None = None
) -> Project:
    """Put nodes, with all below them, under controller *under* or else among the roots.

    Args:
        to: Their place among the other nodes there; None puts them last.

    Raises:
        EditError: A node would come under itself, or *under* is an agent.
    """
    forest = _forest(project, arm)
    taken_out = _find_apart(forest, arm, nodes)
    _refuse_agent(forest, arm, under)
    for node in taken_out:
        if any(below.id == under for below in node.walk()):
            raise EditError(
                f"node {node.id!r} of arm {arm!r} cannot be moved under {under!r}, which is itself or below it"
            )
    moved = _put(_without(forest.roots, set(nodes)), taken_out, under, to)
    return set_hierarchy(project, arm, _tidied(moved, forest))


@says("Group nodes in arm {arm}")
def group_nodes(
    project: Project, arm: str, nodes: Sequence[str], controller_type: str, name: str = ""
) -> tuple[Project, str]:
    """Put nodes under a new controller, which stands where the first of them stood; also returns its id."""
    forest = _forest(project, arm)
    taken_out = _find_apart(forest, arm, nodes)
    allowed = find_type(project, controller_type).subsidiaries
    if not taken_out:
        raise EditError("a group needs at least one node")
    if wrong := [node for node in taken_out if node.type not in allowed]:
        raise EditError(
            f"{controller_type!r} cannot control {wrong[0].id!r} of type {wrong[0].type!r}; allowed: {listed(allowed)}"
        )
    first, *others = (node.id for node in taken_out)
    group_id = fresh_node_id({node.id for node in forest.walk()}, controller_type)
    group = Node(group_id, controller_type, taken_out, name)
    grouped = _exchanged(_without(forest.roots, set(others)), first, (group,))
    return set_hierarchy(project, arm, _tidied(grouped, forest)), group_id


@says("Dissolve {node} in arm {arm}")
def dissolve_node(project: Project, arm: str, node: str) -> Project:
    """Put a controller's subsidiaries in its own place."""
    forest = _forest(project, arm)
    found = _find_node(forest, arm, node)
    if not found.children:
        raise EditError(f"node {node!r} of arm {arm!r} is an agent, so there is no group to dissolve")
    return set_hierarchy(project, arm, Hierarchy(_exchanged(forest.roots, node, found.children)))


@says("Rename node {node} of arm {arm} to {name}")
def rename_node(project: Project, arm: str, node: str, name: str) -> Project:
    """Another name for a node; an empty one shows its id."""
    forest = _forest(project, arm)
    renamed = replace(_find_node(forest, arm, node), name=name)
    return set_hierarchy(project, arm, Hierarchy(_exchanged(forest.roots, node, (renamed,))))


def _forest(project: Project, arm: str) -> Hierarchy:
    try:
        return find_arm(project, arm).forest()
    except HierarchyError as error:
        raise EditError(f"the hierarchy of arm {arm!r} cannot be edited node by node: {error}") from None


def _find_node(forest: Hierarchy, arm: str, node_id: str) -> Node:
    return _find_apart(forest, arm, [node_id])[0]


def _find_apart(forest: Hierarchy, arm: str, node_ids: Sequence[str]) -> Nodes:
    """The nodes with these ids, none of which may stand below another."""
    there = {node.id: node for node in forest.walk()}
    for node_id in node_ids:
        if node_id not in there:
            roots = listed(root.id for root in forest.roots)
            raise EditError(f"arm {arm!r} has no node {node_id!r}; its roots are: {roots}")
    found = {node_id: there[node_id] for node_id in node_ids}
    for node in found.values():
        for below in node.walk():
            if below is not node and below.id in found:
                raise EditError(f"node {below.id!r} stands below {node.id!r}: name one of the two")
    return tuple(found.values())


def _refuse_agent(forest: Hierarchy, arm: str, under: str) -> None:
    if under and not _find_node(forest, arm, under).children:
        raise EditError(f"node {under!r} of arm {arm!r} is an agent; only controllers have subsidiaries")


# ------------------------------------------------------------------------------------ forests as values


def _without(nodes: Nodes, ids: Collection[str]) -> Nodes:
    """*nodes* and what is below them, without those with these ids."""
    kept = (n for n in nodes if n.id not in ids)
    return tuple(replace(n, children=_without(n.children, ids)) if n.children else n for n in kept)


def _put(nodes: Nodes, new: Nodes, under: str, to: int | None = None) -> Nodes:
    """*nodes* with *new* ones at place *to* under *under*, or among themselves if that is empty."""
    if not under:
        place = len(nodes) if to is None else max(0, to)
        return (*nodes[:place], *new, *nodes[place:])
    return tuple(
        replace(n, children=_put(n.children, new, "" if n.id == under else under, to))
        if n.id == under or n.children
        else n
        for n in nodes
    )


def _exchanged(nodes: Nodes, node_id: str, new: Nodes) -> Nodes:
    """*nodes* with *new* ones where the one with this id stands."""
    exchanged: list[Node] = []
    for node in nodes:
        if node.id == node_id:
            exchanged += new
        elif node.children:
            exchanged.append(replace(node, children=_exchanged(node.children, node_id, new)))
        else:
            exchanged.append(node)
    return tuple(exchanged)


def _tidied(nodes: Nodes, before: Hierarchy) -> Hierarchy:
    """The forest of *nodes* without those that had subsidiaries *before* and have none left."""
    controllers = {node.id for node in before.walk() if node.children}
    return Hierarchy(_peopled(nodes, controllers))


def _peopled(nodes: Nodes, controllers: Collection[str]) -> Nodes:
    kept = (
        replace(node, children=_peopled(node.children, controllers)) if node.children else node
        for node in nodes
    )
    return tuple(node for node in kept if node.children or node.id not in controllers)
