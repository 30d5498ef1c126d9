"""Controllers in the world: where they stand among their agents, the hulls around those, and the links to them; no Qt."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import pi

import numpy as np
from numpy.typing import NDArray

from ...engine.place import Place
from .scene import Scene

#: Directions in which a hull is told: its corners are cut by at most 1 - cos(pi / 32), half a percent.
DIRECTIONS = 32
_ANGLES = np.arange(DIRECTIONS) * (2 * pi / DIRECTIONS)
_COS, _SIN = np.cos(_ANGLES), np.sin(_ANGLES)

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Forest:
    """The controllers of a place as arrays, in the order of its nodes.

    Attributes:
        first, end: The agents of each.
        level: Of each.
        parent, child: Rows of nodes that are linked, controllers first.
    """

    first: NDArray[np.int64]
    end: NDArray[np.int64]
    level: NDArray[np.int64]
    parent: NDArray[np.int64]
    child: NDArray[np.int64]

    @property
    def controllers(self) -> int:
        """How many."""
        return len(self.first)


@lru_cache(maxsize=2)  # the live world's, and a stored moment's
def forest_of(place: Place) -> Forest:
    """The controllers of *place*."""
    rows, above = place.rows, len(place.ids) - len(place.agents)
    controllers = place.hierarchy.controllers()
    spans = [[rows[agent.id] - above for agent in node.agents()] for node in controllers]
    links = [(rows[node.id], rows[child.id]) for node in controllers for child in node.children]
    return Forest(
        np.array([span[0] for span in spans], np.int64),
        np.array([span[-1] + 1 for span in spans], np.int64),
        np.array([node.level for node in controllers], np.int64),
        np.array([parent for parent, _ in links], np.int64),
        np.array([child for _, child in links], np.int64),
    )


def nodes_at(scene: Scene) -> tuple[Floats, Floats]:
    """Where all nodes are, in the order of the place's nodes: a controller is in the middle of its agents."""
    forest, agents = forest_of(scene.place), scene.agents
    size = forest.end - forest.first
    found = []
    for values in (scene.x[:agents], scene.y[:agents]):
        sums = np.concatenate(([0.0], np.cumsum(values)))
        found.append(np.concatenate(((sums[forest.end] - sums[forest.first]) / size, values)))
    return found[0], found[1]


def hulls(
    x: Floats, y: Floats, forest: Forest, which: NDArray[np.int64], around: Floats
) -> tuple[Floats, Floats]:
    """Hulls around the agents of some controllers: controllers x corners.

    Each is what all half-planes in `DIRECTIONS` directions that hold the agents have in common, *around* farther out.
    That is one pass over all agents, however many controllers there are, and corners come out blunt.

    Args:
        x, y: Of all agents, in whatever unit.
        around: Of each controller.
    """
    reach = np.empty((len(which), DIRECTIONS))
    for level in np.unique(forest.level[which]):
        mine = np.flatnonzero(forest.level[which] == level)
        reach[mine] = _reach(x, y, forest, which[mine])
    reach += around[:, None]
    # Where two neighboring edges meet: between directions a and b = a + step, cos and sin of the step in the way.
    following = np.roll(reach, -1, axis=1)
    sine = np.sin(2 * pi / DIRECTIONS)
    cos_next, sin_next = np.roll(_COS, -1), np.roll(_SIN, -1)
    return (reach * sin_next - following * _SIN) / sine, (following * _COS - reach * cos_next) / sine


def _reach(x: Floats, y: Floats, forest: Forest, which: NDArray[np.int64]) -> Floats:
    """How far the agents of controllers of one level, which share none, reach in each direction."""
    edges = np.stack((forest.first[which], forest.end[which]), axis=1).ravel()
    along = np.empty((len(x) + 1, DIRECTIONS))  # one more, so that every end is a place in it
    np.multiply.outer(x, _COS, out=along[:-1])
    along[:-1] += np.multiply.outer(y, _SIN)
    along[-1] = -np.inf
    reached: Floats = np.maximum.reduceat(along, edges, axis=0)[::2]
    return reached
