"""What is wrong with the sample project once something in it is another."""

from dataclasses import replace
from typing import Any

from app.core.check import Problem, check
from app.core.library import NodeType
from app.core.project import Arm, LevelTable, Project
from tests.samples import AGENT, project, vocabulary

AGENTS = LevelTable((3,), (AGENT,))


def errors(changed: Project) -> list[Problem]:
    return [problem for problem in check(changed, vocabulary()) if problem.severity == "error"]


def only(changed: Project, severity: str = "error") -> Problem:
    """The one problem of this severity that a project has."""
    found = [problem for problem in check(changed, vocabulary()) if problem.severity == severity]
    assert len(found) == 1, [str(problem) for problem in found]
    return found[0]


def typed(*types: NodeType) -> Project:
    """The sample with these types, and nothing that belongs to others."""
    return replace(project(), types=types, arms=(), demonstrations=(), libraries={}, examples={})


def armed(arm: Arm) -> Project:
    """The sample with one arm more."""
    return replace(project(), arms=(*project().arms, arm))


def with_example(**fields: Any) -> Project:
    """The sample with the first example of goto changed in these fields."""
    first, *others = project().examples_of(AGENT, "goto")
    return replace(project(), examples={AGENT: {"goto": (replace(first, **fields), *others)}})
