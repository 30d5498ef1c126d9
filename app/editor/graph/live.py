"""What the nodes of a snapshot do, seen from one automaton: shares of states, and where the selected node is."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from ...engine.snapshots import Doing, Snapshot, StateRef


@dataclass(frozen=True, slots=True)
class Crowd:
    """How many nodes are in each state of an automaton."""

    counts: Mapping[str, int] = field(default_factory=dict)

    @property
    def total(self) -> int:
        """How many nodes run the automaton."""
        return sum(self.counts.values())

    def share(self, state: str) -> float:
        """The part of them that is in a state; -1 where nobody runs the automaton."""
        total = self.total
        return self.counts.get(state, 0) / total if total else -1.0


def crowd(snapshot: Snapshot | None, type_name: str, automaton: str) -> Crowd:
    """Who is where in an automaton now."""
    return Crowd() if snapshot is None else Crowd(snapshot.doing.in_states(type_name, automaton))


def path_of(snapshot: Snapshot | None, node: str) -> tuple[StateRef, ...]:
    """The states that a node is in, outermost first; none if it idles, runs a basic behavior, or is not there."""
    if snapshot is None or node not in snapshot.doing.rows:
        return ()
    doing: Doing = snapshot.doing
    row = doing.state[doing.row(node)].tolist()
    return tuple(doing.states[number] for number in row if number >= 0)


def active_states(path: tuple[StateRef, ...], type_name: str, automaton: str) -> tuple[str, ...]:
    """The states of *path* from an automaton inward; none if the path does not lead through it."""
    for place, ref in enumerate(path):
        if (ref.type, ref.automaton) == (type_name, automaton):
            return tuple(ref.state for ref in path[place:])
    return ()
