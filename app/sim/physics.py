"""Which physics there are, and what a run needs for the one that it asks for."""

from dataclasses import replace
from typing import Protocol

from ..core.errors import ScenarioError
from .engine import Start
from .motion import Arrays, with_motion
from .scenario import Scenario, World

KINEMATIC, RIGID = "kinematic", "rigid"
PHYSICS = (KINEMATIC, RIGID)


class Physics(Protocol):
    """Moves things in the place of a scenario's own kinematics."""

    def step(self, arrays: Arrays) -> None:
        """Pass the part of a tick between resolving and the after-tick rules."""

    def step_plain(self, world: World) -> None:
        """The same on columns that are lists."""

    def forget(self) -> None:
        """Take everything from the columns again: they come from another moment."""


def with_columns(start: Start) -> Start:
    """*start* with the columns that its physics needs on top of the scenario's.

    Raises:
        ScenarioError: There is no such physics, or not in this scenario.
    """
    scenario = in_physics(start.scenario, start.physics)
    return start if scenario is start.scenario else replace(start, scenario=scenario)


def in_physics(scenario: Scenario, physics: str) -> Scenario:
    """The scenario with the columns that *physics* needs on top of its own.

    Raises:
        ScenarioError: There is no such physics, or not in this scenario.
    """
    if physics not in PHYSICS:
        raise ScenarioError(f"there is no physics {physics!r}; there are: {', '.join(PHYSICS)}")
    return scenario if physics == KINEMATIC else with_motion(scenario)


def physics_of(start: Start, world: World) -> Physics | None:
    """What moves things in *world*; nothing where the scenario's own kinematics do."""
    if start.physics == KINEMATIC:
        return None
    from .rigid import RigidPhysics  # noqa: PLC0415 - only runs that need it pay for importing pymunk

    return RigidPhysics(start.scenario, world)
