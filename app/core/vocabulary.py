"""What a node can do and see: basic behaviors, features and targets, by name.

A scenario declares the vocabulary of agents. The vocabulary of a controller type is derived from its subsidiaries
(see `app.core.library`).
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from math import pi
from typing import TypeVar

from .errors import ScenarioError

T = TypeVar("T")

#: What a target function returns when nothing answers to the target, and what an open slot holds.
NO_ENTITY = -1

#: Flags that every project knows; a user can name others.
DONE, FAILED, FINISHED = "done", "failed", "finished"
STANDARD_FLAGS = (DONE, FAILED)


class FeatureKind(StrEnum):
    """How values of a feature are compared."""

    CONTINUOUS = "continuous"
    BOOLEAN = "boolean"
    CATEGORICAL = "categorical"
    TOROIDAL = "toroidal"


@dataclass(frozen=True, slots=True)
class Phrases:
    """Short words for a feature, from which sentences are made: "sees a box", "farther than 8 from deposit".

    They go on from "it": with a verb ("sees a box"), or with what it is ("within 8 of deposit"); or they are a clause of
    their own ("its box is full", "{target} lies between {start} and {end}"). The names of target parameters stand for
    the targets.

    Attributes:
        true, false: For boolean features; for toroidal ones in and outside of an arc, from {start} to {end}; for
            categorical ones with or without the category {value}.
        above, below, between: For continuous features: above {value}, at most {value}, above {low} and at most {high}.
        at, not_at: The value itself, {value}; any other one, for toroidal features.
        some, none: That there is a target to the feature, or none; where its default is above all values with a target.
        detail: What explanations add to *true* and *false*: "that still needs pullers".
    """

    true: str = ""
    false: str = ""
    above: str = ""
    below: str = ""
    between: str = ""
    at: str = ""
    some: str = ""
    none: str = ""
    detail: str = ""
    not_at: str = ""


@dataclass(frozen=True, slots=True)
class Feature:
    """Something observable, always a float64.

    Booleans are 0 or 1, categories are their index, toroidal values lie in [-period/2, period/2).

    Attributes:
        parameters: Names of the target parameters, e.g. ``("target",)`` for DistanceTo.
        default: The value when a target has no referent.
        whose: ``agent`` features are sensed by an agent, ``group`` features by a controller.
    """

    name: str
    kind: FeatureKind
    parameters: tuple[str, ...] = ()
    default: float = 0.0
    categories: tuple[str, ...] = ()
    period: float = 2 * pi
    unit: str = ""
    phrases: Phrases = Phrases()
    doc: str = ""
    whose: str = "agent"


@dataclass(frozen=True, slots=True)
class BasicBehavior:
    """A hard-coded behavior.

    Attributes:
        one_shot: It is pulsed on entry only and idles while its state stays current.
        raises: The flag that it raises on the automaton that holds it, if any. A flag raiser runs once.
        finishes: It also raises `finished` on the agent itself.
        derived: It belongs to a controller: entering it directs the subsidiaries to start the behavior of this name.
    """

    name: str
    parameters: tuple[str, ...] = ()
    one_shot: bool = False
    raises: str | None = None
    finishes: bool = False
    derived: bool = False
    doc: str = ""

    @property
    def runs_once(self) -> bool:
        """Whether picking it records no continuation (paper, section 3.1)."""
        return self.one_shot or self.raises is not None


@dataclass(frozen=True, slots=True)
class Target:
    """A ground instance that a parameter can be bound to, e.g. "nearest visible box".

    Attributes:
        level: The lowest level of a node that can bind it: 0 for agents, 1 and up for controllers.
    """

    name: str
    level: int = 0
    doc: str = ""


@dataclass(frozen=True, slots=True)
class Vocabulary:
    """The basic behaviors, features and targets that the automata of one node type are made from."""

    level: int = 0
    behaviors: Mapping[str, BasicBehavior] = field(default_factory=dict)
    features: Mapping[str, Feature] = field(default_factory=dict)
    targets: Mapping[str, Target] = field(default_factory=dict)

    def behavior(self, name: str) -> BasicBehavior:
        """The basic behavior called *name*; `ScenarioError` names those that exist."""
        return _named(self.behaviors, name, "basic behavior")

    def feature(self, name: str) -> Feature:
        """The feature called *name*; `ScenarioError` names those that exist."""
        return _named(self.features, name, "feature")

    def target(self, name: str) -> Target:
        """The target called *name*; `ScenarioError` names those that exist."""
        return _named(self.targets, name, "target")


def _named(table: Mapping[str, T], name: str, what: str) -> T:
    if name not in table:
        raise ScenarioError(f"there is no {what} {name!r}; there are: {', '.join(sorted(table)) or 'none'}")
    return table[name]
