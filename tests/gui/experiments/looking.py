"""What a researcher sees of the window of experiments, and how little he asks for."""

from app.editor.experiments.window import ExperimentsWindow
from app.engine.experiments.laboratory import Stage

#: More runs of each arm than any machine makes while a test looks on.
MANY = 100_000


def told(window: ExperimentsWindow, words: str) -> bool:
    return words in window.controls.told.text()


def finished(window: ExperimentsWindow) -> bool:
    look = window.running.look
    return look is not None and look.stage is Stage.FINISHED


def made(window: ExperimentsWindow) -> list[tuple[int, int, float]]:
    """The runs that there are, with how long each took: a run that is made again takes another time."""
    assert window.kept is not None
    return [(row.cell, row.run, row.seconds) for row in window.kept.rows]


def small(window: ExperimentsWindow, name: str = "figure3", runs: int = 2) -> None:
    """Ask for so little that it takes no time."""
    window.listing.choose(name)
    window.controls.ticks.setValue(200)
    window.controls.runs.setValue(runs)
