# mypy: disable-error-code="no-any-return"
# Columns are of numbers, as the program has declared them; mypy takes them for anything.
"""The transition function of a state: which state comes next."""

from ...core.chance import FIRST_CONTROLLER, draw
from ..program.tables import ARGMAX, DECIDE, END, FORBID, HOLD, KEY_HEAD, LEAF, LEARNED, TAKE, TEST
from .calls import MACHINE_KEY, Runs, Tables, World
from .features import value_of


def next_state(
    world: World, tab: Tables, runs: Runs, node: int, row: int, level: int, now: int, stamp: int
) -> int:
    """Evaluate the transition function of the state that a run is in, and draw.

    Nearly all states decide by a single tree: what is more is left to `weighed`.
    """
    state = runs.state[row]
    at = tab.code[state]
    while tab.operation[at] == TEST:
        at = branch(world, tab, runs, node, row, at, now, stamp)
    if tab.operation[at] == DECIDE:
        runs.leaf[row] = tab.goal[at]
        if tab.no[at] >= 0:
            return tab.no[at]
        return drawn_at_leaf(tab, runs, node, state, tab.goal[at], level, now)
    return weighed(world, tab, runs, node, row, at, level, now, stamp)


def branch(world: World, tab: Tables, runs: Runs, node: int, row: int, at: int, now: int, stamp: int) -> int:
    """Where a test leads."""
    value = value_of(world, tab, runs, node, row, tab.use[at], tab.goal[at], now, stamp)
    return tab.yes[at] if tab.low[at] <= value <= tab.high[at] else tab.no[at]


def drawer(tab: Tables, node: int) -> int:
    """The number that a node draws with."""
    return node - tab.controllers if node >= tab.controllers else FIRST_CONTROLLER + node


def drawn_at_leaf(tab: Tables, runs: Runs, node: int, state: int, leaf: int, level: int, now: int) -> int:
    """The next state that chance decides on at a leaf."""
    u = draw(runs.once[MACHINE_KEY], now, drawer(tab, node), level)
    at = tab.shares_at[leaf]
    last = tab.labels[state] - 1
    k = 0
    while k < last and u >= tab.running[at + k]:
        k += 1
    while k > 0 and tab.share[at + k] == 0.0:
        k -= 1  # rounding has left a bit at the end: the last possible label takes it
    return tab.label[tab.labels_at[state] + k]


def weighed(  # noqa: PLR0917 - as many numbers as there are: compiled code takes scalars
    world: World,
    tab: Tables,
    runs: Runs,
    node: int,
    row: int,
    first: int,
    level: int,
    now: int,
    stamp: int,
) -> int:
    """The next state by rules, trees and prunes, whose code goes on at *first*."""
    state = runs.state[row]
    entries = 0
    left = 1.0
    met = 0
    forbidden = 0
    trees = 0
    leaf = -1
    at = first
    operation = tab.operation[at]
    while operation != END:
        if operation == TEST:
            at = branch(world, tab, runs, node, row, at, now, stamp)
        elif operation == TAKE:
            probability = tab.low[at]
            runs.entry[entries] = tab.goal[at]
            runs.entry_share[entries] = left * probability
            entries += 1
            met |= tab.mask[at]
            left = left * (1.0 - probability)
            at = tab.yes[at] if left > 0.0 else 0
        elif operation == LEAF:
            leaf = tab.goal[at]
            at = tab.yes[at]
        elif operation == FORBID:
            forbidden |= tab.mask[at]
            at = tab.yes[at]
        else:
            add_tree(tab, runs, state, tab.goal[at], trees)
            trees += 1
            at = tab.yes[at]
        operation = tab.operation[at]
    if leaf >= 0 or trees > 0:
        met |= LEARNED
    who = drawer(tab, node)
    return decided(tab, runs, row, state, leaf, trees, met, forbidden, entries, left, who, level, now)


def decided(  # noqa: PLR0917 - as many numbers as there are: compiled code takes scalars
    tab: Tables,
    runs: Runs,
    row: int,
    state: int,
    leaf: int,
    trees: int,
    met: int,
    forbidden: int,
    entries: int,
    left: float,
    drawer: int,
    level: int,
    now: int,
) -> int:
    """The next state, after the rules have taken their share and the learned model has ended in its leaves."""
    changed = changed_word(runs, row * tab.key_words, met)
    if met & LEARNED:
        possible = weigh_labels(tab, runs, state, leaf, trees, forbidden, entries, left)
        entries += tab.labels[state]
        if possible != 0:
            left = 0.0
        if tab.prunable[state] != 0:
            changed += changed_word(runs, row * tab.key_words + 1, possible)
        if leaf >= 0:
            changed += changed_word(runs, row * tab.key_words + KEY_HEAD, leaf)
        for tree in range(trees):
            changed += changed_word(runs, row * tab.key_words + KEY_HEAD + tree, runs.tree_leaf[tree])
    if tab.sampling[state] == HOLD and changed == 0:
        return state
    return chosen(tab, runs, state, entries, left, drawer, level, now)


def changed_word(runs: Runs, at: int, word: int) -> int:
    """Write a word of what decided; 1 if another stood there."""
    if runs.keys[at] == word:
        return 0
    runs.keys[at] = word
    return 1


def add_tree(tab: Tables, runs: Runs, state: int, leaf: int, tree: int) -> None:
    """Add the probabilities at a leaf to those of the trees before."""
    runs.tree_leaf[tree] = leaf
    at = tab.shares_at[leaf]
    for k in range(tab.labels[state]):
        before = runs.total[k] if tree > 0 else 0.0
        runs.total[k] = before + tab.share[at + k]


def weigh_labels(
    tab: Tables, runs: Runs, state: int, leaf: int, trees: int, forbidden: int, entries: int, left: float
) -> int:
    """Append the labels with what the rules left of their probabilities; returns those possible, as bits."""
    total = 0.0
    for k in range(tab.labels[state]):
        share = runs.total[k] / trees if leaf < 0 else tab.share[tab.shares_at[leaf] + k]
        if forbidden >> k & 1:
            share = 0.0
        runs.kept[k] = share
        total += share
    possible = 0
    for k in range(tab.labels[state]):
        share = runs.kept[k]
        if forbidden != 0 and total > 0.0:
            share = share / total
        if share > 0.0:
            possible |= 1 << k
        runs.entry[entries + k] = tab.label[tab.labels_at[state] + k]
        runs.entry_share[entries + k] = left * share
    return possible


def chosen(
    tab: Tables, runs: Runs, state: int, entries: int, left: float, drawer: int, level: int, now: int
) -> int:
    """The next state out of the weighed entries and, with what they leave, the current one."""
    if entries == 0:
        return state
    runs.entry[entries] = state
    runs.entry_share[entries] = left
    if tab.sampling[state] == ARGMAX:
        return most_probable(runs, entries + 1)
    if runs.entry_share[0] >= 1.0:
        return runs.entry[0]
    u = draw(runs.once[MACHINE_KEY], now, drawer, level)
    total = 0.0
    last = state
    for k in range(entries + 1):
        share = runs.entry_share[k]
        total += share
        if u < total:
            return runs.entry[k]
        if share > 0.0:
            last = runs.entry[k]
    return last


def most_probable(runs: Runs, entries: int) -> int:
    """The state whose entries add up to most, the first of equals."""
    for k in range(entries):
        runs.state_total[runs.entry[k]] = 0.0
    for k in range(entries):
        runs.state_total[runs.entry[k]] += runs.entry_share[k]
    best = runs.entry[0]
    for k in range(1, entries):
        if runs.state_total[runs.entry[k]] > runs.state_total[best]:
            best = runs.entry[k]
    return best
