"""How late the window's heartbeat comes while the window of experiments makes many runs, and while it shows them."""

from __future__ import annotations

from ...core.project import Project
from ...core.storage import save
from ...engine.experiments.keeping import save_experiment
from ...engine.experiments.laboratory import Stage as How
from ...engine.experiments.plan import Experiment, Treated
from .heartbeat import Heartbeat
from .stage import Stage, StageError

RUNS, TICKS = 1_000, 2_000
#: Seconds that runs are watched in short; otherwise all of them are.
SHORT = 4.0
#: Seconds that each page is looked at in the end.
LOOK = 0.2


def experiment(project: Project, runs: int, ticks: int) -> Experiment:
    """All arms of *project*, as often as it takes for so many runs at least."""
    arms = tuple(Treated(arm.name, arm.name) for arm in project.arms)
    return Experiment("many", "Many runs", arms, ticks, -(-runs // len(arms)))


def lateness(stage: Stage, project: Project, runs: int = RUNS, seconds: float | None = None) -> list[float]:
    """By how many seconds each beat came too late, from the wish to run until every page has been looked at.

    Args:
        seconds: Of the runs, after which they are cancelled; None makes all of them.
    """
    folder = stage.home / "project"
    save(project, folder)
    save_experiment(folder, experiment(project, runs, TICKS))
    stage.window.files.open(folder)
    stage.wait(lambda: stage.studio.is_open and stage.studio.snapshot is not None, "open")
    stage.wait(lambda: stage.snapshot.engine == "compiled", "compile")
    window = stage.window.experiments.show()
    stage.settle()
    heart = Heartbeat()
    window.begin()
    stage.wait(lambda: len(window.running.rows) > 0, "run")
    if seconds is not None:
        stage.run(seconds)
        window.running.cancel()
    stage.wait(lambda: not window.running.is_on, "end")
    stage.wait(lambda: not window.background.busy, "read")
    for page in range(window.pages.count()):
        window.pages.setCurrentIndex(page)
        stage.run(LOOK)
    heart.stop()
    look = window.running.look
    if look is None or look.stage is How.FAILED:
        raise StageError(f"the experiment did not get to its end: {window.controls.told.text()}")
    return heart.late
