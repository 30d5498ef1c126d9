"""What a kernel calls of its scenario, and the types and places that its parts have in common.

The seven functions stand for those that are put in place when a kernel is made, see `app.sim.kernel.build`.
"""

from typing import Any

# Blocks whose types depend on the scenario, see `columns`.
World = Any
Tables = Any
Runs = Any

TICK, KEY = 2, 3
# Places in `runs.once`: the number of the node's tick, counted up; the machine's key for chance; whether a function of the
# scenario answered with what it cannot mean; how many entities there are.
STAMP, MACHINE_KEY, FAULT, ENTITIES = range(4)


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
