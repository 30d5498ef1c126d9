"""Tests of one feature, shared by decision trees, authored rules and prunes."""

from collections.abc import Callable
from dataclasses import dataclass

#: Gives the value of a feature by its id within the automaton. Called only for features that are tested.
Values = Callable[[str], float]


@dataclass(frozen=True, slots=True)
class AtMost:
    """True where a continuous feature is at most *threshold*."""

    feature: str
    threshold: float

    def holds(self, value: float) -> bool:
        """Whether *value* passes."""
        return value <= self.threshold


@dataclass(frozen=True, slots=True)
class Equals:
    """True where a boolean (1.0 is true) or categorical feature (the category's index) has this value."""

    feature: str
    value: float

    def holds(self, value: float) -> bool:
        """Whether *value* passes."""
        return value == self.value


@dataclass(frozen=True, slots=True)
class InArc:
    """True where a toroidal feature lies in the arc that runs upward from *start* up to, not including, *end*.

    Both lie in [-period/2, period/2), as the values do; an arc with ``start > end`` runs through the seam. Equal ends
    make the empty arc.
    """

    feature: str
    start: float
    end: float

    def holds(self, value: float) -> bool:
        """Whether *value* passes."""
        if self.start <= self.end:
            return self.start <= value < self.end
        return value >= self.start or value < self.end


Test = AtMost | Equals | InArc


@dataclass(frozen=True, slots=True)
class Condition:
    """A test that must come out as *wanted*."""

    test: Test
    wanted: bool = True

    def met(self, values: Values) -> bool:
        """Whether the condition is met by the current *values*."""
        return self.test.holds(values(self.test.feature)) == self.wanted


#: A conjunction; the empty one is always met.
Guard = tuple[Condition, ...]


def guard_met(guard: Guard, values: Values) -> bool:
    """Whether every condition of *guard* is met."""
    return all(condition.met(values) for condition in guard)
