"""What goes between a window and the process that makes its runs: an order, then words to it and looks from it."""

import pickle
from dataclasses import dataclass, replace
from enum import StrEnum
from pathlib import Path
from typing import IO, Any, Self

from ...core.errors import ScenarioError
from ...core.project import Project
from ...sim.scenario import Scenario
from ..scenarios import found_again, whereabouts
from .fingerprint import fingerprint_of_scenario
from .laboratory import Laboratory, Look
from .plan import Experiment
from .store import Row


@dataclass(frozen=True, slots=True)
class Order:
    """An experiment, in a form that can go to another process.

    Attributes:
        where: By which the scenario is found, see `whereabouts`.
        scenario: A hash of what the scenario is.
        path: Where the results are kept.
        jobs: Runs at a time.
    """

    project: Project
    where: tuple[str, str, str]
    scenario: str
    experiment: Experiment
    path: Path
    jobs: int

    @classmethod
    def of(cls, project: Project, scenario: Scenario, experiment: Experiment, path: Path, jobs: int) -> Self:
        """What to order; snapshots, which are large and which no run looks at, stay here."""
        lightened = replace(project, moments={})
        mark = fingerprint_of_scenario(scenario)
        return cls(lightened, whereabouts(scenario), mark, experiment, path.absolute(), jobs)

    def begin(self) -> Laboratory:
        """Carry it out, in threads of this process.

        Raises:
            ScenarioError: The scenario is not what it was when the order was given.
        """
        scenario = found_again(*self.where)
        if fingerprint_of_scenario(scenario) != self.scenario:
            raise ScenarioError(f"{self.where[-1]} has changed since it was opened; open the project again")
        return Laboratory(self.project, scenario, self.experiment, self.path, self.jobs)


class Word(StrEnum):
    """What is said to an experiment that runs."""

    PAUSE = "pause"
    RESUME = "resume"
    CANCEL = "cancel"


@dataclass(frozen=True, slots=True)
class Told:
    """A look on its way.

    Attributes:
        as_before: What was found is the same as in the look before, and left out.
        rows: The runs that have been added since then.
    """

    look: Look
    as_before: bool = False
    rows: tuple[Row, ...] = ()


def tell(stream: IO[bytes], told: Any) -> None:
    """Send something to the other side."""
    stream.write(pickle.dumps(told))
    stream.flush()


def heard(stream: IO[bytes]) -> Any:
    """What the other side sends next.

    Raises:
        EOFError: It is gone.
    """
    return pickle.load(stream)  # noqa: S301 - both sides are this program
