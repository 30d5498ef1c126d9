"""What is measured: the shipped foraging project, the forager of the yardstick, and the program as a command."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from ...core.errors import UnderstudyError
from ...core.project import Project, Value
from ...core.storage import load
from ...sim.scenario import Scenario
from ..runs import Treatment, treatment
from ..scenarios import open_scenario

#: The clock of all timings, in seconds.
Clock = Callable[[], float]


class UnmeasurableError(UnderstudyError):
    """A figure cannot be had on this machine; the message says why."""


@dataclass(frozen=True, slots=True)
class Program:
    """How Understudy is called in a process of its own.

    Attributes:
        words: Without arguments.
        environment: Variables that it needs besides those that this process has.
    """

    words: Sequence[str]
    environment: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Subject:
    """Everything that measures work on.

    Attributes:
        folder: Of the foraging project.
        project: What is stored there.
        forager: The project that the loop written by hand does the same as.
        cores: How many there are to run on.
        shrink: Divides how much is done, so that tests need not wait; figures mean something only with 1.
        full: Whether what can be done for longer is done for as long as its goal says.
    """

    folder: Path
    project: Project
    forager: Project
    scenario: Scenario
    program: Program
    cores: int
    clock: Clock
    shrink: int = 1
    full: bool = False

    def much(self, count: int) -> int:
        """*count*, shrunk."""
        return max(1, count // self.shrink)

    def arm(self, name: str, project: Project | None = None, **settings: Value) -> Treatment:
        """An arm made ready to run."""
        of = self.project if project is None else project
        return treatment(of, self.scenario, of.arm(name), settings)


def subject(
    folder: Path, forager: Path, program: Program, cores: int, clock: Clock, *, full: bool = False
) -> Subject:
    """What there is in these folders, to be measured in its full size.

    Raises:
        UnderstudyError: One of them holds no project.
    """
    project = load(folder)
    return Subject(folder, project, load(forager), open_scenario(project), program, cores, clock, full=full)
