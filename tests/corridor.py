"""A tiny scenario and project for tests of teaching: agents walk up and down a line, in whole steps.

Agent number k begins at place 10 k; a lamp stands at place 50.
"""

from dataclasses import dataclass, replace
from typing import Any

from app.core.automaton import START, Automaton, Rule
from app.core.chance import uniform
from app.core.conditions import AtMost, Condition, Equals
from app.core.features import FeatureUse, FlagUp, Ground, Parameter, Sense, Source, TicksInState
from app.core.library import Library
from app.core.project import Arm, LevelTable, Project
from app.core.vocabulary import DONE, NO_ENTITY, FeatureKind
from app.sim.scenario import Column, Kind, Per, Scenario, World, quantity
from tests.samples import AGENT, GROUP, SQUAD, TYPES, automaton, flag, nested, state

LAMP = "lamp"


@dataclass(frozen=True, slots=True)
class Parameters:
    """What can be set; a tick of -1 never comes."""

    length: float = quantity(100.0, "steps", 1.0, 1e6, doc="where the corridor ends")
    lamp: float = quantity(50.0, "steps", 0.0, 1e6, doc="where the lamp stands")
    breaks: int = quantity(-1, "", -1, 1_000_000, doc="the tick in which a rule divides by zero")
    spoils: int = quantity(-1, "", -1, 1_000_000, doc="the tick in which a place becomes infinite")


corridor = Scenario(
    "corridor",
    "A corridor",
    Parameters,
    kinds=(Kind(LAMP, 1),),
    columns=(Column("steps", per=Per.WORLD),),
    measures={"steps": "steps"},
)


@corridor.feature("Place", FeatureKind.CONTINUOUS, unit="steps")
def place(world: World, me: int) -> float:
    """Where the agent is."""
    return float(world.x[me])


@corridor.feature("AtEnd", FeatureKind.BOOLEAN)
def at_end(world: World, me: int) -> float:
    """Whether the agent is at the end of the corridor."""
    return 1.0 if world.x[me] >= world.params.length else 0.0


@corridor.feature("DistanceTo", FeatureKind.CONTINUOUS, ("target",), default=1000.0, unit="steps")
def distance_to(world: World, me: int, target: int) -> float:
    """How far the target is."""
    return float(abs(world.x[target] - world.x[me]))


@corridor.feature("Coin", FeatureKind.BOOLEAN)
def coin(world: World, me: int) -> float:
    """Heads or tails, anew in each tick."""
    return 1.0 if uniform(world.clock, me, 0) < 0.5 else 0.0


@corridor.group_feature("SomeoneAtEnd", FeatureKind.BOOLEAN)
def someone_at_end(world: World, first: int, end: int) -> float:
    """Whether an agent of the group is at the end."""
    for k in range(first, end):
        if world.x[world.members[k]] >= world.params.length:
            return 1.0
    return 0.0


@corridor.target(LAMP)
def lamp(world: World, first: int, end: int, me: int) -> int:
    """The lamp."""
    return int(world.first_lamp)


@corridor.target("the other")
def the_other(world: World, first: int, end: int, me: int) -> int:
    """The first agent, for all but itself."""
    return 0 if me > 0 else NO_ENTITY


@corridor.target("first of mine", level=1)
def first_of_mine(world: World, first: int, end: int, me: int) -> int:
    """The first agent of the node that bound it."""
    return int(world.members[first])


@corridor.behavior("Up")
def up(world: World, me: int) -> None:
    """Walk a step up."""
    world.drive[me] = 1.0


@corridor.behavior("Down")
def down(world: World, me: int) -> None:
    """Walk a step down."""
    world.drive[me] = -1.0


@corridor.behavior("Toward", ("target",))
def toward(world: World, me: int, target: int) -> None:
    """Walk a step toward the target."""
    away = world.x[target] - world.x[me]
    world.drive[me] = 1.0 if away > 0.0 else (-1.0 if away < 0.0 else 0.0)


@corridor.behavior("Jump", one_shot=True)
def jump(world: World, me: int) -> None:
    """Five steps up at once."""
    world.drive[me] = 5.0


@corridor.behavior("Ring", one_shot=True, raises=DONE)
def ring(world: World, me: int) -> None:
    """Done."""


@corridor.behavior("Leave", one_shot=True, raises=DONE, finishes=True)
def leave(world: World, me: int) -> None:
    """Done, and finished."""


@corridor.reset
def reset(world: World) -> None:
    """Agents stand ten steps apart."""
    for agent in range(world.agents):
        world.x[agent] = 10.0 * agent
    world.x[world.first_lamp] = world.params.lamp


@corridor.kinematics
def walk(world: World) -> None:
    """Walk, as far as the corridor goes."""
    for agent in range(world.agents):
        world.x[agent] = min(max(world.x[agent] + world.drive[agent], 0.0), world.params.length)
        world.steps[0] += abs(world.drive[agent])


@corridor.after_tick
def go_wrong(world: World) -> None:
    """Break or spoil the world where a test wants that."""
    if world.clock[2] == world.params.breaks:
        world.x[0] = 1.0 / (world.params.breaks - world.clock[2])
    if world.clock[2] == world.params.spoils:
        world.x[0] = 1e308 * 10.0


# ----------------------------------------------------------------------------------------------- behaviors

PLACE = FeatureUse("place", Sense("Place"))
TICKS = FeatureUse("ticks", TicksInState())
DONE_UP = FeatureUse("done", FlagUp(DONE))
AT_END = FeatureUse("end", Sense("AtEnd"))


def features(**sources: Source) -> tuple[FeatureUse, ...]:
    """Features by id."""
    return tuple(FeatureUse(feature_id, source) for feature_id, source in sources.items())


def stroll() -> Automaton:
    """Authored: up to the end and down again."""
    return automaton(
        "Stroll",
        state("up", "Up"),
        state("down", "Down"),
        features=(AT_END,),
        rules=(Rule("1", START, (), "up"), Rule("2", "up", (Condition(Equals("end", 1.0)),), "down")),
    )


def signal() -> Automaton:
    """Authored: three steps up, then done, over and over."""
    return automaton(
        "Signal",
        state("up", "Up"),
        flag("over"),
        features=(TICKS,),
        rules=(
            Rule("1", START, (), "up"),
            Rule("2", "up", (Condition(AtMost("ticks", 2.5), wanted=False),), "over"),
        ),
    )


def shuttle() -> Automaton:
    """To be taught, with all its states: up and down, jumps, and a signal."""
    return automaton(
        "Shuttle",
        state("up", "Up"),
        state("down", "Down"),
        state("jump", "Jump"),
        state("ring", "Ring"),
        nested("signal", "Signal"),
        flag("over"),
        features=(PLACE, DONE_UP, TICKS),
    )


def seek() -> Automaton:
    """To be taught, with a parameter and no states yet."""
    to_target = {"target": Parameter("target")}
    return automaton(
        "Seek", parameters=("target",), features=features(distance=Sense("DistanceTo", to_target))
    )


def lead() -> Automaton:
    """To be taught, of groups."""
    return automaton("Lead", state("up", "Up"), state("down", "Down"), state("signal", "Signal"))


def command() -> Automaton:
    """Authored, of squads: lets the groups lead."""
    return automaton("Command", state("lead", "Lead"), rules=(Rule("1", START, (), "lead"),))


def project(*more: Automaton, **fields: Any) -> Project:
    """Two agents alone, two groups of two, and a squad of those."""
    agents = {a.id: a for a in (stroll(), signal(), shuttle(), seek(), *more)}
    libraries = {
        AGENT: Library(agents),
        GROUP: Library({"Lead": lead()}),
        SQUAD: Library({"Command": command()}),
    }
    arms = (
        Arm("alone", LevelTable((2,), (AGENT,)), "Stroll"),
        Arm("groups", LevelTable((2, 2), (GROUP, AGENT)), "Stroll"),
        Arm("squads", LevelTable((1, 2, 2), (SQUAD, GROUP, AGENT)), "Command"),
    )
    made = Project("Corridor", "corridor", TYPES, libraries=libraries, arms=arms)
    return replace(made, **fields)


def to(target: str) -> dict[str, Ground]:
    """A binding of the slot called target."""
    return {"target": Ground(target)}
