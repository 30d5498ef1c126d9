"""Where nodes go that are moved by keys."""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum

from ...core.hierarchy import Hierarchy, Node


class Move(Enum):
    """A step among the siblings, or between levels."""

    UP = "up"
    DOWN = "down"
    OUT = "out"
    IN = "in"


def moved(forest: Hierarchy, nodes: Sequence[str], way: Move) -> tuple[str, int | None] | None:
    """The controller (empty: none) and the place among its other nodes that siblings go to; None if they stay.

    IN goes to the end of the controller right before them, OUT to right behind their own.
    """
    parents = forest.parents()
    above = {parents.get(node, "") for node in nodes}
    if len(above) != 1:
        return None
    parent = above.pop()
    siblings = forest.roots if not parent else forest.node(parent).children
    places = [at for at, node in enumerate(siblings) if node.id in nodes]
    match way:
        case Move.UP:
            return None if places[0] == 0 else (parent, places[0] - 1)
        case Move.DOWN:
            rest = len(siblings) - len(places)
            to = places[0] + 1
            return None if to > rest else (parent, to)
        case Move.IN:
            before = _controller_before(siblings, places[0])
            return None if before is None else (before.id, None)
        case Move.OUT if parent:
            higher = parents.get(parent, "")
            aunts = forest.roots if not higher else forest.node(higher).children
            return higher, [node.id for node in aunts].index(parent) + 1
    return None


def _controller_before(siblings: Sequence[Node], place: int) -> Node | None:
    before = siblings[place - 1] if place > 0 else None
    return before if before is not None and before.children else None
