"""What all nodes do at one moment, as arrays: cheap to take and to count, however many nodes there are."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..core.actor import Actor, Run
from ..core.automaton import Automaton

Rows = NDArray[np.int32]
#: Where a path has ended, where a behavior is no automaton, and what a node that idles shows.
NONE = -1


@dataclass(frozen=True, slots=True, order=True)
class BehaviorRef:
    """A behavior of a node type; *id* is empty for a basic one."""

    type: str
    id: str
    name: str


@dataclass(frozen=True, slots=True, order=True)
class StateRef:
    """A state of an automaton of a node type, by ids."""

    type: str
    automaton: str
    state: str


@dataclass(frozen=True, eq=False)  # no slots: what is derived is kept once it was asked for
class Doing:
    """What all nodes do. Rows are nodes in the machine's order: controllers, the top level first, then agents.

    Attributes:
        behaviors, states: What the numbers in the arrays mean.
        behavior: Nodes x levels: what runs, outermost first, -1 where the path has ended; all -1 idles.
        state: Nodes x levels: the state of each automaton on the path, -1 where there is none.
        flags: Nodes x flags: which a node shows, its own and those of the behavior it was directed to do.
        flag_names: What the columns of *flags* mean.
        rows: Row of each node.
        controllers: How many of the rows are controllers.
    """

    behaviors: tuple[BehaviorRef, ...]
    states: tuple[StateRef, ...]
    behavior: Rows = field(repr=False)
    state: Rows = field(repr=False)
    flags: NDArray[np.bool_] = field(repr=False)
    flag_names: tuple[str, ...]
    rows: Mapping[str, int] = field(repr=False)
    controllers: int

    def __post_init__(self) -> None:
        for array in (self.behavior, self.state, self.flags):
            array.flags.writeable = False

    def row(self, node_id: str) -> int:
        """The row of a node; KeyError if there is none."""
        return self.rows[node_id]

    @cached_property
    def shown(self) -> Rows:
        """For each node the behavior that colors it, -1 if it idles.

        That is what the current state of its outermost automaton holds if it is an automaton, otherwise the outermost
        behavior itself.
        """
        outer = self.behavior[:, 0]
        if self.behavior.shape[1] == 1:
            return outer
        held = self.behavior[:, 1]
        automaton = np.array([ref.id != "" for ref in self.behaviors] + [False])  # the last for -1
        shown: Rows = np.where(automaton[held], held, outer)
        shown.flags.writeable = False
        return shown

    def counts(self) -> Mapping[BehaviorRef, int]:
        """How many agents show each behavior; those that idle are left out."""
        agents = self.shown[self.controllers :]
        found = np.bincount(agents[agents >= 0], minlength=len(self.behaviors)).tolist()
        return {ref: count for ref, count in zip(self.behaviors, found, strict=True) if count}

    def in_states(self, type_name: str, automaton: str) -> Mapping[str, int]:
        """How many nodes are in each state of an automaton, at any depth; states with nobody in them are left out."""
        return {
            ref.state: count
            for ref, count in zip(self.states, self._in_states, strict=True)
            if count and ref.automaton == automaton and ref.type == type_name
        }

    @cached_property
    def _in_states(self) -> list[int]:
        counts: list[int] = np.bincount(self.state[self.state >= 0], minlength=len(self.states)).tolist()
        return counts


class Roster:
    """Gives behaviors, states and flags of plain actors their numbers, the same ones for as long as it lives."""

    def __init__(self) -> None:
        self._behaviors: dict[tuple[str, str, str], int] = {}
        self._states: dict[tuple[str, str, str], int] = {}
        self._flags: dict[str, int] = {}
        self._refs: tuple[tuple[BehaviorRef, ...], tuple[StateRef, ...], tuple[str, ...]] = ((), (), ())
        self._actors: Mapping[str, Actor] | None = None
        self._rows: Mapping[str, int] = {}
        self._controllers = 0

    def doing(self, actors: Mapping[str, Actor]) -> Doing:
        """What these nodes do."""
        # Of all runs, *found* being places in *table*: most nodes do what others do as well, and need no other one.
        rows, levels, found = list[int](), list[int](), list[int]()
        places: dict[tuple[str, int, str], int] = {}
        table: list[tuple[int, int]] = []
        up: list[tuple[int, int]] = []  # row, flag
        for row, actor in enumerate(actors.values()):
            level, run, kind = 0, actor.run, actor.node.type
            while run is not None:
                alike = kind, id(run.behavior), run.state
                place = places.get(alike)
                if place is None:
                    place = places[alike] = len(table)
                    table.append(self._numbers(kind, run))
                rows.append(row)
                levels.append(level)
                found.append(place)
                level, run = level + 1, run.child
            if actor.flags or (actor.run is not None and actor.run.flags):
                up += [(row, self._flags.setdefault(flag, len(self._flags))) for flag in _shown(actor)]
        shape = len(actors), 1 + max(levels, default=0)
        behavior, state = np.full(shape, NONE, np.int32), np.full(shape, NONE, np.int32)
        numbers = np.array(table, np.int32).reshape(-1, 2)[found]
        where = np.array(rows, np.int64), np.array(levels, np.int64)
        behavior[where], state[where] = numbers.T
        behaviors, states, names = self._named()
        return Doing(
            behaviors, states, behavior, state, self._raised(up, len(actors)), names, *self._counted(actors)
        )

    def _raised(self, up: Sequence[tuple[int, int]], nodes: int) -> NDArray[np.bool_]:
        flags = np.zeros((nodes, len(self._flags)), np.bool_)
        raised = np.array(up, np.int64).reshape(-1, 2)
        flags[raised[:, 0], raised[:, 1]] = True
        return flags

    def _counted(self, actors: Mapping[str, Actor]) -> tuple[Mapping[str, int], int]:
        """The row of each node, and how many are controllers: the same as long as these are the same nodes."""
        if actors is not self._actors:
            self._actors = actors
            self._rows = {node_id: row for row, node_id in enumerate(actors)}
            self._controllers = sum(not actor.is_agent for actor in actors.values())
        return self._rows, self._controllers

    def _numbers(self, kind: str, run: Run) -> tuple[int, int]:
        behavior = run.behavior
        if isinstance(behavior, Automaton):
            what, where = (kind, behavior.id, behavior.name), (kind, behavior.id, run.state)
            return _number(self._behaviors, what), _number(self._states, where)
        return _number(self._behaviors, (kind, "", behavior.name)), NONE

    def _named(self) -> tuple[tuple[BehaviorRef, ...], tuple[StateRef, ...], tuple[str, ...]]:
        """What the numbers mean; the same tuples until something new comes up."""
        if tuple(map(len, self._refs)) != (len(self._behaviors), len(self._states), len(self._flags)):
            behaviors = tuple(BehaviorRef(*key) for key in self._behaviors)
            self._refs = behaviors, tuple(StateRef(*key) for key in self._states), tuple(self._flags)
        return self._refs


def _number(table: dict[tuple[str, str, str], int], key: tuple[str, str, str]) -> int:
    return table.setdefault(key, len(table))


def _shown(actor: Actor) -> Iterable[str]:
    return actor.flags | actor.run.flags if actor.run else actor.flags
