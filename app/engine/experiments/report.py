"""What an experiment came to, for programs (a JSON document) and for people (Markdown)."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .findings import Findings, Judged, Summary
from .plan import Design, Experiment, Kind, Levels, Reference
from .statistics import Sample, Verdict


@dataclass(frozen=True, slots=True)
class Files:
    """Where everything is; figures only as far as they could be drawn."""

    results: Path
    report: Path
    figures: tuple[Path, ...] = ()


def document(found: Findings, files: Files) -> dict[str, Any]:
    """The result for programs."""
    return {
        "experiment": found.experiment.name,
        "title": found.experiment.title,
        "ticks": found.experiment.ticks,
        "arms": [_arm(summary) for summary in found.summaries],
        "claims": [_claim(judged) for judged in found.claims],
        "tests": found.tests,
        "results": str(files.results),
        "report": str(files.report),
        "figures": [str(figure) for figure in files.figures],
    }


def _arm(summary: Summary) -> dict[str, Any]:
    return {
        "name": summary.cell.name,
        "arm": summary.cell.arm,
        "levels": dict(summary.cell.levels),
        "runs": summary.runs,
        "measures": {name: _sample(sample) for name, sample in summary.measures.items()},
        "stalled_share": summary.stalled_share,
        "agent_ticks_per_second": round(summary.rate),
    }


def _sample(sample: Sample) -> dict[str, Any]:
    return {"mean": sample.mean, "ci95": list(sample.interval), "sd": sample.sd}


def _claim(judged: Judged) -> dict[str, Any]:
    return {
        "text": judged.claim.text,
        "levels": dict(judged.levels),
        "measure": judged.claim.measure,
        "first": judged.first.mean,
        "second": judged.second.mean,
        "p": judged.p,
        "p_corrected": judged.p_corrected,
        "verdict": judged.verdict.value,
    }


# --------------------------------------------------------------------------------------------------------- tables


def arm_columns(found: Findings) -> list[str]:
    """The head of the table of arms."""
    others = ["runs", *measures_in(found), "stalled", "agent-ticks/s"]
    return ["arm", *_where_columns(found.experiment, others), *others]


def arm_rows(found: Findings) -> list[list[str]]:
    """A row a cell: means with half the width of their intervals."""
    return [
        [
            summary.cell.arm,
            *_where(summary, found.experiment),
            str(summary.runs),
            *(with_interval(summary.measures.get(name)) for name in measures_in(found)),
            f"{summary.stalled_share:.0%}",
            f"{summary.rate / 1e6:.1f} M",
        ]
        for summary in found.summaries
    ]


def words_in_arms(experiment: Experiment) -> int:
    """How many columns of the table of arms, from the left, hold words."""
    return 1 + len(_where_columns(experiment, ()))


def _where_columns(experiment: Experiment, others: Collection[str]) -> list[str]:
    """A column a factor beside the *others*, or a single one that names what is unusual."""
    if experiment.design is Design.ONE_AT_A_TIME:
        return ["what is changed"]
    return experiment.factor_heads(others)


def _where(summary: Summary, experiment: Experiment) -> list[str]:
    if experiment.design is Design.ONE_AT_A_TIME:
        return [place(summary.cell.levels, experiment)]
    return [summary.cell.levels[factor.name] for factor in experiment.factors]


def measures_in(found: Findings) -> list[str]:
    """All measures of all runs: the scenario's first, then what else was counted."""
    names = dict.fromkeys([*found.curves, *(name for s in found.summaries for name in s.measures)])
    return list(names)


def with_interval(sample: Sample | None) -> str:
    """A mean and half the width of its 95% interval: ``97.1 ± 2.2``."""
    if sample is None or not sample.count:
        return "–"
    if sample.count < 2 or sample.sd == 0.0:
        return f"{sample.mean:,.4g}"
    return f"{sample.mean:,.1f} ± {sample.half_width:.1f}"


def claim_columns(found: Findings) -> list[str]:
    """The head of the table of claims."""
    where = ["where"] if found.experiment.factors else []
    return ["claim", *where, "means", "difference", "p, corrected", "verdict"]


def claim_rows(found: Findings) -> list[list[str]]:
    """A row a claim and combination of levels."""
    return [
        [
            judged.claim.text,
            *([place(judged.levels, found.experiment)] if found.experiment.factors else []),
            _means(judged),
            "" if judged.p is None else f"{judged.difference:+,.1f}",
            probability(judged.p_corrected),
            judged.verdict.value,
        ]
        for judged in found.claims
    ]


def _means(judged: Judged) -> str:
    if judged.claim.kind is Kind.NEVER_STALLS:
        return f"{judged.first.mean:.0%} of {judged.first.count} stalled"
    other = f" ({judged.claim.second.name})" if isinstance(judged.claim.second, Reference) else ""
    return f"{with_interval(judged.first)} against {with_interval(judged.second)}{other}"


def place(levels: Levels, experiment: Experiment) -> str:
    """A combination of levels as a reader wants it: only what is unusual where one thing is varied at a time."""
    if experiment.design is Design.FACTORIAL:
        return ", ".join(f"{factor} {level}" for factor, level in levels.items())
    usual = {factor.name: factor.levels[0].name for factor in experiment.factors}
    unusual = [f"{factor}: {level}" for factor, level in levels.items() if level != usual[factor]]
    return ", ".join(unusual) or "as usual"


def probability(p: float | None) -> str:
    """A p as people write it."""
    if p is None:
        return "–"
    return "< 0.0001" if p < 0.0001 else f"{p:.4f}" if p < 0.1 else f"{p:.2f}"


# ------------------------------------------------------------------------------------------------------- Markdown


def markdown(found: Findings, files: Files, command: str) -> str:
    """The report as a page.

    Args:
        command: What makes it again.
    """
    experiment = found.experiment
    parts = [f"# {experiment.title}", experiment.note, *(_picture(figure) for figure in _pictures(files))]
    parts.append(_setting(experiment))
    parts.append(_table(arm_columns(found), arm_rows(found), words_in_arms(experiment)))
    if found.claims:
        parts += ["## Claims", _verdicts(found.claims), _tested(found)]
        parts += _overview(found) if experiment.factors else []
        parts.append(_table(claim_columns(found), claim_rows(found), words=len(claim_columns(found))))
    parts.append(f"Made by\n\n    {command}")
    return "\n\n".join(part for part in parts if part) + "\n"


def _pictures(files: Files) -> list[Path]:
    return [figure for figure in files.figures if figure.suffix == ".png"]


def _picture(figure: Path) -> str:
    return f"![The means over all runs with their 95% confidence]({figure.name})"


def _setting(experiment: Experiment) -> str:
    text = (
        f"Each row is the mean of its runs after {experiment.ticks:,} ticks ± half the width of its 95% confidence "
        "interval (Student's t). A run is *stalled* if it got nothing done in its last 30%. The last column is the "
        "speed of one thread, with whatever else the machine had to do."
    )
    if experiment.factors and experiment.design is Design.ONE_AT_A_TIME:
        text += " One thing at a time is changed; the first level of each factor is the usual one."
    return text


def _verdicts(claims: Sequence[Judged]) -> str:
    counts: Mapping[Verdict, int] = {v: sum(judged.verdict is v for judged in claims) for v in Verdict}
    told = [f"{verdict.value}: {count}" for verdict, count in counts.items() if count]
    return f"Of {len(claims)} — {', '.join(told)}."


def _overview(found: Findings) -> list[str]:
    """Where each claim holds and where not: a row a place, a column a claim by its number."""
    texts = list(dict.fromkeys(judged.claim.text for judged in found.claims))
    cells: dict[str, dict[str, str]] = {}
    for judged in found.claims:
        cells.setdefault(place(judged.levels, found.experiment), {})[judged.claim.text] = judged.verdict.value
    listed = "\n".join(f"{number}. {text}" for number, text in enumerate(texts, 1))
    columns = ["where", *(str(number) for number in range(1, len(texts) + 1))]
    rows = [[where, *(verdicts.get(text, "") for text in texts)] for where, verdicts in cells.items()]
    return [listed, _table(columns, rows, words=len(columns))]


def _tested(found: Findings) -> str:
    kinds = {judged.claim.kind for judged in found.claims}
    text = (
        f"Two-tailed Welch t-tests at 95%, p multiplied by {found.tests}, the number of tests in this experiment "
        "(Bonferroni)."
    )
    if Kind.NO_LESS in kinds:
        text += ' "No fewer" holds if the mean is at least the other, and fails if it is significantly lower.'
    if Kind.SAME in kinds:
        text += " Where no difference is significant, none has been shown; that is not proof of equality."
    return text if found.tests else ""


def _table(columns: Sequence[str], rows: Sequence[Sequence[str]], words: int) -> str:
    rule = ["---" if index < words else "---:" for index in range(len(columns))]
    lines = [columns, rule, *rows]
    return "\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |" for line in lines)
