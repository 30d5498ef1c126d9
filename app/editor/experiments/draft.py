"""What the dialog that builds an experiment holds, and the experiment that it describes."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from ...core.errors import ParameterError
from ...engine.experiments.plan import (
    Claim,
    Design,
    Experiment,
    Factor,
    Given,
    Kind,
    Level,
    Panel,
    Treated,
)
from ...engine.experiments.treatments import refuse_settings

if TYPE_CHECKING:
    from ...core.project import Project
    from ...sim.scenario import Scenario

#: What claims can say, as the user reads it.
SAYS = {Kind.GREATER: "is greater than", Kind.SAME: "is the same as", Kind.NEVER_STALLS: "never stalls"}


@dataclass(frozen=True, slots=True)
class Draft:
    """What the dialog holds, as text; `drafted` makes an experiment of it."""

    name: str
    title: str
    note: str
    ticks: str
    runs: str
    seed: str
    arms: tuple[Treated, ...]
    factors: tuple[tuple[str, str], ...]  # setting, values with commas between them
    design: Design
    claims: tuple[tuple[str, Kind, str, str], ...]  # first, kind, second, measure
    measures: tuple[str, ...]


def drafted(draft: Draft, base: Experiment | None, project: Project, scenario: Scenario) -> Experiment:
    """The experiment that a draft describes; what the dialog does not show is kept from *base*.

    Raises:
        UnderstudyError: Something in it is not possible; the message says what and what is allowed.
    """
    if not draft.arms:
        raise ParameterError("an experiment needs at least one arm: tick one")
    factors = tuple(_factor(setting, values, base) for setting, values in draft.factors if setting)
    names = [factor.name for factor in factors]
    if twice := next((name for name in names if names.count(name) > 1), ""):
        raise ParameterError(f"{twice!r} is varied twice; give all its values in one row")
    for arm in draft.arms:
        for level in (Level("", {}), *(level for factor in factors for level in factor.levels)):
            refuse_settings(project, scenario, arm.arm, {**arm.settings, **level.settings})
    ticks = _whole("ticks a run", draft.ticks, 1, 10**9)
    fresh = Experiment(draft.name, draft.title.strip() or draft.name, draft.arms, ticks, 1)
    kept = fresh if base is None else base
    measures = draft.measures or tuple(scenario.measures)[:1]
    shown = tuple(panel.measure for panel in kept.panels)
    return replace(
        kept,
        name=draft.name,
        title=fresh.title,
        note=draft.note.strip(),
        arms=draft.arms,
        ticks=ticks,
        runs=_whole("runs an arm", draft.runs, 1, 1_000_000),
        seed=_whole("the first seed", draft.seed, 0, 2**62),
        points=min(kept.points, ticks),
        factors=factors,
        design=draft.design,
        claims=_claims(draft, base),
        panels=kept.panels if shown == measures else tuple(Panel(measure) for measure in measures),
    )


def _whole(what: str, text: str, low: int, high: int) -> int:
    plain = text.replace(",", "").replace(" ", "")
    if plain.isdecimal() and low <= int(plain) <= high:
        return int(plain)
    raise ParameterError(f"{what}: a whole number from {low:,} to {high:,}, but this is {text.strip()!r}")


def _factor(setting: str, values: str, base: Experiment | None) -> Factor:
    """One row of what is varied; a factor of *base* whose values still read the same stays as it is."""
    for factor in base.factors if base is not None else ():
        if (setting, values) == shown_factor(factor):
            return factor
    given = [part.strip() for part in values.split(",") if part.strip()]
    if not given:
        raise ParameterError(
            f"{setting}: give the values to try, with commas between them, such as 5, 10, 20"
        )
    if twice := next((part for part in given if given.count(part) > 1), ""):
        raise ParameterError(f"{setting}: {twice!r} is given twice")
    name = setting.rpartition(".")[2]
    return Factor(name, tuple(Level(part, {setting: _value(part)}) for part in given))


def _value(text: str) -> Given:
    """What a word stands for: true and false, numbers, sizes such as "2 x 5 x 5", or itself."""
    if text in ("true", "false"):
        return text == "true"
    sizes = [part.strip() for part in text.split("x")]
    if len(sizes) > 1 and all(part.isdecimal() for part in sizes):
        return tuple(map(int, sizes))
    try:
        return int(text)
    except ValueError:
        pass
    try:
        return float(text)
    except ValueError:
        return text


def shown_factor(factor: Factor) -> tuple[str, str]:
    """A factor as a row: its setting, and its values; the names of levels that change several settings at once."""
    settings = {setting for level in factor.levels for setting in level.settings}
    setting = settings.pop() if len(settings) == 1 else factor.name
    return setting, ", ".join(level.name for level in factor.levels)


def _claims(draft: Draft, base: Experiment | None) -> tuple[Claim, ...]:
    """The claims of the rows; those of *base* that a row cannot show are kept, and texts are where nothing has changed."""
    before = base.claims if base is not None else ()
    kept = {row: claim for claim in before if (row := shown_claim(claim)) is not None}
    arms = {arm.name for arm in draft.arms}
    found = [claim for claim in before if shown_claim(claim) is None]
    for row in draft.claims:
        first, kind, second, measure = row
        if first not in arms or (kind is not Kind.NEVER_STALLS and second not in arms):
            raise ParameterError(
                f"a claim compares {first!r} and {second!r}, but both have to be arms that are ticked"
            )
        if kind is not Kind.NEVER_STALLS and first == second:
            raise ParameterError(f"a claim compares {first!r} with itself")
        text = f"{first} {SAYS[kind]} {second} in {measure}" if second else f"{first} {SAYS[kind]}"
        found.append(kept.get(row) or Claim(text, kind, measure, first, second))
    return tuple(found)


def shown_claim(claim: Claim) -> tuple[str, Kind, str, str] | None:
    """A claim as a row; None for one that compares with a result from elsewhere, or speaks of some levels only."""
    if claim.kind not in SAYS or not isinstance(claim.second, str) or claim.where:
        return None
    return claim.first, claim.kind, claim.second, claim.measure
