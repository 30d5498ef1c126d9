"""A pymunk space built from a world's columns.

* An agent is a disc that drives: a joint of bounded force holds it to a body that moves as the agent wants to. The force,
  its pull, is what brings it to its speed within one tick. Nothing turns agents but themselves: contact is smooth.
* A load is a disc, as heavy as the agents that it needs, held to the ground by joints of bounded force, which are its
  friction: against sliding (needed - reserve) pulls, against turning 2/3 of the radius times that, as of a disc that
  presses evenly on the ground.
* An attached agent hangs on a pivot at its center. While it does not drive, it is carried without resisting.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
import pymunk
from numpy.typing import NDArray
from pymunk import batch

AGENT_MASS = 1.0
#: A load's mass, for each agent that it needs.
MASS_NEEDED = 1.0
#: Of an overlap that is left after a tick: bodies part gently.
OVERLAP_LEFT = 0.8
#: Overlaps up to this share of an agent's radius are left alone, so that contacts last.
SLOP_SHARE = 0.02
#: Of what a stretched pivot is stretched by, after a tick.
STRETCH_LEFT = 0.5
#: How often forces are evened out in a tick, and in the first one, when none are remembered from the tick before.
ITERATIONS, FIRST_ITERATIONS = 10, 60
_AGENT, _LOAD, _WALL = 1, 2, 4
_EVERYTHING = batch.BodyFields.BODY_ID | batch.BodyFields.POSITION | batch.BodyFields.ANGLE
FIELDS = (
    batch.BodyFields.POSITION
    | batch.BodyFields.ANGLE
    | batch.BodyFields.VELOCITY
    | batch.BodyFields.ANGULAR_VELOCITY
)
#: Columns of a state: x, y, angle, velocity along x and y, spin.
WIDTH = 6

Floats = NDArray[np.float64]
Wholes = NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class Sizes:
    """What stays the same throughout a run.

    Attributes:
        pull: The force of an agent.
        contact: Whether agents bump into each other.
    """

    agents: int
    loads: int
    agent_radius: float
    load_radius: float
    width: float
    height: float
    pull: float
    reserve: float
    contact: bool


class Space:
    """Bodies in the order agents, loads, and what each agent wants to move like.

    Attributes:
        state: A row for each body, see `WIDTH`; `step` takes it to the next tick.
    """

    def __init__(self, sizes: Sizes, state: Floats, needed: Wholes, held: Wholes, powered: Any) -> None:
        """Build it.

        Args:
            state: Rows for agents and loads.
            needed: For each load.
            held: For each agent, the number of its load among the loads, or -1.
            powered: For each agent, whether it drives or stands on its own.
        """
        self._sizes = sizes
        self._space = _empty(sizes)
        self._loads: list[pymunk.Body] = []
        self._agents = [self._disc(AGENT_MASS, sizes.agent_radius, row) for row in state[: sizes.agents]]
        for load in range(sizes.loads):
            mass = MASS_NEEDED * float(needed[load])
            self._loads.append(self._disc(mass, sizes.load_radius, state[sizes.agents + load], load=True))
            self._lay_down(self._loads[load], float(needed[load]))
        self._motors = [self._motor(agent) for agent in self._agents]
        self._pivots: list[pymunk.PivotJoint | None] = [None] * sizes.agents
        self._held, self._powered = np.full(sizes.agents, -1, np.int64), np.ones(sizes.agents, bool)
        self._open_buffers()
        self.attach(held)
        self.power(powered)

    def _open_buffers(self) -> None:
        """Room for the batch calls, and the order in which they go through the bodies."""
        order = batch.Buffer()
        batch.get_space_bodies(self._space, batch.BodyFields.BODY_ID, order)
        ids = list(memoryview(order.int_buf()).cast("P"))
        place = {identity: k for k, identity in enumerate(ids)}
        wanted = [body.id for body in (*self._agents, *self._loads, *(m.a for m in self._motors))]
        self._rows = np.array([place[identity] for identity in wanted], np.intp)
        self._in_order = bool((self._rows == np.arange(len(wanted))).all())
        self.state = np.zeros((len(wanted), WIDTH))
        self._out, self._in = np.zeros((len(ids), WIDTH)), np.zeros((len(ids) + 1, WIDTH))
        self._writer, self._reader = batch.Buffer(), batch.Buffer()
        self._writer.set_float_buf(self._out)
        self._reader.set_float_buf(self._in)

    # ---------------------------------------------------------------------------------------------- bodies

    def _disc(self, mass: float, radius: float, row: Floats, *, load: bool = False) -> pymunk.Body:
        body = pymunk.Body(mass, pymunk.moment_for_circle(mass, 0.0, radius))
        body.position = (float(row[0]), float(row[1]))
        body.angle = float(row[2])
        shape = pymunk.Circle(body, radius)
        shape.friction = shape.elasticity = 0.0
        bumps = _LOAD | _WALL | (_AGENT if load or self._sizes.contact else 0)
        shape.filter = pymunk.ShapeFilter(categories=_LOAD if load else _AGENT, mask=bumps)
        self._space.add(body, shape)
        return body

    def _motor(self, agent: pymunk.Body) -> pymunk.PivotJoint:
        """What drives an agent; only the velocity of its first body matters."""
        wish = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
        motor = pymunk.PivotJoint(wish, agent, (0.0, 0.0), (0.0, 0.0))
        motor.max_bias, motor.max_force = 0.0, self._sizes.pull
        self._space.add(wish, motor)
        return motor

    def _lay_down(self, load: pymunk.Body, needed: float) -> None:
        """Let a load stick to the ground."""
        ground = self._space.static_body
        slide = pymunk.PivotJoint(ground, load, (0.0, 0.0), (0.0, 0.0))
        turn = pymunk.GearJoint(ground, load, 0.0, 1.0)
        slide.max_bias = turn.max_bias = 0.0
        slide.max_force = (needed - self._sizes.reserve) * self._sizes.pull
        turn.max_force = slide.max_force * self._sizes.load_radius * 2.0 / 3.0
        self._space.add(slide, turn)

    # ---------------------------------------------------------------------------------------- changing them

    def attach(self, held: Wholes) -> None:
        """Let agents hang on these loads, where they are now."""
        for agent in np.flatnonzero(held != self._held):
            if (pivot := self._pivots[agent]) is not None:
                self._space.remove(pivot)
                self._pivots[agent] = None
            if held[agent] >= 0:
                body = self._agents[agent]
                pivot = pymunk.PivotJoint(body, self._loads[held[agent]], body.position)
                pivot.collide_bodies, pivot.error_bias = False, STRETCH_LEFT
                self._pivots[agent] = pivot
                self._space.add(pivot)
        self._held = held

    def power(self, powered: Any) -> None:
        """Let these agents have their force, and the others none."""
        for agent in np.flatnonzero(powered != self._powered):
            self._motors[agent].max_force = self._sizes.pull if powered[agent] else 0.0
        self._powered = powered

    # ---------------------------------------------------------------------------------------------- passing

    def step(self) -> None:
        """Pass a tick: velocities follow from forces, then positions from velocities.

        pymunk moves bodies first, by the velocities of the tick before; so it is given the places from which these lead
        to where the bodies are.
        """
        bodies = len(self._agents) + len(self._loads)
        self.state[:bodies, 0:3] -= self.state[:bodies, 3:6]
        self._out[self._rows] = self.state
        batch.set_space_bodies(self._space, FIELDS, self._writer)
        self._space.step(1.0)
        self._space.iterations = ITERATIONS
        self._reader.clear()
        batch.get_space_bodies(self._space, FIELDS, self._reader)
        self.state[:] = self._in[self._rows]
        self.state[:bodies, 0:3] += self.state[:bodies, 3:6]


def _empty(sizes: Sizes) -> pymunk.Space:
    """The walls."""
    space = pymunk.Space()
    space.iterations = FIRST_ITERATIONS
    space.collision_bias = OVERLAP_LEFT
    space.collision_slop = SLOP_SHARE * sizes.agent_radius
    thick = 4.0 * max(sizes.load_radius, sizes.agent_radius)
    w, h, t = sizes.width, sizes.height, thick
    ends = (
        ((-t, -t), (-t, h + t)),
        ((w + t, -t), (w + t, h + t)),
        ((-t, -t), (w + t, -t)),
        ((-t, h + t), (w + t, h + t)),
    )
    for a, b in ends:
        wall = pymunk.Segment(space.static_body, a, b, thick)
        wall.filter = pymunk.ShapeFilter(categories=_WALL)
        space.add(wall)
    return space
