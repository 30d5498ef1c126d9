"""A pymunk space built from a world's columns.

* An agent is a disc that drives: a bounded force, its pull, brings it to the velocity that it wants within one tick. Nothing
  turns agents but themselves: contact is smooth.
* A load is a disc, as heavy as the agents that it needs, held to the ground by joints of bounded force, which are its
  friction: against sliding (needed - reserve) pulls, against turning 2/3 of the radius times that, as of a disc that
  presses evenly on the ground.
* An attached agent hangs on a pivot at its center, and its pull is in a joint too, so that it goes through the pivot at its
  full strength. While it does not drive, it is carried without resisting.
"""

from dataclasses import dataclass
from math import cos, inf, sin

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
Flags = NDArray[np.bool_]


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
    """Agents, then loads, then for each agent a body that moves as it wants to."""

    def __init__(self, sizes: Sizes, state: Floats, needed: Wholes, held: Wholes, powered: Flags) -> None:
        """Build it.

        Args:
            state: Rows for agents and loads, see `WIDTH`.
            needed: For each load.
            held: For each agent, the number of its load among the loads, or -1.
            powered: For each agent, whether it drives.
        """
        self._sizes = sizes
        self._space = _empty(sizes)
        agents = sizes.agents
        self._agents = [self._disc(AGENT_MASS, sizes.agent_radius, row) for row in state[:agents]]
        self._loads = [
            self._disc(MASS_NEEDED * max(1.0, float(n)), sizes.load_radius, row, load=True)
            for n, row in zip(needed, state[agents:], strict=True)
        ]
        for load, n in zip(self._loads, needed, strict=True):
            self._lay_down(load, float(n))
        self._wishes = [pymunk.Body(body_type=pymunk.Body.KINEMATIC) for _ in self._agents]
        self._space.add(*self._wishes)
        self._hanging: dict[int, tuple[pymunk.PivotJoint, pymunk.PivotJoint]] = {}
        self._held, self._powered = np.full(agents, -1, np.int64), np.zeros(agents, bool)
        self.attach(state, held, powered)

    # ---------------------------------------------------------------------------------------------- bodies

    def _disc(self, mass: float, radius: float, row: Floats, *, load: bool = False) -> pymunk.Body:
        moment = pymunk.moment_for_circle(mass, 0.0, radius) if load and radius > 0.0 else inf
        body = pymunk.Body(mass, moment)
        body.position = (float(row[0]), float(row[1]))
        body.angle = float(row[2])
        shape = pymunk.Circle(body, radius)
        shape.friction = shape.elasticity = 0.0
        bumps = _LOAD | _WALL | (_AGENT if load or self._sizes.contact else 0)
        shape.filter = pymunk.ShapeFilter(categories=_LOAD if load else _AGENT, mask=bumps)
        self._space.add(body, shape)
        return body

    def _lay_down(self, load: pymunk.Body, needed: float) -> None:
        """Let a load stick to the ground."""
        ground = self._space.static_body
        slide = pymunk.PivotJoint(ground, load, (0.0, 0.0), (0.0, 0.0))
        turn = pymunk.GearJoint(ground, load, 0.0, 1.0)
        slide.max_bias = turn.max_bias = 0.0
        slide.max_force = max(0.0, needed - self._sizes.reserve) * self._sizes.pull
        turn.max_force = slide.max_force * self._sizes.load_radius * 2.0 / 3.0
        self._space.add(slide, turn)

    # ---------------------------------------------------------------------------------------- changing them

    def attach(self, state: Floats, held: Wholes, powered: Flags) -> None:
        """Let agents hang on these loads, where they are now, and pull if they are powered."""
        for agent in np.flatnonzero(held != self._held).tolist():
            if agent in self._hanging:
                self._space.remove(*self._hanging.pop(agent))
            if held[agent] >= 0:
                self._hanging[agent] = self._hang(agent, int(held[agent]), state)
                self._powered[agent] = False
        for agent in np.flatnonzero((powered != self._powered) & (held >= 0)).tolist():
            self._hanging[agent][1].max_force = self._sizes.pull if powered[agent] else 0.0
        self._held, self._powered = held, powered

    def _hang(self, agent: int, load: int, state: Floats) -> tuple[pymunk.PivotJoint, pymunk.PivotJoint]:
        """The pivot between an agent and its load, and the motor that pulls, switched off."""
        body = self._agents[agent]
        place = _seen_from(state[self._sizes.agents + load], state[agent])
        pivot = pymunk.PivotJoint(body, self._loads[load], (0.0, 0.0), place)
        pivot.collide_bodies, pivot.error_bias = False, STRETCH_LEFT
        motor = pymunk.PivotJoint(self._wishes[agent], body, (0.0, 0.0), (0.0, 0.0))
        motor.max_bias = motor.max_force = 0.0
        self._space.add(pivot, motor)
        return pivot, motor

    # ---------------------------------------------------------------------------------------------- passing

    def step(self, exchange: "Exchange") -> None:
        """Pass a tick: velocities follow from forces, then positions from velocities.

        pymunk moves bodies first, by the velocities that they have; so it is given the places from which these lead to where
        the bodies are.
        """
        state = exchange.state
        state[:, 0:3] -= state[:, 3:6]
        exchange.put(self._space)
        self._space.step(1.0)
        self._space.iterations = ITERATIONS
        exchange.get(self._space)
        state[:, 0:3] += state[:, 3:6]


class Exchange:
    """What goes into a space and comes out of it, through batch calls, which take the bodies as they were added.

    It outlives its spaces: pymunk does not free what belongs to a buffer.

    Attributes:
        state: A row for each agent and load, see `WIDTH`; `Space.step` takes it to the next tick.
        wishes: For each agent the velocity that it wants, along x and y.
    """

    def __init__(self, sizes: Sizes) -> None:
        bodies = sizes.agents + sizes.loads
        everyone = bodies + sizes.agents + 1  # with the ground
        self._out = np.zeros((everyone, WIDTH))
        # With room to spare: pymunk must not enlarge what is not its own.
        self._in = np.zeros((everyone + 1, WIDTH))
        self._writer, self._reader = batch.Buffer(), batch.Buffer()
        self._writer.set_float_buf(self._out)
        self._reader.set_float_buf(self._in)
        self.state, self._after = self._out[:bodies], self._in[:bodies]
        self.wishes = self._out[bodies : bodies + sizes.agents, 3:5]

    def put(self, space: pymunk.Space) -> None:
        """Give the bodies their states and wishes."""
        batch.set_space_bodies(space, FIELDS, self._writer)

    def get(self, space: pymunk.Space) -> None:
        """Take the states of agents and loads."""
        self._reader.clear()
        batch.get_space_bodies(space, FIELDS, self._reader)
        self.state[:] = self._after


def _seen_from(load: Floats, agent: Floats) -> tuple[float, float]:
    """Where an agent is in the frame of a load."""
    dx, dy, angle = float(agent[0] - load[0]), float(agent[1] - load[1]), float(load[2])
    return cos(angle) * dx + sin(angle) * dy, cos(angle) * dy - sin(angle) * dx


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
