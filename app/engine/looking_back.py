"""What a lesson wants to know of a compiled tick that has passed, found out only when somebody asks."""

from collections.abc import Sequence

from ..core.actor import Actor
from ..core.examples import Moment
from ..core.machine import Machine
from ..core.machine_state import MachineState, freeze
from ..sim.engine import Past
from .commands import Teach
from .departures import Departure
from .moments import FOREST
from .plan import automaton_of
from .recording import seen
from .runs import Treatment


class LookBack:
    """A tick in which nodes of a test left states.

    Attributes:
        tick: Its number.
        nodes: Those nodes, in the order in which they left.
    """

    def __init__(self, past: Past, nodes: Sequence[str], plan: Teach, of: Treatment, forest: str) -> None:
        self.tick = past.tick
        self.nodes = nodes
        self._past = past
        self._plan = plan
        self._of = of
        self._forest = forest

    def departure(self, node_id: str) -> Departure:
        """What a node left, and what it saw."""
        machine, senses = self._past.watch([node_id])
        actor = machine.actors[node_id]
        assert actor.run is not None
        values = seen(machine, senses, actor, actor.run, automaton_of(machine, self._plan))
        return Departure(actor.run.state, values, self.tick)

    def moment(self) -> Moment:
        """The world and what all nodes did when the first of them left."""
        states: list[MachineState] = []

        def leaving(machine: Machine, actor: Actor) -> None:
            if not states and actor.node.id in self.nodes:
                states.append(freeze(machine))

        self._past.replay(leaving)
        of = self._of
        kept = {**states[0], FOREST: self._forest}
        return Moment(of.scenario.name, of.parameters, of.arm.name, self._past.frozen_world(), kept)
