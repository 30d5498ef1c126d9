"""What the nodes do as flat columns, and the way to and from `app.core.actor.Actor`."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from ...core.actor import Actor, Argument, Arguments, Run
from ...core.automaton import START, Automaton
from ...core.errors import ProgramError
from ...core.machine import Machine
from ...core.machine_state import MachineState, freeze_actors
from ...core.vocabulary import BasicBehavior
from ..program.tables import KEY_HEAD, LEARNED, NO_KEY, NO_LEAF, Column, Program, Sizes
from .calls import MACHINE_KEY
from .records import laid_out, records

#: Column name -> float64 ("f") or int64 ("i"), in the order in which a kernel takes them.
RUN_COLUMNS: Mapping[str, str] = {
    # nodes
    "depth": "i",  # runs in the chain; 0 idles
    "node_flags": "i",  # flags of the agent itself
    "left": "i",
    "direction": "i",  # basic behavior last directed, or -1
    "direction_argument": "i",  # its targets
    "direction_owner": "i",  # and who bound them
    # runs
    "what": "i",  # automaton, or -1 - basic behavior
    "state": "i",
    "entered": "i",
    "flags": "i",
    "pulsed": "i",
    "leaf": "i",  # the leaf that decided last, alone; or -1
    "keys": "i",  # what decided last otherwise
    "argument": "i",
    "owner": "i",
    # agents
    "act": "i",  # behavior to be performed in this tick, or -1
    "act_on": "i",  # its entities
    # once
    "once": "i",
    # what was found in this tick
    "use_stamp": "i",
    "use_value": "f",
    "target_stamp": "i",
    "target_owner": "i",
    "target_entity": "i",
    # room to work in
    "sense_on": "i",
    "entry": "i",
    "entry_share": "f",
    "kept": "f",
    "total": "f",
    "tree_leaf": "i",
    "state_total": "f",
    "stack": "i",
}
RUN_RECORDS = records(
    RUN_COLUMNS,
    (
        ("depth", "node_flags", "left", "direction"),
        ("direction_argument", "direction_owner"),
        ("what", "state", "entered", "flags", "pulsed", "leaf"),
        ("argument", "owner"),
        ("use_stamp", "use_value"),
        ("target_stamp", "target_owner", "target_entity"),
        ("entry", "entry_share"),
    ),
)


def new_runs(sizes: Sizes) -> dict[str, Column]:
    """Columns for a program in which every node idles."""
    lengths = _lengths(sizes)
    columns = laid_out(lengths, RUN_COLUMNS, RUN_RECORDS)
    columns["direction"][:] = -1
    columns["act"][:] = -1
    return columns


def _lengths(sizes: Sizes) -> Mapping[str, int]:
    rows, agents = sizes.nodes * sizes.levels, sizes.nodes - sizes.controllers
    per_node = dict.fromkeys(("depth", "node_flags", "left", "direction", "stack"), sizes.nodes)
    per_run = dict.fromkeys(("what", "state", "entered", "flags", "pulsed", "leaf"), rows)
    return {
        **per_node,
        **per_run,
        **dict.fromkeys(("direction_argument", "direction_owner"), sizes.nodes * sizes.arguments),
        "keys": rows * sizes.key_words,
        **dict.fromkeys(("argument", "owner"), rows * sizes.arguments),
        "act": agents,
        "act_on": agents * sizes.slots,
        "once": 4,
        **dict.fromkeys(("use_stamp", "use_value"), sizes.uses),
        **dict.fromkeys(("target_stamp", "target_owner", "target_entity"), sizes.targets),
        "sense_on": sizes.slots,
        **dict.fromkeys(("entry", "entry_share", "kept", "total"), sizes.entries),
        "tree_leaf": sizes.key_words,
        "state_total": sizes.states,
    }


# --------------------------------------------------------------------------------------- from the machine


def runs_of(machine: Machine, program: Program) -> dict[str, Column]:
    """What the nodes of *machine* do, as columns.

    Raises:
        ProgramError: A node does something that the program does not know.
    """
    columns = new_runs(program.sizes)
    writer, actors = _Writer(program, columns), list(machine.actors.values())
    writer.nodes(actors)
    level, links = 0, [(node, actor.node.type, actor.run) for node, actor in enumerate(actors)]
    while running := [(node, kind, run) for node, kind, run in links if run is not None]:
        writer.runs(level, running)
        level, links = level + 1, [(node, kind, run.child) for node, kind, run in running]
    columns["once"][MACHINE_KEY] = machine.key
    return columns


class _Writer:
    """Writes whole columns: there may be ten thousand nodes, and most of them do what others do as well."""

    def __init__(self, program: Program, columns: Mapping[str, Column]) -> None:
        self._program = program
        self._sizes = program.sizes
        self._columns = columns
        self._nodes = {node_id: k for k, node_id in enumerate(program.nodes)}
        self._targets = {name: k for k, name in enumerate(program.targets)}
        self._flags = {name: 1 << k for k, name in enumerate(program.flags)}

    def nodes(self, actors: Sequence[Actor]) -> None:
        """Write what nodes show and direct."""
        columns, count = self._columns, len(actors)
        columns["node_flags"][:count] = [self._mask(actor.flags) if actor.flags else 0 for actor in actors]
        columns["left"][:count] = [actor.left for actor in actors]
        for node, actor in enumerate(actors):
            if actor.direction is not None:
                name, arguments = actor.direction
                row = self._program.basic_rows[actor.node.type, name]
                columns["direction"][node] = row
                parameters = self._program.basics[row][1].parameters
                self._arguments("direction_", node, parameters, arguments)

    def runs(self, level: int, running: Sequence[tuple[int, str, Run]]) -> None:
        """Write the runs at a level of nodes, given with their types; each of them has one at every level above."""
        columns, words = self._columns, self._sizes.key_words
        nodes = np.array([node for node, _, _ in running])
        rows = nodes * self._sizes.levels + level
        columns["depth"][nodes] = level + 1
        columns["entered"][rows] = [run.entered for _, _, run in running]
        columns["pulsed"][rows] = [run.pulsed for _, _, run in running]
        columns["flags"][rows] = [self._mask(run.flags) if run.flags else 0 for _, _, run in running]
        described = self._described([(kind, run) for _, kind, run in running])
        columns["what"][rows], columns["state"][rows], columns["leaf"][rows] = described[:, :_WORDS].T
        columns["keys"][rows[:, None] * words + np.arange(words)] = described[:, _WORDS:]
        for row, (_, _, run) in zip(rows.tolist(), running, strict=True):
            if run.arguments or run.behavior.parameters:
                self._arguments("", row, run.behavior.parameters, run.arguments)

    def _described(self, runs: Iterable[tuple[str, Run]]) -> Column:
        """For each run a row: what it runs, the state, the leaf, and the words of what decided."""
        places: dict[tuple[str, int, str, object], int] = {}  # of those that are alike
        table: list[list[int]] = []
        found: list[int] = []
        for kind, run in runs:
            alike = kind, id(run.behavior), run.state, run.key
            place = places.get(alike)
            if place is None:
                place = places[alike] = len(table)
                table.append(self._description(kind, run))
            found.append(place)
        return np.array(table, np.int64)[found]

    def _description(self, kind: str, run: Run) -> list[int]:
        program, state = self._program, 0
        if isinstance(run.behavior, Automaton):
            what = program.automaton_rows[kind, run.behavior.id]
            state = program.automata[what].states[run.state]
        else:
            what = -1 - program.basic_rows[kind, run.behavior.name]
        words = program.key_words(state, run.key) if state else [NO_KEY]
        alone = bool(state) and program.states[state].plain and words[0] == LEARNED
        leaf = words[KEY_HEAD] if alone else NO_LEAF
        return [what, state, leaf, *words, *(0 for _ in range(self._sizes.key_words - len(words)))]

    def _arguments(self, kind: str, row: int, parameters: Iterable[str], arguments: Arguments) -> None:
        at = row * self._sizes.arguments
        if arguments.keys() != set(parameters):
            raise ProgramError("a node runs a behavior with other arguments than it has parameters")
        for k, parameter in enumerate(parameters):
            given = arguments[parameter]
            if given.target not in self._targets:
                raise ProgramError(
                    f"a node runs a behavior for a target {given.target!r} that does not exist"
                )
            self._columns[kind + "argument"][at + k] = self._targets[given.target]
            self._columns[kind + "owner"][at + k] = self._nodes[given.owner]

    def _mask(self, flags: Iterable[str]) -> int:
        return sum(self._flags[flag] for flag in flags)


#: Of what describes a run, those before the words of what decided: what it runs, the state, the leaf.
_WORDS = 3
#: What is kept between ticks.
_SAVED = (
    "depth",
    "node_flags",
    "left",
    "direction",
    "direction_argument",
    "direction_owner",
    "what",
    "state",
    "entered",
    "flags",
    "pulsed",
    "leaf",
    "keys",
    "argument",
    "owner",
)


# ----------------------------------------------------------------------------------------- to the machine


def put_back(columns: Mapping[str, Column], program: Program, machine: Machine, now: int) -> None:
    """Let the nodes of *machine* do what the columns say."""
    reader = _Reader({name: columns[name].tolist() for name in _SAVED}, program)
    machine.now = now
    for node, actor in enumerate(machine.actors.values()):
        reader.node(node, actor)


def put_back_some(
    columns: Mapping[str, Column], program: Program, machine: Machine, now: int, rows: Mapping[str, int]
) -> None:
    """Let some nodes, given by id with their rows, do what the columns say; the others are left as they are."""
    reader = _Reader({name: columns[name].data for name in _SAVED}, program)
    machine.now = now
    for node_id, row in rows.items():
        reader.node(row, machine.actors[node_id])


class FrozenRuns(Mapping[str, Any]):
    """What the columns say that all nodes do, as `freeze` says it: copied at once, put into words when it is first looked at."""

    def __init__(
        self, columns: Mapping[str, Column], program: Program, actors: Mapping[str, Actor], now: int
    ) -> None:
        self._columns = {name: columns[name].copy() for name in _SAVED}
        self._program = program
        self._actors = actors  # who there is, whatever they do by then
        self._now = now

    def __getitem__(self, name: str) -> Any:
        return self._state[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._state)

    def __len__(self) -> int:
        return len(self._state)

    @cached_property
    def _state(self) -> MachineState:
        reader = _Reader({name: column.tolist() for name, column in self._columns.items()}, self._program)
        actors = {
            node_id: Actor(actor.node, actor.number, actor.members, actor.parent)
            for node_id, actor in self._actors.items()
        }
        for node, actor in enumerate(actors.values()):
            reader.node(node, actor)
        self._columns.clear()
        return freeze_actors(self._now, actors)


class _Reader:
    def __init__(self, columns: Mapping[str, Sequence[int]], program: Program) -> None:
        """Read from lists, or where few entries are looked at, from views of the columns: both give plain numbers."""
        self._program = program
        self._sizes = program.sizes
        self._columns = columns
        # By state and words: most nodes are where others are as well.
        self._keys: dict[tuple[int, ...], object] = {}

    def node(self, node: int, actor: Actor) -> None:
        columns = self._columns
        actor.flags = self._flags(columns["node_flags"][node])
        actor.left = bool(columns["left"][node])
        actor.direction = None
        if (row := columns["direction"][node]) >= 0:
            basic = self._program.basics[row][1]
            actor.direction = (basic.name, self._arguments("direction_", node, basic.parameters))
        actor.run = self._chain(node)

    def _chain(self, node: int) -> Run | None:
        first = node * self._sizes.levels
        chain: Run | None = None
        for row in reversed(range(first, first + self._columns["depth"][node])):
            run = self._run(row)
            run.child = chain
            chain = run
        return chain

    def _run(self, row: int) -> Run:
        columns, what, state = self._columns, self._columns["what"][row], self._columns["state"][row]
        behavior: Automaton | BasicBehavior
        if what >= 0:
            behavior = self._program.automata[what].automaton
            key = self._key(row, state)
        else:
            behavior, key = self._program.basics[-1 - what][1], None
        return Run(
            behavior,
            self._arguments("", row, behavior.parameters),
            self._flags(columns["flags"][row]),
            self._program.states[state].id if what >= 0 else START,
            columns["entered"][row],
            None,
            key,
            bool(columns["pulsed"][row]),
        )

    def _key(self, row: int, state: int) -> object:
        at, leaf = row * self._sizes.key_words, self._columns["leaf"][row]
        words: tuple[int, ...] = (LEARNED, 0, leaf)
        if leaf == NO_LEAF:
            words = tuple(self._columns["keys"][at : at + self._sizes.key_words])
        alike = (state, *words)
        if alike not in self._keys:
            self._keys[alike] = self._program.key(state, words)
        return self._keys[alike]

    def _arguments(self, kind: str, row: int, parameters: Sequence[str]) -> Arguments:
        if not parameters:
            return {}
        at = row * self._sizes.arguments
        return {
            parameter: Argument(
                self._program.targets[self._columns[kind + "argument"][at + k]],
                self._program.nodes[self._columns[kind + "owner"][at + k]],
            )
            for k, parameter in enumerate(parameters)
        }

    def _flags(self, mask: int) -> set[str]:
        return {name for k, name in enumerate(self._program.flags) if mask >> k & 1} if mask else set()
