"""Moments: the world and what all nodes do, taken so that features can be computed later."""

import hashlib

from ..core.examples import Moment
from ..core.hierarchy import Hierarchy
from ..core.machine_state import freeze
from ..sim.engine import Engine
from .runs import Treatment

#: Under this name a moment's machine says which forest it was taken of.
FOREST = "forest"
#: Hexadecimal digits that tell forests apart.
DIGITS = 16


def take(engine: Engine, of: Treatment, forest: str) -> Moment:
    """The world and what all nodes do, now.

    Args:
        forest: The `forest_hash` of the nodes.
    """
    machine = {**freeze(engine.machine), FOREST: forest}
    return Moment(of.scenario.name, of.parameters, of.arm.name, engine.frozen_world(), machine)


def forest_hash(forest: Hierarchy) -> str:
    """Tells forests apart in which an agent has another number, controller or type; names do not matter."""
    parents = forest.parents()
    nodes = [(node.id, node.type, parents.get(node.id, "")) for node in forest.walk()]
    return hashlib.sha256(repr(nodes).encode()).hexdigest()[:DIGITS]
