"""Scenarios and models that an engine stumbles over, for tests of what it says then."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from app.core.automaton import START, Automaton, Basic, Rule, State
from app.core.automaton import Start as StartContent
from app.core.conditions import AtMost, Condition, Values
from app.core.features import FeatureUse, Ground, Sense
from app.core.library import Library, NodeType, Types
from app.core.transition import Classifier
from app.core.tree import Decision
from app.sim.engine import Start
from app.sim.scenario import Column, FeatureKind, Scenario, World, quantity
from tests import foragers

FAULTS = ("none", "division by zero", "nan", "nobody")


@dataclass(frozen=True, slots=True)
class Parameters:
    """What can be set."""

    fault: str = quantity("none", choices=FAULTS, doc="what goes wrong in tick 7")


@dataclass(frozen=True, slots=True)
class FairCoin:
    """A model without a table form: it goes on with either of two states."""

    labels: tuple[str, ...] = ("wander", "return")

    def decide(self, _values: Values) -> Decision:
        return Decision((0,), (0.5, 0.5))


def fair_coin(_type_name: str, automaton: Automaton, _state: str) -> Classifier | None:
    return FairCoin() if automaton.name == "Forage" else None


def undecided_start() -> Start:
    return foragers.start(foragers.alone(3), "Forage")


def _empty(name: str) -> Scenario:
    scenario = Scenario(name, name, Parameters, columns=(Column("count", whole=True, doc="a whole number"),))

    @scenario.reset
    def reset(world: World) -> None:
        """Leave all as it is."""

    return scenario


def uncompilable() -> Scenario:
    scenario = _empty("uncompilable")

    @scenario.behavior("Go")
    def go(world: World, me: int) -> None:
        """Put a fraction into a column of whole numbers."""
        world.count[me] = world.x[me] + 0.5

    return scenario


def unportable() -> Scenario:
    scenario = _empty("unportable")

    @scenario.behavior("Go")
    def go(world: World, me: int) -> None:
        """Raise to a power."""
        world.x[me] = world.x[me] ** 3

    return scenario


def failing() -> Scenario:
    """One whose functions fail in tick 7, each in its own way."""
    scenario = _empty("failing")

    @scenario.feature("Doubt", FeatureKind.CONTINUOUS, ("target",))
    def doubt(world: World, me: int, target: int) -> float:
        """No number in tick 7."""
        if world.params.fault == 2 and world.clock[2] == 7:
            return 1e308 * 10.0 - 1e308 * 10.0
        return 1.0

    @scenario.target("somebody")
    def somebody(world: World, first: int, end: int, me: int) -> int:
        """Nobody that there is in tick 7."""
        return 1000 if world.params.fault == 3 and world.clock[2] == 7 else me

    @scenario.behavior("Step")
    def step(world: World, me: int) -> None:
        """Divide by zero in tick 7."""
        if world.params.fault == 1:
            world.x[me] = 1.0 / (7 - world.clock[2])

    return scenario


def with_fault(start: Start, fault: str) -> Start:
    """A run in which agents step on, and doubt, until *fault* happens."""
    scenario = start.scenario
    target: Mapping[str, Ground] = {"target": Ground("somebody")}
    go = Automaton(
        "Go",
        "Go",
        states=(State(START, StartContent()), State("step", Basic("Step"))),
        features=(FeatureUse("doubt", Sense("Doubt", target)),),
        rules=(
            Rule("1", START, (), "step"),
            Rule("2", "step", (Condition(AtMost("doubt", 0.0)),), "step"),
        ),
    )
    types = Types((NodeType("agent"),), {"agent": Library({"Go": go})}, scenario.vocabulary)
    return replace(start, types=types, parameters=scenario.settle({"fault": fault}))
