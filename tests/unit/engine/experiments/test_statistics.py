"""Means, intervals and tests, against numpy and scipy on the numbers themselves."""

import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from app.engine.experiments.statistics import (
    Running,
    Sample,
    Verdict,
    corrected,
    greater,
    no_less,
    same,
    welch,
)

NUMBERS = st.lists(st.floats(-1e6, 1e6), min_size=2, max_size=20)
HIGH, LOW = Sample(10, 5.0, 1.0), Sample(10, 3.0, 1.0)


def summed_up(numbers: list[float]) -> Sample:
    """The sample that *numbers* are, which come one by one."""
    running = Running()
    for number in numbers:
        running.add(np.array([number]))
    return Sample(running.count, float(running.mean[0]), float(running.sd[0]))


@given(NUMBERS)
def test_mean_and_deviation_are_those_of_all_numbers_together(numbers: list[float]) -> None:
    sample = summed_up(numbers)
    assert sample.count == len(numbers)
    assert sample.mean == pytest.approx(np.mean(numbers), abs=1e-6)
    assert sample.sd == pytest.approx(np.std(numbers, ddof=1), abs=1e-6)


def test_arrays_are_summed_up_place_by_place() -> None:
    running = Running()
    for values in ([1.0, 10.0], [3.0, 10.0], [5.0, 13.0]):
        running.add(np.array(values))
    assert running.mean.tolist() == [3.0, 11.0]
    assert running.sd.tolist() == pytest.approx([2.0, 3.0**0.5])
    assert running.half_width[0] == pytest.approx(summed_up([1.0, 3.0, 5.0]).half_width)


def test_the_interval_is_students() -> None:
    numbers = [3.0, 4.0, 8.0, 9.0]
    expected = stats.t.interval(0.95, 3, loc=np.mean(numbers), scale=stats.sem(numbers))
    assert summed_up(numbers).interval == pytest.approx(expected)


def test_one_number_has_no_interval() -> None:
    assert summed_up([4.0]).interval == (4.0, 4.0)


@given(NUMBERS, NUMBERS)
def test_p_is_that_of_welchs_two_tailed_test_on_the_numbers(a: list[float], b: list[float]) -> None:
    found = welch(summed_up(a), summed_up(b))
    if np.ptp(a) > 1e-3 and np.ptp(b) > 1e-3:
        assert found == pytest.approx(stats.ttest_ind(a, b, equal_var=False).pvalue, abs=1e-6)


def test_samples_that_do_not_vary_differ_for_certain_or_not_at_all() -> None:
    assert welch(Sample(3, 1.0, 0.0), Sample(3, 1.0, 0.0)) == 1.0
    assert welch(Sample(3, 1.0, 0.0), Sample(3, 2.0, 0.0)) == 0.0


def test_a_single_run_proves_nothing() -> None:
    assert welch(Sample(1, 1.0, 0.0), HIGH) is None
    assert greater(HIGH, Sample(1, 1.0, 0.0), None) is Verdict.OPEN
    assert same(HIGH, Sample(1, 1.0, 0.0), None) is Verdict.OPEN


def test_bonferroni_multiplies_by_the_number_of_tests_up_to_1() -> None:
    assert corrected(0.01, 4) == pytest.approx(0.04)
    assert corrected(0.5, 4) == 1.0
    assert corrected(None, 4) is None


@pytest.mark.parametrize(
    ("a", "b", "p", "verdicts"),
    [
        (HIGH, LOW, 0.001, ("holds", "does not hold", "holds")),
        (LOW, HIGH, 0.001, ("does not hold", "does not hold", "does not hold")),
        (HIGH, LOW, 0.05, ("not significant", "holds", "holds")),
        (LOW, HIGH, 0.2, ("not significant", "holds", "not significant")),
        (HIGH, HIGH, 1.0, ("not significant", "holds", "holds")),
    ],
)
def test_verdicts_follow_from_means_and_p(a: Sample, b: Sample, p: float, verdicts: tuple[str, ...]) -> None:
    assert (greater(a, b, p), same(a, b, p), no_less(a, b, p)) == verdicts


def test_numbers_too_small_to_be_squared_tell_nothing() -> None:
    assert welch(Sample(5, 1.0, 1e-200), Sample(5, 1.0 + 1e-200, 1e-200)) is None
    assert welch(Sample(5, 0.0, 1e-200), Sample(5, 0.0, 1e-200)) is None


def test_looking_at_experiments_loads_no_scipy_stats() -> None:
    """It would hold the window up for half a second."""
    code = "import sys, app.editor.experiments.window; sys.exit('scipy.stats' in sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True)
