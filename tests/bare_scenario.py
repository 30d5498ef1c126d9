"""Scenarios of next to nothing, to put one bad function into."""

from dataclasses import dataclass
from typing import Any

from app.sim.scenario import FeatureKind, Scenario, World, quantity


@dataclass(frozen=True, slots=True)
class Parameters:
    count: int = quantity(1, "", 0, 9)


def reset(world: World) -> None:
    """Leave all as it is."""


def empty(**fields: Any) -> Scenario:
    """A scenario in which there is nothing."""
    scenario = Scenario("test", "Test", Parameters, **fields)
    scenario.reset(reset)
    return scenario


def one_feature(function: Any, kind: FeatureKind = FeatureKind.CONTINUOUS, **fields: Any) -> Scenario:
    """A scenario with a feature F."""
    scenario = empty(**fields)
    scenario.feature("F", kind)(function)
    return scenario
