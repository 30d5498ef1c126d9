"""From results of runs to figures: shaping only, no drawing."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ..core.project import Arm, Value
from ..editor.drawing.figures import Body, Figure, Series, Walker, WorldView
from ..engine.runs import RunResult
from ..sim.scenario import Scenario
from .wording import counted, number

#: Columns that a scenario may have, by what they say to a figure: what an agent holds, how many a thing needs and has.
HELD, NEEDED, GOT = "held", "needed", "pulling"


@dataclass(frozen=True, slots=True)
class Shown:
    """One arm in a figure.

    Attributes:
        parameters: All of the scenario's, as its runs had them.
    """

    arm: Arm
    parameters: Mapping[str, Value]
    results: tuple[RunResult, ...]


def figure_of_runs(
    title: str, subtitle: str, scenario: Scenario, arms: Sequence[Shown], measure: str = ""
) -> Figure:
    """A measure over time, a line an arm, and how the world of each arm's first run ended.

    Where an arm has several runs, they are faint lines behind their mean.

    Args:
        measure: The scenario's first one if it has none of this name.
    """
    measure = measure if measure in scenario.measures else next(iter(scenario.measures))
    series = [line for color, shown in enumerate(arms) for line in _lines(shown, measure, color, len(arms))]
    worlds = [_world(shown, measure, scenario, color) for color, shown in enumerate(arms)]
    return Figure(
        title, subtitle, "ticks", _meaning(scenario, measure), tuple(series), tuple(worlds), _legend(scenario)
    )


def structure(arm: Arm) -> str:
    """What the user says of an arm's structure, or what is counted: "50 agents, 10 controllers"."""
    if arm.note:
        return arm.note
    forest = arm.forest()
    agents, controllers = len(forest.agents()), len(forest.controllers())
    return counted(agents, "agent") + (f", {counted(controllers, 'controller')}" if controllers else "")


def mean_of(values: Sequence[float]) -> float:
    """The arithmetic mean."""
    return sum(values) / len(values)


def _lines(shown: Shown, measure: str, color: int, arms: int) -> list[Series]:
    curves = [result.curve for result in shown.results]
    x = tuple(float(tick) for tick in curves[0].ticks)
    runs = [curve.values[measure] for curve in curves]
    mean = tuple(mean_of(values) for values in zip(*runs, strict=True))
    faint = [Series("", color, x, run, faint=True) for run in runs] if len(runs) > 1 else []
    name = shown.arm.name if arms > 1 else ("mean" if len(runs) > 1 else measure)
    return [*faint, Series(f"{name}: {number(mean[-1])}", color, x, mean)]


def _meaning(scenario: Scenario, measure: str) -> str:
    """What a measure counts, in the words of its column."""
    docs = {column.name: column.doc for column in scenario.columns}
    return docs.get(scenario.measures[measure]) or measure


# -------------------------------------------------------------------------------------------------------- worlds


def _world(shown: Shown, measure: str, scenario: Scenario, color: int) -> WorldView:
    result = shown.results[0]
    amount = f"{number(result.measures[measure])} {measure}"
    caption = f"{structure(shown.arm)} · {amount}"
    if len(shown.results) > 1:
        caption += f" · seed {result.seed}"
    bodies, walkers = _bodies(shown, scenario), _walkers(shown)
    left, bottom, width, height = _extent(
        shown.parameters, [*((b.x, b.y) for b in bodies), *((w.x, w.y) for w in walkers)]
    )
    return WorldView(shown.arm.name, caption, color, left, bottom, width, height, walkers, bodies)


def _walkers(shown: Shown) -> tuple[Walker, ...]:
    world = shown.results[0].world
    held = world.get(HELD)
    return tuple(
        Walker(world["x"][i], world["y"][i], world["heading"][i], busy=held is not None and held[i] >= 0)
        for i in range(len(shown.arm.forest().agents()))
    )


def _bodies(shown: Shown, scenario: Scenario) -> tuple[Body, ...]:
    world, found = shown.results[0].world, list[Body]()
    first = len(shown.arm.forest().agents())
    nothing = (0,) * len(world["x"])
    needed, got = world.get(NEEDED, nothing), world.get(GOT, nothing)
    for kind in scenario.kinds:
        count = int(shown.parameters[kind.count]) if isinstance(kind.count, str) else kind.count
        radius, place = _size(kind.name, kind.radius, shown.parameters)
        found += [
            Body(world["x"][i], world["y"][i], radius, int(got[i]), int(needed[i]), place)
            for i in range(first, first + count)
        ]
        first += count
    return tuple(found)


def _size(kind: str, radius: str | float, parameters: Mapping[str, Value]) -> tuple[float, bool]:
    """The radius to draw, and whether it is a place: then the radius is its range.

    A scenario says it by the kind's radius, or by a parameter called KIND_diameter or KIND_range.
    """
    if f"{kind}_range" in parameters:
        return float(parameters[f"{kind}_range"]), True
    if f"{kind}_diameter" in parameters:
        return float(parameters[f"{kind}_diameter"]) / 2, False
    return float(parameters[radius] if isinstance(radius, str) else radius), False


def _extent(
    parameters: Mapping[str, Value], places: Sequence[tuple[float, float]]
) -> tuple[float, float, float, float]:
    """Left, bottom, width and height: the arena where the parameters tell it, else all there is to see."""
    if "width" in parameters and "height" in parameters:
        return 0.0, 0.0, float(parameters["width"]), float(parameters["height"])
    xs, ys = [x for x, _ in places] or [0.0], [y for _, y in places] or [0.0]
    left, bottom = min(xs) - 1.0, min(ys) - 1.0
    return left, bottom, max(xs) + 1.0 - left, max(ys) + 1.0 - bottom


def _legend(scenario: Scenario) -> dict[str, str]:
    """What the marks mean, as far as the scenario has them."""
    columns = {column.name for column in scenario.columns}
    places = [kind.name for kind in scenario.kinds if f"{kind.name}_range" in scenario.parameter_fields()]
    things = [kind.name for kind in scenario.kinds if kind.name not in places]
    legend = {"agent": "agent"}
    if HELD in columns and things:
        legend["busy"] = f"agent that holds a {things[0]}"
    for kind in scenario.kinds:
        if kind.name in places:
            legend["place"] = kind.name
        elif {NEEDED, GOT} <= columns:
            legend |= {"body": f"{kind.name} with too few agents", "full": f"{kind.name} with enough agents"}
        else:
            legend["body"] = kind.name
    return legend
