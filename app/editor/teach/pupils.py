"""Which nodes can be taught a behavior, where, and which of its states they are in."""

from ...core.hierarchy import Hierarchy, Node
from ...core.project import Project
from ...core.wording import node_words
from ...engine.place import Place
from ...engine.snapshots import Snapshot
from ..selection import BehaviorKey


def nodes_of(forest: Hierarchy, type_name: str) -> tuple[str, ...]:
    """The nodes of a type, parents first."""
    return tuple(node.id for node in forest.walk() if node.type == type_name)


def arms_with(project: Project, type_name: str) -> tuple[str, ...]:
    """The names of the arms that have a node of a type."""
    return tuple(arm.name for arm in project.arms if nodes_of(arm.forest(), type_name))


def state_of(snapshot: Snapshot, node: str, key: BehaviorKey) -> str:
    """The state of an automaton that a node is in, at any depth; empty if it does not run it."""
    doing = snapshot.doing
    row = doing.rows.get(node)
    if row is None:
        return ""
    for number in doing.state[row].tolist():
        if number >= 0:
            ref = doing.states[number]
            if (ref.type, ref.automaton) == (key.type, key.id):
                return ref.state
    return ""


def called(place: Place, node_id: str) -> str:
    """What the user calls a node."""
    node = next((node for node in place.hierarchy.walk() if node.id == node_id), Node(node_id, ""))
    return node_words(node)


def entity_called(place: Place, entity: int) -> str:
    """What the user calls something in the world: an agent by its name, others by kind and number."""
    for kind, span in place.spans.items():
        if entity in span:
            if kind == "agent":
                return called(place, place.agents[entity - span.start])
            return kind if len(span) == 1 else f"{kind} {entity - span.start + 1}"
    return "nothing"
