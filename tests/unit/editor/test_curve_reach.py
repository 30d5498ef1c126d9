"""Curves with bands of few runs can still be told apart."""

import numpy as np
import pytest

from app.editor.experiments.reach import reach

LINES = [np.array([0.0, 2.0, 4.0]), np.array([0.0, 1.0, 2.0])]


def test_bands_that_are_near_the_curves_are_shown_in_full() -> None:
    shown, beyond = reach(LINES, [np.full(3, 0.5), np.full(3, 1.0)])
    assert shown == (-1.0, 4.5)
    assert not beyond


def test_bands_that_are_much_higher_leave_the_curves_half_of_the_height() -> None:
    (low, high), beyond = reach(LINES, [np.full(3, 50.0), np.full(3, 1.0)])
    assert 4.0 / (high - low) == pytest.approx(0.5)
    assert beyond


def test_a_single_run_has_no_band() -> None:
    shown, beyond = reach(LINES, [np.full(3, np.nan)] * 2)
    assert shown == (0.0, 4.0)
    assert not beyond


def test_curves_that_are_flat_have_some_height_all_the_same() -> None:
    shown, beyond = reach([np.zeros(3)], [np.zeros(3)])
    assert shown == (0.0, 1.0)
    assert not beyond
