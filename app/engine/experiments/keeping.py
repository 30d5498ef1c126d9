"""Writing experiments into a project's folder, in the form in which `load` reads them."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ...core.errors import ParameterError
from ...core.refusals import reason
from ...core.storage.atomic import WriteError, change_files
from ...core.storage.names import file_name_problem
from ...core.storage.problems import FilesError, Problem
from ...core.storage.text import written
from .load import FOLDER
from .plan import Claim, Design, Experiment, Factor, Kind, Panel, Reference, Settings


def experiment_file(folder: Path, name: str) -> Path:
    """Where the experiment *name* of the project in *folder* is kept."""
    return folder / FOLDER / f"{name}.json"


def save_experiment(folder: Path, experiment: Experiment) -> None:
    """Keep *experiment* under its name, in the place of one that is there.

    Raises:
        ParameterError: It cannot be called so.
        FilesError: The system refused; nothing has changed then.
    """
    if problem := file_name_problem(experiment.name):
        raise ParameterError(f"an experiment cannot be called {experiment.name!r}: {problem}")
    path = experiment_file(folder, experiment.name)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        change_files({path: written(document_of(experiment))}, ())
    except (OSError, WriteError) as error:
        raise _refused(path, error) from error


def delete_experiment(folder: Path, name: str) -> None:
    """Keep an experiment no longer; its results stay.

    Raises:
        FilesError: The system refused.
    """
    path = experiment_file(folder, name)
    try:
        path.unlink()
    except OSError as error:
        raise _refused(path, error) from error


def _refused(path: Path, error: OSError | WriteError) -> FilesError:
    why = reason(error.error if isinstance(error, WriteError) else error)
    return FilesError(path, [Problem("", "", f"cannot be written: {why}")])


def document_of(experiment: Experiment) -> dict[str, Any]:
    """What ``experiments/NAME.json`` holds; what is as usual is left out."""
    document: dict[str, Any] = {
        "title": experiment.title,
        "ticks": experiment.ticks,
        "runs": experiment.runs,
        "seed": experiment.seed,
        "arms": [
            _without_empty({"name": arm.name, "arm": arm.arm, "settings": _settings(arm.settings)})
            for arm in experiment.arms
        ],
        "note": experiment.note,
        "factors": [_factor(factor) for factor in experiment.factors],
        "claims": [_claim(claim) for claim in experiment.claims],
        "figure": [_panel(panel) for panel in experiment.panels],
    }
    if experiment.points != Experiment.__dataclass_fields__["points"].default:
        document["points"] = experiment.points
    if experiment.design is not Design.FACTORIAL:
        document["design"] = str(experiment.design)
    return _without_empty(document)


def _without_empty(document: Mapping[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in document.items() if value not in ("", [], {})}


def _settings(settings: Settings) -> dict[str, Any]:
    return {key: list(given) if isinstance(given, tuple) else given for key, given in settings.items()}


def _factor(factor: Factor) -> dict[str, Any]:
    levels = [{"name": level.name, "settings": _settings(level.settings)} for level in factor.levels]
    return {"name": factor.name, "levels": levels}


def _claim(claim: Claim) -> dict[str, Any]:
    form: dict[str, Any]
    match claim.kind, claim.second:
        case Kind.SAME, _:
            form = {"same": [claim.first, claim.second]}
        case Kind.NO_LESS, Reference(name, mean, sd, runs):
            form = {"no_less": claim.first, "than": {"name": name, "mean": mean, "sd": sd, "runs": runs}}
        case Kind.NEVER_STALLS, _:
            form = {"never_stalls": claim.first}
        case _:
            form = {"greater": claim.first, "less": claim.second}
    whole = {"text": claim.text, "measure": claim.measure, "where": dict(claim.where), **form}
    return _without_empty(whole)


def _panel(panel: Panel) -> dict[str, Any]:
    x = "" if panel.x == "ticks" else panel.x
    whole = {
        "measure": panel.measure,
        "x": x,
        "title": panel.title,
        "by": panel.by,
        "where": dict(panel.where),
    }
    return _without_empty(whole)
