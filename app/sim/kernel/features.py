# mypy: disable-error-code="no-any-return"
# Columns are of numbers, as the program has declared them; mypy takes them for anything.
"""What features mean to a node: values that are sensed once a tick, and whom their targets are."""

from ..program.tables import (
    ALL,
    ANY,
    COUNT,
    FLAG_UP,
    GROUP,
    MAX,
    MEAN,
    MIN,
    SENSE,
    STATISTIC_OF_SENSE,
    TICKS_IN_STATE,
)
from .calls import STAMP, Runs, Tables, World, find, sense, sense_group


def value_of(  # noqa: PLR0917 - as many numbers as there are: compiled code takes scalars
    world: World, tab: Tables, runs: Runs, node: int, row: int, use: int, source: int, now: int, stamp: int
) -> float:
    """The value of a feature that comes from *source*, sensed once a tick."""
    if source == SENSE:
        if runs.use_stamp[use] != stamp:
            runs.use_stamp[use] = stamp
            me = node - tab.controllers
            runs.use_value[use] = sensed(world, tab, runs, node, row, use, me, stamp)
        return runs.use_value[use]
    if source == FLAG_UP:
        below = row + 1 - node * tab.levels
        return 1.0 if below < runs.depth[node] and runs.flags[row + 1] & tab.flag[use] != 0 else 0.0
    if source == TICKS_IN_STATE:
        return float(now - runs.entered[row])
    return of_those_below(world, tab, runs, node, row, use, source, stamp)


def sensed(
    world: World, tab: Tables, runs: Runs, node: int, row: int, use: int, me: int, stamp: int
) -> float:
    """An agent's feature with its targets; the default where one has no referent."""
    slots = tab.slots[use]
    if slots > 0:
        entity = bound_to(world, tab, runs, node, row, tab.binding[tab.slots_at[use]], me, stamp)
        runs.sense_on[0] = entity
        if entity == -1 or (slots > 1 and not others_found(world, tab, runs, node, row, use, me, stamp)):
            return tab.default[use]
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


def found_by(world: World, tab: Tables, runs: Runs, target: int, owner: int, me: int, stamp: int) -> int:
    """The entity that a target means to agent *me*, looked for once a tick and owner."""
    if runs.target_stamp[target] != stamp or runs.target_owner[target] != owner:
        runs.target_stamp[target] = stamp
        runs.target_owner[target] = owner
        runs.target_entity[target] = find(
            world, target, tab.first_member[owner], tab.end_member[owner], me, runs.once
        )
    return runs.target_entity[target]


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
    return runs.use_value[use]


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
        return tab.empty[use]
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
