"""Where a session takes place: what does not change while a world lives."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from ..core.hierarchy import Hierarchy, Node
from ..core.project import Value
from ..core.wording import node_words
from ..sim.columns import AGENT
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

    @cached_property
    def names(self) -> tuple[str, ...]:
        """What the user calls each of `ids`."""
        return tuple(map(self.called, self.ids))

    @cached_property
    def _nodes(self) -> Mapping[str, Node]:
        return {node.id: node for node in self.hierarchy.walk()}

    def called(self, node_id: str) -> str:
        """What the user calls a node; one that is not here goes by its id."""
        return node_words(self._nodes.get(node_id) or Node(node_id, ""))

    def kind_of(self, entity: int) -> str:
        """The kind of an entity."""
        return next(kind for kind, span in self.spans.items() if entity in span)

    def entity_called(self, entity: int) -> str:
        """What the user calls an entity: an agent by its name, ``box 3``, or just ``deposit`` where there is but one."""
        for kind, span in self.spans.items():
            if entity in span:
                if kind == AGENT:
                    return self.called(self.agents[entity - span.start])
                return kind if len(span) == 1 else f"{kind} {entity - span.start + 1}"
        return "nothing"


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
