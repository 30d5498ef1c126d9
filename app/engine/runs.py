"""Headless runs of an arm: no one teaches, every node does what its behavior says."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

from ..core.errors import ParameterError
from ..core.machine import Classifiers, Leaving, stored_classifiers
from ..core.project import Arm, Project, Value
from ..sim.engine import Engine, Start
from ..sim.engines import AUTO, Notice, make_engine
from ..sim.scenario import Scenario
from ..sim.world import FrozenWorld
from .spells import Spells

#: A run is stalled if it made no progress in this last part of it.
STALLED_PART = 0.3
#: Told how many ticks have passed.
Progress = Callable[[int], None]
Cancelled = Callable[[], bool]


@dataclass(frozen=True, slots=True)
class Treatment:
    """An arm made ready to run: everything settled but the seed.

    Attributes:
        parameters: All of the scenario's parameters.
    """

    project: Project
    scenario: Scenario
    arm: Arm
    parameters: Mapping[str, Value]
    physics: str = "kinematic"
    classifiers: Classifiers = stored_classifiers
    engine: str = AUTO


@dataclass(frozen=True, slots=True)
class Curve:
    """Measures over time: ``values[name][k]`` after ``ticks[k]`` ticks."""

    ticks: tuple[int, ...]
    values: Mapping[str, tuple[float, ...]]


@dataclass(frozen=True, slots=True)
class RunResult:
    """What a run came to.

    Attributes:
        ticks: How many passed; fewer than asked for if it was cancelled.
        stalled: Nothing was achieved in its last 30%.
        world: How the world looked in the end.
    """

    seed: int
    ticks: int
    measures: Mapping[str, float]
    stalled: bool
    curve: Curve
    world: FrozenWorld = field(repr=False)


def treatment(
    project: Project,
    scenario: Scenario,
    arm: Arm,
    settings: Mapping[str, Value] | None = None,
    top: str | None = None,
    classifiers: Classifiers = stored_classifiers,
) -> Treatment:
    """Settle an arm's parameters.

    Args:
        settings: What the user set for these runs: ``world.NAME`` for parameters of the scenario, ``physics``, and
            ``engine``, see `app.sim.engines`.
        top: Another behavior for the roots than the arm's.

    Raises:
        ParameterError: A setting is unknown or out of its range.
    """
    world: dict[str, Value] = {}
    ours: dict[str, str] = {"physics": "kinematic", "engine": AUTO}
    for key, value in (settings or {}).items():
        if key.startswith("world."):
            world[key.removeprefix("world.")] = value
        elif key in ours:
            ours[key] = str(value)
        else:
            raise ParameterError(
                f"there is no setting {key!r}; there are: {', '.join(ours)}, world.NAME (see the scenario)"
            )
    parameters = scenario.settle({**project.parameters_of(arm), **world})
    arm = arm if top is None else replace(arm, top=top)
    return Treatment(project, scenario, arm, parameters, ours["physics"], classifiers, ours["engine"])


def start_engine(
    of: Treatment,
    seed: int,
    leaving: Leaving | None = None,
    *,
    idle: bool = False,
    notice: Notice | None = None,
) -> Engine:
    """A world of the treatment, its roots running the arm's top behavior unless *idle*.

    Args:
        leaving: Told of every change of state at the top of a node, before it happens.
        notice: Told in a few words what takes long, such as compiling.
    """
    types = of.project.types_with(of.scenario.vocabulary)
    top = "" if idle else of.arm.top
    start = Start(of.scenario, of.parameters, of.arm.forest(), types, seed, top=top, physics=of.physics)
    return make_engine(start, leaving, of.classifiers, of.engine, notice)


def run(
    of: Treatment,
    seed: int,
    ticks: int,
    points: int = 100,
    progress: Progress | None = None,
    cancelled: Cancelled | None = None,
) -> RunResult:
    """Run one world to the end.

    Args:
        points: Into how many equal slices the curve is cut; between them progress is told.
        cancelled: Asked several times a second whether to end.
    """
    engine = start_engine(of, seed)
    spells = Spells(engine, lambda: cancelled is None or not cancelled())
    at, samples = [0], [engine.measures()]
    for goal in slices(ticks, points):
        if not spells.until(goal):
            break
        at.append(engine.tick)
        samples.append(engine.measures())
        if progress is not None:
            progress(engine.tick)
    curve = Curve(tuple(at), {name: tuple(sample[name] for sample in samples) for name in samples[0]})
    stalled = engine.progressed < (1.0 - STALLED_PART) * engine.tick
    return RunResult(seed, engine.tick, engine.measures(), stalled, curve, engine.frozen_world())


def slices(ticks: int, points: int) -> tuple[int, ...]:
    """The ticks at which a run of *ticks* is sampled, the last included."""
    return tuple(sorted({round(ticks * k / points) for k in range(1, points + 1)} - {0}))
