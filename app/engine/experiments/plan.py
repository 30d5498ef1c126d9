"""What an experiment compares, as frozen values: arms, factors, claims and figures."""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from itertools import product

from ...core.project import Value

#: What a setting is given: a parameter's value, or the sizes of a hierarchy's levels.
Given = Value | tuple[int, ...]
#: Setting -> value; which settings there are is told in `treatments`.
Settings = Mapping[str, Given]
#: Factor -> the name of one of its levels.
Levels = Mapping[str, str]


@dataclass(frozen=True, slots=True)
class Treated:
    """One arm of an experiment: an arm of the project, and what is different about it.

    Attributes:
        arm: The project's arm.
    """

    name: str
    arm: str
    settings: Settings = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Level:
    """One value of a factor."""

    name: str
    settings: Settings


@dataclass(frozen=True, slots=True)
class Factor:
    """Something that is varied in all arms; its first level is the usual one."""

    name: str
    levels: tuple[Level, ...]


class Design(StrEnum):
    """Which combinations of factors are run."""

    FACTORIAL = "factorial"
    ONE_AT_A_TIME = "one at a time"


@dataclass(frozen=True, slots=True)
class Reference:
    """A result from elsewhere to compare with: mean and standard deviation over so many runs."""

    name: str
    mean: float
    sd: float
    runs: int


#: One side of a comparison: an arm of the experiment, or a result from elsewhere.
Side = str | Reference


class Kind(StrEnum):
    """What a claim says about two sides."""

    GREATER = "greater"
    SAME = "same"
    NO_LESS = "no less"
    NEVER_STALLS = "never stalls"


@dataclass(frozen=True, slots=True)
class Claim:
    """Something that the results may bear out or not.

    Attributes:
        first, second: What is compared; `Kind.NEVER_STALLS` has no second.
        where: Only at these levels; elsewhere the claim says nothing.
    """

    text: str
    kind: Kind
    measure: str
    first: str
    second: Side = ""
    where: Levels = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Panel:
    """One chart of the figure.

    Attributes:
        x: ``ticks``, ``rows`` (a row a combination of levels), or a factor.
        by: Where x is a factor: the measure whose mean gives the place of a level; empty takes the level's own number.
        where: Only cells with these levels.
    """

    measure: str
    x: str = "ticks"
    title: str = ""
    by: str = ""
    where: Levels = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Cell:
    """Runs that differ in nothing but chance.

    Attributes:
        arm: The name of the experiment's arm.
        levels: Which level of each factor.
        project_arm: The project's arm that is changed by the settings.
    """

    number: int
    arm: str
    levels: Levels
    project_arm: str
    settings: Settings

    @property
    def name(self) -> str:
        """The arm, and the levels of the factors."""
        return ", ".join((self.arm, *(f"{factor} {level}" for factor, level in self.levels.items())))


@dataclass(frozen=True, slots=True)
class Experiment:
    """What is to be run, and what is to be said about it.

    Attributes:
        seed: Of the first run; each further run takes the next one, each cell seeds of its own.
        points: Into how many slices curves are cut.
    """

    name: str
    title: str
    arms: tuple[Treated, ...]
    ticks: int
    runs: int
    seed: int = 1
    points: int = 100
    factors: tuple[Factor, ...] = ()
    design: Design = Design.FACTORIAL
    claims: tuple[Claim, ...] = ()
    panels: tuple[Panel, ...] = (Panel(""),)
    note: str = ""

    def factor_heads(self, others: Collection[str]) -> list[str]:
        """What columns of factors are called in a table beside *others*: boxes can be varied and counted."""
        taken = {"arm", *others}
        return [f"{f.name} (factor)" if f.name in taken else f.name for f in self.factors]

    def cells(self) -> tuple[Cell, ...]:
        """All combinations that are run, arm by arm within each combination of levels."""
        wanted = [(combination, arm) for combination in self.combinations() for arm in self.arms]
        return tuple(
            Cell(
                number,
                arm.name,
                {factor.name: level.name for factor, level in combination},
                arm.arm,
                _merged(arm, combination),
            )
            for number, (combination, arm) in enumerate(wanted)
        )

    def combinations(self) -> tuple[tuple[tuple[Factor, Level], ...], ...]:
        """Each factor with one of its levels."""
        if self.design is Design.FACTORIAL:
            return tuple(product(*([(factor, level) for level in factor.levels] for factor in self.factors)))
        return tuple(self._one_at_a_time())

    def _one_at_a_time(self) -> Iterator[tuple[tuple[Factor, Level], ...]]:
        usual = {factor.name: (factor, factor.levels[0]) for factor in self.factors}
        yield tuple(usual.values())
        for factor in self.factors:
            for level in factor.levels[1:]:
                yield tuple({**usual, factor.name: (factor, level)}.values())

    def seed_of(self, cell: int, run: int) -> int:
        """The seed of one run: cells draw apart from each other, as independent samples do."""
        return self.seed + cell * SEEDS_A_CELL + run


#: Seeds that belong to one cell; an experiment has at most so many runs.
SEEDS_A_CELL = 1_000_000


def _merged(arm: Treated, combination: tuple[tuple[Factor, Level], ...]) -> Settings:
    """What the arm changes, and what the levels change on top."""
    settings = dict(arm.settings)
    for _, level in combination:
        settings.update(level.settings)
    return settings
