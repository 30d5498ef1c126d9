"""A forager that looks at all there is to be put into words, and tests of directions in degrees."""

from math import pi

from app.core.automaton import Automaton
from app.core.conditions import Condition, InArc
from app.core.features import (
    FeatureUse,
    FlagUp,
    Ground,
    Operation,
    Over,
    Parameter,
    Sense,
    Source,
    Statistic,
    TicksInState,
)
from app.core.vocabulary import DONE, FAILED, FINISHED
from app.core.wording import Speech
from app.sim.scenarios.foraging import scenario as foraging

FORAGING = foraging.vocabulary
BOX = {"target": Ground("nearest visible box")}
DEPOSIT = {"target": Ground("deposit")}
OPEN = {"target": Parameter("X")}
EXPLAINED = Speech(clause=True, group="Group 3", held="Goto", targets={"X": "deposit"}, detailed=True)

SOURCES: dict[str, Source] = {
    "sees": Sense("ICanSeeABox"),
    "box": Sense("DistanceTo", BOX),
    "away": Sense("DistanceTo", DEPOSIT),
    "x": Sense("DistanceTo", OPEN),
    "toward": Sense("DirectionTo", DEPOSIT),
    "ahead": Sense("DirectionTo", BOX),
    "full": Sense("MyBoxMoves"),
    "help": Sense("SomeoneNeedsHelp"),
    "done": FlagUp(DONE),
    "failed": FlagUp(FAILED),
    "odd": FlagUp("odd"),
    "ticks": TicksInState(),
    "any": Statistic(Operation.ANY, Sense("IAmAttachedToABox")),
    "all": Statistic(Operation.ALL, Sense("IAmAttachedToABox")),
    "full one": Statistic(Operation.ANY, Sense("MyBoxMoves")),
    "count": Statistic(Operation.COUNT, Sense("ICanSeeABox")),
    "direct": Statistic(Operation.ANY, FlagUp(FINISHED), Over.SUBSIDIARIES),
    "all done": Statistic(Operation.ALL, FlagUp(DONE), Over.SUBSIDIARIES),
    "mean": Statistic(Operation.MEAN, Sense("DistanceTo", DEPOSIT)),
    "share": Statistic(Operation.MEAN, Sense("ICanSeeABox")),
    "min": Statistic(Operation.MIN, Sense("DistanceTo", DEPOSIT)),
    "max": Statistic(Operation.MAX, Sense("DistanceTo", DEPOSIT)),
    "gone": Sense("Gone"),
}
FORAGER = Automaton("f", "F", features=tuple(FeatureUse(i, source) for i, source in SOURCES.items()))


def arc(feature: str, start: float, end: float, *, wanted: bool = True) -> Condition:
    return Condition(InArc(feature, pi * start / 180.0, pi * end / 180.0), wanted)
