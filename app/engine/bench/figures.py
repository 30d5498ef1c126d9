"""What is measured, as values: a measure with its goal, and the figure that came of it."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from .subject import Subject

#: Measures one thing, in the unit of its measure.
Take = Callable[[Subject], float]


class Better(StrEnum):
    """Which way a figure should go."""

    HIGHER = "higher"
    LOWER = "lower"


@dataclass(frozen=True, slots=True)
class Measure:
    """Something that can be measured.

    Attributes:
        goal: What is to be reached, in *unit*; reaching it just so is enough.
        long: It takes so long that it is measured only on demand.
    """

    name: str
    take: Take
    unit: str
    goal: float
    better: Better
    long: bool = False


@dataclass(frozen=True, slots=True)
class Figure:
    """What was measured."""

    measure: Measure
    value: float

    @property
    def holds(self) -> bool:
        """Whether the goal is reached."""
        if self.measure.better is Better.HIGHER:
            return self.value >= self.measure.goal
        return self.value <= self.measure.goal


def document(figure: Figure) -> Mapping[str, Any]:
    """The figure for programs."""
    measure = figure.measure
    return {
        "name": measure.name,
        "value": figure.value,
        "unit": measure.unit,
        "goal": measure.goal,
        "better": measure.better.value,
        "holds": figure.holds,
    }
