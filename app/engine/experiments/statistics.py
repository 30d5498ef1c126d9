"""Means with confidence, and whether the results bear a claim out."""

from dataclasses import dataclass
from enum import StrEnum
from math import isnan, sqrt

import numpy as np
from numpy.typing import NDArray

#: How sure intervals and verdicts are, and how easily chance may bring a significant difference about.
CONFIDENCE, LEVEL = 0.95, 0.05


@dataclass(frozen=True, slots=True)
class Sample:
    """Numbers summed up: how many, their mean and standard deviation (0 of fewer than two)."""

    count: int
    mean: float
    sd: float

    @property
    def half_width(self) -> float:
        """Half of the 95% confidence interval of the mean, by Student's t; 0 where one cannot be told."""
        if self.count < 2:
            return 0.0
        return float(student(self.count)) * self.sd / sqrt(self.count)

    @property
    def interval(self) -> tuple[float, float]:
        """The 95% confidence interval of the mean."""
        return self.mean - self.half_width, self.mean + self.half_width


class Running:
    """Mean and deviation of arrays that come one by one (Welford 1962): only sums are kept.

    Attributes:
        count: How many arrays came.
        mean: Of each place.
    """

    def __init__(self) -> None:
        self.count = 0
        self.mean: NDArray[np.float64] = np.zeros(0)
        self._squares: NDArray[np.float64] = np.zeros(0)

    def add(self, values: NDArray[np.float64]) -> None:
        """Take in one more; all have the same shape."""
        if self.count == 0:
            self.mean, self._squares = np.zeros_like(values), np.zeros_like(values)
        self.count += 1
        off = values - self.mean
        self.mean = self.mean + off / self.count
        self._squares = self._squares + off * (values - self.mean)

    @property
    def sd(self) -> NDArray[np.float64]:
        """The standard deviation of each place."""
        return np.sqrt(self._squares / max(self.count - 1, 1))

    @property
    def half_width(self) -> NDArray[np.float64]:
        """Half of the 95% confidence interval of each mean."""
        if self.count < 2:
            return np.zeros_like(self.mean)
        return np.asarray(student(self.count) * self.sd / sqrt(self.count), np.float64)


#: The sample that there are no numbers of.
NOTHING = Sample(0, 0.0, 0.0)


def student(count: int) -> float:
    """The quantile of Student's t that a 95% interval from *count* numbers needs."""
    from scipy.special import stdtrit  # noqa: PLC0415 - it takes 0.1 s to load, scipy.stats five times as long

    return float(stdtrit(count - 1, 0.5 + CONFIDENCE / 2))


def welch(a: Sample, b: Sample) -> float | None:
    """The two-tailed p of Welch's t-test: how easily two samples of equal means would differ so; None for too few."""
    if a.count < 2 or b.count < 2:
        return None
    if a.sd == 0.0 and b.sd == 0.0:
        return 1.0 if a.mean == b.mean else 0.0
    from scipy.special import stdtr  # noqa: PLC0415 - as above

    with np.errstate(all="ignore"):  # of numbers too small to be squared, nothing can be told
        first, second = np.float64(a.sd) ** 2 / a.count, np.float64(b.sd) ** 2 / b.count
        freedom = (first + second) ** 2 / (first**2 / (a.count - 1) + second**2 / (b.count - 1))
        t = (a.mean - b.mean) / np.sqrt(first + second)
    p = 2.0 * float(stdtr(1.0 if isnan(freedom) else freedom, -abs(t)))
    return None if isnan(p) else p


def corrected(p: float | None, tests: int) -> float | None:
    """Bonferroni: *p* as one of so many tests."""
    return None if p is None else min(1.0, p * tests)


class Verdict(StrEnum):
    """What the results say of a claim."""

    HOLDS = "holds"
    FAILS = "does not hold"
    OPEN = "not significant"


def significant(p: float | None) -> bool:
    """Whether a corrected p is small enough."""
    return p is not None and p < LEVEL


def greater(a: Sample, b: Sample, p: float | None) -> Verdict:
    """Of the claim that *a* is greater than *b*, with the corrected p of their difference."""
    if not significant(p):
        return Verdict.OPEN
    return Verdict.HOLDS if a.mean > b.mean else Verdict.FAILS


def same(a: Sample, b: Sample, p: float | None) -> Verdict:
    """Of the claim that there is no significant difference; too few runs leave it open."""
    if p is None:
        return Verdict.OPEN
    return Verdict.FAILS if significant(p) and a.mean != b.mean else Verdict.HOLDS


def no_less(a: Sample, b: Sample, p: float | None) -> Verdict:
    """Of the claim that *a* is at least as great as *b*: open if its mean is lower, but not significantly."""
    if a.count and a.mean >= b.mean:
        return Verdict.HOLDS
    return Verdict.FAILS if significant(p) else Verdict.OPEN
