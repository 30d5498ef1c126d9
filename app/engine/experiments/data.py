"""The numbers of an experiment as CSV: one line a run, and curves with their bands."""

import csv
import io
from collections.abc import Iterable, Iterator, Sequence

from .findings import Findings
from .plan import Experiment
from .store import Row


def runs_csv(experiment: Experiment, made: Iterable[Row]) -> str:
    """Every run that has been made: arm, levels, number, seed, measures, and whether it stalled."""
    rows = list(_runs(experiment, made))
    measures = sorted({name for _, _, found in rows for name in found})
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    others = ["run", "seed", "ticks", *measures, "stalled", "agent_ticks", "seconds"]
    writer.writerow(["arm", *experiment.factor_heads(others), *others])
    for before, after, found in rows:
        writer.writerow([*before, *(found.get(name, "") for name in measures), *after])
    return out.getvalue()


def _runs(
    experiment: Experiment, made: Iterable[Row]
) -> Iterator[tuple[list[object], list[object], dict[str, float]]]:
    cells = experiment.cells()
    for row in sorted(made, key=lambda row: (row.cell, row.run)):
        cell = cells[row.cell]
        levels = [cell.levels[factor.name] for factor in experiment.factors]
        before: list[object] = [cell.arm, *levels, row.run + 1, row.seed, experiment.ticks]
        after: list[object] = [int(row.stalled), row.agent_ticks, f"{row.seconds:.6f}"]
        yield before, after, dict(row.measures)


def curves_csv(found: Findings) -> str:
    """Means over time with the bounds of their 95% confidence intervals, one line a sample of a measure in a cell."""
    experiment = found.experiment
    factors = [factor.name for factor in experiment.factors]
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    others = ["measure", "tick", "mean", "low", "high", "runs"]
    writer.writerow(["arm", *experiment.factor_heads(others), *others])
    for summary in found.summaries:
        if not summary.runs:
            continue
        levels = [summary.cell.levels[name] for name in factors]
        for measure, mean, half in zip(found.curves, summary.curve, summary.band, strict=True):
            ticks = _ticks(experiment.ticks, len(mean))
            for tick, middle, width in zip(ticks, mean.tolist(), half.tolist(), strict=True):
                bounds = [tick, middle, middle - width, middle + width]
                writer.writerow([summary.cell.arm, *levels, measure, *bounds, summary.runs])
    return out.getvalue()


def _ticks(ticks: int, samples: int) -> Sequence[int]:
    """The ticks at which curves were sampled, the beginning included."""
    return [round(ticks * k / max(1, samples - 1)) for k in range(samples)]
