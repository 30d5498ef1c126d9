"""The columns of moving bodies: a rigid world is its scenario's world with these on top."""

from collections.abc import Mapping, Sequence
from copy import copy
from functools import cache

import numpy as np
from numpy.typing import NDArray

from ..core.errors import ScenarioError
from .columns import Column
from .scenario import Scenario
from .world import FrozenWorld

#: Column name -> its numbers, float64 or int64.
Arrays = Mapping[str, NDArray[np.float64] | NDArray[np.int64]]

MOTION_COLUMNS = (
    Column("velocity_x", doc="units per tick"),
    Column("velocity_y", doc="units per tick"),
    Column("spin", doc="how fast a load turns, radians per tick"),
    Column("left_x", doc="where physics left the entity; if it is elsewhere now, it was put there"),
    Column("left_y", doc="where physics left the entity; if it is elsewhere now, it was put there"),
)


@cache
def with_motion(scenario: Scenario) -> Scenario:
    """The scenario as it is in rigid worlds: with columns for motion and without kinematics.

    Raises:
        ScenarioError: It declares no bodies, or has a column with the name of one for motion.
    """
    if scenario.bodies is None:
        raise ScenarioError(
            f"scenario {scenario.name!r} declares no bodies, so its physics cannot be rigid; allowed: kinematic"
        )
    if set(MOTION_COLUMNS) <= set(scenario.columns):
        return scenario
    taken = {column.name for column in scenario.columns}
    if clash := [column.name for column in MOTION_COLUMNS if column.name in taken]:
        raise ScenarioError(
            f"scenario {scenario.name!r}: rigid worlds have a column {clash[0]!r} of their own"
        )
    moving = copy(scenario)
    moving.columns = (*scenario.columns, *MOTION_COLUMNS)
    moving.stages = {name: stage for name, stage in scenario.stages.items() if name != "kinematics"}
    return moving


def with_rest(frozen: Mapping[str, Sequence[float] | Sequence[int]]) -> FrozenWorld:
    """A stored world with its entities at rest if it comes from a kinematic run."""
    known = {name: tuple(values) for name, values in frozen.items()}
    rest = {"left_x": known.get("x", ()), "left_y": known.get("y", ())}
    still = (0.0,) * len(known.get("x", ()))
    return {**{column.name: rest.get(column.name, still) for column in MOTION_COLUMNS}, **known}
