"""How much of the engine's speed is left while the window shows what it does."""

from statistics import median
from time import perf_counter

from ...core.project import Project
from ...engine.bench.rates import WARM_UP
from ...engine.commands import Pause, Play
from ...engine.runs import start_engine, treatment
from ...engine.scenarios import open_scenario
from .stage import Stage

#: Pairs of the two that are compared, and seconds that each takes.
PAIRS, SECONDS = 5, 0.8
SEED = 1


def share_of_headless(stage: Stage, project: Project, pairs: int = PAIRS, seconds: float = SECONDS) -> float:
    """The rate at full speed with the window open, over that of the same world without one; the median of pairs."""
    stage.open(project)
    stage.studio.bridge.send(Play(None))
    stage.wait(lambda: stage.snapshot.tick > WARM_UP, "warm up")
    engine = start_engine(treatment(project, open_scenario(project), project.arms[0]), SEED)
    engine.step(WARM_UP)
    shares = []
    for _ in range(pairs):
        shown = _shown(stage, seconds)
        stage.studio.bridge.send(Pause())
        stage.wait(lambda: stage.snapshot.speed == 0.0, "pause")
        stage.settle()
        ticks = max(1, int(shown * seconds))
        began = perf_counter()
        engine.step(ticks)
        shares.append(shown * (perf_counter() - began) / ticks)
        stage.studio.bridge.send(Play(None))
        stage.wait(lambda: stage.snapshot.speed is None, "play")
    return median(shares)


def _shown(stage: Stage, seconds: float) -> float:
    """Ticks a second with the window."""
    first, began = stage.snapshot.tick, perf_counter()
    stage.run(seconds)
    return (stage.snapshot.tick - first) / (perf_counter() - began)
