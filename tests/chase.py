"""A second scenario, as far from foraging as the contract goes: two teams on a line, nobody grabs anything."""

from dataclasses import dataclass
from math import pi

from app.sim.scenario import (
    DONE,
    NO_ENTITY,
    THE_WORLD,
    Column,
    FeatureKind,
    Kind,
    Per,
    Phrases,
    Scenario,
    World,
    distance,
    quantity,
    uniform,
)


@dataclass(frozen=True, slots=True)
class Parameters:
    """What can be set."""

    length: float = quantity(50.0, "units", 1.0, 1000.0, doc="the line that all live on")
    hares: int = quantity(2, "hares", 0, 100, doc="how many are chased")
    reach: float = quantity(1.0, "units", 0.0, 10.0, doc="how near a hare is caught")
    tired: bool = quantity(False, doc="hares stand still")
    pace: str = quantity("walk", choices=("walk", "run"), doc="how agents move")


scenario = Scenario(
    "chase",
    "Chase",
    Parameters,
    kinds=(Kind("hare", "hares", 0.5, doc="chased"), Kind("home", 1, doc="where hares are safe")),
    columns=(
        Column("caught", whole=True, doc="hares that an agent has caught"),
        Column("all_caught", per=Per.WORLD, doc="hares caught by all"),
    ),
    measures={"caught": "all_caught"},
    doc="Agents on a line run after hares.",
)


@scenario.check
def no_room(parameters: Parameters) -> str:
    """A line on which every hare would be caught at once."""
    if parameters.reach >= parameters.length:
        return (
            f"reach must be below {parameters.length}, the length of the line, but it is {parameters.reach}"
        )
    return ""


@scenario.feature(
    "Gap",
    FeatureKind.CONTINUOUS,
    ("a", "b"),
    default=99.0,
    unit="units",
    phrases=Phrases(above="{a} is more than {value} from {b}", below="{a} is within {value} of {b}"),
)
def gap(world: World, me: int, a: int, b: int) -> float:
    """How far apart two are."""
    return distance(world, a, b)


@scenario.feature(
    "Third",
    FeatureKind.CATEGORICAL,
    categories=("left", "middle", "right"),
    phrases=Phrases("in the {value}"),
)
def third(world: World, me: int) -> float:
    """The third of the line that the agent is in."""
    return float(min(int(3.0 * world.x[me] / world.params.length), 2))


@scenario.feature(
    "Clock",
    FeatureKind.TOROIDAL,
    period=12.0,
    unit="hours",
    phrases=Phrases("it is between {start} and {end}"),
)
def hour(world: World, me: int) -> float:
    """The hour of day, in [-6, 6)."""
    return float(world.clock[2] % 12 - 6)


@scenario.group_feature("Alone", FeatureKind.BOOLEAN, phrases=Phrases("alone", "in company"))
def alone(world: World, first: int, end: int) -> float:
    """Whether a controller has but one agent."""
    return 1.0 if end - first == 1 else 0.0


@scenario.target("nearest hare")
def nearest_hare(world: World, first: int, end: int, me: int) -> int:
    """The hare nearest to the agent, if there is one."""
    best = NO_ENTITY
    for hare in range(world.first_hare, world.end_hare):
        if best < 0 or distance(world, me, hare) < distance(world, me, best):
            best = hare
    return best


@scenario.target("home")
def home(world: World, first: int, end: int, me: int) -> int:
    """Where hares are safe."""
    return int(world.first_home)


@scenario.behavior("Approach", ("target",))
def approach(world: World, me: int, target: int) -> None:
    """Walk toward the target."""
    pace = 2.0 if world.params.pace == 1 else 1.0
    world.drive[me] = pace if world.x[target] > world.x[me] else -pace


@scenario.behavior("Shout", one_shot=True, raises=DONE)
def shout(world: World, me: int) -> None:
    """Be done."""


@scenario.reset
def reset(world: World) -> None:
    """Scatter all on the line."""
    for entity in range(world.agents):
        world.x[entity] = uniform(world.clock, entity, 0) * world.params.length
    for hare in range(world.first_hare, world.end_hare):
        world.x[hare] = uniform(world.clock, THE_WORLD, hare) * world.params.length
    world.heading[world.first_home] = -pi


@scenario.kinematics
def move(world: World) -> None:
    """Walk, as far as the line goes."""
    for agent in range(world.agents):
        world.x[agent] = min(max(world.x[agent] + world.drive[agent], 0.0), world.params.length)


@scenario.after_tick
def catch(world: World) -> None:
    """Count every hare within reach of an agent, and put it elsewhere."""
    for hare in range(world.first_hare, world.end_hare):
        for agent in range(world.agents):
            if distance(world, agent, hare) <= world.params.reach and not world.params.tired:
                world.caught[agent] += 1
                world.all_caught[0] += 1.0
                world.progressed[0] = world.clock[2]
                world.x[hare] = uniform(world.clock, THE_WORLD, hare) * world.params.length
