"""What the nodes do, read from the columns that a kernel steps: all of them as arrays, or a few in plain Python."""

from collections.abc import Mapping

import numpy as np

from ..doing import NONE, BehaviorRef, Doing, StateRef
from ..program.tables import Column, Program


class Viewer:
    """Reads the columns of one program; what its rows mean is worked out once."""

    def __init__(self, program: Program) -> None:
        self._sizes = program.sizes
        automata = [BehaviorRef(row.type, row.automaton.id, row.automaton.name) for row in program.automata]
        basics = [BehaviorRef(kind, "", basic.name) for kind, basic in program.basics]
        self._behaviors = (*automata, *basics)
        self._automata = len(automata)
        rows = ((program.automata[state.automaton], state.id) for state in program.states[1:])
        self._states = tuple(StateRef(row.type, row.automaton.id, state) for row, state in rows)
        self._flags = program.flags
        self._rows = {node_id: row for row, node_id in enumerate(program.nodes)}

    def row(self, node_id: str) -> int:
        """The row of a node; KeyError if there is none."""
        return self._rows[node_id]

    def doing(self, runs: Mapping[str, Column]) -> Doing:
        """What all nodes do."""
        nodes, levels = self._sizes.nodes, self._sizes.levels
        depth = runs["depth"][:nodes]
        used = max(1, int(depth.max()))
        what, state, flags = (
            runs[name][: nodes * levels].reshape(nodes, levels) for name in ("what", "state", "flags")
        )
        what, state = what[:, :used].astype(np.int32), state[:, :used].astype(np.int32)
        runs_there = np.arange(used, dtype=np.int32) < depth[:, None]
        is_automaton = runs_there & (what >= 0)
        behavior = np.where(what >= 0, what, self._automata - 1 - what)  # basic behavior b is -1 - b
        behavior[~runs_there] = NONE
        state -= 1  # the first row of a program's states is that of nowhere
        state[~is_automaton] = NONE
        up = runs["node_flags"][:nodes] | np.where(depth > 0, flags[:, 0], 0)
        shown = (up[:, None] >> np.arange(len(self._flags))) & 1 == 1
        return Doing(
            self._behaviors,
            self._states,
            behavior,
            state,
            shown,
            self._flags,
            self._rows,
            self._sizes.controllers,
        )
