"""The studio's figures by groups, each of which is measured in one process."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from ...core.project import Project
from ...core.storage import load
from . import automata, canvas, experiments, keys, library, pace, session
from .heartbeat import percentile
from .stage import stage

#: Seconds that the scripted session takes in full, and otherwise.
FULL, SHORT = 600.0, 20.0


@dataclass(frozen=True, slots=True)
class Order:
    """What is to be measured on.

    Attributes:
        folder: Of the foraging project.
        shrink: Divides how much is done, so that tests need not wait.
        full: Take as long as it takes.
    """

    folder: Path
    shrink: int = 1
    full: bool = False

    @property
    def project(self) -> Project:
        """What is stored there."""
        return load(self.folder)

    def much(self, count: int, least: int = 1) -> int:
        """*count*, shrunk."""
        return max(least, count // self.shrink)


Figures = Mapping[str, float]


def frames(order: Order) -> Figures:
    """How fast the canvas is."""
    few, many = order.much(3_125, 50), order.much(10_000, 50)
    return {"frames 3,125": canvas.canvas_frames(few), "frames 10,000": canvas.canvas_frames(many)}


def picks(order: Order) -> Figures:
    """From a key to an agent."""
    with stage() as shown:
        times = keys.seconds_to_obey(shown, order.project, order.much(keys.PRESSES, 2))
    return {"key": 1000.0 * percentile(times, 0.99)}


def rates(order: Order) -> Figures:
    """The engine under the window."""
    with stage() as shown:
        share = pace.share_of_headless(
            shown, order.project, order.much(pace.PAIRS), pace.SECONDS / order.shrink
        )
    return {"share": share}


def graphs(order: Order) -> Figures:
    """A large automaton."""
    with stage() as shown:
        arranged, edited = automata.of_large_automaton(shown, order.project, order.much(automata.TIMES))
    return {"arranged": arranged, "edited": 1000.0 * edited}


def projects(order: Order) -> Figures:
    """A large project."""
    behaviors, examples = order.much(library.BEHAVIORS, 3), order.much(library.EXAMPLES, 60)
    with stage() as shown:
        opened, slowest = library.of_large_project(shown, order.project, behaviors, examples)
    return {"opened": opened, "used": 1000.0 * slowest}


def stalls(order: Order) -> Figures:
    """How long the window could not answer."""
    seconds = (FULL if order.full else SHORT) / order.shrink
    with stage() as shown:
        late = session.lateness(shown, order.project, seconds, order.much(session.CROWD, 50))
    return {"longest": 1000.0 * max(late), "most": 1000.0 * percentile(late, 0.99)}


def runs(order: Order) -> Figures:
    """Many runs in the window of experiments."""
    seconds = None if order.full else experiments.SHORT / order.shrink
    with stage() as shown:
        late = experiments.lateness(shown, order.project, order.much(experiments.RUNS, 6), seconds)
    return {"longest": 1000.0 * max(late), "most": 1000.0 * percentile(late, 0.99)}


GROUPS: Mapping[str, Callable[[Order], Figures]] = {
    "frames": frames,
    "picks": picks,
    "rates": rates,
    "graphs": graphs,
    "projects": projects,
    "stalls": stalls,
    "runs": runs,
}
