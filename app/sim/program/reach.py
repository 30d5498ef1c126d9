"""What the nodes of a forest may come to run: everything that can be reached from what they run now, numbered."""

from collections.abc import Mapping, Sequence

from ...core.actor import Actor
from ...core.automaton import START, Automaton, Basic, Nested, successors
from ...core.errors import ProgramError
from ...core.library import Types
from ...core.vocabulary import BasicBehavior
from .needs import Needs
from .tables import AutomatonRow, StateRow

#: An automaton's id, or a basic behavior.
What = str | BasicBehavior


class Reached:
    """Behaviors and states in the order in which they were found.

    Attributes:
        automata: By type and id, with the states that can be entered.
        basics: By type and name.
        states: Of all automata; the first stands for all that cannot be entered.
        below: For each type of controllers, the types of their subsidiaries.
    """

    def __init__(self, types: Types, actors: Sequence[Actor]) -> None:
        self.automata: dict[tuple[str, str], AutomatonRow] = {}
        self.basics: dict[tuple[str, str], BasicBehavior] = {}
        self.states: list[StateRow] = [StateRow(-1, "")]
        self._types = types
        self.below = _types_below(actors)

    def find(self, needs: Needs) -> None:
        """Number all that can be reached: automata with the states that can be entered, and basic behaviors."""
        extra: dict[tuple[str, str], set[str]] = {}
        for kind, automaton_id, state_id in needs.states:
            extra.setdefault((kind, automaton_id), set()).add(state_id)
        waiting: list[tuple[str, What]] = sorted(needs.automata)
        waiting += [
            (kind, self._types.vocabulary(kind).behavior(name)) for kind, name in sorted(needs.basics)
        ]
        while waiting:
            kind, what = waiting.pop()
            if isinstance(what, BasicBehavior):
                if (kind, what.name) not in self.basics:
                    self.basics[kind, what.name] = what
                    waiting += self._directed(kind, what)
            elif (kind, what) not in self.automata:
                waiting += self._number(kind, what, extra.get((kind, what), set()))

    def _directed(self, kind: str, basic: BasicBehavior) -> list[tuple[str, What]]:
        if not basic.derived:
            return []
        return [(below, self.started(below, basic)) for below in self.below.get(kind, ())]

    def started(self, kind: str, basic: BasicBehavior) -> What:
        """What a node of *kind* starts when directed to do *basic*.

        Raises:
            ProgramError: It has no such behavior, or one of other parameters.
        """
        repertoire = self._types.repertoire(kind)
        if basic.name not in repertoire:
            raise ProgramError(f"a subsidiary of type {kind!r} has no behavior {basic.name!r}")
        found = repertoire[basic.name]
        if found.parameters != basic.parameters:
            raise ProgramError(f"{basic.name!r} of type {kind!r} has other parameters than its controller's")
        return found if isinstance(found, BasicBehavior) else found.id

    def _number(self, kind: str, automaton_id: str, extra: set[str]) -> list[tuple[str, What]]:
        automaton = self._types.library(kind).get(automaton_id)
        entered = _entered(automaton, extra)
        row, states = len(self.automata), {}
        for state in automaton.states:
            if state.id in entered:
                states[state.id] = len(self.states)
                self.states.append(StateRow(row, state.id))
        self.automata[kind, automaton_id] = AutomatonRow(kind, automaton, states)
        held = [state.content for state in automaton.states if state.id in entered]
        vocabulary = self._types.vocabulary(kind)
        return [
            (kind, vocabulary.behavior(content.behavior) if isinstance(content, Basic) else content.automaton)
            for content in held
            if isinstance(content, Basic | Nested)
        ]

    def levels(self) -> int:
        """The longest chain of automata that hold each other, and a basic behavior at its end."""
        known: dict[tuple[str, str], int] = {}

        def levels(key: tuple[str, str]) -> int:
            if key not in known:
                row = self.automata[key]
                held = (row.automaton.state(state_id).content for state_id in row.states)
                below = [levels((key[0], c.automaton)) for c in held if isinstance(c, Nested)]
                known[key] = 1 + max(below, default=1)
            return known[key]

        for kind in self._types.types:
            self._types.library(kind).refuse_cycle()
        return max([1, *map(levels, self.automata)])


def _types_below(actors: Sequence[Actor]) -> Mapping[str, tuple[str, ...]]:
    """For each type of controllers, the types of their subsidiaries."""
    below: dict[str, dict[str, None]] = {}
    for actor in actors:
        if actor.children:
            below.setdefault(actor.node.type, {}).update(dict.fromkeys(c.node.type for c in actor.children))
    return {kind: tuple(found) for kind, found in below.items()}


def _entered(automaton: Automaton, extra: set[str]) -> set[str]:
    """The states that can be entered from Start, and from those that nodes are in."""
    found = {START} | {state for state in extra if automaton.has_state(state)}
    waiting = list(found)
    while waiting:
        for target in successors(automaton, waiting.pop()) - found:
            if not automaton.has_state(target):
                raise ProgramError(f"{automaton.name!r} goes on to a state {target!r} that it does not have")
            found.add(target)
            waiting.append(target)
    return found
