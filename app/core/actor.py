"""What nodes are doing while a machine runs: the only values here that change."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from .automaton import START
from .chance import FIRST_CONTROLLER
from .hierarchy import Hierarchy, Node
from .library import Behavior
from .vocabulary import BasicBehavior


@dataclass(frozen=True, slots=True)
class Argument:
    """What a parameter stands for while a behavior runs: a ground target, and the node that bound it."""

    target: str
    owner: str


Arguments = Mapping[str, Argument]


@dataclass(slots=True)
class Run:
    """A behavior while one node runs it.

    Attributes:
        arguments: What the behavior's parameters stand for.
        flags: Flags that are up on it; its parent sees them from the parent's next tick on.
        state, entered: The automaton's current state, and the tick in which it was entered.
        child: What the current state runs; none in Start and after a flag was raised.
        key: What decided the last evaluation since the state was entered (for `hold`).
        pulsed: Whether a basic behavior has had a pulse.
    """

    behavior: Behavior
    arguments: Arguments
    flags: set[str] = field(default_factory=set)
    state: str = START
    entered: int = 0
    child: "Run | None" = None
    key: object = None
    pulsed: bool = False

    def directs(self) -> bool:
        """Whether it is in a state in which a controller directs its subsidiaries."""
        if isinstance(self.behavior, BasicBehavior):
            return self.behavior.derived
        return self.child is not None and self.child.directs()


@dataclass(slots=True, eq=False)
class Actor:
    """A node while the machine runs.

    Attributes:
        number: An agent's number; a controller's place among the controllers.
        members: The numbers of the agents at or below it.
        parent: The id of its controller, if it has one.
        children, agents: Its subsidiaries, and all agents below it.
        run: What it does; None idles.
        flags: Flags of the agent itself: `finished`.
        direction: What a controller last told its subsidiaries to start.
        left: Whether a controller has left the state that told them, while they still show the flags they raised in it.
    """

    node: Node
    number: int
    members: range
    parent: str | None
    children: tuple["Actor", ...] = field(default=(), repr=False)
    agents: tuple["Actor", ...] = field(default=(), repr=False)
    run: Run | None = None
    flags: set[str] = field(default_factory=set)
    direction: tuple[str, Arguments] | None = None
    left: bool = False

    @property
    def is_agent(self) -> bool:
        """Whether it has a body."""
        return not self.children

    @property
    def drawer(self) -> int:
        """Who it is when it draws."""
        return self.number if self.is_agent else FIRST_CONTROLLER + self.number

    def shows(self, flag: str) -> bool:
        """Whether its controller sees *flag*: up on the node itself, or on the behavior that it was directed to do."""
        return flag in self.flags or (self.run is not None and flag in self.run.flags)

    def lower(self) -> None:
        """Lower all flags that its controller would see."""
        self.flags.clear()
        if self.run is not None:
            self.run.flags.clear()

    def lower_directed(self) -> None:
        """Lower what the directed behaviors raised, since the controller changed state; `finished` stays."""
        for child in self.children:
            if child.run is not None:
                child.run.flags.clear()
        self.left = False


def actors(hierarchy: Hierarchy) -> dict[str, Actor]:
    """An idle actor for every node, by id, in the order in which they tick: controllers first, the top level first."""
    parents = hierarchy.parents()
    found: dict[str, Actor] = {}
    for number, agent in enumerate(hierarchy.agents()):
        found[agent.id] = Actor(agent, number, range(number, number + 1), parents.get(agent.id))
    inner = [(node, number) for number, node in enumerate(hierarchy.controllers())]
    for node, number in reversed(inner):
        children = tuple(found[child.id] for child in node.children)
        agents = tuple(_agents(children))
        members = range(agents[0].number, agents[-1].number + 1)
        found[node.id] = Actor(node, number, members, parents.get(node.id), children, agents)
    in_turn = (*hierarchy.controllers(), *hierarchy.agents())
    return {node.id: found[node.id] for node in in_turn}


def _agents(children: tuple[Actor, ...]) -> Iterator[Actor]:
    for child in children:
        yield from (child,) if child.is_agent else child.agents
