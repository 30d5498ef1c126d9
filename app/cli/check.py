"""``understudy check``: everything that is wrong with a project."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..core.check import PROJECT_FILE, check
from ..core.errors import EditError, ParameterError, ScenarioError
from ..core.project import Project
from ..core.storage import FilesError
from ..engine.experiments.load import experiments_in, load_experiment
from ..engine.scenarios import OWN_CODE, TrustError, open_scenario
from ..sim import portable, trial
from ..sim.scenario import Scenario
from .console import show, show_json
from .exits import DONE, WRONG_INPUT
from .opening import load_folder
from .wording import counted


@dataclass(frozen=True, slots=True)
class Complaint:
    """One problem, as it is printed; a ``warning`` does not keep the project from running."""

    file: str
    where: str
    message: str
    severity: str = "error"
    fix: str | None = None


@dataclass(frozen=True, slots=True)
class Verdict:
    """What a check came to.

    Attributes:
        unchecked: What could not be looked at, and why; empty if everything was.
    """

    complaints: tuple[Complaint, ...]
    unchecked: str = ""

    @property
    def ok(self) -> bool:
        """Whether nothing keeps the project from running."""
        return all(complaint.severity != "error" for complaint in self.complaints)


def check_project(folder: Path, *, trust: bool, as_json: bool) -> int:
    """Check the project in *folder* and print what is wrong."""
    verdict = judge(folder, trust=trust)
    if as_json:
        show_json(document(verdict))
    else:
        for line in lines(folder, verdict):
            show(line)
    return DONE if verdict.ok else WRONG_INPUT


def judge(folder: Path, *, trust: bool) -> Verdict:
    """Everything that is wrong with the project in *folder*."""
    try:
        project = load_folder(folder)
    except FilesError as error:
        problems = [Complaint(p.file, p.where, p.message) for p in error.problems]
        return Verdict(
            tuple(problems), "names, bindings and experiments: the files have to be readable first"
        )
    try:
        scenario = open_scenario(project, folder, trust=trust)
    except TrustError:
        reason = "the project carries code; --trust runs it, and then all is checked"
        return Verdict((), f"names, bindings and parameters against {OWN_CODE}: {reason}")
    except ScenarioError as error:
        return Verdict((Complaint(PROJECT_FILE, "scenario", str(error)),), "names, bindings and parameters")
    found = check(project, scenario.vocabulary)
    complaints = [Complaint(p.file, p.where, p.message, p.severity, p.fix) for p in found]
    complaints += _of_parameters(project, scenario)
    if project.scenario == OWN_CODE:
        complaints += _of_code(scenario)
    return Verdict((*complaints, *_of_experiments(folder, project, scenario)))


def _of_code(scenario: Scenario) -> list[Complaint]:
    """What a scenario of the project's own does against the contract; what cannot be compiled only runs more slowly."""
    slow = [Complaint(OWN_CODE, "", fault, "warning") for fault in portable.faults(scenario)]
    return slow + [Complaint(OWN_CODE, "", fault) for fault in trial.faults(scenario)]


def _of_experiments(folder: Path, project: Project, scenario: Scenario) -> list[Complaint]:
    """What is wrong with the files of experiments."""
    found = []
    for name in experiments_in(folder):
        try:
            load_experiment(folder, name, project, scenario)
        except FilesError as error:
            found += [Complaint(p.file, p.where, p.message) for p in error.problems]
    return found


def _of_parameters(project: Project, scenario: Scenario) -> list[Complaint]:
    """Scenario parameters that are unknown or out of their range, in each arm's world."""
    found = []
    for index, arm in enumerate(project.arms):
        try:
            scenario.settle(project.parameters_of(arm))
        except ParameterError as error:
            found.append(Complaint(PROJECT_FILE, f"arms[{index}].parameters", f"arm {arm.name!r}: {error}"))
        except EditError:
            continue  # its world is missing, which has been said
    return found


# ------------------------------------------------------------------------------------------------------- shaping


def document(verdict: Verdict) -> dict[str, Any]:
    """The verdict for programs."""
    problems = [
        {"file": c.file, "where": c.where, "message": c.message, "severity": c.severity, "fix": c.fix}
        for c in verdict.complaints
    ]
    return {"ok": verdict.ok, "problems": problems, "unchecked": verdict.unchecked}


def lines(folder: Path, verdict: Verdict) -> list[str]:
    """The verdict for people: a line a problem, and how many there are."""
    said = [_line(complaint, folder) for complaint in verdict.complaints]
    if verdict.unchecked:
        said.append(f"not checked: {verdict.unchecked}")
    errors = sum(complaint.severity == "error" for complaint in verdict.complaints)
    warnings = len(verdict.complaints) - errors
    return [*said, f"{folder}: {_counts(errors, warnings)}"]


def _line(complaint: Complaint, folder: Path) -> str:
    place = ": ".join(
        part for part in (complaint.file or str(folder), complaint.where, complaint.message) if part
    )
    severity = "" if complaint.severity == "error" else f"{complaint.severity}: "
    fix = f" (it would help to {complaint.fix})" if complaint.fix else ""
    return f"{severity}{place}{fix}"


def _counts(errors: int, warnings: int) -> str:
    if not errors and not warnings:
        return "no problems"
    return ", ".join(
        counted(count, what) for count, what in ((errors, "error"), (warnings, "warning")) if count
    )
