"""What a program must know: the behaviors, states and flags that nodes have now, and what follows from them."""

from dataclasses import dataclass

from ...core.automaton import Automaton
from ...core.errors import ProgramError
from ...core.machine import Machine, Run


@dataclass(frozen=True, slots=True)
class Needs:
    """Rows that a program must have; automata by (type, id), basic behaviors by (type, name)."""

    automata: frozenset[tuple[str, str]] = frozenset()
    basics: frozenset[tuple[str, str]] = frozenset()
    states: frozenset[tuple[str, str, str]] = frozenset()
    flags: frozenset[str] = frozenset()

    def covers(self, other: "Needs") -> bool:
        """Whether a program for these needs knows all that *other* needs."""
        return (
            self.automata >= other.automata
            and self.basics >= other.basics
            and self.states >= other.states
            and self.flags >= other.flags
        )

    def __or__(self, other: "Needs") -> "Needs":
        return Needs(
            self.automata | other.automata,
            self.basics | other.basics,
            self.states | other.states,
            self.flags | other.flags,
        )


def needs_of(machine: Machine) -> Needs:
    """What the nodes of *machine* run now.

    Raises:
        ProgramError: A node still runs a behavior that its library has in another version now.
    """
    automata, basics, states, flags = set(), set(), set(), set()
    seen: set[tuple[str, int, str]] = set()  # most nodes do what others do as well
    for actor in machine.actors.values():
        kind, run = actor.node.type, actor.run
        flags |= actor.flags
        if actor.direction is not None:
            basics.add((kind, actor.direction[0]))
        while run is not None:
            flags |= run.flags
            behavior = run.behavior
            if (alike := (kind, id(behavior), run.state)) not in seen:
                seen.add(alike)
                if isinstance(behavior, Automaton):
                    _refuse_old(machine, kind, behavior, run)
                    automata.add((kind, behavior.id))
                    states.add((kind, behavior.id, run.state))
                else:
                    basics.add((kind, behavior.name))
            run = run.child
    return Needs(frozenset(automata), frozenset(basics), frozenset(states), frozenset(flags))


def _refuse_old(machine: Machine, kind: str, behavior: Automaton, run: Run) -> None:
    known = machine.types.library(kind).automata.get(behavior.id)
    if known is not behavior and known != behavior:
        raise ProgramError(f"{run.behavior.name!r} runs in a version that its library no longer has")
