"""One tick of every node over flat columns: what the kernel compiles. Plain Python may run it too, for tests.

It does what `app.core.machine` says, in the same order, so that both give the same numbers to the bit. What the
scenario senses and does is reached through seven functions that are put in place when the kernel is made (see
`app.sim.kernel.build`).

Columns of *tab* are a program's (`app.sim.program.tables`), those of *runs* what the nodes do (`app.sim.kernel.state`). A
node's chain of runs, outermost first, fills the rows from ``node * tab.levels`` on; ``runs.depth`` says how many.
"""

from typing import Any

from ...core.chance import FIRST_CONTROLLER, draw
from ..program.tables import (
    ALL,
    ANY,
    ARGMAX,
    BASIC,
    COUNT,
    DECIDE,
    END,
    FINISHED_BIT,
    FLAG,
    FLAG_UP,
    FORBID,
    GROUP,
    HOLD,
    KEY_HEAD,
    LEAF,
    LEARNED,
    MAX,
    MEAN,
    MIN,
    NESTED,
    NO_KEY,
    NO_LEAF,
    SENSE,
    STATISTIC_OF_SENSE,
    TAKE,
    TEST,
    TICKS_IN_STATE,
)

# Named tuples whose types depend on the scenario.
World = Any
Tables = Any
Runs = Any

TICK, KEY = 2, 3
# Places in `runs.once`: the number of the node's tick, counted up; the machine's key for chance; whether a function of the
# scenario answered with what it cannot mean; how many entities there are.
STAMP, MACHINE_KEY, FAULT, ENTITIES = range(4)
#: Which part of a tick passes: all of it, or what comes before or after something else has moved the world.
WHOLE, BEFORE_MOVING, AFTER_MOVING = range(3)


def sense(world: World, feature: int, me: int, targets: Any, once: Any) -> float:
    """An agent's feature; the first of *targets* are its entities. A value that cannot be sets *once*'s fault."""
    raise NotImplementedError


def sense_group(world: World, feature: int, first: int, end: int, once: Any) -> float:
    """A controller's own feature."""
    raise NotImplementedError


def find(world: World, target: int, first: int, end: int, me: int, once: Any) -> int:
    """The entity that a target means."""
    raise NotImplementedError


def behave(world: World, behavior: int, me: int, targets: Any, at: int) -> None:
    """Perform a basic behavior; its entities are in *targets* from *at* on."""
    raise NotImplementedError


def resolve(world: World) -> None:
    """Settle what agents want of each other."""
    raise NotImplementedError


def kinematics(world: World) -> None:
    """Move everything."""
    raise NotImplementedError


def after_tick(world: World) -> None:
    """Follow the rules at the end of a tick."""
    raise NotImplementedError


def run(world: World, tab: Tables, runs: Runs, ticks: int, part: int) -> None:
    """Pass ticks, or the part before or after moving of them; stop in the first in which something is wrong."""
    for _ in range(ticks):
        if part != AFTER_MOVING:
            for node in range(tab.nodes):
                decide(world, tab, runs, node)
            if runs.once[FAULT] != 0:
                return
            act(world, tab, runs)
            resolve(world)
        if part == WHOLE:
            kinematics(world)
        if part != BEFORE_MOVING:
            after_tick(world)
            world.clock[TICK] += 1


def act(world: World, tab: Tables, runs: Runs) -> None:
    """Let the agents do what they decided."""
    for agent in range(world.agents):
        world.drive[agent] = 0.0
        world.turn[agent] = 0.0
        behavior = runs.act[agent]
        if behavior >= 0:
            runs.act[agent] = -1
            behave(world, behavior, agent, runs.act_on, agent * tab.slots_most)


# --------------------------------------------------------------------------------------------- one node


def decide(world: World, tab: Tables, runs: Runs, node: int) -> None:
    """A node's tick: change state from the outermost automaton inward, then pulse what is innermost."""
    if runs.depth[node] > 0:
        now = world.clock[TICK]
        base = node * tab.levels
        stamp = runs.once[STAMP] + 1
        runs.once[STAMP] = stamp
        if tab.parent[node] < 0:
            runs.node_flags[node] = 0
            runs.flags[base] = 0
        level = 0
        innermost = runs.depth[node] - 1
        while runs.what[base + level] >= 0:
            new = next_state(world, tab, runs, node, base + level, level, now, stamp)
            if new != runs.state[base + level]:
                enter(tab, runs, node, level, new, now)
                innermost = runs.depth[node] - 1
            if level == innermost:
                break
            level += 1
        perform(world, tab, runs, node, level, now, stamp)
        if runs.left[node] != 0:
            lower_directed(tab, runs, node)


def perform(world: World, tab: Tables, runs: Runs, node: int, level: int, now: int, stamp: int) -> None:
    """Pulse the basic behavior at the end of the chain, and raise the flag that it or the state there raises."""
    row = node * tab.levels + level
    if runs.what[row] < 0:
        basic = -1 - runs.what[row]
        pulse(world, tab, runs, node, row, basic, stamp)
        if level > 0 and tab.raises[basic] != 0:
            back_to_start(tab, runs, node, level - 1, tab.raises[basic], now)
    else:
        state = runs.state[row]
        if tab.content[state] == FLAG:
            back_to_start(tab, runs, node, level, tab.held[state], now)


def back_to_start(tab: Tables, runs: Runs, node: int, level: int, flag: int, now: int) -> None:
    """Raise a flag on an automaton, which is in Start then."""
    row = node * tab.levels + level
    runs.flags[row] |= flag
    runs.state[row] = tab.start[runs.what[row]]
    runs.entered[row] = now
    runs.leaf[row] = NO_LEAF
    runs.keys[row * tab.key_words] = NO_KEY
    runs.depth[node] = level + 1


def pulse(world: World, tab: Tables, runs: Runs, node: int, row: int, basic: int, stamp: int) -> None:
    """Note down what the agent is to do, unless it has done it, or a target has no referent; raise its own flags."""
    if tab.derived[basic] == 0 and (runs.pulsed[row] == 0 or tab.once[basic] == 0):
        runs.pulsed[row] = 1
        if tab.finishes[basic] != 0:
            runs.node_flags[node] |= FINISHED_BIT
        runs.flags[row] |= tab.raises[basic]
        agent = node - tab.controllers
        if tab.arity[basic] == 0 or aimed(world, tab, runs, row, basic, agent, stamp):
            runs.act[agent] = tab.behavior[basic]


def aimed(world: World, tab: Tables, runs: Runs, row: int, basic: int, agent: int, stamp: int) -> bool:
    """Look for the entities of a basic behavior; False where a target has no referent."""
    found = True
    for k in range(tab.arity[basic]):
        slot = row * tab.arguments + k
        entity = found_by(world, tab, runs, runs.argument[slot], runs.owner[slot], agent, stamp)
        runs.act_on[agent * tab.slots_most + k] = entity
        if entity == -1:
            found = False
    return found


def found_by(world: World, tab: Tables, runs: Runs, target: int, owner: int, me: int, stamp: int) -> int:
    """The entity that a target means to agent *me*, looked for once a tick and owner."""
    if runs.target_stamp[target] != stamp or runs.target_owner[target] != owner:
        runs.target_stamp[target] = stamp
        runs.target_owner[target] = owner
        runs.target_entity[target] = find(
            world, target, tab.first_member[owner], tab.end_member[owner], me, runs.once
        )
    return runs.target_entity[target]  # type: ignore[no-any-return]


# --------------------------------------------------------------------------------------- changing state


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


def directs(tab: Tables, runs: Runs, node: int) -> bool:
    """Whether a node is in a state in which a controller directs its subsidiaries."""
    what = runs.what[node * tab.levels + runs.depth[node] - 1]
    return what < 0 and tab.derived[-1 - what] != 0  # type: ignore[no-any-return]


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


# -------------------------------------------------------------------------------- the transition function


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
            return tab.no[at]  # type: ignore[no-any-return]
        return drawn_at_leaf(tab, runs, node, state, tab.goal[at], level, now)
    return weighed(world, tab, runs, node, row, at, level, now, stamp)


def drawer(tab: Tables, node: int) -> int:
    """The number that a node draws with."""
    return node - tab.controllers if node >= tab.controllers else FIRST_CONTROLLER + node  # type: ignore[no-any-return]


def branch(world: World, tab: Tables, runs: Runs, node: int, row: int, at: int, now: int, stamp: int) -> int:
    """Where a test leads."""
    value = value_of(world, tab, runs, node, row, tab.use[at], tab.goal[at], now, stamp)
    return tab.yes[at] if tab.low[at] <= value <= tab.high[at] else tab.no[at]  # type: ignore[no-any-return]


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
    return tab.label[tab.labels_at[state] + k]  # type: ignore[no-any-return]


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
        return runs.entry[0]  # type: ignore[no-any-return]
    u = draw(runs.once[MACHINE_KEY], now, drawer, level)
    total = 0.0
    last = state
    for k in range(entries + 1):
        share = runs.entry_share[k]
        total += share
        if u < total:
            return runs.entry[k]  # type: ignore[no-any-return]
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
    return best  # type: ignore[no-any-return]


# ------------------------------------------------------------------------------------------- features


def value_of(  # noqa: PLR0917 - as many numbers as there are: compiled code takes scalars
    world: World, tab: Tables, runs: Runs, node: int, row: int, use: int, source: int, now: int, stamp: int
) -> float:
    """The value of a feature that comes from *source*, sensed once a tick."""
    if source == SENSE:
        if runs.use_stamp[use] != stamp:
            runs.use_stamp[use] = stamp
            me = node - tab.controllers
            runs.use_value[use] = sensed(world, tab, runs, node, row, use, me, stamp)
        return runs.use_value[use]  # type: ignore[no-any-return]
    if source == FLAG_UP:
        below = row + 1 - node * tab.levels
        return 1.0 if below < runs.depth[node] and runs.flags[row + 1] & tab.flag[use] != 0 else 0.0
    if source == TICKS_IN_STATE:
        return float(now - runs.entered[row])
    return of_those_below(world, tab, runs, node, row, use, source, stamp)


def of_those_below(
    world: World, tab: Tables, runs: Runs, node: int, row: int, use: int, source: int, stamp: int
) -> float:
    """The value of a controller's feature, sensed once a tick."""
    if runs.use_stamp[use] != stamp:
        runs.use_stamp[use] = stamp
        if source == GROUP:
            runs.use_value[use] = sense_group(
                world, tab.feature[use], tab.first_member[node], tab.end_member[node], runs.once
            )
        else:
            runs.use_value[use] = statistic(world, tab, runs, node, row, use)
    return runs.use_value[use]  # type: ignore[no-any-return]


def sensed(
    world: World, tab: Tables, runs: Runs, node: int, row: int, use: int, me: int, stamp: int
) -> float:
    """An agent's feature with its targets; the default where one has no referent."""
    slots = tab.slots[use]
    if slots > 0:
        entity = bound_to(world, tab, runs, node, row, tab.binding[tab.slots_at[use]], me, stamp)
        runs.sense_on[0] = entity
        if entity == -1 or (slots > 1 and not others_found(world, tab, runs, node, row, use, me, stamp)):
            return tab.default[use]  # type: ignore[no-any-return]
    return sense(world, tab.feature[use], me, runs.sense_on, runs.once)


def others_found(
    world: World, tab: Tables, runs: Runs, node: int, row: int, use: int, me: int, stamp: int
) -> bool:
    """Look for a feature's targets from the second on; False where one has no referent."""
    for k in range(1, tab.slots[use]):
        entity = bound_to(world, tab, runs, node, row, tab.binding[tab.slots_at[use] + k], me, stamp)
        runs.sense_on[k] = entity
        if entity == -1:
            return False
    return True


def bound_to(
    world: World, tab: Tables, runs: Runs, node: int, row: int, binding: int, me: int, stamp: int
) -> int:
    """The entity that a binding means: a target of the node itself, or one that a parameter stands for."""
    if binding >= 0:
        return found_by(world, tab, runs, binding, node, me, stamp)
    slot = row * tab.arguments - 1 - binding
    return found_by(world, tab, runs, runs.argument[slot], runs.owner[slot], me, stamp)


def statistic(world: World, tab: Tables, runs: Runs, node: int, row: int, use: int) -> float:
    """A controller's statistic over those below it, in the order of their numbers."""
    first = tab.children_at[node]
    end = tab.children_end[node]
    if tab.direct[use] == 0 and end > first:
        first = tab.controllers + tab.first_member[node]
        end = tab.controllers + tab.end_member[node]
    of_agents = tab.source[use] == STATISTIC_OF_SENSE
    count = 0
    result = 0.0
    for place in range(first, end):
        below = tab.child[place] if tab.direct[use] != 0 else place
        if of_agents and below >= tab.controllers:
            stamp = runs.once[STAMP] + 1  # another agent looks: what was found before does not count
            runs.once[STAMP] = stamp
            value = sensed(world, tab, runs, node, row, use, below - tab.controllers, stamp)
            result = summed_up(tab.statistic[use], count, result, value)
            count += 1
        elif not of_agents:
            result = summed_up(tab.statistic[use], count, result, shown(tab, runs, use, below))
            count += 1
    if count == 0:
        return tab.empty[use]  # type: ignore[no-any-return]
    return result / count if tab.statistic[use] == MEAN else result


def summed_up(operation: int, count: int, so_far: float, value: float) -> float:
    """A statistic with one value more; *count* values came before."""
    if operation == ANY:
        return 1.0 if so_far != 0.0 or value != 0.0 else 0.0
    if operation == ALL:
        return 1.0 if (count == 0 or so_far != 0.0) and value != 0.0 else 0.0
    if operation == COUNT:
        return so_far + 1.0 if value != 0.0 else so_far
    if operation == MEAN:
        return so_far + value
    if count == 0 or (operation == MIN and value < so_far) or (operation == MAX and value > so_far):
        return value
    return so_far


def shown(tab: Tables, runs: Runs, use: int, below: int) -> float:
    """Whether a node shows a flag: up on itself, or on what it was directed to do."""
    up = runs.node_flags[below]
    if runs.depth[below] > 0:
        up |= runs.flags[below * tab.levels]
    return 1.0 if up & tab.flag[use] != 0 else 0.0


#: What runs in few of the ticks of a node stays out of what runs in all: there it would take up registers.
APART = (
    enter,
    direct_all,
    lower_directed,
    back_to_start,
    weighed,
    drawn_at_leaf,
    of_those_below,
    others_found,
    aimed,
)
