"""Axes of plots."""

from PySide6.QtWidgets import QApplication

from app.editor.plotting import quiet_plot


def test_thousands_are_told_apart(qapp: QApplication) -> None:
    axis = quiet_plot("curves").getAxis("bottom")
    assert axis.tickStrings([0.0, 500.0, 60_000.0, 1_200_000.0], 1.0, 500.0) == [
        "0",
        "500",
        "60,000",
        "1,200,000",
    ]
    assert axis.tickStrings([0.2, 0.4], 1.0, 0.2) == ["0.2", "0.4"]


def test_numbers_beside_a_low_plot_do_not_touch(qapp: QApplication) -> None:
    axis = quiet_plot("curves").getAxis("left")
    high, low, lowest = (list(axis.tickValues(0.0, 1.0, size)[0][1]) for size in (100, 32, 18))
    assert len(high) > 3
    assert low == [0.0, 1.0]
    assert lowest == [1.0]
