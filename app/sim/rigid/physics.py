"""One tick of rigid physics on a world's columns."""

from typing import Any

import numpy as np

from ..bodies import Bodies
from ..geometry import wrapped
from ..motion import MOTION_COLUMNS, Arrays
from ..scenario import Scenario, World
from .space import AGENT_MASS, Sizes, Space

#: Every so many ticks the space is built anew, so that runs which begin at such a tick go on as the others do.
KEYFRAME = 120
_READ = ("clock", "x", "y", "heading", "drive", "turn", *(column.name for column in MOTION_COLUMNS))
_WRITTEN = ("x", "y", "heading", *(column.name for column in MOTION_COLUMNS))
_TICK = 2


class RigidPhysics:
    """The bodies of one world."""

    def __init__(self, scenario: Scenario, world: World) -> None:
        """Make bodies for a world of this shape; where they are is read from the columns of each step."""
        assert scenario.bodies is not None
        self._bodies = bodies = scenario.bodies
        self._sizes = sizes_of(bodies, world)
        self._first = int(getattr(world, f"first_{bodies.loads}"))
        loads = np.arange(self._first, self._first + self._sizes.loads)
        self._entities = np.concatenate([np.arange(self._sizes.agents), loads])
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
        agents, loads = self._sizes.agents, self._sizes.loads
        if agents + loads == 0:
            return
        self._turn(arrays)
        drive = arrays["drive"][:agents]
        held = arrays[self._bodies.held][:agents]
        held = np.where(held < 0, -1, held - self._first)
        powered = (held < 0) | (drive != 0.0)
        state = self._read(arrays)
        space = self._current(arrays, state, held, powered)
        space.state[: agents + loads] = state
        wishes = space.state[agents + loads :]
        heading = arrays["heading"][:agents]
        wishes[:, 3] = drive * np.cos(heading)
        wishes[:, 4] = drive * np.sin(heading)
        space.step()
        self._write(arrays, space.state)

    def _turn(self, arrays: Arrays) -> None:
        """Agents turn as they want to: nothing holds them."""
        turn, heading = arrays["turn"], arrays["heading"]
        for agent in np.flatnonzero(turn[: self._sizes.agents]).tolist():
            heading[agent] = wrapped(float(heading[agent]) + float(turn[agent]))

    def _read(self, arrays: Arrays) -> Any:
        """Where agents and loads are, and how they move; what was put somewhere else has stopped."""
        entities, agents = self._entities, self._sizes.agents
        state = np.empty((len(entities), 6))
        for place, name in enumerate(("x", "y", "heading", "velocity_x", "velocity_y", "spin")):
            state[:, place] = arrays[name][entities]
        state[:agents, 2] = 0.0
        put = (arrays["left_x"][entities] != state[:, 0]) | (arrays["left_y"][entities] != state[:, 1])
        if put.any():
            state[put, 3:] = 0.0
            self.forget()
        return state

    def _current(self, arrays: Arrays, state: Any, held: Any, powered: Any) -> Space:
        """The space, built anew if it is time to."""
        if self._space is None or arrays["clock"][_TICK] % KEYFRAME == 0:
            needed = arrays[self._bodies.needed][self._entities[self._sizes.agents :]]
            self._space = Space(self._sizes, state, needed, held, powered)
        else:
            self._space.attach(held)
            self._space.power(powered)
        return self._space

    def _write(self, arrays: Arrays, state: Any) -> None:
        """Put what came of it into the columns; nothing is outside of the walls."""
        sizes, entities = self._sizes, self._entities
        x = np.minimum(np.maximum(state[: len(entities), 0], 0.0), sizes.width)
        y = np.minimum(np.maximum(state[: len(entities), 1], 0.0), sizes.height)
        arrays["x"][entities] = arrays["left_x"][entities] = x
        arrays["y"][entities] = arrays["left_y"][entities] = y
        for place, name in ((3, "velocity_x"), (4, "velocity_y"), (5, "spin")):
            arrays[name][entities] = state[: len(entities), place]
        for row in range(sizes.agents, len(entities)):
            arrays["heading"][entities[row]] = wrapped(float(state[row, 2]))


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
