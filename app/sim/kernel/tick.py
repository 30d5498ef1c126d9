"""One tick of every node over flat columns: what the kernel compiles. Plain Python may run it too, for tests.

It does what `app.core.machine` says, in the same order, so that both give the same numbers to the bit: here nodes tick and
agents act, `deciding` has the transition function, `entering` what a change of state does, `features` the values.

Columns of *tab* are a program's (`app.sim.program.tables`), those of *runs* what the nodes do (`app.sim.kernel.state`). A
node's chain of runs, outermost first, fills the rows from ``node * tab.levels`` on; ``runs.depth`` says how many.
"""

from ..program.tables import FINISHED_BIT, FLAG
from .calls import FAULT, STAMP, TICK, Runs, Tables, World, after_tick, behave, kinematics, resolve
from .deciding import drawn_at_leaf, next_state, weighed
from .entering import back_to_start, direct_all, enter, lower_directed
from .features import found_by, of_those_below, others_found

#: Which part of a tick passes: all of it, or what comes before or after something else has moved the world.
WHOLE, BEFORE_MOVING, AFTER_MOVING = range(3)


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
