"""A scenario in which everything that a kernel has to deal with happens often: a few children, stones, a pit, no order.

It has features of every kind and of a group, with no, one and two targets; targets of every level, some without
referent; behaviors that run once, raise flags, finish, and take targets; children who hold stones and drop them into a pit.
"""

from dataclasses import dataclass
from math import atan2, pi

from app.sim.scenario import (
    DONE,
    FAILED,
    NO_ENTITY,
    Column,
    FeatureKind,
    Kind,
    Per,
    Scenario,
    World,
    clamped,
    distance,
    heading_cos,
    heading_sin,
    quantity,
    uniform,
    wrapped,
)

FAULTS = ("none", "division by zero", "no number", "nobody")


@dataclass(frozen=True, slots=True)
class Parameters:
    """What can be set."""

    side: float = quantity(8.0, "units", 1.0, 100.0, doc="how wide and high the yard is")
    step: float = quantity(0.7, "units per tick", 0.0, 10.0, doc="how far a child walks")
    stones: int = quantity(4, "stones", 0, 100, doc="how many lie around")
    reach: float = quantity(1.5, "units", 0.0, 10.0, doc="how near a stone or the pit is")
    slippery: bool = quantity(False, doc="children turn by chance")
    fault: str = quantity("none", choices=FAULTS, doc="what goes wrong in tick 7")
    ground: str = quantity("flat", choices=("flat", "hilly"), doc="hills slow children down")


scenario = Scenario(
    "playground",
    "Playground",
    Parameters,
    kinds=(Kind("stone", "stones", doc="held and dropped"), Kind("pit", 1, doc="stones end here")),
    columns=(
        Column("holds", whole=True, initial=NO_ENTITY, doc="the stone that a child holds"),
        Column("held_by", whole=True, initial=NO_ENTITY, doc="the child that holds a stone"),
        Column("reaches", whole=True, initial=NO_ENTITY, doc="the stone that a child reaches for"),
        Column("drops", whole=True, doc="1 where a child lets go"),
        Column("dropped", per=Per.WORLD, doc="stones in the pit so far"),
        Column("hours", whole=True, per=Per.WORLD, doc="ticks so far"),
    ),
    measures={"dropped": "dropped"},
    doc="Children take stones to a pit, or not.",
)


@scenario.feature("Far", FeatureKind.CONTINUOUS, ("target",), default=99.0, unit="units")
def far(world: World, me: int, target: int) -> float:
    """How far away the target is."""
    return distance(world, me, target)


@scenario.feature("Gap", FeatureKind.CONTINUOUS, ("a", "b"), default=-1.0, unit="units")
def gap(world: World, me: int, a: int, b: int) -> float:
    """How far two targets are apart."""
    return distance(world, a, b)


@scenario.feature("Bearing", FeatureKind.TOROIDAL, ("target",), unit="radians")
def bearing(world: World, me: int, target: int) -> float:
    """Where the target is, seen from the child."""
    angle = atan2(world.y[target] - world.y[me], world.x[target] - world.x[me])
    return wrapped(angle - world.heading[me])


@scenario.feature("Hour", FeatureKind.TOROIDAL, period=5.0, unit="hours")
def hour(world: World, me: int) -> float:
    """The hour of a day that has five."""
    return float(world.hours[0] % 5) - 2.5


@scenario.feature("Holds", FeatureKind.BOOLEAN)
def holds(world: World, me: int) -> float:
    """Whether the child holds a stone."""
    return 1.0 if world.holds[me] >= 0 else 0.0


@scenario.feature("Lucky", FeatureKind.BOOLEAN)
def lucky(world: World, me: int) -> bool:
    """Whether the child is in luck."""
    return bool(uniform(world.clock, me, 1) < 0.4)


@scenario.feature("Third", FeatureKind.CATEGORICAL, categories=("left", "middle", "right"))
def third(world: World, me: int) -> int:
    """The part of the yard that the child is in."""
    return min(int(3.0 * world.x[me] / world.params.side), 2)


@scenario.feature("Doubt", FeatureKind.CONTINUOUS, ("target",))
def doubt(world: World, me: int, target: int) -> float:
    """How long it has been, unless that is no number."""
    if world.params.fault == 2 and world.clock[2] == 7:
        return 1e308 * 10.0 - 1e308 * 10.0
    return float(world.clock[2])


@scenario.group_feature("Crowded", FeatureKind.BOOLEAN)
def crowded(world: World, first: int, end: int) -> float:
    """Whether two of the group stand near each other."""
    for k in range(first, end):
        for other in range(k + 1, end):
            if distance(world, world.members[k], world.members[other]) < world.params.reach:
                return 1.0
    return 0.0


@scenario.group_feature("Spread", FeatureKind.CONTINUOUS, unit="units")
def spread(world: World, first: int, end: int) -> float:
    """How far the first and the last of the group are apart."""
    return distance(world, world.members[first], world.members[end - 1])


@scenario.target("free stone")
def free_stone(world: World, first: int, end: int, me: int) -> int:
    """The nearest stone that nobody holds."""
    best = NO_ENTITY
    for stone in range(world.first_stone, world.end_stone):
        if world.held_by[stone] < 0 and (best < 0 or distance(world, me, stone) < distance(world, me, best)):
            best = stone
    return best


@scenario.target("pit")
def pit(world: World, first: int, end: int, me: int) -> int:
    """Where stones end."""
    return int(world.first_pit)


@scenario.target("holder", level=1)
def holder(world: World, first: int, end: int, me: int) -> int:
    """The first of the owner's group who holds a stone; none for who holds one."""
    for k in range(first, end):
        child = world.members[k]
        if world.holds[child] >= 0 and world.holds[me] < 0:
            return int(child)
    return NO_ENTITY


@scenario.target("last", level=2)
def last(world: World, first: int, end: int, me: int) -> int:
    """The last of the owner's group."""
    return int(world.members[end - 1])


@scenario.target("somebody")
def somebody(world: World, first: int, end: int, me: int) -> int:
    """The child itself, unless that is nobody that there is."""
    return 1000 if world.params.fault == 3 and world.clock[2] == 7 else me


@scenario.behavior("Swing")
def swing(world: World, me: int) -> None:
    """Go to and fro, ever faster."""
    left = 7 - world.clock[2] if world.params.fault == 1 else 8
    world.turn[me] = 1.0 / left


@scenario.behavior("Walk")
def walk(world: World, me: int) -> None:
    """Walk on."""
    world.drive[me] = world.params.step / (2.0 if world.params.ground == 1 else 1.0)


@scenario.behavior("Turn")
def turn(world: World, me: int) -> None:
    """Turn a bit, or by chance."""
    world.turn[me] = uniform(world.clock, me, 0) * pi if world.params.slippery else 0.6


@scenario.behavior("Face", ("target",))
def face(world: World, me: int, target: int) -> None:
    """Turn to the target and walk."""
    world.turn[me] = bearing(world, me, target)
    world.drive[me] = world.params.step


@scenario.behavior("Between", ("a", "b"))
def between(world: World, me: int, a: int, b: int) -> None:
    """Walk to where *a* is, as fast as *b* is far."""
    world.turn[me] = bearing(world, me, a)
    world.drive[me] = min(distance(world, me, b), world.params.step)


@scenario.behavior("Take", one_shot=True)
def take(world: World, me: int) -> None:
    """Reach for the nearest free stone."""
    if world.holds[me] < 0:
        stone = free_stone(world, 0, 0, me)
        if stone >= 0 and distance(world, me, stone) <= 2.0 * world.params.reach:
            world.reaches[me] = stone


@scenario.behavior("Drop", raises=DONE, finishes=True)
def drop(world: World, me: int) -> None:
    """Let go, and be finished."""
    world.drops[me] = 1


@scenario.behavior("Throw", ("target",), one_shot=True, raises="thrown")
def throw(world: World, me: int, target: int) -> None:
    """Let go while walking to a target."""
    world.turn[me] = bearing(world, me, target)
    world.drops[me] = 1


@scenario.behavior("Cry", raises=FAILED)
def cry(world: World, me: int) -> None:
    """Fail."""


@scenario.reset
def reset(world: World) -> None:
    """Put all anywhere."""
    for entity in range(world.end_pit):
        world.x[entity] = uniform(world.clock, entity, 10) * world.params.side
        world.y[entity] = uniform(world.clock, entity, 11) * world.params.side
        world.heading[entity] = uniform(world.clock, entity, 12) * 6.0 - 3.0


@scenario.resolve
def settle(world: World) -> None:
    """Let go, then take: the first child gets the stone."""
    for child in range(world.agents):
        stone = world.holds[child]
        if world.drops[child] == 1 and stone >= 0:
            world.holds[child] = NO_ENTITY
            world.held_by[stone] = NO_ENTITY
        world.drops[child] = 0
    for child in range(world.agents):
        stone = world.reaches[child]
        world.reaches[child] = NO_ENTITY
        if stone >= 0 and world.held_by[stone] < 0:
            world.holds[child] = stone
            world.held_by[stone] = child


@scenario.kinematics
def move(world: World) -> None:
    """Turn, walk, and carry."""
    for child in range(world.agents):
        world.heading[child] = wrapped(world.heading[child] + world.turn[child])
        x = world.x[child] + world.drive[child] * heading_cos(world, child)
        y = world.y[child] + world.drive[child] * heading_sin(world, child)
        world.x[child] = clamped(x, world.params.side)
        world.y[child] = clamped(y, world.params.side)
        if world.holds[child] >= 0:
            world.x[world.holds[child]] = world.x[child]
            world.y[world.holds[child]] = world.y[child]


@scenario.after_tick
def swallow(world: World) -> None:
    """Count every stone in the pit, and put it elsewhere."""
    world.hours[0] += 1
    for stone in range(world.first_stone, world.end_stone):
        if distance(world, stone, world.first_pit) <= world.params.reach:
            world.dropped[0] += 1.0
            world.progressed[0] = world.clock[2]
            child = world.held_by[stone]
            if child >= 0:
                world.holds[child] = NO_ENTITY
                world.held_by[stone] = NO_ENTITY
            world.x[stone] = uniform(world.clock, stone, 20) * world.params.side
            world.y[stone] = uniform(world.clock, stone, 21) * world.params.side
