"""From the findings of an experiment to a chart: shaping only, no drawing."""

from collections.abc import Iterator, Sequence

import numpy as np

from ...core.amounts import counted, number
from ...engine.experiments.findings import Findings, Summary
from ...engine.experiments.load import ROWS, TICKS
from ...engine.experiments.plan import Panel
from ...engine.experiments.report import place
from ...engine.experiments.statistics import NOTHING
from .curves import Band, Chart, Dot, Key, Plot, Row


def chart_of(found: Findings) -> Chart:
    """The figure of an experiment: a plot a panel, every line a mean with its 95% confidence."""
    experiment = found.experiment
    most = max((summary.runs for summary in found.summaries), default=0)
    subtitle = f"{counted(experiment.ticks, 'tick')}, {counted(most, 'run')} each; means with 95% confidence"
    lines = _Lines(found)
    plots = tuple(_plot(found, panel, lines) for panel in experiment.panels)
    keys = tuple(Key(name, *lines.style(name)) for name in lines.names)
    return Chart(experiment.title, subtitle, plots, keys)


class _Lines:
    """What tells lines apart: the arm, and the levels of every factor that no panel draws along or holds fast.

    Attributes:
        names: Of all lines, in the order of the cells.
    """

    def __init__(self, found: Findings) -> None:
        panels = found.experiment.panels
        self._spent = {panel.x for panel in panels} | {factor for panel in panels for factor in panel.where}
        if any(panel.x == ROWS for panel in panels):
            self._spent |= {factor.name for factor in found.experiment.factors}
        self.names = list(dict.fromkeys(map(self.of, found.summaries)))

    def of(self, summary: Summary) -> str:
        """The line that a cell belongs to."""
        levels = [level for factor, level in summary.cell.levels.items() if factor not in self._spent]
        return ", ".join((summary.cell.arm, *levels))

    def style(self, name: str) -> tuple[int, int]:
        """Color and dash: both change from line to line, so that either tells them apart."""
        index = self.names.index(name)
        return index, index


def _plot(found: Findings, panel: Panel, lines: _Lines) -> Plot:
    title = panel.title or panel.measure
    chosen = [s for s in found.summaries if s.runs and panel.where.items() <= s.cell.levels.items()]
    if panel.x == TICKS:
        return Plot(title, "ticks", tuple(_over_time(found, panel, chosen, lines)))
    if panel.x == ROWS:
        return Plot(title, panel.measure, rows=tuple(_rows(found, panel, chosen, lines)))
    return Plot(title, panel.by or panel.x, tuple(_over_factor(panel, chosen, lines)))


def _over_time(found: Findings, panel: Panel, chosen: Sequence[Summary], lines: _Lines) -> Iterator[Band]:
    row = found.curves.index(panel.measure)
    for summary in chosen:
        name = lines.of(summary)
        mean, half = summary.curve[row], summary.band[row]
        x = tuple(np.linspace(0.0, found.experiment.ticks, len(mean)).tolist())
        label = f"{name}: {number(round(float(mean[-1]), 1))}"
        low, high = tuple((mean - half).tolist()), tuple((mean + half).tolist())
        yield Band(label, *lines.style(name), x, tuple(mean.tolist()), low, high)


def _over_factor(panel: Panel, chosen: Sequence[Summary], lines: _Lines) -> Iterator[Band]:
    for name in lines.names:
        cells = [(_x(s, panel), s) for s in chosen if lines.of(s) == name]
        cells.sort(key=lambda cell: cell[0])
        samples = [s.measures.get(panel.measure, NOTHING) for _, s in cells]
        if samples:
            yield Band(
                name,
                *lines.style(name),
                tuple(x for x, _ in cells),
                tuple(sample.mean for sample in samples),
                tuple(sample.interval[0] for sample in samples),
                tuple(sample.interval[1] for sample in samples),
                marks=True,
            )


def _x(summary: Summary, panel: Panel) -> float:
    """Where a cell stands: the mean of a measure, or its level's own number."""
    if panel.by:
        return summary.measures.get(panel.by, NOTHING).mean
    try:
        return float(summary.cell.levels[panel.x])
    except ValueError:
        return 0.0


# ---------------------------------------------------------------------------------------------------------- rows


def _rows(found: Findings, panel: Panel, chosen: Sequence[Summary], lines: _Lines) -> Iterator[Row]:
    by_place: dict[str, list[Dot]] = {}
    for summary in chosen:
        sample = summary.measures.get(panel.measure, NOTHING)
        color = lines.style(lines.of(summary))[0]
        dots = by_place.setdefault(place(summary.cell.levels, found.experiment), [])
        dots.append(Dot(color, sample.mean, *sample.interval))
    for where, dots in by_place.items():
        yield Row(where, tuple(dots))
