# mypy: disable-error-code="no-any-return"
# Columns are of numbers, as the program has declared them; mypy takes them for anything.
"""Changing state: a run stops what it holds and starts something else, a controller directs its subsidiaries."""

from ..program.tables import BASIC, NESTED, NO_KEY, NO_LEAF
from .calls import Runs, Tables


def enter(tab: Tables, runs: Runs, node: int, level: int, new: int, now: int) -> None:
    """Stop what runs below *level* and start what state *new* holds."""
    row = node * tab.levels + level
    if directs(tab, runs, node):
        runs.left[node] = 1
    runs.state[row] = new
    runs.entered[row] = now
    runs.leaf[row] = NO_LEAF
    runs.keys[row * tab.key_words] = NO_KEY
    runs.depth[node] = level + 1
    content = tab.content[new]
    if content in (BASIC, NESTED):
        held = tab.held[new]
        for k in range(tab.bound[new]):
            binding = tab.binding[tab.bound_at[new] + k]
            into = (row + 1) * tab.arguments + k
            if binding >= 0:
                runs.argument[into] = binding
                runs.owner[into] = node
            else:
                runs.argument[into] = runs.argument[row * tab.arguments - 1 - binding]
                runs.owner[into] = runs.owner[row * tab.arguments - 1 - binding]
        begin(tab, runs, row + 1, held if content == NESTED else -1 - held, now)
        runs.depth[node] = level + 2
        if content == BASIC and tab.derived[held] != 0:
            direct_all(tab, runs, node, row + 1, held, now)


def begin(tab: Tables, runs: Runs, row: int, what: int, now: int) -> None:
    """A fresh run: an automaton in Start, or a basic behavior that has had no pulse; its arguments are there already."""
    runs.what[row] = what
    runs.state[row] = tab.start[what] if what >= 0 else 0
    runs.entered[row] = now
    runs.flags[row] = 0
    runs.pulsed[row] = 0
    runs.leaf[row] = NO_LEAF
    runs.keys[row * tab.key_words] = NO_KEY


def back_to_start(tab: Tables, runs: Runs, node: int, level: int, flag: int, now: int) -> None:
    """Raise a flag on an automaton, which is in Start then."""
    row = node * tab.levels + level
    runs.flags[row] |= flag
    runs.state[row] = tab.start[runs.what[row]]
    runs.entered[row] = now
    runs.leaf[row] = NO_LEAF
    runs.keys[row * tab.key_words] = NO_KEY
    runs.depth[node] = level + 1


def directs(tab: Tables, runs: Runs, node: int) -> bool:
    """Whether a node is in a state in which a controller directs its subsidiaries."""
    what = runs.what[node * tab.levels + runs.depth[node] - 1]
    return what < 0 and tab.derived[-1 - what] != 0


def direct_all(tab: Tables, runs: Runs, node: int, row: int, basic: int, now: int) -> None:
    """Let all subsidiaries start what *node* directs, and theirs, as far as they only pass it on."""
    note_direction(tab, runs, node, row, basic)
    runs.stack[0] = node
    waiting = 1
    while waiting > 0:
        waiting -= 1
        parent = runs.stack[waiting]
        directed = runs.direction[parent]
        for place in range(tab.children_at[parent], tab.children_end[parent]):
            child = tab.child[place]
            what = tab.directs[directed * tab.types + tab.type[child]]
            direct(tab, runs, child, parent, directed, what, now)
            if what < 0 and tab.derived[-1 - what] != 0:
                note_direction(tab, runs, child, child * tab.levels, -1 - what)
                runs.stack[waiting] = child
                waiting += 1


def note_direction(tab: Tables, runs: Runs, node: int, row: int, basic: int) -> None:
    """Remember what a controller directs, for those that join."""
    runs.direction[node] = basic
    for k in range(tab.arity[basic]):
        runs.direction_argument[node * tab.arguments + k] = runs.argument[row * tab.arguments + k]
        runs.direction_owner[node * tab.arguments + k] = runs.owner[row * tab.arguments + k]


def direct(tab: Tables, runs: Runs, child: int, parent: int, directed: int, what: int, now: int) -> None:
    """Start a behavior on a node: its flags fall, an automaton begins in Start."""
    row = child * tab.levels
    runs.node_flags[child] = 0
    if runs.depth[child] > 0 and directs(tab, runs, child):
        runs.left[child] = 1
    begin(tab, runs, row, what, now)
    runs.depth[child] = 1
    for k in range(tab.arity[directed]):
        runs.argument[row * tab.arguments + k] = runs.direction_argument[parent * tab.arguments + k]
        runs.owner[row * tab.arguments + k] = runs.direction_owner[parent * tab.arguments + k]


def lower_directed(tab: Tables, runs: Runs, node: int) -> None:
    """The flags of what the subsidiaries were directed to do fall, since their controller changed state."""
    for place in range(tab.children_at[node], tab.children_end[node]):
        runs.flags[tab.child[place] * tab.levels] = 0
    runs.left[node] = 0
