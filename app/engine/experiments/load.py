"""Reading ``experiments/NAME.json`` of a project: everything that is wrong with it is said, with its place."""

from collections.abc import Iterator, Mapping, Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from ...core.errors import EditError, ParameterError, UnderstudyError
from ...core.project import Project
from ...core.refusals import reason
from ...core.storage.problems import FilesError, Problem, of_document
from ...core.storage.text import TextError, parsed
from ...sim.scenario import Scenario
from .plan import Claim, Experiment, Factor, Given, Kind, Level, Levels, Panel, Reference, Settings, Treated
from .records import ClaimRecord, ExperimentRecord, FactorRecord, PanelRecord
from .treatments import EXTRA_MEASURES, refuse_settings

FOLDER = "experiments"
TICKS, ROWS = "ticks", "rows"


def experiments_in(folder: Path) -> list[str]:
    """The names of the experiments of the project in *folder*."""
    try:
        return sorted(path.stem for path in (folder / FOLDER).glob("*.json") if not path.name.startswith("."))
    except OSError:
        return []


def load_experiment(folder: Path, name: str, project: Project, scenario: Scenario) -> Experiment:
    """The experiment *name* of the project in *folder*.

    Raises:
        ParameterError: There is no such experiment; the message names those there are.
        FilesError: The file is damaged, or names what the project does not have.
    """
    there = experiments_in(folder)
    if name not in there:
        near = get_close_matches(name, there, n=1)
        meant = f" (did you mean {near[0]!r}?)" if near else ""
        raise ParameterError(
            f"there is no experiment {name!r} in {folder / FOLDER}{meant}; there are: {', '.join(there) or 'none'}"
        )
    file = f"{FOLDER}/{name}.json"
    document = _document(folder, file)
    try:
        record = ExperimentRecord.model_validate(document)
    except ValidationError as error:
        raise FilesError(folder, of_document(file, ExperimentRecord, document, error)) from error
    if problems := [Problem(file, *told) for told in _problems(record, project, scenario)]:
        raise FilesError(folder, problems)
    return _experiment(name, record, scenario)


def _document(folder: Path, file: str) -> Any:
    try:
        return parsed((folder / file).read_bytes())
    except TextError as error:
        raise FilesError(folder, [Problem(file, error.where, error.message)]) from error
    except OSError as error:
        raise FilesError(folder, [Problem(file, "", f"cannot be read: {reason(error)}")]) from error


# ------------------------------------------------------------------------------------------------------ the value


def _experiment(name: str, record: ExperimentRecord, scenario: Scenario) -> Experiment:
    usual = next(iter(scenario.measures), "")
    return Experiment(
        name,
        record.title,
        tuple(Treated(arm.name, arm.arm, arm.settings) for arm in record.arms),
        record.ticks,
        record.runs,
        record.seed,
        record.points,
        tuple(_factor(factor) for factor in record.factors),
        record.design,
        tuple(_claim(claim, usual) for claim in record.claims),
        tuple(_panel(panel, usual) for panel in record.figure) or (Panel(usual),),
        record.note,
    )


def _factor(record: FactorRecord) -> Factor:
    levels = [Level(_shown(value), {record.setting: value}) for value in record.values]
    levels += [Level(level.name, level.settings) for level in record.levels]
    return Factor(record.name, tuple(levels))


def _shown(value: Given) -> str:
    """A level's name, made from its value: ``5``, ``2 x 5 x 5``."""
    if isinstance(value, tuple):
        return " x ".join(map(str, value))
    return f"{value:g}" if isinstance(value, float) else str(value)


def _claim(record: ClaimRecord, usual: str) -> Claim:
    measure = record.measure or usual
    if record.same is not None:
        first, second = record.same
        return Claim(record.text, Kind.SAME, measure, first, second, record.where)
    if record.no_less is not None and record.than is not None:
        other = Reference(record.than.name, record.than.mean, record.than.sd, record.than.runs)
        return Claim(record.text, Kind.NO_LESS, measure, record.no_less, other, record.where)
    if record.never_stalls is not None:
        return Claim(record.text, Kind.NEVER_STALLS, measure, record.never_stalls, "", record.where)
    return Claim(record.text, Kind.GREATER, measure, record.greater or "", record.less or "", record.where)


def _panel(record: PanelRecord, usual: str) -> Panel:
    return Panel(record.measure or usual, record.x, record.title, record.by, record.where)


# -------------------------------------------------------------------------------------------------- what is wrong

#: A place in the file, and what is wrong there.
Told = tuple[str, str]


def _problems(record: ExperimentRecord, project: Project, scenario: Scenario) -> list[Told]:
    found = list(_wrong_arms(record, project, scenario))
    for number, factor in enumerate(record.factors):
        found += _wrong_factor(f"factors[{number}]", factor, record, project, scenario)
    return found or [*_wrong_claims(record, scenario), *_wrong_panels(record, scenario)]


def _wrong_arms(record: ExperimentRecord, project: Project, scenario: Scenario) -> Iterator[Told]:
    for number, arm in enumerate(record.arms):
        try:
            project.arm(arm.arm)
        except EditError as error:
            yield f"arms[{number}].arm", str(error)
            continue
        yield from _refused(f"arms[{number}].settings", arm.arm, arm.settings, project, scenario)


def _wrong_factor(
    where: str, factor: FactorRecord, record: ExperimentRecord, project: Project, scenario: Scenario
) -> Iterator[Told]:
    """A level is tried in every arm: what it changes has to be there."""
    levels: list[tuple[str, Settings]] = [
        *((f"{where}.values[{n}]", {factor.setting: value}) for n, value in enumerate(factor.values)),
        *((f"{where}.levels[{n}].settings", level.settings) for n, level in enumerate(factor.levels)),
    ]
    known = {arm.name for arm in project.arms}
    for place, settings in levels:
        for arm in record.arms:
            if arm.arm in known:
                both = {**arm.settings, **settings}
                told = list(_refused(place, arm.arm, both, project, scenario, arm.settings))
                yield from told
                if told:
                    break


def _refused(
    where: str,
    arm: str,
    settings: Settings,
    project: Project,
    scenario: Scenario,
    sound: Settings | None = None,
) -> Iterator[Told]:
    try:
        refuse_settings(project, scenario, arm, settings, sound)
    except UnderstudyError as error:
        yield where, str(error)


def _wrong_claims(record: ExperimentRecord, scenario: Scenario) -> Iterator[Told]:
    arms = [arm.name for arm in record.arms]
    for number, claim in enumerate(record.claims):
        where = f"claims[{number}]"
        named = [
            (key, name)
            for key in ("greater", "less", "no_less", "never_stalls")
            if (name := getattr(claim, key)) is not None
        ]
        named += [(f"same[{n}]", name) for n, name in enumerate(claim.same or ())]
        for key, name in named:
            if name not in arms:
                yield f"{where}.{key}", _missing("arm of this experiment", name, arms)
        yield from _wrong_measure(f"{where}.measure", claim.measure, scenario)
        yield from _wrong_levels(f"{where}.where", claim.where, record)


def _wrong_panels(record: ExperimentRecord, scenario: Scenario) -> Iterator[Told]:
    factors = [factor.name for factor in record.factors]
    for number, panel in enumerate(record.figure):
        where = f"figure[{number}]"
        if panel.x not in (TICKS, ROWS, *factors):
            yield f"{where}.x", _missing("factor", panel.x, [TICKS, ROWS, *factors])
        yield from _wrong_measure(f"{where}.measure", panel.measure, scenario)
        yield from _wrong_measure(f"{where}.by", panel.by, scenario)
        yield from _wrong_levels(f"{where}.where", panel.where, record)


def _wrong_measure(where: str, measure: str, scenario: Scenario) -> Iterator[Told]:
    known = [*scenario.measures, *EXTRA_MEASURES]
    if measure and measure not in known:
        yield where, _missing("measure", measure, known)


def _wrong_levels(where: str, levels: Levels, record: ExperimentRecord) -> Iterator[Told]:
    factors: Mapping[str, list[str]] = {
        factor.name: [level.name for level in _factor(factor).levels] for factor in record.factors
    }
    for factor, level in levels.items():
        if factor not in factors:
            yield where, _missing("factor", factor, list(factors))
        elif level not in factors[factor]:
            yield where, _missing(f"level of {factor!r}", level, factors[factor])


def _missing(what: str, name: str, there: Sequence[str]) -> str:
    return f"there is no {what} {name!r}; there are: {', '.join(map(repr, there)) or 'none'}"
