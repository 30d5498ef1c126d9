"""One tick of rigid physics on a world's columns."""

import numpy as np

from ..bodies import Bodies
from ..geometry import wrapped
from ..motion import MOTION_COLUMNS, Arrays
from ..scenario import Scenario, World
from .space import AGENT_MASS, WIDTH, Exchange, Flags, Floats, Sizes, Space, Wholes

#: Every so many ticks the space is built anew, so that runs which begin at such a tick go on as the others do.
KEYFRAME = 240
_READ = ("clock", "x", "y", "heading", "drive", "turn", *(column.name for column in MOTION_COLUMNS))
_WRITTEN = ("x", "y", "heading", *(column.name for column in MOTION_COLUMNS))
_TICK, _TINY = 2, 1e-300


class RigidPhysics:
    """The bodies of one world."""

    def __init__(self, scenario: Scenario, world: World) -> None:
        """Make bodies for a world of this shape; where they are is read from the columns of each step."""
        assert scenario.bodies is not None
        self._bodies = bodies = scenario.bodies
        self._sizes = sizes = sizes_of(bodies, world)
        self._first = int(getattr(world, f"first_{bodies.loads}"))
        self._loads = slice(self._first, self._first + sizes.loads)
        self._entities = entities_of(sizes.agents, self._loads)
        self._exchange = Exchange(sizes)
        self._space: Space | None = None

    def forget(self) -> None:
        """Take everything from the columns again: they come from another moment."""
        self._space = None

    def step_plain(self, world: World) -> None:
        """Move the bodies of a world whose columns are lists."""
        names = (*_READ, self._bodies.held, self._bodies.needed)
        arrays = {name: np.array(getattr(world, name)) for name in names}
        self.step(arrays)
        for name in _WRITTEN:
            getattr(world, name)[:] = arrays[name].tolist()

    def step(self, arrays: Arrays) -> None:
        """Move the bodies: what agents want, contact, joints and friction decide where to."""
        agents = self._sizes.agents
        if agents + self._sizes.loads == 0:
            return
        self._turn(arrays)
        state = self._read(arrays)
        drive, heading = arrays["drive"][:agents], arrays["heading"][:agents]
        wishes = np.empty((agents, 2))
        np.multiply(drive, np.cos(heading), out=wishes[:, 0])
        np.multiply(drive, np.sin(heading), out=wishes[:, 1])
        held = arrays[self._bodies.held][:agents]
        self._drive(state, wishes, held < 0)
        space = self._current(arrays, state, np.where(held < 0, -1, held - self._first), drive != 0.0)
        self._exchange.state[:] = state
        self._exchange.wishes[:] = wishes
        space.step(self._exchange)
        self._write(arrays, self._exchange.state)

    def _drive(self, state: Floats, wishes: Floats, free: Flags) -> None:
        """Bring agents that hold nothing nearer to the velocities that they want, as far as their force goes."""
        velocity = state[: self._sizes.agents, 3:5]
        change = wishes - velocity
        size = np.sqrt(change[:, 0] * change[:, 0] + change[:, 1] * change[:, 1])
        most = self._sizes.pull / AGENT_MASS
        share = np.where(size > most, most / np.maximum(size, _TINY), 1.0) * free
        velocity += change * share[:, None]

    def _turn(self, arrays: Arrays) -> None:
        """Agents turn as they want to: nothing holds them."""
        turn, heading = arrays["turn"], arrays["heading"]
        for agent in np.flatnonzero(turn[: self._sizes.agents]).tolist():
            heading[agent] = wrapped(float(heading[agent]) + float(turn[agent]))

    def _read(self, arrays: Arrays) -> Floats:
        """Where agents and loads are, and how they move; what was put somewhere else has stopped."""
        entities, agents = self._entities, self._sizes.agents
        state = np.empty((agents + self._sizes.loads, WIDTH))
        for place, name in enumerate(("x", "y", "heading", "velocity_x", "velocity_y", "spin")):
            state[:, place] = arrays[name][entities]
        state[:agents, 2] = 0.0
        put = (arrays["left_x"][entities] != state[:, 0]) | (arrays["left_y"][entities] != state[:, 1])
        if put.any():
            state[put, 3:] = 0.0
            self.forget()
        return state

    def _current(self, arrays: Arrays, state: Floats, held: Wholes, powered: Flags) -> Space:
        """The space, built anew if it is time to."""
        if self._space is None or arrays["clock"][_TICK] % KEYFRAME == 0:
            needed = arrays[self._bodies.needed][self._loads].astype(np.int64)
            self._space = Space(self._sizes, state, needed, held, powered)
        else:
            self._space.attach(state, held, powered)
        return self._space

    def _write(self, arrays: Arrays, state: Floats) -> None:
        """Put what came of it into the columns; nothing is outside of the walls."""
        sizes, entities = self._sizes, self._entities
        arrays["x"][entities] = arrays["left_x"][entities] = _within(state[:, 0], sizes.width)
        arrays["y"][entities] = arrays["left_y"][entities] = _within(state[:, 1], sizes.height)
        for place, name in ((3, "velocity_x"), (4, "velocity_y"), (5, "spin")):
            arrays[name][entities] = state[:, place]
        arrays["heading"][self._loads] = [wrapped(angle) for angle in state[sizes.agents :, 2].tolist()]


def _within(places: Floats, high: float) -> Floats:
    return np.minimum(np.maximum(places, 0.0), high)


def entities_of(agents: int, loads: slice) -> slice | Wholes:
    """The entities that are bodies: agents come first in a world, and loads are the kind after them or a later one."""
    if loads.start == agents:
        return slice(0, loads.stop)
    return np.concatenate([np.arange(agents), np.arange(loads.start, loads.stop)])


def sizes_of(bodies: Bodies, world: World) -> Sizes:
    """What stays the same throughout a run."""

    def number(parameter: str) -> float:
        return float(getattr(world.params, parameter))

    return Sizes(
        agents=int(world.agents),
        loads=int(getattr(world, f"end_{bodies.loads}") - getattr(world, f"first_{bodies.loads}")),
        agent_radius=number(bodies.agent_diameter) / 2.0,
        load_radius=number(bodies.load_diameter) / 2.0,
        width=number(bodies.width),
        height=number(bodies.height),
        pull=AGENT_MASS * number(bodies.speed),
        reserve=number(bodies.reserve),
        contact=bool(getattr(world.params, bodies.contact)),
    )
