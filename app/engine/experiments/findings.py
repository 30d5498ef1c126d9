"""What the results of an experiment say: a summary of each cell, and of each claim."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .plan import Cell, Claim, Experiment, Kind, Levels, Reference
from .statistics import NOTHING, Running, Sample, Verdict, corrected, greater, no_less, same, welch
from .store import Results


@dataclass(frozen=True, slots=True, eq=False)
class Summary:
    """All runs of a cell, summed up.

    Attributes:
        measures: By name.
        stalled: How many runs got nothing done in their last 30%.
        curve, band: Measures over time, one row a measure: the mean, and half the width of its 95% interval.
        rate: Agent-ticks a second of one thread.
    """

    cell: Cell
    runs: int
    measures: Mapping[str, Sample]
    stalled: int
    curve: NDArray[np.float64]
    band: NDArray[np.float64]
    rate: float

    @property
    def stalled_share(self) -> float:
        """From 0 to 1."""
        return self.stalled / self.runs if self.runs else 0.0


@dataclass(frozen=True, slots=True)
class Judged:
    """A claim at one combination of levels.

    Attributes:
        levels: Where; empty if the experiment has no factors.
        first, second: What was compared.
        p, p_corrected: Of the difference; None where nothing was tested.
    """

    claim: Claim
    levels: Levels
    first: Sample
    second: Sample
    p: float | None
    p_corrected: float | None
    verdict: Verdict

    @property
    def difference(self) -> float:
        """By how much the first mean is greater."""
        return self.first.mean - self.second.mean


@dataclass(frozen=True, slots=True)
class Findings:
    """Everything that is told about an experiment.

    Attributes:
        curves: The measures of which there are curves, in their order.
        tests: How many tests the p values are corrected for.
    """

    experiment: Experiment
    curves: tuple[str, ...]
    summaries: tuple[Summary, ...]
    claims: tuple[Judged, ...]
    tests: int


def findings(experiment: Experiment, measures: Sequence[str], results: Results) -> Findings:
    """What *results* say about *experiment*.

    Args:
        measures: The scenario's, in the order in which curves have them.
    """
    cells = experiment.cells()
    summaries = tuple(summary(cell, experiment, len(measures), results) for cell in cells)
    tested = [found for claim in experiment.claims for found in _sides(claim, summaries)]
    tests = sum(claim.kind is not Kind.NEVER_STALLS for claim, *_ in tested)
    judged = tuple(_judged(*found, tests) for found in tested)
    return Findings(experiment, tuple(measures), summaries, judged, tests)


def summary(cell: Cell, experiment: Experiment, measures: int, results: Results) -> Summary:
    """The runs of a cell as far as they have been made, read one at a time."""
    final, curves = Running(), Running()
    names: list[str] = []
    stalled, ticks, seconds = 0, 0, 0.0
    for row in results.rows(cell.number, experiment.runs):
        names = names or sorted(row.measures)
        final.add(np.array([row.measures[name] for name in names], np.float64))
        curves.add(row.curves.reshape(measures, -1))
        stalled += row.stalled
        ticks, seconds = ticks + row.agent_ticks, seconds + row.seconds
    samples = {
        name: Sample(final.count, float(mean), float(sd))
        for name, mean, sd in zip(names, final.mean, final.sd, strict=False)
    }
    rate = ticks / seconds if seconds > 0.0 else 0.0
    return Summary(cell, final.count, samples, stalled, curves.mean, curves.half_width, rate)


# --------------------------------------------------------------------------------------------------------- claims

_Found = tuple[Claim, Summary, Sample, Sample]


def _sides(claim: Claim, summaries: Sequence[Summary]) -> Iterator[_Found]:
    """The claim with its two sides, at every combination of levels where it says something."""
    for one in summaries:
        if one.cell.arm == claim.first and claim.where.items() <= one.cell.levels.items():
            yield claim, one, _sample(one, claim), _other(claim, one, summaries)


def _other(claim: Claim, one: Summary, summaries: Sequence[Summary]) -> Sample:
    if isinstance(claim.second, Reference):
        return Sample(claim.second.runs, claim.second.mean, claim.second.sd)
    for other in summaries:
        if other.cell.arm == claim.second and other.cell.levels == one.cell.levels:
            return _sample(other, claim)
    return NOTHING


def _sample(of: Summary, claim: Claim) -> Sample:
    return of.measures.get(claim.measure, NOTHING)


def _judged(claim: Claim, one: Summary, first: Sample, second: Sample, tests: int) -> Judged:
    if claim.kind is Kind.NEVER_STALLS:
        share = Sample(one.runs, one.stalled_share, 0.0)
        verdict = Verdict.OPEN if not one.runs else Verdict.FAILS if one.stalled else Verdict.HOLDS
        return Judged(claim, one.cell.levels, share, NOTHING, None, None, verdict)
    p = welch(first, second)
    p_corrected = corrected(p, tests)
    verdict = {Kind.GREATER: greater, Kind.SAME: same, Kind.NO_LESS: no_less}[claim.kind](
        first, second, p_corrected
    )
    return Judged(claim, one.cell.levels, first, second, p, p_corrected, verdict)
