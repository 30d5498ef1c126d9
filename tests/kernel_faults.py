"""Scenarios and models that an engine stumbles over, for tests of what it says then."""

from collections.abc import Mapping
from dataclasses import dataclass

from app.core.automaton import START, Automaton, Basic, Rule, State
from app.core.automaton import Start as StartContent
from app.core.conditions import AtMost, Condition, Values
from app.core.features import FeatureUse, Ground, Sense
from app.core.hierarchy import from_table
from app.core.library import Library, NodeType, Types
from app.core.transition import Classifier
from app.core.tree import Decision
from app.sim.engine import Start
from app.sim.scenario import Column, Scenario, World
from tests import foragers
from tests.playground import scenario as playground


@dataclass(frozen=True, slots=True)
class Parameters:
    """Nothing can be set."""


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


def failing_start(fault: str) -> Start:
    """A run in the playground in which something goes wrong in tick 7."""
    target: Mapping[str, Ground] = {"target": Ground("somebody")}
    go = Automaton(
        "Go",
        "Go",
        states=(State(START, StartContent()), State("swing", Basic("Swing"))),
        features=(FeatureUse("doubt", Sense("Doubt", target)),),
        rules=(
            Rule("1", START, (), "swing"),
            Rule("2", "swing", (Condition(AtMost("doubt", 0.0)),), "swing"),
        ),
    )
    types = Types((NodeType("child"),), {"child": Library({"Go": go})}, playground.vocabulary)
    forest = from_table((3,), ("child",))
    return Start(playground, playground.settle({"fault": fault}), forest, types, 1, top="Go")
