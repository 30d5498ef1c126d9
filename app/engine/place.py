"""Where a session takes place: what does not change while a world lives."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from ..core.hierarchy import Hierarchy
from ..core.project import Value
from ..sim.engine import Engine
from ..sim.look import SettledLook, settled


@dataclass(frozen=True, eq=False)  # no slots: what is derived is kept once it was asked for
class Place:
    """A world's forest, parameters and looks; all snapshots of one world have the same one, to be compared by `is`.

    Attributes:
        arm: The name that the arm had when the world began.
        parameters: All of the scenario's.
        spans: Kind, agents included -> its entities.
        look: How it is drawn.
    """

    scenario: str
    arm: str
    hierarchy: Hierarchy = field(repr=False)
    parameters: Mapping[str, Value] = field(repr=False)
    spans: Mapping[str, range]
    physics: str
    look: SettledLook = field(repr=False)

    @cached_property
    def ids(self) -> tuple[str, ...]:
        """All nodes in the machine's order: controllers, the top level first, then agents by number."""
        return (*(node.id for node in self.hierarchy.controllers()), *self.agents)

    @cached_property
    def rows(self) -> Mapping[str, int]:
        """Where each node stands among `ids`."""
        return {node_id: row for row, node_id in enumerate(self.ids)}

    @cached_property
    def agents(self) -> tuple[str, ...]:
        """Agents by number, which is also the number of their entity."""
        return tuple(node.id for node in self.hierarchy.agents())


def place_of(engine: Engine, arm: str) -> Place:
    """Where *engine*'s world is."""
    start = engine.start
    return Place(
        start.scenario.name,
        arm,
        start.hierarchy,
        start.parameters,
        engine.spans(),
        start.physics,
        settled(start.scenario.look, start.scenario.kinds, start.parameters),
    )
