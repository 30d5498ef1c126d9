"""A forager authored by hand for the foraging scenario, and worlds to run it in: alone, in groups, in squads of groups."""

from collections.abc import Mapping
from typing import Any

from app.core.automaton import START, Automaton, Rule
from app.core.conditions import AtMost, Condition, Equals, Guard, InArc
from app.core.features import (
    Bindings,
    FeatureUse,
    FlagUp,
    Ground,
    Operation,
    Parameter,
    Sense,
    Statistic,
    TicksInState,
)
from app.core.hierarchy import Hierarchy, from_table
from app.core.library import Library, Types
from app.core.vocabulary import DONE, FAILED, FINISHED
from app.sim.engine import Start
from app.sim.scenario import Scenario
from app.sim.scenarios.foraging import scenario as foraging
from tests.samples import AGENT, GROUP, SQUAD, TYPES, automaton, flag, nested, state

BOX, DEPOSIT = "nearest visible box", "deposit"
CLOSEST, BIGGEST = "closest attached agent", "biggest attached agent"


def yes(feature: str) -> Condition:
    return Condition(Equals(feature, 1.0))


def no(feature: str) -> Condition:
    return Condition(Equals(feature, 1.0), wanted=False)


def within(feature: str, threshold: float) -> Condition:
    return Condition(AtMost(feature, threshold))


def beyond(feature: str, threshold: float) -> Condition:
    return Condition(AtMost(feature, threshold), wanted=False)


def to(target: str) -> Bindings:
    return {"target": Ground(target)}


def rules(*listed: tuple[str, Guard, str] | tuple[str, Guard, str, float]) -> tuple[Rule, ...]:
    """Rules in order: source, guard, target and, where it is not certain, probability."""
    return tuple(Rule(str(number), *rule) for number, rule in enumerate(listed, 1))


def wander() -> Automaton:
    return automaton(
        "Wander",
        state("forward", "Forward"),
        state("left", "RotateLeft"),
        state("right", "RotateRight"),
        rules=rules(
            (START, (), "forward"),
            ("forward", (), "left", 0.02),
            ("forward", (), "right", 0.02),
            ("left", (), "forward", 0.1),
            ("right", (), "forward", 0.1),
        ),
    )


def goto() -> Automaton:
    """Turns until the target lies ahead, and walks."""
    ahead, left = Condition(InArc("direction", -0.05, 0.05)), Condition(InArc("direction", 0.0, -3.14159))
    target = {"target": Parameter("target")}
    return automaton(
        "Goto",
        state("forward", "Forward"),
        state("left", "RotateLeft"),
        state("right", "RotateRight"),
        parameters=("target",),
        features=(FeatureUse("direction", Sense("DirectionTo", target)),),
        rules=tuple(
            rule
            for source in (START, "forward", "left", "right")
            for rule in rules((source, (ahead,), "forward"), (source, (left,), "left"), (source, (), "right"))
        ),
    )


def return_with_box() -> Automaton:
    """Goes to the box it sees, grabs it and pulls it home; done without the box, failed where it sees none."""
    return automaton(
        "ReturnWithBox",
        nested("approach", "Goto", to(BOX)),
        state("grab", "GrabBox"),
        nested("home", "Goto", to(DEPOSIT)),
        state("release", "ReleaseBoxAndFinish"),
        flag("lost", FAILED),
        features=(
            FeatureUse("sees", Sense("ICanSeeABox")),
            FeatureUse("attached", Sense("IAmAttachedToABox")),
            FeatureUse("box", Sense("DistanceTo", to(BOX))),
        ),
        rules=rules(
            (START, (yes("attached"),), "home"),
            (START, (), "approach"),
            ("approach", (no("sees"),), "lost"),
            ("approach", (within("box", 4.5),), "grab"),
            ("grab", (yes("attached"),), "home"),
            ("grab", (), "approach"),
            ("home", (no("attached"),), "release"),
        ),
    )


def forage() -> Automaton:
    return automaton(
        "Forage",
        nested("wander", "Wander"),
        nested("return", "ReturnWithBox"),
        features=(
            FeatureUse("sees", Sense("ICanSeeABox")),
            FeatureUse("attached", Sense("IAmAttachedToABox")),
            FeatureUse("done", FlagUp(DONE)),
            FeatureUse("failed", FlagUp(FAILED)),
        ),
        rules=rules(
            (START, (), "wander"),
            ("wander", (yes("sees"),), "return"),
            ("wander", (yes("attached"),), "return"),
            ("return", (yes("done"),), "wander"),
            ("return", (yes("failed"),), "wander"),
        ),
    )


def release() -> Automaton:
    """Lets go, as a behavior that any controller can direct."""
    return automaton("Release", state("release", "ReleaseBox"), rules=rules((START, (), "release")))


def _control(name: str, search: str, target: str, called_by: Statistic | Sense) -> Automaton:
    """Lets all search until someone calls, gathers them there, has them pull, and lets them go once one is finished."""
    return automaton(
        name,
        state("search", search),
        state("gather", "Goto", to(target)),
        state("pull", "ReturnWithBox"),
        state("let go", "Release"),
        features=(
            FeatureUse("called", called_by),
            FeatureUse("finished", Statistic(Operation.ANY, FlagUp(FINISHED))),
            FeatureUse("there", Statistic(Operation.ALL, Sense("ICanSeeABox"))),
            FeatureUse("ticks", TicksInState()),
        ),
        rules=rules(
            (START, (), "search"),
            ("search", (yes("called"),), "gather"),
            ("gather", (yes("there"),), "pull"),
            ("gather", (beyond("ticks", 400.0),), "pull"),
            ("pull", (yes("finished"),), "let go"),
            ("pull", (beyond("ticks", 2000.0),), "let go"),
            ("let go", (beyond("ticks", 2.0),), "search"),
        ),
    )


def control_forage() -> Automaton:
    attached = Statistic(Operation.ANY, Sense("IAmAttachedToABox"))
    return _control("ControlForage", "Forage", CLOSEST, attached)


def control_forage_2() -> Automaton:
    return _control("ControlForage2", "ControlForage", BIGGEST, Sense("SomeoneNeedsHelp"))


def library(*automata: Automaton) -> Library:
    return Library({a.id: a for a in automata})


def libraries() -> Mapping[str, Library]:
    return {
        AGENT: library(wander(), goto(), return_with_box(), forage(), release()),
        GROUP: library(control_forage()),
        SQUAD: library(control_forage_2()),
    }


def types(scenario: Scenario = foraging, made: Mapping[str, Library] | None = None) -> Types:
    return Types(TYPES, libraries() if made is None else made, scenario.vocabulary)


def alone(agents: int = 1) -> Hierarchy:
    return from_table((agents,), (AGENT,))


def groups(count: int = 10, agents: int = 5) -> Hierarchy:
    return from_table((count, agents), (GROUP, AGENT))


def squads(count: int = 2, held: int = 5, agents: int = 5) -> Hierarchy:
    return from_table((count, held, agents), (SQUAD, GROUP, AGENT))


#: Name -> forest and what its roots do: the three structures of the paper's figure 1.
STRUCTURES: Mapping[str, tuple[Hierarchy, str]] = {
    "independent": (alone(50), "Forage"),
    "one level": (groups(), "ControlForage"),
    "two levels": (squads(), "ControlForage2"),
}


def start(
    hierarchy: Hierarchy | None = None,
    top: str = "",
    seed: int = 1,
    world: int = 0,
    **parameters: Any,
) -> Start:
    """A foraging world of authored foragers."""
    forest = alone() if hierarchy is None else hierarchy
    return Start(foraging, foraging.settle(parameters), forest, types(), seed, world, top)


#: The same with fewer agents, to run in `BUSY` worlds.
SMALL: Mapping[str, tuple[Hierarchy, str]] = {
    "independent": (alone(12), "Forage"),
    "one level": (groups(3, 4), "ControlForage"),
    "two levels": (squads(2, 2, 3), "ControlForage2"),
}
#: A world so small and full that everything happens within some hundred ticks.
BUSY: dict[str, Any] = {
    "width": 40.0,
    "height": 40.0,
    "deposit_x": 20.0,
    "deposit_y": 20.0,
    "boxes": 6,
    "pullers": 2,
    "big_boxes": 1,
    "big_pullers": 5,
    "step": 0.4,
}


def busy(structure: str = "independent", seed: int = 1, **more: Any) -> Start:
    """A few foragers in a busy world."""
    forest, top = SMALL[structure]
    return start(forest, top, seed, **{**BUSY, **more})
