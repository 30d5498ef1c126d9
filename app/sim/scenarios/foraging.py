"""Box foraging (paper, section 4): agents hunt for boxes and pull them to a deposit; heavy boxes need many agents."""

from dataclasses import dataclass
from math import atan2, cos, hypot, pi, sin, sqrt, tau

from ...core.amounts import exact
from ...core.chance import uniform
from ...core.vocabulary import DONE, NO_ENTITY, FeatureKind, Phrases
from ..geometry import clamped, distance, heading_cos, heading_sin, square_distance, wrapped
from ..scenario import Bodies, Column, Kind, Look, Per, Scenario, World, quantity

PLACEMENTS = ("anywhere", "ring")
RELEASES = ("anyone", "full")

# How often a place for a box is drawn before it is put into a corner, two numbers a time.
_TRIES = 32
# Draw numbers of agents: when they are placed (x, y, heading), and when they claim a box.
_PLACE_AGENT, _CLAIM = 0, 3
# Draw numbers of boxes: the first when they are placed at the beginning, and when they are placed anew.
_PLACE_BOX, _PLACE_BOX_ANEW = 0, 2 * _TRIES


@dataclass(frozen=True, slots=True)
class Parameters:
    """What can be set. Lengths are in world units, speeds a tick."""

    width: float = quantity(200.0, "units", 10.0, 100_000.0, doc="the arena's extent along x")
    height: float = quantity(200.0, "units", 10.0, 100_000.0, doc="the arena's extent along y")
    step: float = quantity(0.1, "units per tick", 0.0, 100.0, doc="how far Forward moves, and a pulled box")
    turn_degrees: float = quantity(2.0, "degrees per tick", 0.0, 180.0, doc="how far a rotation turns")
    boxes: int = quantity(10, "", 0, 100_000, doc="boxes altogether")
    big_boxes: int = quantity(0, "", 0, 100_000, doc="how many of the boxes are big")
    pullers: int = quantity(5, "agents", 1, 10_000, doc="agents that an ordinary box needs")
    big_pullers: int = quantity(25, "agents", 1, 10_000, doc="agents that a big box needs")
    box_diameter: float = quantity(5.0, "units", 0.1, 1_000.0, doc="for drawing and for contact")
    agent_diameter: float = quantity(1.0, "units", 0.01, 1_000.0, doc="for drawing and for contact")
    contact: bool = quantity(default=True, doc="rigid worlds: agents bump into each other")
    reserve: float = quantity(
        0.9,
        "pulls",
        0.01,
        0.99,
        doc="rigid worlds: how much less than the pull of all that it needs a box gives way to",
    )
    sight: float = quantity(10.0, "units", 0.0, 100_000.0, doc="boxes are seen within this distance")
    grab_range: float = quantity(5.0, "units", 0.0, 100_000.0, doc="boxes are grabbed within this distance")
    deposit_x: float = quantity(100.0, "units", 0.0, 100_000.0, doc="where the deposit is")
    deposit_y: float = quantity(100.0, "units", 0.0, 100_000.0, doc="where the deposit is")
    deposit_range: float = quantity(5.0, "units", 0.0, 100_000.0, doc="a box this near counts as deposited")
    placement: str = quantity("anywhere", choices=PLACEMENTS, doc="where boxes appear")
    ring_radius: float = quantity(70.0, "units", 0.0, 100_000.0, doc="the ring's distance from the deposit")
    release: str = quantity(
        "anyone", choices=RELEASES, doc="who may let go: pullers of any box, or of full ones"
    )


scenario = Scenario(
    "foraging",
    "Box foraging",
    Parameters,
    kinds=(
        Kind("box", "boxes", doc="pulled to the deposit"),
        Kind("deposit", 1, doc="where boxes are brought"),
    ),
    columns=(
        Column("held", whole=True, initial=NO_ENTITY, doc="the box that an agent is attached to"),
        Column("wants", whole=True, initial=NO_ENTITY, doc="the box that an agent grabs in this tick"),
        Column("lets_go", whole=True, doc="1 where an agent lets go of its box in this tick"),
        Column("needed", whole=True, doc="agents that a box needs"),
        Column("pulling", whole=True, doc="agents attached to a box"),
        Column("boxes_delivered", per=Per.WORLD, doc="boxes brought to the deposit"),
        Column("weight_delivered", per=Per.WORLD, doc="sum of the agents needed by the boxes brought"),
    ),
    measures={"boxes": "boxes_delivered", "weight": "weight_delivered"},
    doc="Agents hunt for boxes and pull them to a deposit; a box moves once enough agents pull it together.",
    bodies=Bodies(
        loads="box",
        held="held",
        needed="needed",
        speed="step",
        agent_diameter="agent_diameter",
        load_diameter="box_diameter",
        width="width",
        height="height",
        contact="contact",
        reserve="reserve",
    ),
    look=Look(
        width="width",
        height="height",
        diameters={"agent": "agent_diameter", "box": "box_diameter"},
        ranges={"agent": ("sight", "grab_range"), "deposit": ("deposit_range",)},
        held="held",
        loads="box",
        got="pulling",
        needed="needed",
        places=("deposit",),
    ),
)


@scenario.check
def impossible(p: Parameters) -> str:
    """Parameters with which there would be more big boxes than boxes, or no place for the deposit or a box."""
    if p.big_boxes > p.boxes:
        return f"big_boxes must be {p.boxes:,} or less, as many as there are boxes, but it is {p.big_boxes:,}"
    if p.deposit_x > p.width:
        return f"deposit_x must be {exact(p.width)} or less, within the arena's width, but it is {exact(p.deposit_x)}"
    if p.deposit_y > p.height:
        return f"deposit_y must be {exact(p.height)} or less, within the arena's height, but it is {exact(p.deposit_y)}"
    corner = hypot(max(p.deposit_x, p.width - p.deposit_x), max(p.deposit_y, p.height - p.deposit_y))
    if p.deposit_range >= corner:
        below = f"{exact(round(corner, 2))}, short of a corner of the arena"
        return f"deposit_range must be below {below}, but it is {exact(p.deposit_range)}"
    if p.placement == "ring" and p.ring_radius <= p.deposit_range:
        return f"ring_radius must be above {exact(p.deposit_range)}, beyond deposit_range, but it is {exact(p.ring_radius)}"
    return ""


# ------------------------------------------------------------------------------------------------ features


@scenario.feature(
    "DistanceTo",
    FeatureKind.CONTINUOUS,
    ("target",),
    default=1000.0,
    unit="units",
    phrases=Phrases(
        above="farther than {value} from {target}",
        below="within {value} of {target}",
        between="between {low} and {high} from {target}",
        at="{value} from {target}",
        some="there is a {target}",
        none="there is no {target}",
    ),
)
def distance_to(world: World, me: int, target: int) -> float:
    """How far the target is, center to center; 1000 if there is none."""
    return distance(world, me, target)


@scenario.feature(
    "DirectionTo",
    FeatureKind.TOROIDAL,
    ("target",),
    default=0.0,
    unit="radians",
    phrases=Phrases(
        true="{target} lies between {start} and {end}",
        false="{target} does not lie between {start} and {end}",
        at="{target} lies at {value}",
        not_at="{target} does not lie at {value}",
    ),
)
def direction_to(world: World, me: int, target: int) -> float:
    """Angle to the target in the agent's frame, in [-pi, pi), positive to the left; 0 (ahead) if there is none."""
    dx = world.x[target] - world.x[me]
    dy = world.y[target] - world.y[me]
    return wrapped(atan2(dy, dx) - world.heading[me])


@scenario.feature(
    "ICanSeeABox",
    FeatureKind.BOOLEAN,
    phrases=Phrases(true="sees a box", false="sees no box", detail="that still needs pullers"),
)
def i_can_see_a_box(world: World, me: int) -> float:
    """Whether a box that still needs pullers is within sight."""
    far = world.params.sight * world.params.sight
    near = 0
    for box in range(world.first_box, world.end_box):
        near += square_distance(world, me, box) <= far
    return 1.0 if near > 0 and nearest_box_within(world, me, world.params.sight) >= 0 else 0.0


@scenario.feature(
    "IAmAttachedToABox",
    FeatureKind.BOOLEAN,
    phrases=Phrases(true="is attached to a box", false="is attached to no box"),
)
def i_am_attached_to_a_box(world: World, me: int) -> float:
    """Whether the agent is attached to a box."""
    return 1.0 if world.held[me] >= 0 else 0.0


@scenario.feature(
    "MyBoxMoves", FeatureKind.BOOLEAN, phrases=Phrases(true="its box is full", false="its box lacks pullers")
)
def my_box_moves(world: World, me: int) -> float:
    """Whether the agent is attached to a box that has all the pullers it needs."""
    box = world.held[me]
    return 1.0 if box >= 0 and world.pulling[box] >= world.needed[box] else 0.0


@scenario.group_feature(
    "SomeoneNeedsHelp",
    FeatureKind.BOOLEAN,
    phrases=Phrases(true="someone needs help", false="nobody needs help"),
)
def someone_needs_help(world: World, first: int, end: int) -> float:
    """Whether someone below is attached to a box that needs more agents than that one's level-1 group has."""
    for k in range(first, end):
        agent = world.members[k]
        box = world.held[agent]
        if box >= 0 and world.needed[box] > world.group_size[agent]:
            return 1.0
    return 0.0


# ------------------------------------------------------------------------------------------------- targets


def nearest_box_within(world: World, me: int, reach: float) -> int:
    """The nearest box within *reach* that still needs pullers, or -1; the first of equally near ones."""
    best = -1
    least = reach * reach
    for box in range(world.first_box, world.end_box):
        if world.pulling[box] < world.needed[box]:
            square = square_distance(world, me, box)
            if square < least or (best < 0 and square == least):
                best = box
                least = square
    return best


@scenario.target("nearest visible box")
def nearest_visible_box(world: World, first: int, end: int, me: int) -> int:
    """The nearest box within sight that still needs pullers."""
    return nearest_box_within(world, me, world.params.sight)


@scenario.target("deposit")
def deposit(world: World, first: int, end: int, me: int) -> int:
    """Where boxes are brought."""
    return int(world.first_deposit)


@scenario.target("closest attached agent", level=1)
def closest_attached_agent(world: World, first: int, end: int, me: int) -> int:
    """The attached agent in the owner's subtree nearest to the performer; none for an attached performer."""
    if world.held[me] >= 0:
        return -1
    return nearest_holder(world, first, end, me, 0)


@scenario.target("biggest attached agent", level=2)
def biggest_attached_agent(world: World, first: int, end: int, me: int) -> int:
    """The agent in the owner's subtree attached to the box that needs most; none for who is attached to such a box.

    Of several, the one nearest to the performer.
    """
    most = 0
    for k in range(first, end):
        box = world.held[world.members[k]]
        if box >= 0 and world.needed[box] > most:
            most = world.needed[box]
    mine = world.held[me]
    if mine >= 0 and world.needed[mine] >= most:
        return -1
    return nearest_holder(world, first, end, me, most)


def nearest_holder(world: World, first: int, end: int, me: int, least: int) -> int:
    """The agent nearest to *me* of those attached to a box that needs *least* agents or more, or -1."""
    best = -1
    best_distance = 0.0
    for k in range(first, end):
        agent = world.members[k]
        box = world.held[agent]
        if box >= 0 and world.needed[box] >= least:
            d = distance(world, me, agent)
            if best < 0 or d < best_distance:
                best = agent
                best_distance = d
    return best


# ----------------------------------------------------------------------------------------------- behaviors


@scenario.behavior("Forward")
def forward(world: World, me: int) -> None:
    """Walk ahead; attached, pull ahead."""
    world.drive[me] = world.params.step


@scenario.behavior("RotateLeft")
def rotate_left(world: World, me: int) -> None:
    """Turn counterclockwise on the spot."""
    world.turn[me] = world.params.turn_degrees * pi / 180.0


@scenario.behavior("RotateRight")
def rotate_right(world: World, me: int) -> None:
    """Turn clockwise on the spot."""
    world.turn[me] = -world.params.turn_degrees * pi / 180.0


@scenario.behavior("GrabBox", one_shot=True)
def grab_box(world: World, me: int) -> None:
    """Try once to attach to the nearest box within reach that still needs pullers."""
    if world.held[me] < 0:
        world.wants[me] = nearest_box_within(world, me, world.params.grab_range)


@scenario.behavior("ReleaseBox", one_shot=True, raises=DONE)
def release_box(world: World, me: int) -> None:
    """Let go of the box, if any; done."""
    world.lets_go[me] = 1


@scenario.behavior("ReleaseBoxAndFinish", one_shot=True, raises=DONE, finishes=True)
def release_box_and_finish(world: World, me: int) -> None:
    """Let go of the box, if any; done, and finished."""
    world.lets_go[me] = 1


@scenario.behavior("Done", one_shot=True, raises=DONE)
def done(world: World, me: int) -> None:
    """Do nothing; done."""


# -------------------------------------------------------------------------------------------------- stages


@scenario.reset
def reset(world: World) -> None:
    """Put the deposit in place, agents and boxes at random."""
    world.x[world.first_deposit] = world.params.deposit_x
    world.y[world.first_deposit] = world.params.deposit_y
    for agent in range(world.agents):
        world.x[agent] = uniform(world.clock, agent, _PLACE_AGENT) * world.params.width
        world.y[agent] = uniform(world.clock, agent, _PLACE_AGENT + 1) * world.params.height
        world.heading[agent] = uniform(world.clock, agent, _PLACE_AGENT + 2) * tau - pi
    for box in range(world.first_box, world.end_box):
        big = box - world.first_box < world.params.big_boxes
        world.needed[box] = world.params.big_pullers if big else world.params.pullers
        place_box(world, box, _PLACE_BOX)


def place_box(world: World, box: int, number: int) -> None:
    """Put a box down at random beyond the deposit's range; if all draws fail, in the corner farthest from it."""
    params = world.params
    home = world.first_deposit
    for k in range(_TRIES):
        a = uniform(world.clock, box, number + 2 * k)
        b = uniform(world.clock, box, number + 2 * k + 1)
        if params.placement == 0:
            world.x[box] = a * params.width
            world.y[box] = b * params.height
        else:
            world.x[box] = clamped(world.x[home] + params.ring_radius * cos(a * tau), params.width)
            world.y[box] = clamped(world.y[home] + params.ring_radius * sin(a * tau), params.height)
        if distance(world, box, home) > params.deposit_range:
            return
    world.x[box] = params.width if 2.0 * world.x[home] < params.width else 0.0
    world.y[box] = params.height if 2.0 * world.y[home] < params.height else 0.0


@scenario.resolve
def settle_grabs(world: World) -> None:
    """Let agents go, then attach those who grab; where more grab than a box needs, the lowest draws win."""
    asked = False
    for agent in range(world.agents):
        asked |= (world.lets_go[agent] != 0) | (world.wants[agent] >= 0)
    if not asked:
        return
    for agent in range(world.agents):
        if world.lets_go[agent] == 1 and not may_let_go(world, agent):
            world.lets_go[agent] = 0
    for agent in range(world.agents):
        if world.lets_go[agent] == 1:
            world.lets_go[agent] = 0
            detach(world, agent)
    for agent in range(world.agents):
        box = world.wants[agent]
        if box >= 0 and world.pulling[box] + stronger_claims(world, agent, box) < world.needed[box]:
            world.held[agent] = box
    for agent in range(world.agents):
        box = world.wants[agent]
        if box >= 0:
            world.wants[agent] = -1
            if world.held[agent] == box:
                world.pulling[box] += 1


def may_let_go(world: World, agent: int) -> bool:
    """Whether an agent is attached, and the rules allow it to let go."""
    box = world.held[agent]
    if box < 0:
        return False
    return bool(world.params.release == 0 or world.pulling[box] >= world.needed[box])


def stronger_claims(world: World, me: int, box: int) -> int:
    """How many others grab *box* in this tick with a lower draw."""
    mine = uniform(world.clock, me, _CLAIM)
    count = 0
    for agent in range(world.agents):
        if world.wants[agent] == box and agent != me:
            other = uniform(world.clock, agent, _CLAIM)
            if other < mine or (other == mine and agent < me):
                count += 1
    return count


def detach(world: World, agent: int) -> None:
    """Take an agent off its box."""
    world.pulling[world.held[agent]] -= 1
    world.held[agent] = -1


@scenario.kinematics
def move(world: World) -> None:
    """Turn all agents, walk the free ones, and pull the boxes that have enough pullers."""
    for agent in range(world.agents):
        if world.turn[agent] != 0.0:
            world.heading[agent] = wrapped(world.heading[agent] + world.turn[agent])
        if world.drive[agent] != 0.0 and world.held[agent] < 0:
            dx = world.drive[agent] * heading_cos(world, agent)
            dy = world.drive[agent] * heading_sin(world, agent)
            world.x[agent] = clamped(world.x[agent] + dx, world.params.width)
            world.y[agent] = clamped(world.y[agent] + dy, world.params.height)
    for box in range(world.first_box, world.end_box):
        if world.pulling[box] >= world.needed[box]:
            pull(world, box)


def pull(world: World, box: int) -> None:
    """Move a box one step along the sum of its pullers' headings, as far as the walls allow, and carry them along."""
    sx = 0.0
    sy = 0.0
    for agent in range(world.agents):
        if world.held[agent] == box and world.drive[agent] != 0.0:
            sx += heading_cos(world, agent)
            sy += heading_sin(world, agent)
    length = sqrt(sx * sx + sy * sy)
    if length > 1e-9:
        x = clamped(world.x[box] + world.params.step * sx / length, world.params.width)
        y = clamped(world.y[box] + world.params.step * sy / length, world.params.height)
        dx = x - world.x[box]
        dy = y - world.y[box]
        world.x[box] = x
        world.y[box] = y
        carry(world, box, dx, dy)


def carry(world: World, box: int, dx: float, dy: float) -> None:
    """Move all agents that are attached to a box, as far as the walls allow."""
    for agent in range(world.agents):
        if world.held[agent] == box:
            world.x[agent] = clamped(world.x[agent] + dx, world.params.width)
            world.y[agent] = clamped(world.y[agent] + dy, world.params.height)


@scenario.after_tick
def deliver(world: World) -> None:
    """Count every box that was pulled to the deposit, release its agents, and place it anew."""
    for box in range(world.first_box, world.end_box):
        pulled = world.pulling[box] >= world.needed[box]
        if pulled and distance(world, box, world.first_deposit) <= world.params.deposit_range:
            world.boxes_delivered[0] += 1.0
            world.weight_delivered[0] += world.needed[box]
            world.progressed[0] = world.clock[2]
            for agent in range(world.agents):
                if world.held[agent] == box:
                    detach(world, agent)
            place_box(world, box, _PLACE_BOX_ANEW)


@scenario.moved
def drag(world: World, entity: int, x: float, y: float) -> None:
    """Put an entity within the walls; a box takes its agents along, an agent out of reach of its box loses it."""
    dx = clamped(x, world.params.width) - world.x[entity]
    dy = clamped(y, world.params.height) - world.y[entity]
    world.x[entity] += dx
    world.y[entity] += dy
    if world.pulling[entity] > 0:
        carry(world, entity, dx, dy)
    if entity < world.agents:
        box = world.held[entity]
        if box >= 0 and distance(world, entity, box) > world.params.grab_range:
            detach(world, entity)
